// A servo's own position loop, for recordings that hold what it was asked for in place of what drove it.
#pragma once

#include <optional>
#include <vector>

#include "base/axis.h"

namespace breakaway {

enum class DriveInput { voltage, duty, current, torque };  ///< `torque` is force on a linear axis

/// drive = kp·(reference − position) − kd·velocity (+ kd·velocity reference), clipped at the limit, computed rate_Hz
/// times a second, acting delay_s later. The drive is what Bench::input says: torque, current, duty or voltage. Missing
/// values are fitted; without a limit nothing clips, without a rate the law acts at every instant.
struct ServoLaw {
  std::optional<double> kp = {}, kd = {}, limit = {};  ///< per rad or m, per rad/s or m/s, of the drive
  std::optional<double> rate_Hz = {}, delay_s = {};
};

/// The names of a law's values, by what it gives out; in a bench file within `controller`, in models among the base.
struct ServoNames {
  Axis axis;
  DriveInput output;
  const char *kp, *kd, *limit;
};
const ServoNames& servoNames(DriveInput output, Axis axis);
std::vector<ServoNames> servoNamesOf(Axis axis);

constexpr const char* servoDelayName = "delay_s";

}  // namespace breakaway
