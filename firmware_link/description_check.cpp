#include "firmware_link/description_check.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <iterator>

namespace breakaway {

namespace {

struct Range {
  const char* name;
  double least, most;
};

/// Far beyond any board that turns a motor, and far within what arithmetic bears.
constexpr Range ranges[] = {
    {"loop_rate_Hz", 10.0, 1e6},
    {"supply_V", 1.0, 2000.0},
    {"counts_per_rev", 1.0, 268435456.0},
    {"dictionary_entries", 1.0, 1000.0},
    {"velocity_kp_A_s_per_rad", 0.0, 1e9},
    {"velocity_ki_A_per_rad", 0.0, 1e9},
    {"velocity_kd_A_s2_per_rad", 0.0, 1e9},
    {"position_kp_A_per_rad", 0.0, 1e9},
    {"position_ki_A_per_rad_s", 0.0, 1e9},
    {"position_kd_A_s_per_rad", 0.0, 1e9},
    {"observer_cutoff_rad_per_s", 0.0, 1e6},
    {"nominal_inertia_kg_m2", 0.0, 1e5},
    {"nominal_torque_constant_Nm_per_A", 0.0, 1e4},
    {"current_limit_A", 1e-6, 1e5},
    {"velocity_limit_rad_per_s", 1e-6, 1e6},
    {"lease_s", 1e-3, 60.0},
    {"velocity_trip_rad_per_s", 0.0, 1e6},
    {"travel_limit_rad", 0.0, 1e9},
    {"temperature_limit_degC", 0.0, 1e3},
    {"current_trip_A", 1e-6, 1e5},
    {"blocked_for_s", 0.0, 1e4},
    {"winding_resistance_ohm", 0.0, 1e6},
    {"winding_inductance_H", 0.0, 1e3},
    {"winding_back_emf_V_s_per_rad", 0.0, 1e4},
    {"current_zero_A", -1e5, 1e5},
    {"velocity_bandwidth_rad_per_s", 1e-3, 1e7},
    {"current_bandwidth_rad_per_s", 1e-3, 1e7},
};

constexpr double mostScale = 1e3;    // of a channel: 3e7 of its unit
constexpr double mostLimit = 1e12;   // of what a parameter may be set to
constexpr double leastScale = 1e-9;  // 3e-5 of its unit

Error says(const std::string& place, const std::string& field, double value, const std::string& expected) {
  return {place, fmt::format("says of itself {} = {:g}, expected {}", field, value, expected)};
}

Result<void> within(const std::string& place, const std::string& field, double value, double least, double most) {
  if (value >= least && value <= most) return {};
  return says(place, field, value, fmt::format("{:g} to {:g}", least, most));
}

}  // namespace

Result<void> checkValue(const std::string& place, const std::string& name, double value) {
  const auto* range =
      std::find_if(std::begin(ranges), std::end(ranges), [&name](const Range& one) { return one.name == name; });
  return range == std::end(ranges) ? Result<void>{} : within(place, name, value, range->least, range->most);
}

Result<void> checkHello(const std::string& place, const wire::Hello& hello) {
  const std::pair<const char*, double> fields[] = {{"loop_rate_Hz", static_cast<double>(hello.loopRate_Hz)},
                                                   {"supply_V", static_cast<double>(hello.supply_V)},
                                                   {"counts_per_rev", static_cast<double>(hello.countsPerRev)},
                                                   {"dictionary_entries", static_cast<double>(hello.entries)}};
  for (const auto& [name, value] : fields) {
    if (auto checked = checkValue(place, name, value); !checked) return checked;
  }
  return {};
}

Result<void> checkEntry(const std::string& place, const wire::DictionaryEntry& entry) {
  const std::string name = textOf(entry.name);
  if (entry.kind == wire::DictionaryEntry::Kind::channel) {
    if (entry.format != wire::Format::int16) return {};
    return within(place, "the scale of " + name, static_cast<double>(entry.scale), leastScale, mostScale);
  }
  const auto least = static_cast<double>(entry.least), most = static_cast<double>(entry.most);
  if (auto checked = within(place, "the least " + name, least, -mostLimit, mostLimit); !checked) return checked;
  return within(place, "the most " + name, most, least, mostLimit);
}

}  // namespace breakaway
