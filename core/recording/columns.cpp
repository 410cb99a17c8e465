#include "recording/columns.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace breakaway {

namespace {

constexpr auto table = std::to_array<Column>({
    {"time_s", "s", Quantity::time, {}, Cell::number, "strictly increasing"},
    {"angle_rad", "rad", Quantity::position, Axis::rotary, Cell::number, "as the encoder gives it, unwrapped"},
    {"position_m", "m", Quantity::position, Axis::linear, Cell::number, "as the encoder gives it"},
    {"velocity_rad_per_s", "rad/s", Quantity::velocity, Axis::rotary, Cell::number,
     "measured, or the board's estimate"},
    {"velocity_m_per_s", "m/s", Quantity::velocity, Axis::linear, Cell::number, "measured, or the board's estimate"},
    {"voltage_V", "V", Quantity::voltage, {}, Cell::number, "across the motor"},
    {"duty", "1", Quantity::duty, {}, Cell::ratio, "voltage over supply"},
    {"current_A", "A", Quantity::current, {}, Cell::number, "as the sensor gives it"},
    {"torque_Nm", "Nm", Quantity::torque, Axis::rotary, Cell::number, "the motor's"},
    {"force_N", "N", Quantity::torque, Axis::linear, Cell::number, "the motor's"},
    {"supply_V", "V", Quantity::supply, {}, Cell::number, "of the bridge"},
    {"temperature_degC", "°C", Quantity::temperature, {}, Cell::number, "of the winding"},
    {"angle_reference_rad", "rad", Quantity::positionReference, Axis::rotary, Cell::number,
     "what the servo was asked for"},
    {"position_reference_m", "m", Quantity::positionReference, Axis::linear, Cell::number,
     "what the servo was asked for"},
    {"velocity_reference_rad_per_s", "rad/s", Quantity::velocityReference, Axis::rotary, Cell::number,
     "what the servo was asked for"},
    {"velocity_reference_m_per_s", "m/s", Quantity::velocityReference, Axis::linear, Cell::number,
     "what the servo was asked for"},
    {"current_reference_A", "A", Quantity::currentReference, {}, Cell::number, "after the current limit"},
    {"disturbance_estimate_Nm", "Nm", Quantity::disturbance, Axis::rotary, Cell::number,
     "the disturbance observer's output"},
    {"disturbance_estimate_N", "N", Quantity::disturbance, Axis::linear, Cell::number,
     "the disturbance observer's output"},
    {"index", "1", Quantity::index, {}, Cell::flag, "1 in the row in which the encoder's index was seen"},
    {"enabled", "1", Quantity::enabled, {}, Cell::flag, "0 while the windings are open"},
});

template <typename Is>
const Column* firstThat(Is is) {
  const auto it = std::find_if(table.begin(), table.end(), is);
  return it == table.end() ? nullptr : &*it;
}

}  // namespace

std::span<const Column> columns() {
  return table;
}

const Column* columnNamed(std::string_view name) {
  return firstThat([name](const Column& one) { return name == one.name; });
}

const Column* columnIn(std::string_view unit, Quantity quantity) {
  return firstThat([=](const Column& one) { return one.quantity == quantity && unit == one.unit; });
}

const char* columnName(Quantity quantity, Axis axis) {
  const Column* column =
      firstThat([=](const Column& one) { return one.quantity == quantity && one.axis.value_or(axis) == axis; });
  assert(column != nullptr);  // each quantity stands in the table, on each axis
  return column->name;
}

}  // namespace breakaway
