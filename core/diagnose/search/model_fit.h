// Models with and without effects, and their fits to the training windows.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/time_limit.h"
#include "diagnose/fit/preparation.h"
#include "diagnose/fit/split.h"
#include "diagnose/fit/windowed_fit.h"
#include "diagnose/screen/screen.h"

namespace breakaway {

/// How many simulated steps the search may still spend on loads that swing: those behind a gap need fine ones, and
/// where nothing explains a recording, all their shapes are tried. A count, not a clock: the answer is the same on any
/// machine.
class StepBudget {
 public:
  explicit StepBudget(double steps) : left_(steps) {}
  /// Whether there are so many left; then they are spent.
  bool take(double steps) {
    left_ -= steps;
    return left_ >= 0.0;
  }

 private:
  double left_;
};

/// How a search goes.
struct SearchSettings {
  std::vector<const Effect*> effects;  ///< that are looked for: the catalogue, or what of it the errors can show
  Freedom freedom;
  Excitation seen;
  Criteria criteria;
  std::uint64_t seed = 1;
  std::stop_token stop;
  TimeLimit time;
  std::function<void(double, const Message&)> progress;
  std::function<void(const std::vector<const Effect*>&)> named;  ///< called once, when the names are likely to stay
  std::vector<double> windowWeights;                             ///< of split.train; empty: all 1
  /// What a model may err by, rms, for bounds of sizes by profile: one that is far off lacks something, and what it
  /// makes of a size that is held says nothing of that size.
  double adequate = std::numeric_limits<double>::infinity();
  bool mayShorten = false;                ///< the windows, where the motion can't be foreseen over their length
  bool mayTurnToTorque = false;           ///< the same, to errors in torque
  std::shared_ptr<StepBudget> loadSteps;  ///< of the whole search
};

/// What of a limited time goes into looking for effects, and until when they are weighed; the rest is for the proof.
inline constexpr double partToSearch = 0.65, partToWeigh = 0.8;

/// What a search runs on.
struct SearchInput : SearchSettings {
  const std::vector<Track>& tracks;
  const Split& split;

  SearchInput(const Preparation& prepared, std::uint64_t seed);
  /// The same search on other windows of these tracks, whose weights are `weights`.
  SearchInput(const SearchInput& other, const Split& windows, std::vector<double> weights)
      : SearchSettings(other), tracks(other.tracks), split(windows) {
    windowWeights = std::move(weights);
  }
  /// Whether to look no further: what was found has to be weighed and proved, too, before the time is over.
  bool enough() const { return stop.stop_requested() || time.over(partToSearch); }
  /// Whether to weigh no further.
  bool enoughWeighed() const { return stop.stop_requested() || time.over(partToWeigh); }
  void say(double part, const Message& activity) const {
    if (progress) progress(part, activity);
  }
};

Model with(const SearchInput& input, const Model& model, const Pick& pick);
Model without(const Model& model, const Effect& effect);

/// The model with the screen's base parameters (LinearRig's order), where they make sense.
Model withScreenedBase(const SearchInput& input, Model model, const Eigen::VectorXd& coefficients);

/// The model with one effect at a time at another variant.
std::vector<Model> variantsOf(const SearchInput& input, const Model& model);

/// What an amplitude of that name makes in Nm or N at the most; nothing where it is no torque.
std::optional<double> torqueOf(const std::string& name, double value, const Excitation& seen);

/// Whether an effect, or every one of a model, is of a sign and size that it can have, and large enough to be told from
/// what every rig does besides.
bool plausible(const Effect& effect, const std::vector<double>& parameters, const Excitation& seen);
bool plausible(const EffectTerm& term, const Excitation& seen);
bool plausible(const Model& model, const Excitation& seen);
/// The same, however small the effects are.
bool possible(const Model& model, const Excitation& seen);

/// Whether the effect's amplitude, its first parameter, can't be told from zero.
bool vanishes(const Model& model, const Effect& effect);

/// Whether effects of the model carry hidden states, so that a fit has to simulate each parameter's change.
bool remembers(const Model& model);

/// What a fit may change; `last`: also what is held before; `heldSize`: but for that effect's size.
ParameterVector vectorOf(const SearchInput& input, const Model& model, bool last = false,
                         std::optional<size_t> heldSize = {});

/// A fit of `model` to the training windows.
FitResult fitModel(const SearchInput& input, const Model& model, int iterations = 20);

/// In long windows a wrong start of a wave is a valley away from the right one: a fit to short windows.
Model fitShort(const SearchInput& input, const Model& model, double tolerance = 1e-3);

/// The base model: the best of the fits from each start.
FitResult fitBase(const SearchInput& input, const std::vector<Model>& starts);

/// Whether it holds something that happens in one recording only, at a time of its own.
bool happensOnce(const Model& model);
/// Whether it holds friction that grows the longer the axis rests.
bool growsAtRest(const Model& model);

/// Weights for the last refinement of a model: windows in which the base model errs far more than in others count less,
/// or those in which the model itself does, if it holds what happens once or grows at rest, and rests on them.
std::vector<double> polishWeights(const SearchInput& input, const Model& base, const Model& model);

/// The last refinement's fit, on the overlapping windows.
FitResult refineModel(const SearchInput& input, const Model& model, const std::vector<double>& windowWeights);
/// The last refinement: the same, with bounds of sizes by profile.
FitResult polishModel(const SearchInput& input, const Model& model, const std::vector<double>& windowWeights = {});

/// The effects named, each at its best shape by the screen, fitted together with the base.
Result<FitResult> fitNamed(const SearchInput& input, const std::vector<Model>& starts,
                           const std::vector<std::string>& names);

}  // namespace breakaway
