#include "widgets/live_channels.h"

#include <QCoreApplication>
#include <numbers>

namespace breakaway {

std::array<LiveChannel, 4> liveChannels(bool linear) {
  const auto translated = [](const char* text) { return QCoreApplication::translate("LiveChannel", text); };
  constexpr double degree = 180.0 / std::numbers::pi;
  if (linear)
    return {{{translated("Position"), translated("mm"), 1e3, 1.0, 3, &Sample::angle_rad},
             {translated("Speed"), translated("mm/s"), 1e3, 5.0, 2, &Sample::velocity_rad_per_s},
             {translated("Current"), translated("A"), 1.0, 0.2, 3, &Sample::current_A},
             {translated("Disturbance"), translated("N"), 1.0, 2.0, 2, &Sample::disturbance_estimate_Nm}}};
  return {{{translated("Angle"), translated("°"), degree, 10.0, 2, &Sample::angle_rad},
           {translated("Speed"), translated("rad/s"), 1.0, 1.0, 2, &Sample::velocity_rad_per_s},
           {translated("Current"), translated("A"), 1.0, 0.2, 3, &Sample::current_A},
           {translated("Disturbance"), translated("mNm"), 1e3, 10.0, 2, &Sample::disturbance_estimate_Nm}}};
}

}  // namespace breakaway
