#include "widgets/number_text.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"

namespace breakaway {

namespace {

/// Decimals with which the number has so many significant digits.
int decimalsFor(double value, int digits) {
  if (value == 0.0 || !std::isfinite(value)) return 0;
  return std::clamp(digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value)))), 0, 12);
}

QString fixed(double value, int decimals) {
  QString text = QString::number(value, 'f', decimals);
  if (text.startsWith('-') && text.toDouble() == 0.0) text.remove(0, 1);
  return text;
}

}  // namespace

QString numberText(double value, int digits) {
  if (!std::isfinite(value)) return QStringLiteral("–");
  const double size = std::abs(value);
  if (size != 0.0 && (size < 1e-4 || size >= 1e6)) return QString::number(value, 'g', digits);
  return fixed(value, decimalsFor(value, digits));
}

QString steadyNumber(double value, double scale) {
  if (!std::isfinite(value)) return QStringLiteral("–");
  return fixed(value, decimalsFor(scale, 2) + 1);
}

QString intervalText(double standardError, double scale) {
  return QStringLiteral("± ") + numberText(normal95 * standardError * std::abs(scale), 2);
}

QString estimateText(const Estimate& estimate, double scale, const QString& unit) {
  const double value = scale * estimate.value, half = normal95 * std::abs(scale) * estimate.standardError;
  if (!(half > 0.0)) return numberText(value) + " " + unit;
  // Both to the same place: three digits of the value, one of the interval at least, three of it at most.
  const int decimals = std::min(decimalsFor(half, 3), std::max(decimalsFor(value, 3), decimalsFor(half, 1)));
  return fixed(value, decimals) + " ± " + fixed(half, decimals) + " " + unit;
}

}  // namespace breakaway
