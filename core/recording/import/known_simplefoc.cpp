#include "recording/import/known_simplefoc.h"

#include <algorithm>
#include <vector>

#include "base/numbers.h"
#include "recording/import/settle_motion.h"
#include "recording/import/tool_columns.h"

namespace breakaway {

using namespace tools;

namespace {

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

}  // namespace

std::optional<ToolColumns> recogniseSimpleFoc(RawTable& table) {
  if (isSimpleFoc(table)) return simpleFoc(table);
  if (isNamedSimpleFoc(table)) return namedSimpleFoc(table);
  return std::nullopt;
}

}  // namespace breakaway
