#include "recording/import/known_logs.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "recording/columns.h"

namespace breakaway {

namespace {

constexpr double fullDuty_pwm = 885.0;  // XL330: PWM limit of the control table

RawColumn* find(RawTable& table, const std::string& name) {
  const auto it = std::find_if(table.columns.begin(), table.columns.end(),
                               [&](const RawColumn& one) { return one.channel.name == name; });
  return it == table.columns.end() ? nullptr : &*it;
}

bool hasSoundColumns(RawTable& table, std::initializer_list<const char*> names) {
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

struct Renaming {
  const char* from;
  Quantity to;
};

/// Names these columns for the axis and puts them first, in this order.
void rename(RawTable& table, Axis axis, std::initializer_list<Renaming> renamings) {
  auto next = table.columns.begin();
  for (const Renaming& one : renamings) {
    RawColumn* column = find(table, one.from);
    if (column == nullptr) continue;
    column->channel.name = columnName(one.to, axis);
    const auto place = table.columns.begin() + (column - table.columns.data());
    std::rotate(next++, place, place + 1);
  }
}

bool translateEmps(RawTable& table) {
  const std::string gain = noteOf(table, "gtau");
  if (gain.empty() || !hasSoundColumns(table, {"t", "qm", "qg", "vir"})) return false;
  const double gain_N_per_V = std::strtod(gain.c_str(), nullptr);
  Channel force{"force", find(table, "vir")->channel.values};
  for (double& value : force.values) value *= gain_N_per_V;
  table.columns.push_back({std::move(force), {}});
  rename(table, Axis::linear,
         {{"t", Quantity::time},
          {"qm", Quantity::position},
          {"force", Quantity::torque},
          {"vir", Quantity::voltage},
          {"qg", Quantity::positionReference}});
  table.remarks.push_back(message("recognised the EMPS benchmark: force_N is gtau × vir, gtau = {} N/V", gain));
  return true;
}

/// The register's 16 bits as a signed number.
double asSigned(double raw) {
  return raw >= 32768.0 ? raw - 65536.0 : raw;
}

Result<bool> translateBam(RawTable& table, const std::string& name) {
  if (noteOf(table, "motor") != "xl330" || !hasSoundColumns(table, {"timestamp", "position", "load", "input_volts"}))
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
                 message("{} is no PWM value: the log was interpolated across the register's 16 bit wrap and its drive "
                         "input is lost; "
                         "import the raw log ({} of {} entries are like this)",
                         std::to_string(*first), std::count_if(raw.begin(), raw.end(), impossible), raw.size())};
  }
  Channel duty{"duty", raw}, voltage{"voltage", raw};
  for (size_t k = 0; k < raw.size(); ++k) {
    duty.values[k] = asSigned(raw[k]) / fullDuty_pwm;
    voltage.values[k] = duty.values[k] * supply[k];
  }
  *find(table, "load") = {std::move(duty), {}};
  table.columns.push_back({std::move(voltage), {}});
  rename(table, Axis::rotary,
         {{"timestamp", Quantity::time},
          {"position", Quantity::position},
          {"voltage", Quantity::voltage},
          {"duty", Quantity::duty},
          {"input_volts", Quantity::supply},
          {"speed", Quantity::velocity},
          {"goal_position", Quantity::positionReference},
          {"temp", Quantity::temperature},
          {"torque_enable", Quantity::enabled}});
  table.remarks.push_back(message(
      "recognised a BAM log of an XL330: duty is load as a signed 16 bit number / 885, voltage_V is duty × supply_V"));
  return true;
}

}  // namespace

Result<void> translateKnownLog(RawTable& table, const std::string& name) {
  if (translateEmps(table)) return {};
  if (const auto bam = translateBam(table, name); !bam) return bam.error();
  return {};
}

}  // namespace breakaway
