// Numbers as people read them: three significant digits, no minus before a zero, and as many digits in a value as its
// interval is worth.
#pragma once

#include <QString>

#include "base/estimate.h"

namespace breakaway {

/// "0.388", "14.2", "1030": `digits` significant ones, never an exponent between 1e-4 and 1e6; "0" for zero.
QString numberText(double value, int digits = 3);
/// For a number that changes while one looks: decimals by `scale`, a difference that still matters, so that its width
/// stays; "0.00", never "-0.00".
QString steadyNumber(double value, double scale);
/// "± 0.07": half of the 95 % interval, two digits.
QString intervalText(double standardError, double scale = 1.0);
/// "17.00 ± 0.07 mNm": both to the same place; without a standard error the value alone.
QString estimateText(const Estimate& estimate, double scale, const QString& unit);

}  // namespace breakaway
