#include "widgets/live_channels.h"

#include <QCoreApplication>
#include <numbers>

namespace breakaway {

std::array<LiveChannel, 4> liveChannels(bool linear) {
  const auto translated = [](const char* text) { return QCoreApplication::translate("LiveChannel", text); };
  constexpr double degree = 180.0 / std::numbers::pi;
  if (linear)
    return {{{translated(QT_TRANSLATE_NOOP("LiveChannel", "Position")),
              translated(QT_TRANSLATE_NOOP("LiveChannel", "mm")), 1e3, 1.0, 3, &Sample::angle_rad},
             {translated(QT_TRANSLATE_NOOP("LiveChannel", "Speed")),
              translated(QT_TRANSLATE_NOOP("LiveChannel", "mm/s")), 1e3, 5.0, 2, &Sample::velocity_rad_per_s},
             {translated(QT_TRANSLATE_NOOP("LiveChannel", "Current")),
              translated(QT_TRANSLATE_NOOP("LiveChannel", "A")), 1.0, 0.2, 3, &Sample::current_A},
             {translated(QT_TRANSLATE_NOOP("LiveChannel", "Disturbance")),
              translated(QT_TRANSLATE_NOOP("LiveChannel", "N")), 1.0, 2.0, 2, &Sample::disturbance_estimate_Nm}}};
  return {{{translated(QT_TRANSLATE_NOOP("LiveChannel", "Angle")), translated(QT_TRANSLATE_NOOP("LiveChannel", "°")),
            degree, 10.0, 2, &Sample::angle_rad},
           {translated(QT_TRANSLATE_NOOP("LiveChannel", "Speed")),
            translated(QT_TRANSLATE_NOOP("LiveChannel", "rad/s")), 1.0, 1.0, 2, &Sample::velocity_rad_per_s},
           {translated(QT_TRANSLATE_NOOP("LiveChannel", "Current")), translated(QT_TRANSLATE_NOOP("LiveChannel", "A")),
            1.0, 0.2, 3, &Sample::current_A},
           {translated(QT_TRANSLATE_NOOP("LiveChannel", "Disturbance")),
            translated(QT_TRANSLATE_NOOP("LiveChannel", "mNm")), 1e3, 10.0, 2, &Sample::disturbance_estimate_Nm}}};
}

}  // namespace breakaway
