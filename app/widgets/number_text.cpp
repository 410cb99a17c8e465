#include "widgets/number_text.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "base/typeset.h"

namespace breakaway {

namespace {

/// Decimals with which the number has so many significant digits.
int decimalsFor(double value, int digits) {
  if (value == 0.0 || !std::isfinite(value)) return 0;
  return std::clamp(digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value)))), 0, 12);
}

}  // namespace

QString typeset(const QString& number) {
  return QString::fromStdString(typeset(std::string_view(number.toStdString())));
}

std::optional<double> numberIn(const QString& text) {
  static const QString raised = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
  QString plain = text.trimmed().replace(',', '.').replace(QChar(0x2212), '-').remove(QChar(0x202f));
  if (plain.contains(QStringLiteral("·10"))) {
    plain.replace(QStringLiteral("·10"), "e").replace(QStringLiteral("⁻"), "-");
    for (int digit = 0; digit < raised.size(); ++digit) plain.replace(raised[digit], QChar('0' + digit));
  }
  bool number = false;
  const double value = plain.toDouble(&number);
  return number ? std::optional(value) : std::nullopt;
}

QString fixedText(double value, int decimals) {
  QString text = QString::number(value, 'f', decimals);
  if (text.startsWith('-') && text.toDouble() == 0.0) text.remove(0, 1);
  return typeset(text);
}

QString numberText(double value, int digits) {
  if (!std::isfinite(value)) return QStringLiteral("–");
  const double size = std::abs(value);
  if (size != 0.0 && (size < 1e-4 || size >= 1e6)) return typeset(QString::number(value, 'g', digits));
  return fixedText(value, decimalsFor(value, digits));
}

QString plainText(double value, int digits) {
  if (!std::isfinite(value)) return QStringLiteral("–");
  const double size = std::abs(value);
  const bool whole = value == std::round(value) && size < 1e6;
  return typeset(whole ? QString::number(value, 'f', 0) : QString::number(value, 'g', digits));
}

QString steadyNumber(double value, double scale) {
  if (!std::isfinite(value)) return QStringLiteral("–");
  return fixedText(value, decimalsFor(scale, 2) + 1);
}

QString intervalText(double standardError, double scale) {
  return QStringLiteral("± ") + numberText(normal95 * standardError * std::abs(scale), 2);
}

QString estimateText(const Estimate& estimate, double scale, const QString& unit) {
  const double value = scale * estimate.value, half = normal95 * std::abs(scale) * estimate.standardError;
  if (!(half > 0.0)) return numberText(value) + " " + unit;
  // Both to the same place: three digits of the value, one of the interval at least, three of it at most.
  const int decimals = std::min(decimalsFor(half, 3), std::max(decimalsFor(value, 3), decimalsFor(half, 1)));
  return fixedText(value, decimals) + " ± " + fixedText(half, decimals) + " " + unit;
}

}  // namespace breakaway
