#include "diagnose/verdict/rival_scores.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/statistics.h"
#include "diagnose/effects/catalogue.h"
#include "diagnose/fit/seen_span.h"
#include "diagnose/fit/windowed_fit.h"

namespace breakaway {

namespace {

constexpr size_t mostScored = 4;  ///< beside those that the finding can't be told from
constexpr size_t draws = 2000;

/// `best` with what was tried in the place of an effect: its terms, and the base beside which it was fitted.
Model inPlaceOf(const Effect& effect, const InPlace& other, const Model& best) {
  Model model = without(best, effect);
  for (Parameter& one : model.base) {
    if (const auto value = other.model.baseValue(one.name)) one.value = *value;
  }
  for (const EffectTerm& term : other.model.effects) {
    if (term.effect == other.effect->name()) model.effects.push_back(term);
  }
  return model;
}

bool isRival(const InPlace* one, const Chosen& chosen) {
  return std::find(chosen.rivals.begin(), chosen.rivals.end(), one->effect) != chosen.rivals.end();
}

/// Those that are listed as rivals, and of the others the best few.
std::vector<const InPlace*> toScore(const Chosen& chosen) {
  std::vector<const InPlace*> all;
  all.reserve(chosen.tried.size());
  for (const InPlace& one : chosen.tried) all.push_back(&one);
  const auto rivals =
      std::stable_partition(all.begin(), all.end(), [&chosen](const InPlace* one) { return isRival(one, chosen); });
  std::stable_sort(rivals, all.end(), [](const InPlace* a, const InPlace* b) { return a->square < b->square; });
  if (all.end() - rivals > static_cast<std::ptrdiff_t>(mostScored)) all.erase(rivals + mostScored, all.end());
  return all;
}

}  // namespace

Interval errorInterval(const std::vector<double>& squares, std::uint64_t seed) {
  return bootstrap(squares.size(), draws, seed, [&](std::span<const size_t> blocks) {
    double sum = 0.0;
    for (const size_t block : blocks) sum += squares[block];
    return std::sqrt(sum / static_cast<double>(std::max<size_t>(blocks.size(), 1)));
  });
}

std::vector<RivalScore> rivalScores(const Chosen& chosen, const SearchResult& found, const Model& best,
                                    const Preparation& prepared, const SearchInput& input) {
  const std::vector<Window>& windows = prepared.split.heldoutScore;
  const std::vector<double> own = scoreWindows(best, prepared.tracks, windows);
  std::vector<RivalScore> scores;
  for (const InPlace* other : toScore(chosen)) {
    // What is far behind needn't be brought as far as can be, which takes long: it stays as it was tried.
    Model model = other->model;
    if (isRival(other, chosen)) {
      const Model start = inPlaceOf(*chosen.effect, *other, best);
      const FitResult fit = refineModel(input, start, polishWeights(input, found.base.model, start));
      if (!fit.usable || input.stop.stop_requested()) continue;
      model = fit.model;
    }
    model = withinSeen(std::move(model), prepared.tracks, prepared.split);
    const std::vector<double> squares = scoreWindows(model, prepared.tracks, windows);
    const double error = std::sqrt(mean(squares));
    if (!std::isfinite(error)) continue;
    const Interval of = errorInterval(squares, input.seed);
    const Interval over = bootstrap(squares.size(), draws, input.seed, [&](std::span<const size_t> blocks) {
      double rival = 0.0, finding = 0.0;
      for (const size_t block : blocks) {
        rival += squares[block];
        finding += own[block];
      }
      return std::sqrt(rival / std::max(finding, 1e-300));
    });
    const double ratio = error / std::max(std::sqrt(mean(own)), 1e-300);
    scores.push_back({std::string(other->effect->name()), error, of.low, of.high, ratio, over.low, over.high});
  }
  std::stable_sort(scores.begin(), scores.end(),
                   [](const RivalScore& a, const RivalScore& b) { return a.error < b.error; });
  return scores;
}

}  // namespace breakaway
