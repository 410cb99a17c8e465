#include "session/tuning_preview.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "session/language.h"
#include "stability/predicted_step.h"

namespace breakaway {

namespace {

constexpr size_t frequencies = 160, cutoffs = 80, observerBandwidths = 16;
constexpr size_t fewestSettled = 20;  // samples of a step
constexpr double lowest_rad_per_s = 10.0;
constexpr double degree = std::numbers::pi / 180.0;

Grade grade(double badness, double good, double bearable) {
  return badness <= good ? Grade::good : badness <= bearable ? Grade::warning : Grade::trouble;
}

/// From where to where, in what the loop's mode counts in.
VelocityStepOptions stepOf(const PreviewQuestion& question) {
  VelocityStepOptions step = question.step;
  if (question.mode != ServoMode::position) return step;
  step.from_rad_per_s = 0.0;
  step.to_rad_per_s = question.to_rad;
  return step;
}

StepCurve foretold(const ServoLoop& loop, const PreviewQuestion& question) {
  StepWanted wanted;
  wanted.from_rad_per_s = question.step.from_rad_per_s;
  wanted.to_rad_per_s = question.step.to_rad_per_s;
  wanted.to_rad = question.to_rad;
  wanted.after_s = question.step.after_s;
  wanted.supply_V = question.identity.supply_V;
  wanted.coulomb_Nm = question.coulomb_Nm;
  wanted.static_Nm = question.static_Nm;
  PredictedStep step = predictStep(loop, wanted);
  const bool position = loop.mode == ServoMode::position;
  StepCurve curve{std::move(step.time_s),
                  position ? std::move(step.angle_rad) : std::move(step.velocity_rad_per_s),
                  {},
                  std::move(step.current_A)};
  const VelocityStepOptions asked = stepOf(question);
  for (const double time_s : curve.time_s)
    curve.reference_rad_per_s.push_back(time_s >= 0.0 ? asked.to_rad_per_s : asked.from_rad_per_s);
  return curve;
}

/// What a velocity step took to keep its speed, less the viscous part: of its last half, as far as it had settled.
std::optional<double> coulombIn(const StepResult& step, const LoopMotor& motor) {
  const double to = step.options.to_rad_per_s;
  if (step.kind != RunKind::step || to == 0.0) return {};
  double current_A = 0.0, speed_rad_per_s = 0.0;
  size_t count = 0;
  for (size_t k = 0; k < step.curve.time_s.size(); ++k) {
    const double velocity = step.curve.velocity_rad_per_s[k];
    if (step.curve.time_s[k] < 0.5 * step.options.after_s) continue;
    if (std::abs(velocity - to) > step.options.settleBand * std::abs(to)) continue;
    current_A += step.curve.current_A[k];
    speed_rad_per_s += velocity;
    ++count;
  }
  if (count < fewestSettled) return {};
  const double drive_Nm = motor.torqueConstant_Nm_per_A * current_A - motor.viscous_Nm_s_per_rad * speed_rad_per_s;
  return std::max(0.0, std::copysign(1.0, to) * drive_Nm / static_cast<double>(count));
}

/// The torque at which the wiring check saw the shaft break loose, mean of both ways.
std::optional<double> breakawayInWiring(const Commission& known, const LoopMotor& motor) {
  if (!known.wiring) return {};
  const auto &down = known.wiring->breakaway_A[0], &up = known.wiring->breakaway_A[1];
  if (!down || !up) return {};
  return 0.5 * motor.torqueConstant_Nm_per_A * (down->value + up->value);
}

}  // namespace

TuningPreview previewOf(const PreviewQuestion& question) {
  TuningPreview preview;
  ServoLoop loop = boardLoop(question.identity, question.settings, question.motor);
  loop.mode = question.mode;
  if (const auto fine = check(loop); !fine) {
    preview.trouble = inLanguage(fine.error().said());
    return preview;
  }
  preview.tick_s = loop.board.tick_s;
  preview.alphaGT = loop.alphaGT();
  preview.ruleOfThumb_rad_per_s = loop.alpha() > 0.0 ? 0.3 / (loop.alpha() * loop.board.tick_s) : 0.0;
  preview.margins = margins(loop);
  if (preview.margins.stable) {
    const SensorNoise sensors{roundingRms_rad(loop.board.count_rad), question.motor.currentNoise_A};
    if (const auto noise = loopNoise(loop, sensors)) preview.currentNoise_A = noise->currentReference_A;
    preview.observerNoise = noiseOverObserver(loop, sensors, observerBandwidths);
    preview.step = foretold(loop, question);
    preview.figures = figuresOf(preview.step, stepOf(question));
  }
  const double nyquist = std::numbers::pi / loop.board.tick_s;
  preview.response = loopResponse(loop, decades(lowest_rad_per_s, 0.98 * nyquist, frequencies));
  const double cutoff = question.settings.observer_cutoff_rad_per_s;
  if (cutoff > 0.0)
    preview.locus = rootLocus(loop, decades(0.1 * cutoff, std::max(4.0 * cutoff, 1.0 / loop.board.tick_s), cutoffs));
  return preview;
}

namespace {

KnownFriction knownCoulomb(const std::optional<Bench>& bench, const Commission& known,
                           const std::vector<StepResult>& steps, const LoopMotor& motor) {
  if (const auto average = known.coulombAverage_Nm()) return {average->value, 0.0, FrictionSource::identification};
  if (known.knows(Known::motor))
    return {std::max(0.0, known.motor.coulomb_Nm.value), 0.0, FrictionSource::identification};
  for (size_t k = steps.size(); k-- > 0;) {
    if (const auto seen_Nm = coulombIn(steps[k], motor)) return {*seen_Nm, 0.0, FrictionSource::step};
  }
  if (bench && bench->motor.coulomb) return {*bench->motor.coulomb, 0.0, FrictionSource::benchFile};
  if (const auto seen_Nm = breakawayInWiring(known, motor)) return {*seen_Nm, 0.0, FrictionSource::wiring};
  return {};
}

}  // namespace

KnownFriction knownFriction(const std::optional<Bench>& bench, const Commission& known,
                            const std::vector<StepResult>& steps, const LoopMotor& motor) {
  KnownFriction friction = knownCoulomb(bench, known, steps, motor);
  double standing_Nm = 0.0;
  if (known.knows(Known::map) && !known.map.bins.empty()) {
    for (const MapBin& bin : known.map.bins) standing_Nm += bin.staticFriction_Nm();
    standing_Nm /= static_cast<double>(known.map.bins.size());
  } else if (const auto seen_Nm = breakawayInWiring(known, motor)) {
    standing_Nm = *seen_Nm;
  }
  friction.static_Nm = std::max(friction.coulomb_Nm, standing_Nm);
  return friction;
}

Grade gradeOfPhase(const LoopMargins& margins) {
  return margins.stable ? grade(-margins.phaseMargin_rad, -45.0 * degree, -30.0 * degree) : Grade::trouble;
}

Grade gradeOfGain(const LoopMargins& margins) {
  return margins.stable ? grade(-margins.gainMargin, -2.5, -2.0) : Grade::trouble;
}

Grade gradeOfAlphaGT(double alphaGT) {
  return grade(alphaGT, 0.3, 1.0);
}

double goodNoise_A(double limit_A) {
  return 0.02 * limit_A;
}

Grade gradeOfNoise(double noise_A, double limit_A) {
  const double good = goodNoise_A(limit_A);
  return limit_A > 0.0 ? grade(noise_A / good, 1.0, 2.5) : Grade::good;
}

}  // namespace breakaway
