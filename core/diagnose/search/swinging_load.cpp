#include "diagnose/search/swinging_load.h"

#include <algorithm>
#include <utility>

#include "base/statistics.h"
#include "diagnose/catalogue.h"

namespace breakaway {

namespace {

constexpr size_t mostShapeWindows = 4;
constexpr double hardlyLess = 0.9;  // of a squared error

}  // namespace

bool swings(const Pick& pick) {
  return pick.effect->loadPeriod_s(pick.parameters) > 0.0;
}

bool swings(const Model& model) {
  return std::any_of(model.effects.begin(), model.effects.end(), [](const EffectTerm& term) {
    std::vector<double> values;
    for (const Parameter& one : term.parameters) values.push_back(one.value);
    return findEffect(term.effect)->loadPeriod_s(values) > 0.0;
  });
}

Shaped simulatedShape(const SearchInput& input, const Model& model, Pick pick) {
  Shaped best{std::move(pick)};
  if (!swings(best.pick)) return best;
  const std::vector<Window>& all = input.split.train;
  std::vector<Window> windows;
  windows.reserve(2 * mostShapeWindows);
  for (size_t k = 0; k < all.size(); k += std::max<size_t>(1, all.size() / mostShapeWindows)) windows.push_back(all[k]);
  const auto base = residualSquares(model, input.tracks, windows);
  const auto tryOne = [&](std::vector<double> parameters) {
    Pick other = best.pick;
    other.parameters = std::move(parameters);
    if (input.stop.stop_requested() || !other.effect->plausible(other.parameters, input.seen)) return false;
    auto squares = residualSquares(with(input, model, other), input.tracks, windows);
    // How far a window runs away says no more than that it does.
    for (size_t w = 0; w < squares.size(); ++w) squares[w] = squares[w] < 4.0 * base[w] ? squares[w] : 4.0 * base[w];
    const double left = mean(squares) / std::max(mean(base), 1e-300);
    if (!(left < best.left)) return false;
    best = {std::move(other), left};
    return true;
  };
  tryOne(best.pick.parameters);
  for (const Shape& shape : best.pick.effect->shapes(input.seen)) tryOne(shape.front());
  if (best.left > hardlyLess) return best;
  const auto specs = best.pick.effect->parameters(input.seen.axis);
  for (size_t p = 0; p < specs.size(); ++p) {
    for (const double by : {1.5, 1.0 / 1.5}) {
      for (bool better = !specs[p].held; better;) {
        auto parameters = best.pick.parameters;
        parameters[p] *= by;
        better = tryOne(std::move(parameters));
      }
    }
  }
  return best;
}

}  // namespace breakaway
