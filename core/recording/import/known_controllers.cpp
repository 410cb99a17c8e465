#include "recording/import/known_controllers.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <set>

#include "base/numbers.h"
#include "recording/import/name_parts.h"
#include "recording/import/settle_motion.h"
#include "recording/import/tool_columns.h"

namespace breakaway {

using namespace tools;

namespace {

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
          {"currentin", ofSupply},
          {"inputcurrent", ofSupply},
          {"dutycyclenow", duty},
          {"dutynow", duty},
          {"dutycycle", duty},
          {"duty", duty},
          {"inpvoltage", supply},
          {"vin", supply},
          {"voltageinput", supply},
          {"voltagein", supply},
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
  // Only they tell of their transistors ("Temp Mos") beside both currents.
  const bool shown = has("tempmos") && has("rpm") && (has("motorcurrent") || has("currentmotor")) &&
                     (has("currentin") || has("inputcurrent"));
  const bool ros = has("currentmotor") && has("currentinput") && has("dutycycle") && has("speed");
  return library || ros || shortened || shown;
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

/// "ODrive0Position", "odrv0.axis0.pos".
bool isOdrives(const std::string& name) {
  const std::string lower = lowered(name);
  return lower.find("odrive") != std::string::npos || lower.starts_with("odrv");
}

/// By its current's name alone only where no motion beside it tells a unit of its own, "turns" beside an "angle", and
/// only one angle is there.
bool isOdrive(const RawTable& table) {
  bool motion = false, current = false, told = false;
  size_t angles = 0;
  for (const RawColumn& column : table.columns) {
    const std::string& name = column.channel.name;
    const auto has = [&name](const char* part) { return name.find(part) != std::string::npos; };
    const ColumnName known = understandName(name, column.unit);
    const bool moves = known.to == "angle_rad" || known.to == "velocity_rad_per_s";
    motion = motion || (moves && known.unit.empty() && isOdrives(name)) || has("pos_estimate") || has("vel_estimate") ||
             has("pos_vel_mapper");
    current = current || has("Iq_measured") || has("iq_measured");
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

}  // namespace

std::optional<ToolColumns> recogniseController(RawTable& table) {
  if (isVesc(table)) return vesc(table);
  if (isVescValues(table)) return vescValues(table);
  if (find(table, "loopIteration") != nullptr || find(table, "loopiteration") != nullptr) return betaflight(table);
  if (std::any_of(table.columns.begin(), table.columns.end(),
                  [](const RawColumn& column) { return isPhoenix(column.channel.name); }))
    return phoenix(table);
  if (isMoteus(table)) return moteus(table);
  if (isOdrive(table)) return odrive(table);
  return std::nullopt;
}

}  // namespace breakaway
