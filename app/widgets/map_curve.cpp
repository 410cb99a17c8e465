#include "widgets/map_curve.h"

#include <QCoreApplication>

#include "base/numbers.h"
#include "widgets/number_text.h"

namespace breakaway {

QString readingOf(const MapPoint& point, const QString& unit) {
  const auto translated = [](const char* text) { return QCoreApplication::translate("MapCurve", text); };
  QString text = numberText(point.value, 4);
  if (point.standardError > 0.0)
    text += translated(QT_TRANSLATE_NOOP("MapCurve", " ± %1")).arg(numberText(normal95 * point.standardError, 2));
  text += " " + unit;
  if (point.standardError > 0.0) text += translated(QT_TRANSLATE_NOOP("MapCurve", " (95 %)"));
  if (point.outlier) text += translated(QT_TRANSLATE_NOOP("MapCurve", ", outlier"));
  return text;
}

}  // namespace breakaway
