#include "recording/known_logs.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace breakaway {

namespace {

constexpr double fullDuty_pwm = 885.0;  // XL330: PWM limit of the control table

RawColumn* find(RawTable& table, const std::string& name) {
  const auto it = std::find_if(table.columns.begin(), table.columns.end(),
                               [&](const RawColumn& one) { return one.channel.name == name; });
  return it == table.columns.end() ? nullptr : &*it;
}

bool hasAll(RawTable& table, std::initializer_list<const char*> names) {
  return std::all_of(names.begin(), names.end(), [&table](const char* name) {
    const RawColumn* column = find(table, name);
    return column != nullptr && !column->fault;
  });
}

std::string noteOf(const RawTable& table, const std::string& key) {
  for (const auto& [name, value] : table.notes) {
    if (name == key) return value;
  }
  return {};
}

void rename(RawTable& table, const std::string& from, const std::string& to) {
  if (RawColumn* column = find(table, from)) column->channel.name = to;
}

/// Puts the columns with these names first, in this order.
void order(RawTable& table, const std::vector<std::string>& names) {
  const auto rank = [&names](const RawColumn& one) {
    return std::find(names.begin(), names.end(), one.channel.name) - names.begin();
  };
  std::stable_sort(table.columns.begin(), table.columns.end(),
                   [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
}

bool translateEmps(RawTable& table) {
  const std::string gain = noteOf(table, "gtau");
  if (gain.empty() || !hasAll(table, {"t", "qm", "qg", "vir"})) return false;
  const double gain_N_per_V = std::strtod(gain.c_str(), nullptr);
  Channel force{"force_N", find(table, "vir")->channel.values};
  for (double& value : force.values) value *= gain_N_per_V;
  table.columns.push_back({std::move(force), {}});
  rename(table, "t", "time_s");
  rename(table, "qm", "position_m");
  rename(table, "vir", "voltage_V");
  rename(table, "qg", "position_reference_m");
  order(table, {"time_s", "position_m", "force_N", "voltage_V", "position_reference_m"});
  table.remarks.push_back("recognised the EMPS benchmark: force_N is gtau × vir, gtau = " + gain + " N/V");
  return true;
}

/// The register's 16 bits as a signed number.
double asSigned(double raw) {
  return raw >= 32768.0 ? raw - 65536.0 : raw;
}

Result<bool> translateBam(RawTable& table, const std::string& name) {
  if (noteOf(table, "motor") != "xl330" || !hasAll(table, {"timestamp", "position", "load", "input_volts"}))
    return false;
  const auto& raw = find(table, "load")->channel.values;
  const auto& supply = find(table, "input_volts")->channel.values;
  // Fractions come from resampling. They are harmless until one lies between a small positive and a small negative
  // value.
  const auto impossible = [](double v) {
    return std::isfinite(v) && (std::abs(asSigned(v)) > fullDuty_pwm || (v != std::round(v) && v > fullDuty_pwm));
  };
  const auto first = std::find_if(raw.begin(), raw.end(), impossible);
  if (first != raw.end()) {
    return Error{name + ", entry " + std::to_string(first - raw.begin() + 1) + ", field load",
                 std::to_string(*first) +
                     " is no PWM value: the log was interpolated across the register's 16 bit wrap and its drive "
                     "input is lost; import the raw log (" +
                     std::to_string(std::count_if(raw.begin(), raw.end(), impossible)) + " of " +
                     std::to_string(raw.size()) + " entries are like this)"};
  }
  Channel duty{"duty", raw}, voltage{"voltage_V", raw};
  for (size_t k = 0; k < raw.size(); ++k) {
    duty.values[k] = asSigned(raw[k]) / fullDuty_pwm;
    voltage.values[k] = duty.values[k] * supply[k];
  }
  *find(table, "load") = {std::move(duty), {}};
  table.columns.push_back({std::move(voltage), {}});
  rename(table, "timestamp", "time_s");
  rename(table, "position", "angle_rad");
  rename(table, "input_volts", "supply_V");
  rename(table, "speed", "velocity_rad_per_s");
  rename(table, "goal_position", "angle_reference_rad");
  rename(table, "temp", "temperature_degC");
  rename(table, "torque_enable", "enabled");
  order(table, {"time_s", "angle_rad", "voltage_V", "duty", "supply_V", "velocity_rad_per_s", "angle_reference_rad",
                "temperature_degC", "enabled"});
  table.remarks.push_back(
      "recognised a BAM log of an XL330: duty is load as a signed 16 bit number / 885, voltage_V is duty × supply_V");
  return true;
}

}  // namespace

Result<void> translateKnownLog(RawTable& table, const std::string& name) {
  if (translateEmps(table)) return {};
  if (const auto bam = translateBam(table, name); !bam) return bam.error();
  return {};
}

}  // namespace breakaway
