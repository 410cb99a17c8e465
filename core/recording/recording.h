// A recording is immutable once sealed and the only input of analysis.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"

namespace breakaway {

/// One column: its name ends in its unit; a missing value is NaN.
struct Channel {
  std::string name;
  std::vector<double> values;
  bool operator==(const Channel&) const = default;
};

/// Columns over time, all of the same length. Copies share the data.
class Recording {
 public:
  /// Seals the channels. Required: `time_s`, finite and strictly increasing; equal lengths; no name twice. `name` is
  /// what errors and reports call it, usually the file's path. `notes` are the `# key: value` lines.
  static Result<Recording> seal(std::string name, std::vector<Channel> channels,
                                std::vector<std::pair<std::string, std::string>> notes = {});

  size_t rows() const;
  const std::string& name() const;
  bool has(std::string_view channel) const;
  /// The values of a channel, rows() long; empty when there is no such channel.
  std::span<const double> channel(std::string_view channel) const;
  std::span<const double> time() const;
  const std::vector<Channel>& channels() const;
  const std::vector<std::pair<std::string, std::string>>& notes() const;
  /// Median of the steps of time_s in s; 0 for fewer than two rows.
  double medianStep_s() const;

 private:
  struct Sealed;
  explicit Recording(std::shared_ptr<const Sealed> sealed);
  std::shared_ptr<const Sealed> sealed_;
};

}  // namespace breakaway
