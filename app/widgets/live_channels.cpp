#include "widgets/live_channels.h"

#include <QCoreApplication>
#include <numbers>

namespace breakaway {

namespace {

constexpr double channelDegree = 180.0 / std::numbers::pi;

QString channelWords(const char* text) {
  return QCoreApplication::translate("LiveChannel", text);
}

}  // namespace

std::array<LiveChannel, 4> liveChannels(bool linear) {
  if (linear)
    return {{{channelWords(QT_TRANSLATE_NOOP("LiveChannel", "Position")),
              channelWords(QT_TRANSLATE_NOOP("LiveChannel", "mm")), 1e3, 1.0, 3, &Sample::angle_rad},
             {channelWords(QT_TRANSLATE_NOOP("LiveChannel", "Speed")),
              channelWords(QT_TRANSLATE_NOOP("LiveChannel", "mm/s")), 1e3, 5.0, 2, &Sample::velocity_rad_per_s},
             {channelWords(QT_TRANSLATE_NOOP("LiveChannel", "Current")),
              channelWords(QT_TRANSLATE_NOOP("LiveChannel", "A")), 1.0, 0.2, 3, &Sample::current_A},
             {channelWords(QT_TRANSLATE_NOOP("LiveChannel", "Disturbance")),
              channelWords(QT_TRANSLATE_NOOP("LiveChannel", "N")), 1.0, 2.0, 2, &Sample::disturbance_estimate_Nm}}};
  return {{{channelWords(QT_TRANSLATE_NOOP("LiveChannel", "Angle")),
            channelWords(QT_TRANSLATE_NOOP("LiveChannel", "°")), channelDegree, 10.0, 2, &Sample::angle_rad},
           {channelWords(QT_TRANSLATE_NOOP("LiveChannel", "Speed")),
            channelWords(QT_TRANSLATE_NOOP("LiveChannel", "rad/s")), 1.0, 1.0, 2, &Sample::velocity_rad_per_s},
           {channelWords(QT_TRANSLATE_NOOP("LiveChannel", "Current")),
            channelWords(QT_TRANSLATE_NOOP("LiveChannel", "A")), 1.0, 0.2, 3, &Sample::current_A},
           {channelWords(QT_TRANSLATE_NOOP("LiveChannel", "Disturbance")),
            channelWords(QT_TRANSLATE_NOOP("LiveChannel", "mNm")), 1e3, 10.0, 2, &Sample::disturbance_estimate_Nm}}};
}

std::vector<LiveChannel> boardChannels(bool linear) {
  const auto shown = liveChannels(linear);
  std::vector<LiveChannel> all(shown.begin(), shown.end());
  const auto add = [&](const char* name, const LiveChannel& like, double Sample::*value) {
    all.push_back(like);
    all.back().name = channelWords(name);
    all.back().value = value;
  };
  const LiveChannel volts{{}, channelWords(QT_TRANSLATE_NOOP("LiveChannel", "V")), 1.0, 0.5, 2, nullptr};
  add(QT_TRANSLATE_NOOP("LiveChannel", "Voltage"), volts, &Sample::voltage_V);
  add(QT_TRANSLATE_NOOP("LiveChannel", "Supply"), volts, &Sample::supply_V);
  add(linear ? QT_TRANSLATE_NOOP("LiveChannel", "Position asked for")
             : QT_TRANSLATE_NOOP("LiveChannel", "Angle asked for"),
      shown[0], &Sample::angle_reference_rad);
  add(QT_TRANSLATE_NOOP("LiveChannel", "Speed asked for"), shown[1], &Sample::velocity_reference_rad_per_s);
  add(QT_TRANSLATE_NOOP("LiveChannel", "Current asked for"), shown[2], &Sample::current_reference_A);
  return all;
}

}  // namespace breakaway
