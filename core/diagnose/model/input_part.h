// The part of effects that lie between what was recorded as the drive's input and what acts.
#pragma once

#include <optional>
#include <span>

namespace breakaway {

class InputPart {
 public:
  /// The drive input as it acts, in place of `input` (row k acts from time_s[k] until time_s[k + 1]); the first rows
  /// may lack their past.
  virtual void shape(std::span<const double> p, std::span<const double> time_s, std::span<double> input) const = 0;
  /// How late the recorded input acts, s: for a winding, whose current follows within a row, better than shape().
  virtual double delay_s(std::span<const double> /*p*/) const { return 0.0; }
  /// Of effects that move the drive in time: how late, in rows, the record would show it otherwise. What else is not
  /// known of that can't be told from the effect.
  virtual std::optional<double> otherwiseLate_rows() const { return std::nullopt; }

 protected:
  ~InputPart() = default;
};

}  // namespace breakaway
