#include "stability/auto_tuning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "control/tuning.h"
#include "stability/reach.h"

namespace breakaway {

namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr std::array<std::string_view, 3> names{"soft", "medium", "stiff"};
constexpr double highestCutoffPerTick = 0.5;  // g·T that a board accepts

/// One motor and one way to tune it.
class Tuner {
 public:
  Tuner(const ServoLoop& loop, const Estimate& inertia, const Estimate& torqueConstant,
        const AutoTuningOptions& options)
      : loop_(loop), options_(options), wanted_(wantedMargins(options.stiffness)) {
    loop_.settings.inertia_kg_m2 = loop_.motor.inertia_kg_m2 = inertia.value;
    loop_.settings.torqueConstant_Nm_per_A = loop_.motor.torqueConstant_Nm_per_A = torqueConstant.value;
    for (const double J : {inertia.low95(), inertia.high95()}) {
      for (const double Kt : {torqueConstant.low95(), torqueConstant.high95()}) corners_.emplace_back(J, Kt);
    }
  }

  Result<Tuning> tune();
  Result<VelocityTuning> tuneVelocity();

 private:
  Reach velocityReach() const;
  ServoLoop tuned(double bandwidth, double positionBandwidth, ServoMode mode) const;
  ServoLoop at(ServoLoop loop, std::pair<double, double> corner) const;
  std::string loss(const ServoLoop& loop) const;
  TuningCorner look(std::pair<double, double> corner, double bandwidth, double positionBandwidth) const;

  ServoLoop loop_;
  AutoTuningOptions options_;
  WantedMargins wanted_;
  std::vector<std::pair<double, double>> corners_;
};

ServoLoop Tuner::tuned(double bandwidth, double positionBandwidth, ServoMode mode) const {
  ServoLoop loop = loop_;
  loop.mode = mode;
  loop.settings.gains =
      tuneMotion(loop.settings.inertia_kg_m2, loop.settings.torqueConstant_Nm_per_A, bandwidth, positionBandwidth);
  loop.settings.observer_cutoff_rad_per_s = options_.cutoffPerBandwidth * bandwidth;
  return loop;
}

ServoLoop Tuner::at(ServoLoop loop, std::pair<double, double> corner) const {
  loop.motor.inertia_kg_m2 = corner.first;
  loop.motor.torqueConstant_Nm_per_A = corner.second;
  return loop;
}

/// What these gains don't keep at some corner, in words; empty when they keep all.
std::string Tuner::loss(const ServoLoop& loop) const {
  if (loop.settings.observer_cutoff_rad_per_s > highestCutoffPerTick / loop.board.tick_s)
    return "highest cutoff that a board accepts";
  for (const auto& corner : corners_) {
    if (auto lost = lossOfMargins(margins(at(loop, corner)), wanted_); !lost.empty()) return lost;
  }
  if (!(loop.settings.current_limit_A > 0.0)) return {};
  const auto noise = loopNoise(loop, options_.noise);
  const double most_A = wanted_.noiseShare * loop.settings.current_limit_A;
  return noise && noise->currentReference_A <= most_A ? std::string() : "noise of the current";
}

TuningCorner Tuner::look(std::pair<double, double> corner, double bandwidth, double positionBandwidth) const {
  return {corner.first, corner.second, margins(at(tuned(bandwidth, positionBandwidth, ServoMode::velocity), corner)),
          margins(at(tuned(bandwidth, positionBandwidth, ServoMode::position), corner))};
}

LoopMargins worse(const LoopMargins& a, const LoopMargins& b) {
  LoopMargins worst = a.peakSensitivity > b.peakSensitivity ? a : b;
  worst.stable = a.stable && b.stable;
  worst.gainReduction = std::max(a.gainReduction, b.gainReduction);
  worst.delayMargin_s = std::min(a.delayMargin_s, b.delayMargin_s);
  worst.peakComplementary = std::max(a.peakComplementary, b.peakComplementary);
  worst.damping = std::min(a.damping, b.damping);
  const LoopMargins &gain = a.gainMargin < b.gainMargin ? a : b, &phase = a.phaseMargin_rad < b.phaseMargin_rad ? a : b;
  worst.gainMargin = gain.gainMargin;
  worst.phaseCrossover_rad_per_s = gain.phaseCrossover_rad_per_s;
  worst.phaseMargin_rad = phase.phaseMargin_rad;
  worst.gainCrossover_rad_per_s = phase.gainCrossover_rad_per_s;
  return worst;
}

Reach Tuner::velocityReach() const {
  const double T = loop_.board.tick_s;
  return farthest(1e-4 / T, 1.0 / T, [this](double w) { return loss(tuned(w, 0.0, ServoMode::velocity)); });
}

Result<VelocityTuning> Tuner::tuneVelocity() {
  if (auto fine = check(loop_); !fine) return fine.error();
  const Reach velocity = velocityReach();
  if (!(velocity.most > 0.0)) return VelocityTuning{0.0, velocity.heldBy, loop_, {}};
  const ServoLoop loop = tuned(velocity.most, 0.0, ServoMode::velocity);
  auto noise = loopNoise(loop, options_.noise);
  if (!noise) return noise.error();
  return VelocityTuning{velocity.most, velocity.heldBy, loop, *noise};
}

Result<Tuning> Tuner::tune() {
  if (auto fine = check(loop_); !fine) return fine.error();
  const Reach velocity = velocityReach();
  if (!(velocity.most > 0.0))
    return Error{"tuning", message("finds no gains that hold at every corner: the {} is lost", velocity.heldBy)};
  const double w = velocity.most;
  const auto position = farthest(1e-3 * w, w, [this, w](double wp) { return loss(tuned(w, wp, ServoMode::position)); });
  if (!(position.most > 0.0))
    return Error{"tuning",
                 message("finds no position gains that hold at every corner: the {} is lost", position.heldBy)};
  Tuning tuning;
  tuning.stiffness = options_.stiffness;
  tuning.wanted = wanted_;
  const ServoLoop nominal = tuned(w, position.most, ServoMode::velocity);
  tuning.settings = nominal.settings;
  tuning.velocityBandwidth_rad_per_s = w;
  tuning.positionBandwidth_rad_per_s = position.most;
  tuning.heldBy = velocity.heldBy;
  tuning.nominal = look({loop_.motor.inertia_kg_m2, loop_.motor.torqueConstant_Nm_per_A}, w, position.most);
  for (const auto& corner : corners_) tuning.corners.push_back(look(corner, w, position.most));
  tuning.worstVelocity = tuning.corners.front().velocity;
  tuning.worstPosition = tuning.corners.front().position;
  for (const TuningCorner& one : tuning.corners) {
    tuning.worstVelocity = worse(tuning.worstVelocity, one.velocity);
    tuning.worstPosition = worse(tuning.worstPosition, one.position);
  }
  auto noise = loopNoise(nominal, options_.noise);
  if (!noise) return noise.error();
  tuning.noise = *noise;
  return tuning;
}

}  // namespace

std::string_view nameOf(Stiffness stiffness) {
  return names[static_cast<size_t>(stiffness)];
}

std::optional<Stiffness> stiffnessNamed(std::string_view name) {
  const auto* found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return {};
  return static_cast<Stiffness>(found - names.begin());
}

WantedMargins wantedMargins(Stiffness stiffness) {
  switch (stiffness) {
    case Stiffness::soft:
      return {4.0, 60.0 * degree, 1.4, 0.01};
    case Stiffness::medium:
      return {3.0, 45.0 * degree, 1.6, 0.02};
    case Stiffness::stiff:
      break;
  }
  return {2.0, 30.0 * degree, 2.0, 0.05};
}

std::string lossOfMargins(const LoopMargins& found, const WantedMargins& wanted) {
  if (!found.stable) return "stability";
  if (found.peakSensitivity > wanted.peakSensitivity) return "peak of the sensitivity";
  if (found.gainMargin < wanted.gainMargin) return "gain margin";
  if (found.phaseMargin_rad < wanted.phaseMargin_rad) return "phase margin";
  return {};
}

namespace {

Result<void> awayFromZero(const Estimate& inertia_kg_m2, const Estimate& torqueConstant_Nm_per_A) {
  if (!(inertia_kg_m2.low95() > 0.0)) return Error{"inertia_kg_m2", message("has an interval that reaches zero")};
  if (!(torqueConstant_Nm_per_A.low95() > 0.0))
    return Error{"torque_constant_Nm_per_A", message("has an interval that reaches zero")};
  return {};
}

}  // namespace

Result<Tuning> autoTune(const ServoLoop& loop, const Estimate& inertia_kg_m2, const Estimate& torqueConstant_Nm_per_A,
                        const AutoTuningOptions& options) {
  if (auto away = awayFromZero(inertia_kg_m2, torqueConstant_Nm_per_A); !away) return away.error();
  return Tuner(loop, inertia_kg_m2, torqueConstant_Nm_per_A, options).tune();
}

Result<VelocityTuning> tuneVelocity(const ServoLoop& loop, const Estimate& inertia_kg_m2,
                                    const Estimate& torqueConstant_Nm_per_A, const AutoTuningOptions& options) {
  if (auto away = awayFromZero(inertia_kg_m2, torqueConstant_Nm_per_A); !away) return away.error();
  return Tuner(loop, inertia_kg_m2, torqueConstant_Nm_per_A, options).tuneVelocity();
}

}  // namespace breakaway
