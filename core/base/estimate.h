// No number without its doubt.
#pragma once

#include "base/numbers.h"

namespace breakaway {

/// A quantity with its standard error, in the quantity's own SI unit; the interval assumes a normal error.
struct Estimate {
  double value = 0.0;
  double standardError = 0.0;

  double low95() const { return value - normal95 * standardError; }
  double high95() const { return value + normal95 * standardError; }
  bool operator==(const Estimate&) const = default;
};

}  // namespace breakaway
