#include "recording/import/plausible.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/numbers.h"
#include "recording/import/number_text.h"

namespace breakaway {

namespace {

/// Speeds of the rows; NaN where unknown.
std::vector<double> speedOf(const Recording& recording) {
  for (const char* name : {"velocity_rad_per_s", "velocity_m_per_s"}) {
    if (!recording.has(name)) continue;
    const auto speed = recording.channel(name);
    return {speed.begin(), speed.end()};
  }
  const auto position = recording.channel(recording.has("angle_rad") ? "angle_rad" : "position_m");
  const auto time = recording.time();
  const size_t rows = recording.rows(),
               reach = std::min<size_t>(5, rows / 20);  // over several rows: encoders are coarse
  std::vector<double> speed(rows, std::numeric_limits<double>::quiet_NaN());
  for (size_t k = reach; k + reach < rows && reach > 0; ++k)
    speed[k] = (position[k + reach] - position[k - reach]) / (time[k + reach] - time[k - reach]);
  return speed;
}

struct Agreement {
  double correlation = 0.0;  ///< of drive and speed, about 0
  double forward = 0.0;      ///< part of the way that goes forward
  bool oneSign = false;      ///< the drive's
};

Agreement agreementOf(const Recording& recording, std::span<const double> drive, const std::vector<double>& speed) {
  double both = 0.0, drives = 0.0, speeds = 0.0, way = 0.0, forward = 0.0, low = 0.0, high = 0.0;
  const auto time = recording.time();
  for (size_t k = 0; k + 1 < drive.size(); ++k) {
    if (!std::isfinite(drive[k]) || !std::isfinite(speed[k])) continue;
    both += drive[k] * speed[k];
    drives += drive[k] * drive[k];
    speeds += speed[k] * speed[k];
    const double step = std::abs(speed[k]) * (time[k + 1] - time[k]);
    way += step;
    forward += speed[k] > 0.0 ? step : 0.0;
    low = std::min(low, drive[k]);
    high = std::max(high, drive[k]);
  }
  if (!(drives > 0.0) || !(speeds > 0.0) || !(way > 0.0)) return {0.0, 1.0, false};
  return {both / std::sqrt(drives * speeds), forward / way, low > -0.01 * high || high < -0.01 * low};
}

}  // namespace

std::vector<Message> contradictionsIn(const Recording& recording) {
  constexpr double against = -0.3;  // the axis gives energy back
  constexpr double oneWay = 0.2;    // of the way
  constexpr double fastest_rad_per_s = 20000.0;
  constexpr size_t fewestRows = 50;
  std::vector<Message> out;
  if (recording.rows() < fewestRows) return out;
  const std::vector<double> speed = speedOf(recording);
  for (const char* name : {"voltage_V", "duty", "current_A", "torque_Nm", "force_N"}) {
    if (!recording.has(name)) continue;
    const Agreement agreement = agreementOf(recording, recording.channel(name), speed);
    const std::string turned = std::string("{\"sign\": {\"") + name + "\": -1}}";
    if (agreement.correlation < against) {
      out.push_back(
          message("implausible: the axis moves against {} most of the time; unless a load drives it, one of the two "
                  "has the wrong sign: {}",
                  name, turned));
    } else if (agreement.oneSign && agreement.forward > oneWay && agreement.forward < 1.0 - oneWay) {
      out.push_back(
          message("implausible: {} never changes its sign although the axis moves both ways; a column of its direction "
                  "is missing",
                  name));
    }
  }
  double most = 0.0;
  if (recording.has("angle_rad") || recording.has("velocity_rad_per_s")) {
    for (const double value : speed) most = std::isfinite(value) ? std::max(most, std::abs(value)) : most;
  }
  if (most > fastest_rad_per_s)
    out.push_back(
        message("implausible: it would turn with up to {} rad/s; the unit of the time, the angle or the speed is wrong",
                shortText(most)));
  return out;
}

}  // namespace breakaway
