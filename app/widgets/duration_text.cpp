#include "widgets/duration_text.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace breakaway {

QString durationText(double duration_s) {
  const auto translated = [](const char* text) { return QCoreApplication::translate("Duration", text); };
  const auto whole = std::lround(std::clamp(duration_s, 0.0, 1e9));
  if (whole < 60) return translated(QT_TRANSLATE_NOOP("Duration", "%1 s")).arg(whole);
  if (whole < 3600) return translated(QT_TRANSLATE_NOOP("Duration", "%1 min %2 s")).arg(whole / 60).arg(whole % 60);
  return translated(QT_TRANSLATE_NOOP("Duration", "%1 h %2 min")).arg(whole / 3600).arg(whole / 60 % 60);
}

}  // namespace breakaway
