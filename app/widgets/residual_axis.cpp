#include "widgets/residual_axis.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "base/numbers.h"
#include "recording/columns.h"

namespace breakaway {

namespace {

constexpr const char* axisNames[] = {"time", "angle", "velocity", "acceleration", "current", "reversal"};
constexpr double angleDegree = 180.0 / std::numbers::pi;

QString words(const char* text) {
  return QCoreApplication::translate("ResidualAxis", text);
}

std::vector<double> copy(std::span<const double> values) {
  return {values.begin(), values.end()};
}

std::vector<double> slope(const std::vector<double>& values, std::span<const double> time_s) {
  std::vector<double> slopes(values.size(), 0.0);
  for (size_t row = 1; row + 1 < values.size(); ++row) {
    slopes[row] = (values[row + 1] - values[row - 1]) / (time_s[row + 1] - time_s[row - 1]);
  }
  return slopes;
}

std::vector<double> travelSinceReversal(const Trace& trace) {
  std::vector<double> travel(trace.position.size(), 0.0);
  double way = 0.0;
  for (size_t row = 1; row < travel.size(); ++row) {
    const double now = trace.velocity[row] > 0.0 ? 1.0 : trace.velocity[row] < 0.0 ? -1.0 : way;
    travel[row] = (now == way ? travel[row - 1] : 0.0) + std::abs(trace.position[row] - trace.position[row - 1]);
    way = now;
  }
  return travel;
}

std::vector<double> positions(const Model& model, const Recording& recording) {
  std::vector<double> position = copy(recording.channel(columnName(Quantity::position, model.axis)));
  const auto [low, high] = std::minmax_element(position.begin(), position.end());
  if (model.axis == Axis::linear || position.empty() || *high - *low <= turn_rad) return position;
  for (double& angle : position) angle -= turn_rad * std::floor(angle / turn_rad);
  return position;
}

std::vector<double> motorTorque(const Model& model, const Recording& recording, const Trace& trace) {
  const bool rotary = model.axis == Axis::rotary;
  if (model.input == DriveInput::torque) return copy(recording.channel(columnName(Quantity::torque, model.axis)));
  std::vector<double> torque =
      model.input == DriveInput::current ? copy(recording.channel("current_A")) : trace.current_A;
  const double constant = model.baseValue(rotary ? "torque_constant_Nm_per_A" : "force_constant_N_per_A").value_or(1.0);
  for (double& value : torque) value *= constant;
  return torque;
}

}  // namespace

QStringList residualAxes() {
  return {std::begin(axisNames), std::end(axisNames)};
}

QString ShownAxis::label() const {
  return unit.isEmpty() ? name : QString("%1 (%2)").arg(name, unit);
}

ShownAxis shownAxis(const QString& axis, bool linear) {
  if (axis == "time") return {words(QT_TRANSLATE_NOOP("ResidualAxis", "time")), "s", 1.0};
  if (axis == "angle")
    return linear ? ShownAxis{words(QT_TRANSLATE_NOOP("ResidualAxis", "position")), "mm", 1e3}
                  : ShownAxis{words(QT_TRANSLATE_NOOP("ResidualAxis", "rotor angle")), "°", angleDegree};
  if (axis == "velocity")
    return linear ? ShownAxis{words(QT_TRANSLATE_NOOP("ResidualAxis", "speed")), "mm/s", 1e3}
                  : ShownAxis{words(QT_TRANSLATE_NOOP("ResidualAxis", "speed")), "rad/s", 1.0};
  if (axis == "acceleration")
    return {words(QT_TRANSLATE_NOOP("ResidualAxis", "acceleration")), linear ? "m/s²" : "rad/s²", 1.0};
  if (axis == "current")
    return linear ? ShownAxis{words(QT_TRANSLATE_NOOP("ResidualAxis", "motor force")), "N", 1.0}
                  : ShownAxis{words(QT_TRANSLATE_NOOP("ResidualAxis", "motor torque")), "mNm", 1e3};
  if (axis == "reversal")
    return linear ? ShownAxis{words(QT_TRANSLATE_NOOP("ResidualAxis", "travel since the reversal")), "mm", 1e3}
                  : ShownAxis{words(QT_TRANSLATE_NOOP("ResidualAxis", "angle since the reversal")), "°", angleDegree};
  if (axis == "temperature") return {words(QT_TRANSLATE_NOOP("ResidualAxis", "temperature")), "°C", 1.0};
  return {axis, {}, 1.0};
}

std::vector<double> residualAxis(const QString& axis, const Model& model, const Recording& recording,
                                 const Trace& trace) {
  if (axis == "time") return copy(recording.time());
  if (axis == "angle") return positions(model, recording);
  if (axis == "velocity") return trace.velocity;
  if (axis == "acceleration") return slope(trace.velocity, recording.time());
  if (axis == "current") return motorTorque(model, recording, trace);
  if (axis == "reversal") return travelSinceReversal(trace);
  return {};
}

}  // namespace breakaway
