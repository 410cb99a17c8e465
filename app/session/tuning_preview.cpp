#include "session/tuning_preview.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "session/language.h"
#include "stability/predicted_step.h"

namespace breakaway {

namespace {

constexpr size_t frequencies = 160, cutoffs = 80;
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
    if (const auto noise = loopNoise(loop, {roundingRms_rad(loop.board.count_rad), question.motor.currentNoise_A}))
      preview.currentNoise_A = noise->currentReference_A;
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

double knownCoulomb_Nm(const std::optional<Bench>& bench, const Commission& known) {
  if (const auto average = known.coulombAverage_Nm()) return average->value;
  if (known.knows(Known::motor)) return std::max(0.0, known.motor.coulomb_Nm.value);
  return bench ? bench->motor.coulomb.value_or(0.0) : 0.0;
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

Grade gradeOfNoise(double noise_A, double limit_A) {
  return limit_A > 0.0 ? grade(noise_A / limit_A, 0.02, 0.05) : Grade::good;
}

}  // namespace breakaway
