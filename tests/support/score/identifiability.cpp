#include "score/identifiability.h"

#include <algorithm>
#include <cmath>

#include "base/statistics.h"
#include "diagnose/effects/catalogue.h"
#include "diagnose/fit/noise_floor.h"
#include "diagnose/fit/preparation.h"
#include "diagnose/fit/windowed_fit.h"
#include "diagnose/search/model_fit.h"
#include "score/scored_trial.h"

namespace breakaway {

namespace {

constexpr double materialFloors = 1.6;
constexpr double clearErrors = 2.0;
constexpr size_t mostRivals = 3;
constexpr double window_s = 0.5;

using Names = std::vector<std::string>;

/// The other effects that are taken for `effect`, apart from itself, its twin and what is concealed as well.
Names lookAlikesOf(const std::string& effect, const Names& truth) {
  Names names;
  for (const std::string_view one : findEffect(effect)->lookAlikes()) {
    const std::string name(one);
    const bool concealed = std::any_of(
        truth.begin(), truth.end(), [&name](const std::string& other) { return countedAs(other) == countedAs(name); });
    if (!concealed && findEffect(name) != nullptr) names.push_back(name);
  }
  return names;
}

std::vector<Names> rivalsOf(const Names& truth) {
  std::vector<Names> rivals;
  const size_t each = std::max<size_t>(1, mostRivals / truth.size());
  for (size_t k = 0; k < truth.size(); ++k) {
    const Names alike = lookAlikesOf(truth[k], truth);
    for (size_t a = 0; a < std::min(each, alike.size()); ++a) {
      rivals.push_back(truth);
      rivals.back()[k] = alike[a];
    }
    if (!alike.empty()) continue;
    rivals.push_back(truth);
    rivals.back().erase(rivals.back().begin() + static_cast<std::ptrdiff_t>(k));
  }
  return rivals;
}

/// How much worse `rival` is, window by window, in standard errors of the mean. Compared are the windows' RMSE: single
/// windows would rule the squares.
double standardErrorsWorse(const std::vector<double>& rival, const std::vector<double>& truth) {
  std::vector<double> loss(truth.size());
  for (size_t k = 0; k < loss.size(); ++k) loss[k] = std::sqrt(rival[k]) - std::sqrt(truth[k]);
  const auto n = static_cast<double>(loss.size());
  const double middle = mean(loss), squares = rms(loss) * rms(loss) - middle * middle;
  const double error = std::sqrt(std::max(squares, 0.0) / std::max(1.0, n - 1.0));
  return error > 0.0 ? middle / error : 0.0;
}

}  // namespace

Result<Identifiability> identifiability(const SealedTrial& trial) {
  Names truth;
  if (trial.outside.empty()) {
    for (const Concealed& one : trial.truth) truth.push_back(one.effect);
  }
  for (const std::string& name : truth) {
    if (findEffect(name) == nullptr) return Error{"effect " + name, "is not in the catalogue"};
  }
  const auto prepared = prepare(trial.bench, trial.recordings, trial.heldout, window_s);
  if (!prepared) return prepared.error();
  const SearchInput input(*prepared, 1);
  const auto& windows = prepared->split.heldoutScore;
  const auto errorsOf = [&](const Model& model) { return scoreWindows(model, prepared->tracks, windows); };
  const auto fittedBase = fitNamed(input, prepared->starts, {});
  if (!fittedBase) return fittedBase.error();
  const Model& base = fittedBase->model;
  Identifiability out;
  out.base = std::sqrt(mean(errorsOf(base)));
  const auto weigh = [&out](double floor) {
    out.floor = floor;
    out.material = out.base >= materialFloors * floor;
  };
  if (truth.empty()) {
    weigh(noiseFloor(base, prepared->tracks, windows, 1));
    out.separable = !trial.outside.empty();
    return out;
  }
  const auto best = fitNamed(input, prepared->starts, truth);
  if (!best) return best.error();
  const auto errors = errorsOf(best->model);
  out.truth = std::sqrt(mean(errors));
  weigh(noiseFloor(best->model, prepared->tracks, windows, 1));
  if (!out.material) return out;
  const auto rivals = rivalsOf(truth);
  out.separable = std::all_of(rivals.begin(), rivals.end(), [&](const Names& names) {
    const auto fit = fitNamed(input, prepared->starts, names);
    return !fit || standardErrorsWorse(errorsOf(fit->model), errors) >= clearErrors;
  });
  return out;
}

}  // namespace breakaway
