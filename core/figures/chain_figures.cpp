#include "figures/chain_figures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numbers.h"
#include "base/statistics.h"
#include "commission/motor_tests.h"
#include "stability/bench_loop.h"

namespace breakaway {

namespace {

/// Of the bridge, as commissioning found it: its curve, or the dead zone alone.
double bridgeOutput_V(const IdentifiedMotor& motor, double input_V, double supply_V) {
  if (motor.dutyCurve.known()) return supply_V * motor.dutyCurve.output(input_V / supply_V);
  return std::copysign(std::max(0.0, std::abs(input_V) - motor.deadZone_V.value), input_V);
}

struct BridgeBlocks {
  std::vector<double> asked_V, given_V;
};

/// What each block's current and speed say the winding got. Blocks in which the current changes tell L·di/dt, too.
BridgeBlocks blocksOf(const Commission& measured) {
  const BridgeTests& tests = measured.tests->bridge;
  const double R = measured.shownResistance_ohm, Ke = measured.motor.backEmfConstant_V_s_per_rad.value;
  const double L = R * tests.timeConstant_s;
  BridgeBlocks blocks;
  for (const WindingPoint& one : tests.standing) {
    blocks.asked_V.push_back(one.voltage_V);
    blocks.given_V.push_back(R * one.current_A);
  }
  for (const auto& run : tests.moving) {
    for (size_t k = 1; k + 1 < run.size(); ++k) {
      const SpinBlock &before = run[k - 1], &here = run[k], &after = run[k + 1];
      const double span_s = after.end_s - before.end_s;
      if (!(here.duration_s > 0.0) || span_s > 2.5 * here.duration_s) continue;
      const double speed = (here.angle_rad - before.angle_rad) / (here.end_s - before.end_s);
      const double slope = (after.current_A - before.current_A) / span_s;
      blocks.asked_V.push_back(here.voltage_V);
      blocks.given_V.push_back(R * here.current_A + L * slope + Ke * speed);
    }
  }
  return blocks;
}

std::vector<size_t> byAscending(const std::vector<double>& values) {
  std::vector<size_t> order(values.size());
  for (size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::sort(order.begin(), order.end(), [&values](size_t a, size_t b) { return values[a] < values[b]; });
  return order;
}

Result<void> hasTests(const Commission& measured, const char* figure) {
  if (measured.tests == nullptr || measured.tests->bridge.standing.empty())
    return Error{figure, "the tests that the motor was identified from were not kept"};
  return {};
}

}  // namespace

Result<BenchFigure> bridgeFigure(const Commission& measured) {
  if (auto kept = hasTests(measured, "bridge-duty"); !kept) return kept.error();
  const IdentifiedMotor& motor = measured.motor;
  const double supply_V = measured.tests->bridge.supply_V;
  const double zone =
      (motor.dutyCurve.known() ? motor.dutyCurve.points.front().input : motor.deadZone_V.value / supply_V);
  BenchFigure figure{"bridge-duty",
                     "What the bridge gives of the duty it is asked for, both as part of the supply: points by current "
                     "and speed of the tests that the motor was identified from, R·i + L·di/dt + Ke·ω over the supply; "
                     "the line is what commissioning took from them.",
                     {"Output duty over input duty", "input duty / %", "output duty / %"},
                     {{"input_duty", {}}, {"output_duty", {}}, {"curve_duty", {}}}};
  const BridgeBlocks blocks = blocksOf(measured);
  std::vector<double> offCurve, offIdeal;
  for (const size_t k : byAscending(blocks.asked_V)) {
    const double asked = blocks.asked_V[k] / supply_V, given = blocks.given_V[k] / supply_V;
    const double curve = bridgeOutput_V(motor, blocks.asked_V[k], supply_V) / supply_V;
    const double row[] = {asked, given, curve};
    for (size_t column = 0; column < 3; ++column) figure.columns[column].values.push_back(row[column]);
    offCurve.push_back(given - curve);
    offIdeal.push_back(given - asked);
  }
  const double reach = std::max(5.0 * zone, 0.02);
  Curve points = drawn(figure, "measured", "input_duty", "output_duty", 100.0, 100.0);
  points.style = Curve::Style::points;
  points.width_px = 1.2;
  points.colour = 4;
  Curve curve{"as commissioned", {}, {}},
      ideal{"ideal", {-100.0 * reach, 100.0 * reach}, {-100.0 * reach, 100.0 * reach}};
  for (int k = -200; k <= 200; ++k) {
    const double input = reach * k / 200.0;
    curve.x.push_back(100.0 * input);
    curve.y.push_back(100.0 * bridgeOutput_V(motor, input * supply_V, supply_V) / supply_V);
  }
  curve.colour = 1;
  ideal.style = Curve::Style::dashed;
  ideal.colour = 6;
  figure.figure.curves = {std::move(points), std::move(curve), std::move(ideal)};
  figure.figure.xRange = figure.figure.yRange = std::pair(-100.0 * reach, 100.0 * reach);
  figure.keyNumbers = {{"dead_zone_duty", zone},
                       {"dead_zone_V", motor.deadZone_V.value},
                       {"dead_zone_std_V", motor.deadZone_V.standardError},
                       {"bends", motor.dutyCurve.known() ? 1.0 : 0.0},
                       {"rms_off_the_curve_duty", rms(offCurve)},
                       {"rms_off_an_ideal_bridge_duty", rms(offIdeal)}};
  return figure;
}

Result<BenchFigure> currentSensorFigure(const Commission& measured) {
  if (auto kept = hasTests(measured, "current-sensor"); !kept) return kept.error();
  const IdentifiedMotor& motor = measured.motor;
  const double gain = motor.currentGain.value, zero_A = measured.sensorZero_A.value;
  const double R = measured.shownResistance_ohm * gain, supply_V = measured.tests->bridge.supply_V;
  BenchFigure figure{
      "current-sensor",
      "What the current sensor reads before its zero is taken off, over the current that a standing "
      "winding must carry at its voltage, dead zone taken off; each point is a mean over 10 ms. The band is the "
      "gain's 95 % interval: from one sensor alone its gain can't be told from the torque constant.",
      {"The current sensor's chain", "current in the winding / A", "reading / A"},
      {{"current_A", {}}, {"reading_A", {}}, {"line_A", {}}}};
  std::vector<double> current_A, reading_A, off;
  for (const WindingPoint& one : measured.tests->bridge.standing) {
    current_A.push_back(bridgeOutput_V(motor, one.voltage_V, supply_V) / R);
    reading_A.push_back(one.current_A + zero_A);
  }
  for (const size_t k : byAscending(current_A)) {
    const double line_A = zero_A + gain * current_A[k];
    const double row[] = {current_A[k], reading_A[k], line_A};
    for (size_t column = 0; column < 3; ++column) figure.columns[column].values.push_back(row[column]);
    off.push_back(reading_A[k] - line_A);
  }
  const double most_A = std::max(std::abs(figure.columns[0].values.front()), figure.columns[0].values.back());
  Curve line{"zero and gain as measured", {-most_A, 0.0, most_A}, {}},
      ideal{"ideal", {-most_A, most_A}, {-most_A, most_A}};
  for (const double x : line.x) {
    line.y.push_back(zero_A + gain * x);
    const double reach = std::abs(x) * (motor.currentGain.high95() - gain);
    line.low.push_back(line.y.back() - reach);
    line.high.push_back(line.y.back() + reach);
  }
  line.colour = 1;
  ideal.style = Curve::Style::dashed;
  ideal.colour = 6;
  Curve points = drawn(figure, "readings", "current_A", "reading_A");
  points.style = Curve::Style::points;
  points.width_px = 1.5;
  points.colour = 4;
  figure.figure.curves = {std::move(points), std::move(line), std::move(ideal)};
  figure.keyNumbers = {{"zero_A", zero_A},
                       {"zero_std_A", measured.sensorZero_A.standardError},
                       {"gain", gain},
                       {"gain_std", motor.currentGain.standardError},
                       {"noise_rms_A", measured.noiseRms_A},
                       {"rms_off_the_line_A", rms(off)}};
  return figure;
}

namespace {

/// A square wave of the current's reference: low for `held` ticks, then high for as many.
struct Steps {
  double low_A = 0.0, high_A = 0.0, tick_s = 0.0;
  size_t held = 0;
  double at_A(size_t tick) const { return tick % (2 * held) < held ? low_A : high_A; }
};

/// The board's current loop around a standing winding behind the bridge: the third step upwards, from the tick on whose
/// reference is the high one.
std::vector<double> foretoldStep(const ServoLoop& loop, const Commission& measured, const Steps& steps) {
  const double supply_V = measured.identity.supply_V;
  const double share = std::exp(-steps.tick_s * loop.motor.resistance_ohm / loop.motor.inductance_H);
  ServoController<double> controller(loop.board);
  controller.configure(loop.settings);
  std::vector<double> current_A;
  double now_A = 0.0;
  for (size_t tick = 0; tick < 6 * steps.held; ++tick) {
    if (tick >= 5 * steps.held) current_A.push_back(now_A);
    controller.command({ServoMode::current, steps.at_A(tick), 0.0, false});
    const double asked_V = controller.step(0.0, now_A, supply_V).voltage_V;
    // A straightened bridge gives what the controller asks for.
    const double given_V = measured.linearised ? asked_V : bridgeOutput_V(measured.motor, asked_V, supply_V);
    const double final_A = given_V / loop.motor.resistance_ohm;
    now_A = final_A + share * (now_A - final_A);
  }
  return current_A;
}

/// When the values first reach this, between ticks; the last time when they never do.
double reaches_s(const std::vector<double>& time_s, const std::vector<double>& values, double level) {
  for (size_t k = 1; k < values.size(); ++k) {
    if (values[k] < level) continue;
    const double part = (level - values[k - 1]) / (values[k] - values[k - 1]);
    return time_s[k - 1] + part * (time_s[k] - time_s[k - 1]);
  }
  return time_s.empty() ? 0.0 : time_s.back();
}

}  // namespace

Result<BenchFigure> currentStepFigure(CommissionedBench& bench, const CurrentStepOptions& options) {
  const Commission& measured = bench.measured;
  BoardTiming timing;
  timing.tick_s = 1.0 / measured.identity.loopRate_Hz;
  auto loop = loopOfBench(measured.bench, timing);
  if (!loop) return loop.error();
  if (loop->current != CurrentPath::winding)
    return Error{"current-step", "needs resistance and inductance, which weren't measured"};
  const auto held = static_cast<size_t>(std::lround(options.hold_s / timing.tick_s));
  const double friction_A = measured.map.coulombAverage_Nm.value / bench.torqueConstant_Nm_per_A();
  const Steps steps{options.from * friction_A, options.to * friction_A, timing.tick_s, held};
  CourseOptions course;
  course.activity = "steps of the current";
  course.before = {Command::Mode::current, steps.low_A, 0.0, false};
  course.before_s = 0.2;
  course.duration_s = 2.0 * static_cast<double>(held * options.steps) * timing.tick_s;
  course.command = [steps](double time_s, const Sample&) {
    const auto tick = static_cast<size_t>(std::lround(std::max(0.0, time_s) / steps.tick_s));
    return Command{Command::Mode::current, steps.at_A(tick), 0.0, false};
  };
  const auto ran = runCourse(bench, course, CompensatedFriction::none);
  if (!ran) return ran.error();
  BenchFigure figure{
      "current-step",
      "The board's current loop takes a step below the friction, so that the rotor stands: the mean over " +
          std::to_string(options.steps) +
          " steps, and the same controller foretold around the identified winding and bridge.",
      {"Step of the current", "time / ms", "current / A"},
      {{"time_s", {}}, {"reference_A", {}}, {"mean_A", {}}, {"mean_std_A", {}}, {"foretold_A", {}}}};
  // A command comes after its tick's control: the next tick is the first whose reference it is.
  const auto foretold = foretoldStep(*loop, measured, steps);
  std::vector<double> off;
  for (size_t tick = 0; tick < held; ++tick) {
    std::vector<double> values;
    for (size_t step = 0; step < options.steps; ++step) {
      const size_t at = (2 * step + 1) * held + tick + 1;
      if (at < ran->samples.size()) values.push_back(ran->samples[at].current_A);
    }
    const double middle = mean(values);
    std::vector<double> scatter;
    scatter.reserve(values.size());
    for (const double value : values) scatter.push_back(value - middle);
    const double row[] = {static_cast<double>(tick) * timing.tick_s, steps.high_A, middle,
                          rms(scatter) / std::sqrt(static_cast<double>(values.size())), foretold[tick]};
    for (size_t k = 0; k < figure.columns.size(); ++k) figure.columns[k].values.push_back(row[k]);
    off.push_back(middle - foretold[tick]);
  }
  figure.figure.curves = {drawn(figure, "reference", "time_s", "reference_A", 1.0, 1e3),
                          drawn(figure, "measured", "time_s", "mean_A", 1.0, 1e3),
                          drawn(figure, "foretold", "time_s", "foretold_A", 1.0, 1e3)};
  figure.figure.curves[0].style = Curve::Style::dashed;
  figure.figure.curves[0].colour = 6;
  for (size_t k = 0; k < held; ++k) {
    const double doubt = normal95 * figure.columns[3].values[k], value = figure.columns[2].values[k];
    figure.figure.curves[1].low.push_back(value - doubt);
    figure.figure.curves[1].high.push_back(value + doubt);
  }
  const auto& mean_A = figure.columns[2].values;
  const double level_A = steps.low_A + (1.0 - std::exp(-1.0)) * (steps.high_A - steps.low_A);
  figure.keyNumbers = {{"from_A", steps.low_A},
                       {"to_A", steps.high_A},
                       {"bandwidth_rad_per_s", loop->board.current.bandwidth_rad_per_s},
                       {"measured_63_s", reaches_s(figure.columns[0].values, mean_A, level_A)},
                       {"foretold_63_s", reaches_s(figure.columns[0].values, foretold, level_A)},
                       {"rms_off_the_foretold_A", rms(off)},
                       {"overshoot_A", std::max(0.0, *std::max_element(mean_A.begin(), mean_A.end()) - steps.high_A)},
                       {"error_at_end_A", mean_A.back() - steps.high_A}};
  return figure;
}

}  // namespace breakaway
