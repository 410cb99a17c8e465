#include "diagnose/search/swinging_load.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/statistics.h"
#include "diagnose/catalogue.h"

namespace breakaway {

namespace {

struct Viewed {
  double window_s;
  size_t windows;
  size_t shapesWalked;
};
constexpr std::array<Viewed, 2> views{{{0.1, 24, 2}, {0.5, 12, 1}}};
constexpr size_t fewestRows = 8;
constexpr double ranAway = 4.0;       ///< of a squared error: beyond it, how far says no more
constexpr double hardlyLess = 0.8;    ///< of a squared error
constexpr double stillFalling = 0.9;  ///< of a squared error, from one fit to its continuation
/// Of the model's squared error: what leaves more is not followed further. Behind a gap a load can follow anything to
/// some part, at each window's start anew, and its fits take long.
constexpr double promising = 0.5, promisingInPlay = 0.2;
constexpr int mostContinuations = 2;

}  // namespace

bool swings(const Pick& pick) {
  return pick.effect->loadPeriod_s(pick.parameters) > 0.0;
}

bool swings(const Model& model) {
  return std::any_of(model.effects.begin(), model.effects.end(), [](const EffectTerm& term) {
    return findEffect(term.effect)->loadPeriod_s(valuesOf(term)) > 0.0;
  });
}

double typicalPart(const std::vector<double>& squares, const std::vector<double>& ofSquares, double hardly) {
  const double unit = std::max(hardly * mean(ofSquares), 1e-300);
  double sum = 0.0;
  for (size_t w = 0; w < squares.size(); ++w) sum += std::log((squares[w] + unit) / (ofSquares[w] + unit));
  return std::exp(sum / static_cast<double>(std::max<size_t>(squares.size(), 1)));
}

SwingingLoads::SwingingLoads(const SearchInput& input, const Model& model) : input_(input), model_(model) {
}

std::vector<Pick> SwingingLoads::offered(const SearchInput& input, const Screen& screen) {
  std::vector<Pick> picks;
  for (const Effect* effect : catalogue()) {
    const auto shapes = effect->shapes(input.seen);
    if (shapes.empty() || effect->loadPeriod_s(shapes.front().front()) <= 0.0) continue;
    Pick pick = screen.best(*effect, {});
    if (pick.parameters.empty()) {
      pick.effect = effect;
      pick.parameters = shapes.front().front();
    }
    picks.push_back(std::move(pick));
  }
  return picks;
}

SwingingLoads::View SwingingLoads::viewOf(double window_s, size_t most) const {
  View view;
  const std::vector<Window>& all = input_.split.train;
  const size_t count = std::min(most, all.size());
  for (size_t k = 0; k < count; ++k) {
    Window window = all[k * all.size() / count];
    const std::vector<double>& time = input_.tracks[window.track].time;
    const size_t whole = window.last;
    window.last = window.first;
    while (window.last < whole &&
           (time[window.last] < time[window.first] + window_s || window.last < window.first + fewestRows))
      ++window.last;
    view.windows.push_back(window);
  }
  view.own = residualSquares(model_, input_.tracks, view.windows);
  view.unit = std::max(insignificant * mean(view.own), 1e-300);
  return view;
}

double SwingingLoads::leftBy(const Pick& pick, const View& view) const {
  const std::vector<double>& own = view.own;
  std::vector<double> squares = residualSquares(with(input_, model_, pick), input_.tracks, view.windows);
  for (size_t w = 0; w < squares.size(); ++w) {
    const double most = ranAway * (own[w] + view.unit) - view.unit;
    squares[w] = std::isfinite(squares[w]) ? std::min(squares[w], most) : most;
  }
  return typicalPart(squares, own, insignificant);
}

std::vector<SwingingLoads::Shaped> SwingingLoads::bestOfGrid(const Pick& pick, const View& view, size_t most) const {
  std::vector<std::vector<double>> candidates{pick.parameters};
  for (const Shape& shape : pick.effect->shapes(input_.seen)) {
    for (const double load : {0.6, 1.4}) candidates.push_back(pick.effect->scaled(shape, std::vector<double>{load}));
  }
  std::vector<Shaped> grid;
  for (std::vector<double>& parameters : candidates) {
    if (input_.stop.stop_requested()) break;
    Pick other = pick;
    other.parameters = std::move(parameters);
    if (!plausible(*other.effect, other.parameters, input_.seen)) continue;
    const double left = leftBy(other, view);
    grid.push_back({std::move(other.parameters), left});
  }
  std::stable_sort(grid.begin(), grid.end(), [](const Shaped& a, const Shaped& b) { return a.left < b.left; });
  if (grid.size() > most) grid.resize(most);
  return grid;
}

/// Multiplies or divides one parameter at a time for as long as that does better.
void SwingingLoads::walk(Shaped& best, const Pick& pick, const View& view) const {
  const auto specs = pick.effect->parameters(input_.seen.axis);
  Pick other = pick;
  const auto step = [&](size_t p, double by) {
    other.parameters = best.parameters;
    other.parameters[p] *= by;
    if (input_.stop.stop_requested() || !plausible(*other.effect, other.parameters, input_.seen)) return false;
    const double left = leftBy(other, view);
    if (!(left < best.left)) return false;
    best = {other.parameters, left};
    return true;
  };
  for (const double factor : {1.5, 1.2}) {
    for (size_t p = 0; p < specs.size(); ++p) {
      if (specs[p].held) continue;
      for (const double by : {factor, 1.0 / factor}) {
        while (step(p, by)) {
        }
      }
    }
  }
}

FitResult SwingingLoads::fitted(const Pick& pick) const {
  FitResult best;
  const double own = mean(residualSquares(model_, input_.tracks, input_.split.train));
  double least = own;
  const bool inPlay = pick.effect->loadPlay(pick.parameters) > 0.0;
  const double followed = (inPlay ? promisingInPlay : promising) * own;
  const auto fitFrom = [&](const Model& start) {
    FitResult fit = fitModel(input_, start, 10);
    const double before = least;
    if (!fit.usable || !(mean(fit.windowSquares) < before)) return false;
    least = mean(fit.windowSquares);
    best = std::move(fit);
    return least < stillFalling * before;
  };
  for (const Viewed& viewed : views) {
    const View view = viewOf(viewed.window_s, viewed.windows);
    for (Shaped& shaped : bestOfGrid(pick, view, viewed.shapesWalked)) {
      walk(shaped, pick, view);
      if (shaped.left > hardlyLess || input_.stop.stop_requested()) continue;
      Pick walked = pick;
      walked.parameters = std::move(shaped.parameters);
      fitFrom(with(input_, model_, walked));
      if (least > followed) break;
    }
    if (!inPlay) break;  // only what flies takes long
    if (best.usable && least > followed) break;
  }
  for (int k = 0; k < mostContinuations && best.usable && least <= followed; ++k) {
    if (!fitFrom(best.model)) break;
  }
  return best;
}

}  // namespace breakaway
