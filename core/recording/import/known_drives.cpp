#include "recording/import/known_drives.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/numbers.h"
#include "recording/import/settle_motion.h"
#include "recording/import/tool_columns.h"

namespace breakaway {

using namespace tools;

namespace {

/// A thrust stand measures what its speed controller draws.
bool isThrustStand(const RawTable& table) {
  return std::any_of(table.columns.begin(), table.columns.end(), [](const RawColumn& column) {
    return column.channel.name.starts_with("ESC signal") || column.channel.name.starts_with("ESC throttle");
  });
}

ToolColumns thrustStand(RawTable& table) {
  table.remarks.push_back(message("recognised a thrust stand: current and voltage are those of the supply"));
  ToolColumns columns;
  for (const RawColumn& column : table.columns) {
    const ColumnName name = understandName(column.channel.name, column.unit);
    if (name.to == "current_A")
      columns[column.channel.name] = setAside(message("is the supply's current, not the motor's"));
    if (name.to == "voltage_V") columns[column.channel.name] = in("supply_V", name.scale, "V");
    if (column.channel.name.starts_with("Throttle")) columns[column.channel.name] = in("duty", 0.01, "%");
  }
  return columns;
}

/// Registers are sent without a sign.
void makeSigned(std::vector<double>& values, double bits16or32) {
  for (double& value : values) {
    if (value >= 0.5 * bits16or32) value -= bits16or32;
  }
}

ToolColumns dynamixel(RawTable& table, double countsPerRev) {
  ToolColumns columns;
  const bool others = std::any_of(table.columns.begin(), table.columns.end(), [](const RawColumn& column) {
    const auto words = wordsOf(column.channel.name, true);  // an older model's or another maker's
    return hasWord(words, "present") && hasWord(words, "speed") && column.unit.empty();
  });
  const double counts = countsPerRev > 0.0 ? countsPerRev : 4096.0;
  for (RawColumn& column : table.columns) {
    const auto words = wordsOf(column.channel.name, true);
    const bool present = hasWord(words, "present"), goal = hasWord(words, "goal");
    if ((!present && !goal) || column.fault || !column.unit.empty() || !areWhole(column.channel.values)) continue;
    auto& values = column.channel.values;
    ColumnName& to = columns[column.channel.name];
    if (hasWord(words, "position")) {
      makeSigned(values, 4294967296.0);
      to = in(present ? "angle_rad" : "angle_reference_rad", turn_rad / counts, "1/4096 turn");
    } else if (hasWord(words, "velocity")) {  // a "speed" is an older model's or another maker's: the angle tells
      makeSigned(values, 4294967296.0);
      to = in(present ? "velocity_rad_per_s" : "velocity_reference_rad_per_s", 0.229 * turn_rad / 60.0, "0.229 rpm");
    } else if (hasWord(words, "current") && others) {
      to = setAside(message("counts steps of a servo that is no X series'; say how many amperes one is with a map"));
    } else if (hasWord(words, "current")) {
      makeSigned(values, 65536.0);
      to = in(present ? "current_A" : "current_reference_A", 2.69e-3, "2.69 mA");
    } else if (hasWord(words, "pwm")) {
      makeSigned(values, 65536.0);
      to = in("duty", 1.0 / 885.0, "1/885", present ? 0 : 4);
    } else if (hasWord(words, "voltage")) {
      to = in("supply_V", 0.1, "0.1 V");
    } else {
      columns.erase(column.channel.name);
    }
  }
  if (!columns.empty())
    table.remarks.push_back(message(
        "recognised Dynamixel registers, whole numbers in an X series' units: 4096 per turn, 0.229 rpm, 2.69 mA (an "
        "XL330 has 1 mA), PWM of 885, 0.1 V; another model needs a map"));
  return columns;
}

bool isDynamixel(const RawTable& table) {
  size_t count = 0;
  double most = 0.0;
  for (const RawColumn& column : table.columns) {
    const auto words = wordsOf(column.channel.name, true);
    if (!hasWord(words, "present") || !column.unit.empty() || column.fault) continue;
    if (understandName(column.channel.name).unit.empty() && areWhole(column.channel.values)) ++count;
    if (hasWord(words, "position")) most = largest(column.channel.values);
  }
  return count >= 1 && most > 50.0;
}

/// Servo drives that call their loops by letters: position, velocity and current loop, feedback and command.
constexpr auto loopNames = std::to_array<std::pair<const char*, const char*>>({{"PL.FB", "position"},
                                                                               {"PL.CMD", "position command"},
                                                                               {"VL.FB", "velocity"},
                                                                               {"VL.CMD", "velocity command"},
                                                                               {"IL.FB", "current"},
                                                                               {"IL.CMD", "current command"},
                                                                               {"VBUS.VALUE", "supply voltage"}});

bool isAkd(const RawTable& table) {
  return std::any_of(table.columns.begin(), table.columns.end(), [](const RawColumn& column) {
    const std::string& name = column.channel.name;
    return name.starts_with("IL.FB") || name.starts_with("PL.FB") || name.starts_with("VL.FB");
  });
}

ToolColumns akd(RawTable& table) {
  ToolColumns columns;
  for (const RawColumn& column : table.columns) {
    const std::string& name = column.channel.name;
    for (const auto& [loop, words] : loopNames) {
      const std::string_view rest = std::string_view(name).substr(std::min(name.size(), std::string_view(loop).size()));
      if (name.starts_with(loop) && (rest.empty() || rest.front() == ' ' || rest.front() == '('))
        columns[name] = understandName(std::string(words) + " " + std::string(rest), column.unit);
    }
  }
  table.remarks.push_back(
      message("recognised an AKD drive's log: PL, VL and IL are its position, velocity and current loop"));
  return columns;
}

/// CiA 402, by which EtherCAT and CANopen drives speak, counts torque and current in thousandths of the rated ones.
bool isCia402(const RawTable& table) {
  return std::any_of(table.columns.begin(), table.columns.end(), [](const RawColumn& column) {
    std::string name;
    for (const std::string& word : wordsOf(column.channel.name, true)) name += word;
    return name.find("statusword") != std::string::npos || name.find("controlword") != std::string::npos;
  });
}

ToolColumns cia402(RawTable& table) {
  ToolColumns columns;
  for (const RawColumn& column : table.columns) {
    const ColumnName name = understandName(column.channel.name, column.unit);
    const bool rated = name.to == "torque_Nm" || name.to == "current_A" || name.to == "current_reference_A";
    if (rated && name.unit.empty() && !column.fault && areWhole(column.channel.values))
      columns[column.channel.name] =
          setAside(message("counts thousandths of the drive's rated value, which no file says: map it with \"scale\""));
  }
  if (!columns.empty())
    table.remarks.push_back(
        message("recognised a drive's CiA 402 objects by its status word: torque and current in "
                "thousandths of the rated ones"));
  return columns;
}

/// ST's motor control counts speeds in rpm; currents are in A, or in steps of its converter where they are whole.
bool isStMotorControl(const RawTable& table) {
  return std::any_of(table.columns.begin(), table.columns.end(),
                     [](const RawColumn& column) { return column.channel.name.starts_with("SPEED_MEAS"); });
}

ToolColumns stMotorControl(RawTable& table) {
  ToolColumns columns;
  for (const RawColumn& column : table.columns) {
    const ColumnName name = understandName(column.channel.name, column.unit);
    const bool speed = name.to == "velocity_rad_per_s" || name.to == "velocity_reference_rad_per_s";
    const bool electrical = name.to.starts_with("current_") || name.to == "voltage_V";
    if (!name.understood() || !name.unit.empty()) continue;
    if (speed) columns[column.channel.name] = in(name.to, turn_rad / 60.0, "rpm", name.rank);
    if (electrical && areWhole(column.channel.values) && largest(column.channel.values) > 1.0)
      columns[column.channel.name] =
          setAside(message("counts steps of the converter, which no file says: map it with \"scale\""));
  }
  table.remarks.push_back(message("recognised ST's motor control by its registers: speeds in rpm"));
  return columns;
}

constexpr auto armJoints = std::to_array<const char*>({"shoulder", "elbow", "wrist", "gripper"});

/// LeRobot keeps joints in degrees or in hundredths of their range, by the robot's settings.
bool isLerobot(const RawTable& table) {
  return std::count_if(table.columns.begin(), table.columns.end(), [](const RawColumn& column) {
           const std::string& name = column.channel.name;
           const bool joint = std::any_of(armJoints.begin(), armJoints.end(),
                                          [&name](const char* part) { return name.find(part) != std::string::npos; });
           return joint && name.ends_with(".pos");
         }) > 1;
}

ToolColumns lerobot(const RawTable& table) {
  ToolColumns columns;
  for (const RawColumn& column : table.columns) {
    const bool speed = column.channel.name.ends_with(".vel") && column.unit.empty();
    if (column.channel.name.ends_with(".pos") || speed)
      columns[column.channel.name] =
          setAside(message("is in degrees or in hundredths of the joint's range: name its unit in a map"));
  }
  return columns;
}

}  // namespace

std::optional<ToolColumns> recogniseDrive(RawTable& table, double countsPerRev) {
  if (isDynamixel(table)) return dynamixel(table, countsPerRev);
  if (isThrustStand(table)) return thrustStand(table);
  if (isAkd(table)) return akd(table);
  if (isCia402(table)) return cia402(table);
  if (isStMotorControl(table)) return stMotorControl(table);
  if (isLerobot(table)) return lerobot(table);
  return std::nullopt;
}

}  // namespace breakaway
