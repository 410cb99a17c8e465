#include "diagnose/search/model_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "base/statistics.h"
#include "diagnose/effects/catalogue.h"
#include "diagnose/effects/wording.h"
#include "diagnose/fit/cross_validation.h"
#include "diagnose/fit/size_profile.h"
#include "diagnose/search/swinging_load.h"
#include "diagnose/simulate/physics.h"

namespace breakaway {

namespace {

EffectTerm termOf(const Effect& effect, Axis axis, const std::vector<double>& values) {
  EffectTerm term{std::string(effect.name()), {}};
  const auto specs = effect.parameters(axis);
  for (size_t k = 0; k < specs.size(); ++k) {
    const double value = std::clamp(values[k], specs[k].lower, specs[k].upper);
    term.parameters.push_back({specs[k].name, value, value, value});
  }
  return term;
}

constexpr double otherInertia = 3.0;  ///< times as much or as little: where else a fit begins
constexpr double startOfWinding_s = 5e-4;
constexpr double startOfLoop = 0.4;  ///< of the slowest that a current loop may be
constexpr double leastLoadSteps = 1e8, loadStepsPerRow = 600.0;

bool endsWith(const std::string& text, std::string_view end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

}  // namespace

std::optional<double> torqueOf(const std::string& name, double value, const Excitation& seen) {
  const double size = std::abs(value), speed = seen.highSpeed;
  if (endsWith(name, "_Nm") || endsWith(name, "_N")) return size;
  if (endsWith(name, "_Nm_s_per_rad") || endsWith(name, "_N_s_per_m")) return size * speed;
  if (endsWith(name, "_Nm_s2_per_rad2") || endsWith(name, "_N_s2_per_m2")) return size * speed * speed;
  return std::nullopt;
}

/// Whether errors in torque can show an effect: it is a torque, and none that follows from the drive, which would
/// explain the drive's torque by itself.
static bool showsInTorque(const Effect& effect, DriveInput drive, const Excitation& seen) {
  if (!effect.isTorqueAlone(drive)) return false;
  const auto shapes = effect.shapes(seen);
  if (shapes.empty()) return true;
  Situation at;
  at.axis = seen.axis;
  at.position = 0.5 * (seen.lowest + seen.highest);
  at.velocity = seen.highSpeed;
  at.direction = 1.0;
  const auto torqueAt = [&](double part) {
    at.driveTorque = part * seen.peakTorque;
    at.current = part * seen.peakCurrent;
    at.input = part * seen.peakInput;
    const Term term = effect.term(shapes.front().front(), at);
    return term.load_Nm + term.friction_Nm;
  };
  return torqueAt(0.0) == torqueAt(1.0);
}

SearchInput::SearchInput(const Preparation& prepared, std::uint64_t anySeed)
    : tracks(prepared.tracks), split(prepared.split) {
  effects = {catalogue().begin(), catalogue().end()};
  freedom = prepared.freedom;
  seen = prepared.seen;
  criteria = prepared.criteria;
  seed = anySeed;
  const bool inTorque = !split.train.empty() && split.train.front().errorIn == ErrorIn::torque;
  if (inTorque)
    std::erase_if(effects, [this](const Effect* one) { return !showsInTorque(*one, tracks.front().drive, seen); });
  double rows = 0.0;
  for (const Window& window : split.train) rows += static_cast<double>(window.last - window.first);
  loadSteps = std::make_shared<StepBudget>(leastLoadSteps + loadStepsPerRow * rows);
}

Model with(const SearchInput& input, const Model& model, const Pick& pick) {
  Model out = model;
  out.effects.push_back(termOf(*pick.effect, model.axis, pick.parameters));
  if (pick.track != everyTrack) out.effects.back().recording = fileNameOf(input.tracks[pick.track].name);
  return out;
}

bool plausible(const Effect& effect, const std::vector<double>& parameters, const Excitation& seen) {
  if (!effect.plausible(parameters, seen)) return false;
  const auto torque = torqueOf(effect.parameters(seen.axis).front().name, parameters.front(), seen);
  return !torque || *torque >= seen.immaterialTorque();
}

bool plausible(const EffectTerm& term, const Excitation& seen) {
  return plausible(*findEffect(term.effect), valuesOf(term), seen);
}

bool possible(const Model& model, const Excitation& seen) {
  return std::all_of(model.effects.begin(), model.effects.end(), [&seen](const EffectTerm& term) {
    return findEffect(term.effect)->plausible(valuesOf(term), seen);
  });
}

bool plausible(const Model& model, const Excitation& seen) {
  return std::all_of(model.effects.begin(), model.effects.end(),
                     [&seen](const EffectTerm& term) { return plausible(term, seen); });
}

Model without(const Model& model, const Effect& effect) {
  Model out = model;
  std::erase_if(out.effects, [&effect](const EffectTerm& term) { return term.effect == effect.name(); });
  return out;
}

bool vanishes(const Model& model, const Effect& effect) {
  for (const EffectTerm& term : model.effects) {
    if (term.effect == effect.name())
      return term.parameters.front().low95 < 0.0 && term.parameters.front().high95 > 0.0;
  }
  return true;
}

bool remembers(const Model& model) {
  return std::any_of(model.effects.begin(), model.effects.end(),
                     [](const EffectTerm& term) { return findEffect(term.effect)->hidden() != nullptr; });
}

ParameterVector vectorOf(const SearchInput& input, const Model& model, bool last, std::optional<size_t> heldSize) {
  Freedom freedom = input.freedom;
  freedom.heldSize = heldSize;
  return {model, freedom, std::max(input.seen.peakTorque, 1e-12), std::max(input.seen.highSpeed, 1e-9), last};
}

Model withScreenedBase(const SearchInput& input, Model model, const Eigen::VectorXd& coefficients) {
  const Physics physics = physicsOf(model);
  const MotorNames& names = motorNames(model.axis);
  const double hanging = model.pendulum ? pendulumInertia(*model.pendulum) : 0.0;
  const double emf = physics.electrical ? physics.torqueConstant * physics.backEmf / physics.resistance : 0.0;
  // The linear rig's back-EMF doesn't lag behind the inductance: J comes out smaller by that.
  const double late = physics.electrical ? physics.inductance / physics.resistance * emf : 0.0;
  // Where gravity is known, it tells the drive's scale.
  const double scale = physics.gravity > 0.0 ? std::hypot(coefficients[3], coefficients[4]) / physics.gravity : 1.0;
  const char* drive = physics.electrical ? names.resistance : names.torqueConstant;
  const double driveValue = physics.electrical ? physics.resistance * scale : physics.torqueConstant / scale;
  const std::array<std::pair<const char*, double>, 4> found{{{names.inertia, coefficients[0] / scale - hanging + late},
                                                             {names.viscous, coefficients[1] / scale - emf / scale},
                                                             {names.coulomb, coefficients[2] / scale},
                                                             {drive, driveValue}}};
  for (const auto& [name, value] : found) {
    if (!(value > 0.0) || input.freedom.holds(name)) continue;
    for (Parameter& one : model.base) {
      if (one.name == name) one.value = value;
    }
  }
  return model;
}

std::vector<Model> variantsOf(const SearchInput& input, const Model& model) {
  std::vector<Model> variants;
  for (size_t e = 0; e < model.effects.size(); ++e) {
    const Effect& effect = *findEffect(model.effects[e].effect);
    for (const auto& variant : effect.variants(valuesOf(model.effects[e]), input.seen)) {
      variants.push_back(model);
      variants.back().effects[e] = termOf(effect, model.axis, variant);
      variants.back().effects[e].recording = model.effects[e].recording;
    }
  }
  return variants;
}

/// A base model is fitted to its end: all else rests on it, and it is the answer where nothing was found in time.
static TimeLimit timeFor(const SearchInput& input, const Model& model) {
  return model.effects.empty() ? TimeLimit() : input.time;
}

FitResult fitModel(const SearchInput& input, const Model& model, int iterations) {
  if (remembers(model)) iterations = std::min(iterations, 5);  // each takes several times as long
  const auto fitted = [&](const Model& start) {
    return fitWindows(vectorOf(input, start), input.tracks, input.split.train,
                      {.iterations = iterations,
                       .tolerance = 1e-3,
                       .windowWeights = input.windowWeights,
                       .weights = {},
                       .stop = input.stop,
                       .time = timeFor(input, start)});
  };
  FitResult fit = fitted(model);
  // The worse a start was, the more it holds its fit back: if the fit has come far below it, it goes on from there.
  if (!fit.usable || remembers(model) || fit.rmse * fit.weights.position > input.criteria.half) return fit;
  FitResult further = fitted(fit.model);
  return further.usable && further.rmse < fit.rmse ? further : fit;
}

Model fitShort(const SearchInput& input, const Model& model, double tolerance) {
  return fitWindows(vectorOf(input, model), input.tracks, input.split.trainScore,
                    {.iterations = 8,
                     .tolerance = tolerance,
                     .windowWeights = {},
                     .weights = {},
                     .stop = input.stop,
                     .time = timeFor(input, model)})
      .model;
}

/// The base model with a further parameter, from the best of `starts`, where windows that a fit didn't see err less
/// with it, typically and in the mean: it is likely beforehand, so that they needn't prove it.
static FitResult withFurther(const SearchInput& input, FitResult base, const std::string& name,
                             std::initializer_list<double> starts) {
  FitResult further;
  for (const double start : starts) {
    if (input.enough()) break;
    Model model = base.model;
    model.base.push_back({name, start, start, start});
    FitResult fit = fitModel(input, model, 8);
    if (fit.usable && (further.windows.empty() || fit.rmse < further.rmse)) further = std::move(fit);
  }
  if (further.windows.empty()) return base;
  const auto unseen = [&](const FitResult& fit) {
    return crossValidated(fit, input.tracks, input.split.train, input.windowWeights, input.split.fold, folds,
                          base.weights);
  };
  const auto before = unseen(base), after = unseen(further);
  const double gain = 1.0 - mean(after) / mean(before);
  const bool typically = typicalPart(after, before, input.criteria.hardlyAny) < input.criteria.hardlyLess;
  return gain > input.criteria.hardlyAny && typically ? further : base;
}

/// A motor that a voltage drives may follow it within a few rows, which hardly show the inertia then, and a fit may
/// come to rest in another valley: where even the best one is far off its sensors' noise, it begins again with far more
/// of it and with far less.
static void fromOtherInertias(const SearchInput& input, FitResult& best) {
  const char* inertia = motorNames(best.model.axis).inertia;
  double noise = 0.0;
  for (const Track& track : input.tracks) noise = std::max(noise, track.readingNoise());
  const bool inMotion = input.split.train.front().errorIn == ErrorIn::motion;
  const bool follows = physicsOf(best.model).electrical;  // a current's torque shows the inertia in every row
  if (!follows || !inMotion || input.enough() || input.freedom.holds(inertia) ||
      best.rmse <= input.criteria.farOff * noise)
    return;
  const Model begun = best.model;
  double least = input.criteria.farLess * std::pow(fitModel(input, begun, 8).rmse, 2);  // all go on for as long
  for (const double factor : {1.0 / otherInertia, otherInertia}) {
    Model start = begun;
    for (Parameter& one : start.base) one.value *= one.name == inertia ? factor : 1.0;
    FitResult fit = fitModel(input, start, 8);
    if (!fit.usable || std::pow(fit.rmse, 2) >= least) continue;
    least = std::pow(fit.rmse, 2);
    best = std::move(fit);
  }
}

/// The base model with an inductance, where voltage drives and nobody knows one.
static FitResult withWinding(const SearchInput& input, FitResult base) {
  const Physics physics = physicsOf(base.model);
  const char* inductance = motorNames(base.model.axis).inductance;
  if (!physics.electrical || base.model.baseValue(inductance)) return base;
  return withFurther(input, std::move(base), inductance, {startOfWinding_s * physics.resistance});
}

/// The base model with a drive that acts earlier or later than recorded, if it may and doesn't yet.
static FitResult withLateness(const SearchInput& input, FitResult base) {
  const Freedom& freedom = input.freedom;
  if (!freedom.mayBeLate() || base.model.baseValue(driveLateName)) return base;
  const double follows_s = startOfLoop * freedom.leastLate_s;
  return freedom.mostLate_s > 0.0 ? withFurther(input, std::move(base), driveLateName,
                                                {follows_s, 0.5 * freedom.mostLate_s, freedom.mostLate_s})
                                  : withFurther(input, std::move(base), driveLateName, {follows_s});
}

FitResult fitBase(const SearchInput& input, const std::vector<Model>& starts) {
  FitResult best;
  for (const Model& start : starts) {
    if (!best.windows.empty() && input.enough()) break;
    FitResult fit = fitModel(input, start, 8);
    if (best.windows.empty() || (fit.usable && fit.rmse < best.rmse)) best = std::move(fit);
  }
  if (!best.usable) return best;
  fromOtherInertias(input, best);
  const auto withLags = [&](FitResult fit) { return withLateness(input, withWinding(input, std::move(fit))); };
  best = withLags(std::move(best));
  if (!(input.freedom.mostBias > 0.0)) return best;
  FitResult biased = withFurther(input, best, biasName(input.seen.axis), {0.0});
  // One that would be larger, if it could, is no trifle.
  const double bias = biased.model.baseValue(biasName(input.seen.axis)).value_or(0.0);
  if (std::abs(bias) >= input.criteria.hardlyLess * input.freedom.mostBias) return best;
  return withLags(std::move(biased));  // a load that is always there hides how late the drive is
}

bool happensOnce(const Model& model) {
  return std::any_of(model.effects.begin(), model.effects.end(),
                     [](const EffectTerm& term) { return findEffect(term.effect)->happensOnce(); });
}

bool growsAtRest(const Model& model) {
  return std::any_of(model.effects.begin(), model.effects.end(),
                     [](const EffectTerm& term) { return findEffect(term.effect)->growsAtRest(); });
}

std::vector<double> polishWeights(const SearchInput& input, const Model& base, const Model& model) {
  const bool restsOnFew = happensOnce(model) || growsAtRest(model);
  return robustWeights(residualSquares(restsOnFew ? model : base, input.tracks, input.split.polish));
}

static FitOptions polishOptions(const SearchInput& input, const Model& model, bool slow,
                                const std::vector<double>& windowWeights) {
  return {.iterations = slow ? 4 : 6,
          .tolerance = slow ? 1e-3 : 3e-5,
          .exact = !slow,
          .windowWeights = slow ? input.windowWeights : windowWeights,
          .weights = {},
          .stop = input.stop,
          .time = timeFor(input, model)};
}

FitResult refineModel(const SearchInput& input, const Model& model, const std::vector<double>& windowWeights) {
  if (remembers(model)) return fitModel(input, model, 4);
  return fitWindows(vectorOf(input, model, true), input.tracks, input.split.polish,
                    polishOptions(input, model, false, windowWeights));
}

FitResult polishModel(const SearchInput& input, const Model& model, const std::vector<double>& windowWeights) {
  FitResult fit = refineModel(input, model, windowWeights);
  if (!(fit.rmse < input.adequate)) return fit;
  const bool slow = remembers(model);
  const std::vector<Window>& windows = slow ? input.split.train : input.split.polish;
  FitOptions options = polishOptions(input, model, slow, windowWeights);
  profileSizes(fit, [&](const Model& start, size_t effect, const Weights& weights) {
    options.weights = weights;
    options.iterations = 20;  // one that came to no end would seem to err more than it has to
    options.tolerance = 1e-3;
    return fitWindows(vectorOf(input, start, !slow, effect), input.tracks, windows, options);
  });
  return fit;
}

Result<FitResult> fitNamed(const SearchInput& input, const std::vector<Model>& starts,
                           const std::vector<std::string>& names) {
  FitResult fit = fitModel(input, fitBase(input, starts).model);
  if (!names.empty()) {
    std::vector<const Effect*> effects;
    effects.reserve(names.size());
    for (const std::string& name : names) effects.push_back(findEffect(name));
    Model model = fit.model;
    std::vector<Pick> picks;
    const LinearRig rig(model, input.tracks, input.split.train);
    const Model base = model;
    Eigen::VectorXd coefficients;  // of the base, beside all effects
    for (const Effect* effect : effects) {
      const Screen screen(rig, {effect}, input.seen, input.split.fold, folds, input.seed, input.criteria);
      picks.push_back(screen.best(*effect, picks));
      const auto shapes = effect->shapes(input.seen);
      if (picks.back().parameters.empty() && !shapes.empty()) {  // only the regression sees none of it
        picks.back().shape = shapes.front();
        picks.back().parameters = shapes.front().front();
      }
      if (picks.back().parameters.empty()) {
        return Error{input.tracks.front().name, message("can't show the effect {}: {}", effectName(*effect),
                                                        effect->neededExcitation(input.seen))};
      }
      model = with(input, model, picks.back());
      coefficients = screen.baseCoefficients(picks);
    }
    Model screened = withScreenedBase(input, base, coefficients);
    for (const Pick& pick : picks) screened = with(input, screened, pick);
    fit = fitModel(input, fitShort(input, model, 1e-4));
    // What the base model has taken for its own may hold the fit back.
    FitResult other = fitModel(input, screened);
    if (other.usable && mean(other.windowSquares) < mean(fit.windowSquares)) fit = std::move(other);
  }
  fit = polishModel(input, fit.model);
  if (!fit.usable)
    return Error{input.tracks.front().name, "can't be fitted: the search for the best parameters came to no end"};
  return fit;
}

}  // namespace breakaway
