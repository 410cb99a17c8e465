#include "trial/sealed_trial.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "base/atomic_file.h"
#include "recording/csv.h"
#include "trial/trial_course.h"
#include "trial/trial_effects.h"
#include "trial/trial_imperfections.h"
#include "trial/trial_recorder.h"
#include "trial/trial_rig.h"
#include "trial/trial_sizing.h"

namespace breakaway {

namespace {

using Names = std::vector<std::string>;

/// The families beyond single effects, with their share in percent of what `breakaway trial` draws.
const std::vector<std::pair<std::string, unsigned>> furtherFamilies{
    {"combination", 10}, {"masked", 5}, {"noisy", 5},     {"weak", 5}, {"low", 5},
    {"outside", 8},      {"clean", 8},  {"imperfect", 5}, {"rough", 5}};

/// What is drawn from when any one effect will do.
const Names commonEffects{"constant_load",   "viscous_asymmetry", "stribeck",
                          "presliding",      "quadratic_drag",    "position_dependent_friction",
                          "friction_warmup", "imbalance",         "cogging",
                          "torque_ripple",   "transport_delay",   "external_disturbance"};

/// What slow motion hides.
const Names hiddenEffects{"viscous_asymmetry", "quadratic_drag", "position_dependent_viscous",
                          "torque_saturation", "torque_ripple",  "load_dependent_friction",
                          "transport_delay",   "compliance"};

/// Effects of different kinds that one rig and one course show together.
const std::vector<Names> combinations{{"stribeck", "cogging"},
                                      {"stribeck", "constant_load"},
                                      {"cogging", "quadratic_drag"},
                                      {"imbalance", "position_dependent_friction"},
                                      {"friction_warmup", "cogging"},
                                      {"viscous_asymmetry", "cogging"},
                                      {"presliding", "quadratic_drag"},
                                      {"torque_ripple", "constant_load"},
                                      {"dead_time", "cogging"},
                                      {"transport_delay", "quadratic_drag"},
                                      {"compliance", "constant_load"},
                                      {"backlash", "viscous_asymmetry"},
                                      {"winding_heating", "cogging"},
                                      {"supply_sag", "position_dependent_friction"},
                                      {"external_disturbance", "quadratic_drag"},
                                      {"encoder_eccentricity", "stribeck"},
                                      {"current_sensor_offset", "stribeck"},
                                      {"load_dependent_friction", "cogging"},
                                      {"stribeck", "imbalance", "friction_warmup"},
                                      {"cogging", "constant_load", "quadratic_drag"},
                                      {"coulomb_asymmetry", "cogging", "external_disturbance"}};

/// Below the first an effect would be too small to be called physics, above the second too large to be true.
constexpr double smallestSize = 0.06, smallestWeakSize = 0.02, largestSize = 2.0;

template <typename T>
const T& oneOf(const std::vector<T>& all, Random& random) {
  return all[random.below(all.size())];
}

std::vector<const TrialEffect*> drawEffects(const std::string& family, Random& random) {
  if (family == "clean" || family == "imperfect") return {};
  if (family == "outside") return {&oneOf(outsideEffects(), random)};
  Names names{family};
  if (family == "combination") names = oneOf(combinations, random);
  if (family == "masked" || family == "noisy" || family == "weak" || family == "rough")
    names = {oneOf(commonEffects, random)};
  if (family == "low") names = {oneOf(hiddenEffects, random)};
  std::vector<const TrialEffect*> effects;
  for (const std::string& name : names) effects.push_back(&trialEffectNamed(name));
  return effects;
}

TrialNeeds needsOf(const std::string& family, const std::vector<const TrialEffect*>& effects) {
  TrialNeeds needs;
  for (const TrialEffect* effect : effects) {
    const TrialNeeds& own = effect->needs;
    needs.electrical |= own.electrical;
    needs.windings |= own.windings;
    needs.heldTorque |= own.heldTorque;
    needs.currentSeen |= own.currentSeen;
    needs.rotary |= own.rotary;
    needs.noPendulum |= own.noPendulum;
    needs.positionLoop |= own.positionLoop;
  }
  needs.masked = family == "masked";
  needs.noisy = family == "noisy";
  return needs;
}

/// What moves show all effects.
std::vector<TrialMove> movesFor(const std::vector<const TrialEffect*>& effects) {
  std::vector<TrialMove> moves;
  for (const TrialEffect* effect : effects) moves.insert(moves.end(), effect->moves.begin(), effect->moves.end());
  if (moves.empty()) moves = {TrialMove::multisine, TrialMove::turns, TrialMove::steps, TrialMove::ramps};
  return moves;
}

/// Imperfections that every plant has and none of which matters: far below one count.
void addTrifles(TrialRig& rig, Random& random) {
  PlantPhysics& p = rig.physics;
  p.load = -1e-5 * rig.peakTorque * random.normal();
  if (rig.axis == Axis::rotary) {
    const double cogging = 5e-5 * rig.peakTorque * random.uniform();
    p.position.push_back({36.0, cogging, 6.0 * random.uniform()});
    const double swing = 0.2 * rig.sensors.count * random.uniform();
    rig.sensors.eccentricity = {1.0, swing, 6.0 * random.uniform()};
  }
}

/// How many floors it shall cost to leave one effect out.
double drawCost(const std::string& family, Random& random) {
  if (family == "rough") return drawnLog(random, 10.0, 30.0);
  return family == "weak" ? drawnLog(random, 1.8, 3.0) : drawnLog(random, 4.0, 12.0);
}

/// The size at which leaving the effect out costs `cost` floors, tried out on the rig and course; the same draws follow
/// for every size.
double sizeFor(const TrialEffect& effect, const TrialRig& rig, const TrialCourse& course, double cost, double smallest,
               std::uint64_t seed) {
  if (!effect.sized) return 1.0;
  double size = 1.0, lastSize = 0.0, lastCost = 0.0, power = 1.0;  // cost grows as size to this power
  for (int round = 0; round < 3; ++round) {
    TrialRig tried = rig;
    Random random(seed);
    effect.conceal(tried, course, size, random);
    TrialTrace trace;
    (void)recordTrial(tried, course, "trial", seed, &trace);
    const double found = std::max(0.05, costOfLeavingOut(tried, trace));
    if (found > 0.75 * cost && found < 1.33 * cost) break;
    if (round > 0 && size != lastSize) {
      power = std::clamp(std::log(found / lastCost) / std::log(size / lastSize), 0.5, 3.0);
    }
    lastSize = size;
    lastCost = found;
    size = std::clamp(size * std::pow(cost / found, 1.0 / power), smallest, largestSize);
  }
  return size;
}

/// Another course of the same moves; before an end stop one that runs into it about as far as the first.
std::optional<TrialCourse> secondCourse(const TrialRig& rig, const std::vector<TrialMove>& moves,
                                        const TrialCourse& first, Random& random) {
  const auto& stops = rig.physics.stops;
  const auto beyond = [&stops](const TrialCourse& course) {
    const auto [low, high] = std::minmax_element(course.position.begin(), course.position.end());
    return std::max(*high - stops.high_rad, stops.low_rad - *low);
  };
  for (int attempt = 0; attempt < 30; ++attempt) {
    TrialCourse course = drawCourse(rig, moves, drawn(random, 20.0, 30.0), random);
    if (!stops.present || (beyond(course) > 0.3 * beyond(first) && beyond(course) < 1.6 * beyond(first))) return course;
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::string> trialFamilies() {
  Names names;
  for (const TrialEffect& effect : catalogueEffects()) names.push_back(effect.name);
  for (const auto& [family, share] : furtherFamilies) names.push_back(family);
  return names;
}

std::string familyOf(std::uint64_t seed) {
  Random random(seed ^ 0xfa311eULL);
  size_t percent = random.below(100);
  for (const auto& [family, share] : furtherFamilies) {
    if (percent < share) return family;
    percent -= share;
  }
  return oneOf(catalogueEffects(), random).name;
}

SealedTrial makeTrial(const std::string& family, std::uint64_t seed, const TrialForm& form) {
  SealedTrial trial;
  trial.family = family;
  trial.seed = seed;
  std::uint64_t mixed = seed;
  for (const char letter : family) mixed = mixed * 1099511628211ULL + static_cast<unsigned char>(letter);
  Random random(mixed);

  const auto effects = drawEffects(family, random);
  TrialRig rig = drawTrialRig(needsOf(family, effects), random);
  const bool imperfect = family == "imperfect" || family == "rough";
  TrialLogger logger;
  if (imperfect) logger = drawImperfections(rig, random);
  if (form.row_s > 0.0) rig.sensors.row_s = form.row_s;
  double duration_s = drawn(random, 30.0, 36.0);
  for (const TrialEffect* effect : effects) duration_s = std::max(duration_s, effect->shortest_s);
  if (form.duration_s > 0.0) duration_s = form.duration_s;
  std::vector<TrialMove> moves = movesFor(effects);
  const TrialCourse course = drawCourse(rig, moves, duration_s, random);
  const TrialRig plain = rig;
  if (!imperfect) addTrifles(rig, random);
  const double smallest = family == "weak" ? smallestWeakSize : smallestSize;
  for (const TrialEffect* effect : effects) {
    const std::uint64_t own = random.bits();
    const double size = sizeFor(*effect, plain, course, drawCost(family, random), smallest, own);
    Random same(own);
    trial.truth.push_back(effect->conceal(rig, course, size, same));
  }
  trial.wanderShare = rig.physics.outside.wander / rig.coulomb();
  if (trial.wanderShare > 0.0) trial.wander_s = rig.physics.outside.wanderTime_s;
  if (family == "outside") trial.outside = effects.front()->name;

  trial.bench = believedBench(rig, random);
  const bool described = random.uniform() < 0.6 || family == "masked";
  if (described && rig.input != DriveInput::torque && rig.loop.mode != ControlMode::openLoop)
    trial.bench.controller = describedLoop(rig);
  const bool hardlyShown = family == "low";
  const auto record = [&](const TrialCourse& way, const char* name) {
    const Recording all = recordTrial(rig, way, name, random.bits());
    return imperfect ? logged(all, rig, logger, random) : all;
  };
  const TrialCourse poor =
      hardlyShown
          ? drawCourse(rig, {TrialMove::idle, moves.front(), TrialMove::idle, TrialMove::idle}, duration_s, random)
          : course;
  trial.recordings.push_back(record(poor, "recording.csv"));
  rig.physics.pulse.torque = 0.0;  // what happened once doesn't come again
  if (random.uniform() < 0.15) {
    const auto repeat = secondCourse(rig, moves, course, random);
    if (repeat) trial.recordings.push_back(record(*repeat, "recording2.csv"));
  }
  if (random.uniform() < 0.5) {
    std::reverse(moves.begin(), moves.end());
    const auto second = secondCourse(rig, moves, course, random);
    if (second) trial.heldout.push_back(record(*second, "heldout.csv"));
  }
  return trial;
}

Result<void> writeTrial(const SealedTrial& trial, const std::string& folder) {
  if (auto done = makeFolder(folder); !done) return done;
  if (auto done = writeBench(trial.bench, folder + "/bench.json"); !done) return done;
  for (const auto* recordings : {&trial.recordings, &trial.heldout}) {
    for (const Recording& one : *recordings) {
      if (auto done = writeCsv(one, folder + "/" + one.name()); !done) return done;
    }
  }
  return {};
}

}  // namespace breakaway
