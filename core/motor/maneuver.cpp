#include "motor/maneuver.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"

namespace breakaway {

namespace {

constexpr double turnAround_s = 0.2;  // from one way to the other

void hold(Maneuver& motion, double speed, double duration_s) {
  const double before = motion.empty() ? 0.0 : motion.back().to;
  motion.push_back({ManeuverStretch::Of::speed, turnAround_s, before, speed});
  motion.push_back({ManeuverStretch::Of::speed, duration_s, speed, speed});
}

void comeToRest(Maneuver& motion) {
  hold(motion, 0.0, turnAround_s);
}

void current(Maneuver& motion, double from_A, double to_A, double duration_s) {
  motion.push_back({ManeuverStretch::Of::current, duration_s, from_A, to_A});
}

}  // namespace

double ManeuverStretch::at(double time_s) const {
  const double part = duration_s > 0.0 ? std::clamp(time_s / duration_s, 0.0, 1.0) : 1.0;
  const double value = from + (to - from) * part;
  if (!(high_Hz > 0.0)) return value;
  return value * std::sin(turn_rad * (low_Hz + 0.5 * (high_Hz - low_Hz) * part) * time_s);
}

double durationOf(const Maneuver& motion) {
  double sum_s = 0.0;
  for (const ManeuverStretch& stretch : motion) sum_s += stretch.duration_s;
  return sum_s;
}

Maneuver operator+(Maneuver first, const Maneuver& then) {
  first.insert(first.end(), then.begin(), then.end());
  return first;
}

Maneuver speedsBothWays(std::initializer_list<double> speeds, double way) {
  Maneuver motion;
  for (const double speed : speeds) {
    if (!(speed > 0.0)) continue;
    const double each_s = std::clamp(way / speed, 1.0, 20.0);
    hold(motion, speed, each_s);
    hold(motion, -speed, each_s);
  }
  comeToRest(motion);
  return motion;
}

Maneuver reversals(double speed, int count, double each_s) {
  Maneuver motion;
  for (int k = 0; k < count; ++k) hold(motion, k % 2 == 0 ? speed : -speed, each_s);
  comeToRest(motion);
  return motion;
}

Maneuver throughStandstill(double speed, int times, double each_s) {
  Maneuver motion;
  hold(motion, speed, 0.5);
  for (int k = 0; k < times; ++k) {
    const double sign = k % 2 == 0 ? 1.0 : -1.0;
    motion.push_back({ManeuverStretch::Of::speed, each_s, sign * speed, -sign * speed});
  }
  comeToRest(motion);
  return motion;
}

Maneuver startsFromRest(double speed, std::initializer_list<double> rests_s, int count) {
  Maneuver motion;
  for (int k = 0; k < count; ++k) {
    const double rest_s = *(rests_s.begin() + k % static_cast<int>(rests_s.size()));
    const double sign = k % 2 == 0 ? 1.0 : -1.0;
    hold(motion, 0.0, rest_s);
    motion.push_back({ManeuverStretch::Of::speed, 1.0, 0.0, sign * speed});
    motion.push_back({ManeuverStretch::Of::speed, 0.5, sign * speed, sign * speed});
  }
  comeToRest(motion);
  return motion;
}

Maneuver currentPulses(std::initializer_list<double> currents_A, double each_s, double rest_s) {
  Maneuver motion;
  for (const double level_A : currents_A) {
    for (const double sign : {1.0, -1.0, -1.0, 1.0}) current(motion, sign * level_A, sign * level_A, each_s);
    current(motion, 0.0, 0.0, rest_s);
  }
  return motion;
}

Maneuver currentRamps(double peak_A, int times, double each_s) {
  Maneuver motion;
  for (int k = 0; k < times; ++k) {
    const double sign = k % 2 == 0 ? 1.0 : -1.0;
    current(motion, 0.0, sign * peak_A, 0.5 * each_s);
    current(motion, sign * peak_A, 0.0, 0.5 * each_s);
  }
  return motion;
}

Maneuver currentChirp(double amplitude_A, double low_Hz, double high_Hz, double duration_s) {
  return {{ManeuverStretch::Of::current, duration_s, amplitude_A, amplitude_A, low_Hz, high_Hz}};
}

}  // namespace breakaway
