#include "motor/servo_law.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace breakaway {

namespace {

constexpr std::array<ServoNames, 8> names{
    {{Axis::rotary, DriveInput::torque, "kp_Nm_per_rad", "kd_Nm_s_per_rad", "torque_limit_Nm"},
     {Axis::rotary, DriveInput::current, "kp_A_per_rad", "kd_A_s_per_rad", "current_limit_A"},
     {Axis::rotary, DriveInput::voltage, "kp_V_per_rad", "kd_V_s_per_rad", "voltage_limit_V"},
     {Axis::rotary, DriveInput::duty, "kp_duty_per_rad", "kd_duty_s_per_rad", "duty_limit"},
     {Axis::linear, DriveInput::torque, "kp_N_per_m", "kd_N_s_per_m", "force_limit_N"},
     {Axis::linear, DriveInput::current, "kp_A_per_m", "kd_A_s_per_m", "current_limit_A"},
     {Axis::linear, DriveInput::voltage, "kp_V_per_m", "kd_V_s_per_m", "voltage_limit_V"},
     {Axis::linear, DriveInput::duty, "kp_duty_per_m", "kd_duty_s_per_m", "duty_limit"}}};

}  // namespace

const ServoNames& servoNames(DriveInput output, Axis axis) {
  return *std::find_if(names.begin(), names.end(),
                       [=](const ServoNames& one) { return one.output == output && one.axis == axis; });
}

std::vector<ServoNames> servoNamesOf(Axis axis) {
  std::vector<ServoNames> own;
  std::copy_if(names.begin(), names.end(), std::back_inserter(own),
               [axis](const ServoNames& one) { return one.axis == axis; });
  return own;
}

}  // namespace breakaway
