// The part of effects that remember: a temperature, a load's place.
#pragma once

#include <cstddef>
#include <span>

#include "diagnose/model/situation.h"

namespace breakaway {

/// Numbers that a simulation carries along for an effect; all start at 0.
class HiddenState {
 public:
  /// How many, at most 4.
  virtual size_t size() const = 0;
  /// Advances them over dt_s that ended in `at`, whose `memory` is the state before. Must be stable for any dt_s up to
  /// Effect::longestStep_s().
  virtual void remember(std::span<const double> p, const Situation& at, double dt_s,
                        std::span<double> memory) const = 0;

 protected:
  ~HiddenState() = default;
};

}  // namespace breakaway
