#include "recording/import/known_tools.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <functional>
#include <optional>
#include <set>
#include <utility>

#include "base/numbers.h"
#include "recording/import/known_scopes.h"
#include "recording/import/settle_motion.h"

namespace breakaway {

namespace {

const RawColumn* find(const RawTable& table, std::string_view name) {
  const auto it = std::find_if(table.columns.begin(), table.columns.end(),
                               [name](const RawColumn& one) { return isSameWord(one.channel.name, name); });
  return it == table.columns.end() ? nullptr : &*it;
}

bool hasAll(const RawTable& table, std::initializer_list<std::string_view> names) {
  return std::all_of(names.begin(), names.end(), [&](std::string_view name) { return find(table, name) != nullptr; });
}

bool hasWord(const std::vector<std::string>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

ColumnName in(std::string to, double scale, const char* unit, int rank = 0, UnitNeeds needs = UnitNeeds::nothing) {
  ColumnName name;
  name.to = std::move(to);
  name.scale = scale;
  name.unit = unit;
  name.rank = rank;
  name.needs = needs;
  return name;
}

ColumnName setAside(Message why) {
  ColumnName name;
  name.aside = std::move(why);
  return name;
}

bool isVesc(const RawTable& table) {
  return find(table, "ms_today") != nullptr && (find(table, "erpm") != nullptr || find(table, "tachometer") != nullptr);
}

ToolColumns vesc(RawTable& table) {
  table.remarks.push_back(
      message("recognised VESC Tool's log: the tachometer counts 6 steps per electrical turn, erpm electrical turns"));
  return {{"ms_today", in("time_s", 1e-3, "ms")},
          {"ms_today_setup", setAside(message("is the clock of another block of values"))},
          {"tachometer", in("angle_rad", turn_rad / 6.0, "steps of 1/6 electrical turn", 0, UnitNeeds::polePairs)},
          {"tachometer_abs", setAside(message("counts both ways up"))},
          {"tacho", in("angle_rad", turn_rad / 6.0, "steps of 1/6 electrical turn", 0, UnitNeeds::polePairs)},
          {"encoder_position", in("angle_rad", turn_rad / 360.0, "deg", 8)},
          {"erpm", in("velocity_rad_per_s", turn_rad / 60.0, "erpm", 0, UnitNeeds::polePairs)},
          {"q_axis_current", in("current_A", 1.0, "A")},
          {"current_motor", in("current_A", 1.0, "A", 1)},
          {"current_in", setAside(message("is the supply's current, not the motor's"))},
          {"duty_cycle", in("duty", 1.0, "1")},
          {"input_voltage", in("supply_V", 1.0, "V")},
          {"q_axis_voltage", in("voltage_V", 1.0, "V", 1)},
          {"temp_motor", in("temperature_degC", 1.0, "°C")},
          {"speed_meters_per_sec", setAside(message("is the vehicle's speed, by VESC Tool's settings"))}};
}

/// "dutycyclenow" of "vesc.dutyCycleNow" and "duty_cycle_now".
std::string lastName(const std::string& name) {
  std::string text;
  const size_t from = name.find_last_of("./");
  for (const char c : name.substr(from == std::string::npos ? 0 : from + 1)) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return text;
}

/// What libraries and ROS' driver call a VESC's values; their rpm and speed count electrical turns.
ToolColumns vescNames() {
  const ColumnName erpm = in("velocity_rad_per_s", turn_rad / 60.0, "erpm", 0, UnitNeeds::polePairs);
  const ColumnName tachometer =
      in("angle_rad", turn_rad / 6.0, "steps of 1/6 electrical turn", 0, UnitNeeds::polePairs);
  const ColumnName ofSupply = setAside(message("is the supply's current, not the motor's"));
  const ColumnName current = in("current_A", 1.0, "A", 1), duty = in("duty", 1.0, "1"),
                   supply = in("supply_V", 1.0, "V");
  return {{"rpm", erpm},
          {"erpm", erpm},
          {"speed", erpm},
          {"tachometer", tachometer},
          {"displacement", tachometer},
          {"tachometerabs", setAside(message("counts both ways up"))},
          {"tach", tachometer},
          {"tachabs", setAside(message("counts both ways up"))},
          {"imotor", current},
          {"iin", ofSupply},
          {"vbat", supply},
          {"tmotor", in("temperature_degC", 1.0, "°C")},
          {"distancetraveled", setAside(message("counts both ways up"))},
          {"avgmotorcurrent", current},
          {"currentmotor", current},
          {"motorcurrent", current},
          {"avgiq", in("current_A", 1.0, "A")},
          {"avgid", setAside(message("is the d axis, which makes no torque"))},
          {"avginputcurrent", ofSupply},
          {"currentinput", ofSupply},
          {"inputcurrent", ofSupply},
          {"dutycyclenow", duty},
          {"dutynow", duty},
          {"dutycycle", duty},
          {"inpvoltage", supply},
          {"vin", supply},
          {"voltageinput", supply},
          {"inputvoltage", supply},
          {"tempmotor", in("temperature_degC", 1.0, "°C")}};
}

bool isVescValues(const RawTable& table) {
  std::set<std::string> names;
  for (const RawColumn& column : table.columns) names.insert(lastName(column.channel.name));
  const auto has = [&names](const char* name) { return names.contains(name); };
  const bool library = (has("avgmotorcurrent") || has("dutycyclenow") || has("dutynow") || has("avginputcurrent")) &&
                       (has("rpm") || has("tachometer"));
  const bool shortened = has("tachabs") && has("tach") && has("rpm");
  const bool ros = has("currentmotor") && has("currentinput") && has("dutycycle") && has("speed");
  return library || ros || shortened;
}

ToolColumns vescValues(RawTable& table) {
  table.remarks.push_back(message("recognised a VESC's values by their names: rpm and speed count electrical turns"));
  const ToolColumns known = vescNames();
  ToolColumns columns;
  for (const RawColumn& column : table.columns) {
    const auto it = known.find(lastName(column.channel.name));
    if (it != known.end()) columns[column.channel.name] = it->second;
  }
  return columns;
}

/// Turns for all that moves in this table and whose name tells no unit.
ToolColumns inTurns(const RawTable& table, const std::function<bool(const std::string&)>& belongs) {
  ToolColumns columns;
  for (const RawColumn& column : table.columns) {
    ColumnName name = understandName(column.channel.name, column.unit);
    if (!belongs(column.channel.name) || !name.understood() || !name.unit.empty()) continue;
    const bool position = name.to == "angle_rad" || name.to == "angle_reference_rad";
    const bool velocity = name.to == "velocity_rad_per_s" || name.to == "velocity_reference_rad_per_s";
    if (!position && !velocity) continue;
    name.scale = turn_rad;
    name.unit = position ? "turns" : "turns/s";
    columns[column.channel.name] = name;
  }
  return columns;
}

/// By its current's name alone only where no motion beside it tells a unit of its own, "turns" beside an "angle", and
/// only one angle is there.
bool isOdrive(const RawTable& table) {
  bool motion = false, current = false, told = false;
  size_t angles = 0;
  for (const RawColumn& column : table.columns) {
    const std::string& name = column.channel.name;
    const auto has = [&name](const char* part) { return name.find(part) != std::string::npos; };
    motion = motion || has("pos_estimate") || has("vel_estimate") || has("pos_vel_mapper");
    current = current || has("Iq_measured") || has("iq_measured");
    const ColumnName known = understandName(name, column.unit);
    angles += known.to == "angle_rad" ? 1 : 0;
    told = told || ((known.to == "angle_rad" || known.to == "velocity_rad_per_s") && !known.unit.empty());
  }
  return motion || (current && !told && angles < 2);
}

ToolColumns odrive(RawTable& table) {
  ToolColumns columns = inTurns(table, [](const std::string&) { return true; });
  constexpr double fastest_turns_per_s = 1000.0;
  bool counts = false;
  for (const RawColumn& column : table.columns) {
    const auto it = columns.find(column.channel.name);
    if (it == columns.end() || it->second.unit != "turns/s") continue;
    counts = counts || largest(column.channel.values) > fastest_turns_per_s;
  }
  if (counts) {
    for (auto& [name, column] : columns) {
      column.needs = UnitNeeds::countsPerRev;
      column.unit = column.unit == "turns" ? "counts" : "counts/s";
    }
  }
  for (const RawColumn& column : table.columns) {
    const std::string& name = column.channel.name;
    if (name.find("pos_estimate_counts") != std::string::npos || name.find("shadow_count") != std::string::npos)
      columns[name] = in("angle_rad", turn_rad, "counts", 3, UnitNeeds::countsPerRev);
    if (name.find("_cpr") != std::string::npos || name.find("pos_circular") != std::string::npos)
      columns[name] = setAside(message("starts anew with each turn"));
  }
  table.remarks.push_back(
      counts ? message("recognised an ODrive's log: positions in counts, as firmware before 0.5 has them")
             : message("recognised an ODrive's log: positions in turns, speeds in turns per second"));
  return columns;
}

/// CTRE's motors, by the names that their logs give devices.
bool isPhoenix(const std::string& name) {
  return name.find("TalonFX") != std::string::npos || name.find("Phoenix6/") != std::string::npos;
}

ToolColumns phoenix(RawTable& table) {
  table.remarks.push_back(message("recognised a Phoenix 6 log: positions in turns, speeds in turns per second"));
  return inTurns(table, isPhoenix);
}

bool isMoteus(const RawTable& table) {
  const bool stats = std::any_of(table.columns.begin(), table.columns.end(), [](const RawColumn& column) {
    return column.channel.name.starts_with("servo_stats.");
  });
  const bool registers = std::count_if(table.columns.begin(), table.columns.end(), [](const RawColumn& column) {
                           return column.channel.name.starts_with("Register.");
                         }) > 1;
  return stats || registers || (hasAll(table, {"position", "velocity", "q_current", "d_current"})) ||
         hasAll(table, {"position", "velocity", "torque", "q_a", "d_a"}) ||
         (hasAll(table, {"mode", "position", "velocity", "torque", "voltage", "temperature", "fault"}));
}

ToolColumns moteus(RawTable& table) {
  table.remarks.push_back(message("recognised a moteus log: positions in turns, speeds in turns per second"));
  ToolColumns columns = inTurns(table, [](const std::string& name) { return name.find("raw") == std::string::npos; });
  for (const RawColumn& column : table.columns) {
    const std::string& name = column.channel.name;
    const size_t dot = name.find_last_of('.');
    const std::string last = dot == std::string::npos ? name : name.substr(dot + 1);
    if (isSameWord(last, "voltage") || isSameWord(last, "filt_bus_v") || isSameWord(last, "bus_v"))
      columns[name] = in("supply_V", 1.0, "V", isSameWord(last, "filt_bus_v") ? 2 : 1);
    if (isSameWord(last, "temperature"))
      columns[name] = setAside(message("is the board's temperature, not the winding's"));
    if (isSameWord(last, "abs_position") || isSameWord(last, "unwrapped_position"))
      columns[name] = setAside(message("is another of moteus' positions"));
  }
  return columns;
}

bool isSimpleFoc(const RawTable& table) {
  const size_t count = table.columns.size();
  const bool nameless = std::all_of(table.columns.begin(), table.columns.end(), [](const RawColumn& column) {
    return column.channel.name.starts_with("column_") && !column.fault;
  });
  if (!nameless || table.rows() < 10) return false;
  const bool stamped = table.columns.front().clock;
  const size_t values = count - (stamped ? 1 : 0);
  if (values != 4 && values != 7) return false;
  // The last column but one has to be the speed of the last.
  std::vector<double> rows(table.rows());
  for (size_t k = 0; k < rows.size(); ++k) rows[k] = static_cast<double>(k);
  const auto motion =
      compareMotion(rows, table.columns[count - 1].channel.values, table.columns[count - 2].channel.values, {});
  const bool says = std::any_of(table.preamble.begin(), table.preamble.end(),
                                [](const std::string& line) { return line.find("MOT:") != std::string::npos; });
  return motion && motion->correlation > (says ? 0.7 : 0.97);
}

ToolColumns simpleFoc(RawTable& table) {
  const bool stamped = table.columns.front().clock;
  const size_t first = stamped ? 1 : 0;
  const std::vector<const char*> names =
      table.columns.size() - first == 4
          ? std::vector<const char*>{"target", "voltage_q", "velocity", "angle"}
          : std::vector<const char*>{"target", "voltage_q", "voltage_d", "current_q", "current_d", "velocity", "angle"};
  if (stamped) table.columns.front().channel.name = "terminal time";
  for (size_t c = 0; c < names.size(); ++c) table.columns[first + c].channel.name = names[c];
  table.remarks.push_back(
      message("recognised SimpleFOC's monitor: target, voltage (V), currents (mA), velocity (rad/s), angle (rad) in "
              "its order"));
  return {{"target", setAside(message("may be an angle, a speed or a voltage: the control mode isn't in the log"))},
          {"voltage_q", in("voltage_V", 1.0, "V")},
          {"current_q", in("current_A", 1e-3, "mA")},
          {"velocity", in("velocity_rad_per_s", 1.0, "rad/s")},
          {"angle", in("angle_rad", 1.0, "rad")}};
}

/// SimpleFOC's names for what its monitor sends, written by programs that read it.
bool isNamedSimpleFoc(const RawTable& table) {
  return hasAll(table, {"target", "voltage_q", "velocity", "angle"}) ||
         hasAll(table, {"target", "voltage_q", "voltage_d", "current_q", "current_d"});
}

ToolColumns namedSimpleFoc(RawTable& table) {
  table.remarks.push_back(message(
      "recognised SimpleFOC's monitor by its names: voltage (V), currents (mA), velocity (rad/s), angle (rad)"));
  return {{"target", setAside(message("may be an angle, a speed or a voltage: the control mode isn't in the log"))},
          {"voltage_q", in("voltage_V", 1.0, "V")},
          {"current_q", in("current_A", 1e-3, "mA")},
          {"velocity", in("velocity_rad_per_s", 1.0, "rad/s")},
          {"angle", in("angle_rad", 1.0, "rad")}};
}

ToolColumns betaflight(RawTable& table) {
  ToolColumns columns;
  for (const RawColumn& column : table.columns) {
    const std::string& name = column.channel.name;
    if (name.starts_with("eRPM")) {
      ColumnName speed = understandName(name.find('[') == std::string::npos ? "erpm" : "erpm" + name.substr(4));
      speed.to = "velocity_rad_per_s";
      speed.scale = 100.0 * turn_rad / 60.0;
      speed.unit = "100 erpm";
      speed.needs = UnitNeeds::polePairs;
      columns[name] = speed;
    }
    if (name.starts_with("motor["))
      columns[name] = setAside(message("is the mixer's output, in steps that the log's head tells"));
    for (const char* part : {"axis", "rcCommand", "setpoint", "gyro", "debug"}) {
      if (name.starts_with(part)) columns[name] = setAside(message("belongs to the flight controller, not to a motor"));
    }
    if (name.starts_with("amperage")) columns[name] = setAside(message("is the supply's current, not the motor's"));
    if (name.starts_with("time")) columns[name] = in("time_s", 1e-6, "µs");
  }
  table.remarks.push_back(
      message("recognised Betaflight's decoded log: eRPM in hundreds of electrical turns per minute"));
  return columns;
}

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

using ColumnPlace = std::vector<RawColumn>::iterator;

/// Stamps in two columns, seconds and nanoseconds, become one.
void joinColumns(RawTable& table, ColumnPlace seconds, ColumnPlace nanos) {
  auto& values = seconds->channel.values;
  if (seconds->origin == 0.0 && !values.empty() && std::abs(values.front()) > 1e6) {
    seconds->origin = std::floor(values.front());  // since 1970: a double has no room for nanoseconds beside these
    for (double& value : values) value -= seconds->origin;
  }
  for (size_t k = 0; k < values.size(); ++k) values[k] += 1e-9 * (nanos->channel.values[k] + nanos->origin);
  seconds->unit = "s";
  table.remarks.push_back(message("{} and {} are one stamp", seconds->channel.name, nanos->channel.name));
  seconds->channel.name = "stamp (" + seconds->channel.name + ")";
  table.columns.erase(nanos);
}

/// A message per row without names, as `ros2 topic echo --csv` prints it, begins with its stamp.
void joinNamelessStamps(RawTable& table) {
  const bool nameless = table.rows() > 1 && table.columns.size() > 2 &&
                        std::all_of(table.columns.begin(), table.columns.end(),
                                    [](const RawColumn& one) { return one.channel.name.starts_with("column_"); });
  if (!nameless || table.columns[0].fault || table.columns[1].fault) return;
  const auto all = [&table](size_t c, double from, double below) {
    const auto& values = table.columns[c].channel.values;
    return areWhole(values) && std::all_of(values.begin(), values.end(), [&](double value) {
             const double whole = value + table.columns[c].origin;
             return whole >= from && whole < below;
           });
  };
  constexpr double year2001_s = 1e9, farAway_s = 4e9, second_ns = 1e9, manyNanoseconds = 1e6;
  if (all(0, year2001_s, farAway_s) && all(1, 0.0, second_ns) &&
      largest(table.columns[1].channel.values) > manyNanoseconds)
    joinColumns(table, table.columns.begin(), table.columns.begin() + 1);
}

/// Columns of seconds and nanoseconds, by their names.
void joinStamps(RawTable& table) {
  const auto endsIn = [](const std::string& name, std::initializer_list<const char*> words) {
    const auto parts = wordsOf(name, false);
    return !parts.empty() &&
           std::any_of(words.begin(), words.end(), [&](const char* word) { return parts.back() == word; });
  };
  const auto seconds = std::find_if(table.columns.begin(), table.columns.end(), [&](const RawColumn& one) {
    return !one.fault && endsIn(one.channel.name, {"sec", "secs"});
  });
  const auto nanos = std::find_if(table.columns.begin(), table.columns.end(), [&](const RawColumn& one) {
    return !one.fault && endsIn(one.channel.name, {"nsec", "nsecs", "nanosec", "nanosecs"});
  });
  if (seconds != table.columns.end() && nanos != table.columns.end()) return joinColumns(table, seconds, nanos);
  joinNamelessStamps(table);
}

}  // namespace

ToolColumns recogniseTool(RawTable& table, double countsPerRev) {
  joinStamps(table);
  if (auto scope = recogniseScope(table)) return std::move(*scope);
  if (isVesc(table)) return vesc(table);
  if (isVescValues(table)) return vescValues(table);
  if (find(table, "loopIteration") != nullptr || find(table, "loopiteration") != nullptr) return betaflight(table);
  if (std::any_of(table.columns.begin(), table.columns.end(),
                  [](const RawColumn& column) { return isPhoenix(column.channel.name); }))
    return phoenix(table);
  if (isMoteus(table)) return moteus(table);
  if (isOdrive(table)) return odrive(table);
  if (isDynamixel(table)) return dynamixel(table, countsPerRev);
  if (isThrustStand(table)) return thrustStand(table);
  if (isAkd(table)) return akd(table);
  if (isCia402(table)) return cia402(table);
  if (isStMotorControl(table)) return stMotorControl(table);
  if (isLerobot(table)) return lerobot(table);
  if (isSimpleFoc(table)) return simpleFoc(table);
  if (isNamedSimpleFoc(table)) return namedSimpleFoc(table);
  return {};
}

}  // namespace breakaway
