// Numbers as people read them: three significant digits, no minus before a zero, and as many digits in a value as its
// interval is worth.
#pragma once

#include <QString>
#include <optional>

#include "base/estimate.h"

namespace breakaway {

/// "0.388", "14.2", "1030": `digits` significant ones, never an exponent between 1e-4 and 1e6; "0" for zero.
QString numberText(double value, int digits = 3);
/// A number that somebody set or that is known exactly: no more digits than it has, "24", "0.02", "14 400".
QString plainText(double value, int digits = 4);
/// With so many decimals, "−0.25".
QString fixedText(double value, int decimals);
/// base/typeset.h: with minus signs, groups of three digits, powers of ten.
QString typeset(const QString& number);
/// What somebody typed, or typeset() made, as a number: a decimal comma is a point. Nothing if it is none.
std::optional<double> numberIn(const QString& text);
/// For a number that changes while one looks: decimals by `scale`, a difference that still matters, so that its width
/// stays; "0.00", never "-0.00".
QString steadyNumber(double value, double scale);
/// "± 0.07": half of the 95 % interval, two digits.
QString intervalText(double standardError, double scale = 1.0);
/// "17.00 ± 0.07 mNm": both to the same place; without a standard error the value alone.
QString estimateText(const Estimate& estimate, double scale, const QString& unit);

}  // namespace breakaway
