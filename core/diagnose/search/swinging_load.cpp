#include "diagnose/search/swinging_load.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/statistics.h"
#include "diagnose/effects/catalogue.h"

namespace breakaway {

namespace {

struct Viewed {
  double window_s;
  size_t windows, shapesWalked, fits;
};
constexpr std::array<Viewed, 2> ofGrid{{{0.1, 24, 2, 2}, {0.5, 12, 1, 1}}};
constexpr std::array<Viewed, 2> ofSpread{{{0.2, 16, 5, 3}, {0.5, 12, 3, 2}}};
constexpr int shapesSpread = 80;
constexpr double lightest = 0.2, heaviest = 2.1;  ///< of a shape's load
constexpr size_t fewestLoadRows = 8;
constexpr int mostContinuations = 2;
/// Runs of a window: the nominal one and one for each number of its start; and a fit's iterations.
constexpr double runsPerStart = 5.0, runsPerFit = 5.0;
constexpr double effortOfLaw = 3.0, stepOfLaw_s = 1e-3;    ///< of a servo that answers to the motion
constexpr double effortOfTerm = 0.25, effortOfLoss = 3.0;  ///< of a step without any
constexpr double restart_s = 2.0, restartInPlay_s = 10.0;  ///< simulated for a window's restart

}  // namespace

bool swings(const Pick& pick) {
  return pick.effect->load() != nullptr;
}

bool inPlay(const Pick& pick) {
  return swings(pick) && pick.effect->load()->loadOf(pick.parameters).play() > 0.0;
}

bool swings(const Model& model) {
  return std::any_of(model.effects.begin(), model.effects.end(),
                     [](const EffectTerm& term) { return findEffect(term.effect)->load() != nullptr; });
}

bool loadFollowsAll(const FitResult& loaded, const FitResult& other, const Criteria& criteria) {
  return swings(loaded.model) && !swings(other.model) &&
         typicalSquare(loaded.windowSquares) < criteria.hardlyAny * typicalSquare(other.windowSquares);
}

double typicalPart(const std::vector<double>& squares, const std::vector<double>& ofSquares, double hardly) {
  const double unit = std::max(hardly * mean(ofSquares), 1e-300);
  double sum = 0.0;
  for (size_t w = 0; w < squares.size(); ++w) sum += std::log((squares[w] + unit) / (ofSquares[w] + unit));
  return std::exp(sum / static_cast<double>(std::max<size_t>(squares.size(), 1)));
}

SwingingLoads::SwingingLoads(const SearchInput& input, const Worth& worth, const Model& model)
    : input_(input), limits_(input.criteria), worth_(worth), model_(model) {
}

std::vector<Pick> SwingingLoads::offered(const SearchInput& input, const Screen& screen) {
  std::vector<Pick> picks;
  for (const Effect* effect : input.effects) {
    const auto shapes = effect->shapes(input.seen);
    if (shapes.empty() || effect->load() == nullptr) continue;
    Pick pick = screen.best(*effect, {});
    if (pick.parameters.empty()) {
      pick.effect = effect;
      pick.parameters = shapes.front().front();
    }
    picks.push_back(std::move(pick));
  }
  // What flies takes long, and would leave nothing of the steps for the others.
  std::stable_partition(picks.begin(), picks.end(), [](const Pick& one) { return !inPlay(one); });
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
           (time[window.last] < time[window.first] + window_s || window.last < window.first + fewestLoadRows))
      ++window.last;
    view.windows.push_back(window);
  }
  view.own = residualSquares(model_, input_.tracks, view.windows);
  view.unit = std::max(limits_.little * mean(view.own), 1e-300);
  return view;
}

double SwingingLoads::stepsOf(const std::vector<Window>& windows, const Pick& pick, double runs) const {
  const double ofEffect_s = pick.effect->longestStep_s(pick.parameters);
  const double longest_s = model_.servo ? std::min(ofEffect_s, stepOfLaw_s) : ofEffect_s;
  const double sought_s = inPlay(pick) ? restartInPlay_s : restart_s;
  double steps = 0.0;
  for (const Window& window : windows) {
    const std::vector<double>& time = input_.tracks[window.track].time;
    const auto rows = static_cast<double>(window.last - window.first);
    const double length_s = time[window.last] - time[window.first];
    steps += (runs + sought_s / length_s) * std::max(rows, length_s / longest_s);
  }
  // The model's other effects take time, too: most of all lost voltages, which are iterated, and hidden states, which
  // follow the tracks from their beginning.
  double effort = model_.servo ? effortOfLaw : 1.0;
  for (const EffectTerm& term : model_.effects)
    effort += findEffect(term.effect)->losesVoltage() ? effortOfLoss : effortOfTerm;
  if (remembers(model_)) {
    for (const Track& track : input_.tracks) steps += runs / runsPerStart * static_cast<double>(track.rows());
  }
  return effort * steps;
}

double SwingingLoads::leftBy(const Pick& pick, const View& view) const {
  const std::vector<double>& own = view.own;
  std::vector<double> squares = residualSquares(with(input_, model_, pick), input_.tracks, view.windows);
  for (size_t w = 0; w < squares.size(); ++w) {
    const double most = (own[w] + view.unit) / limits_.farLess - view.unit;
    squares[w] = std::isfinite(squares[w]) ? std::min(squares[w], most) : most;
  }
  return typicalPart(squares, own, limits_.little);
}

std::vector<std::vector<double>> SwingingLoads::grid(const Pick& pick) const {
  std::vector<std::vector<double>> out{pick.parameters};
  for (const Shape& shape : pick.effect->shapes(input_.seen)) {
    for (const double load : {0.6, 1.4}) out.push_back(pick.effect->scaled(shape, std::vector<double>{load}));
  }
  return out;
}

/// Gap, contact and load make a narrow valley, which a grid may miss: shapes spread over all that it spans, each
/// parameter on a logarithmic scale (the generalised golden ratio's sequence, M. Roberts, 'The unreasonable
/// effectiveness of quasirandom sequences', 2018).
std::vector<std::vector<double>> SwingingLoads::spread(const Pick& pick) const {
  std::vector<std::vector<double>> out;
  const Effect& effect = *pick.effect;
  const std::vector<Shape> shapes = effect.shapes(input_.seen);
  if (shapes.empty()) return out;
  std::vector<double> low = shapes.front().front(), high = low;
  for (const Shape& shape : shapes) {
    for (size_t p = 0; p < low.size(); ++p) {
      low[p] = std::min(low[p], shape.front()[p]);
      high[p] = std::max(high[p], shape.front()[p]);
    }
  }
  constexpr double golden = 1.2207440846057596;  // x⁴ = x + 1
  for (int k = 1; k <= shapesSpread; ++k) {
    double rate = 1.0;
    const auto between = [&](double from, double to) {
      rate /= golden;
      const double along = k * rate - std::floor(k * rate);
      return from * std::pow(to / from, along);
    };
    const double load = between(lightest, heaviest);
    std::vector<double> shape = low;
    for (size_t p = 0; p < low.size(); ++p) {
      if (high[p] > low[p] && low[p] > 0.0) shape[p] = between(low[p], high[p]);
    }
    out.push_back(effect.scaled({shape}, std::vector<double>{load}));
  }
  return out;
}

std::vector<std::vector<double>> SwingingLoads::variants(const std::vector<std::vector<double>>& shapes,
                                                         const Pick& pick) const {
  std::vector<std::vector<double>> out;
  for (const std::vector<double>& shape : shapes) {
    for (std::vector<double>& variant : pick.effect->variants(shape, input_.seen)) out.push_back(std::move(variant));
  }
  return out;
}

std::vector<SwingingLoads::Shaped> SwingingLoads::bestOf(const std::vector<std::vector<double>>& candidates,
                                                         const Pick& pick, const View& view, size_t most) const {
  std::vector<Shaped> best;
  for (const std::vector<double>& parameters : candidates) {
    if (input_.enough()) break;
    Pick other = pick;
    other.parameters = parameters;
    if (!plausible(*other.effect, other.parameters, input_.seen)) continue;
    if (!input_.loadSteps->take(stepsOf(view.windows, other, runsPerStart))) break;
    const double left = leftBy(other, view);
    best.push_back({std::move(other.parameters), left});
  }
  sortByLeft(best);
  if (best.size() > most) best.resize(most);
  return best;
}

void SwingingLoads::sortByLeft(std::vector<Shaped>& shapes) {
  std::stable_sort(shapes.begin(), shapes.end(), [](const Shaped& a, const Shaped& b) { return a.left < b.left; });
}

/// Multiplies or divides the size, or one other parameter at a time, for as long as that does better.
void SwingingLoads::walk(Shaped& best, const Pick& pick, const View& view) const {
  const auto specs = pick.effect->parameters(input_.seen.axis);
  Pick other = pick;
  const auto step = [&](size_t p, double by) {
    other.parameters = best.parameters;
    if (p == 0) {
      other.parameters = pick.effect->scaled({best.parameters}, std::vector<double>{by});
    } else {
      other.parameters[p] *= by;
    }
    if (input_.enough() || !plausible(*other.effect, other.parameters, input_.seen)) return false;
    if (!input_.loadSteps->take(stepsOf(view.windows, other, runsPerStart))) return false;
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

std::optional<Model> SwingingLoads::fittedTo(const View& view, const Pick& pick) const {
  const ParameterVector free = vectorOf(input_, with(input_, model_, pick));
  const auto columns = static_cast<double>(free.size());
  if (!input_.loadSteps->take(stepsOf(view.windows, pick, runsPerFit * (runsPerStart + columns)))) return std::nullopt;
  const FitResult fit = fitWindows(free, input_.tracks, view.windows,
                                   {.iterations = 10,
                                    .tolerance = 1e-3,
                                    .windowWeights = {},
                                    .weights = {},
                                    .stop = input_.stop,
                                    .time = input_.time});
  if (!fit.usable || !plausible(fit.model, input_.seen)) return std::nullopt;
  const auto left = residualSquares(fit.model, input_.tracks, view.windows);
  if (!(typicalPart(left, view.own, limits_.little) < limits_.clearlyLess)) return std::nullopt;
  return fit.model;
}

FitResult SwingingLoads::fitted(const Pick& pick) const {
  FitResult best;
  const double own = mean(residualSquares(model_, input_.tracks, input_.split.train));
  double least = own;
  const double followed = (inPlay(pick) ? limits_.farLess : limits_.half) * own;
  const auto fitFrom = [&](const Model& start, const Pick& shaped) {
    const auto columns = static_cast<double>(vectorOf(input_, start).size());
    if (!input_.loadSteps->take(stepsOf(input_.split.train, shaped, runsPerFit * (runsPerStart + columns))))
      return false;
    FitResult fit = fitModel(input_, start, 10);
    const double before = least;
    if (!fit.usable || !(mean(fit.windowSquares) < before)) return false;
    least = mean(fit.windowSquares);
    best = std::move(fit);
    return least < limits_.hardlyLess * before;
  };
  const auto lookFrom = [&](const std::vector<std::vector<double>>& candidates, const Viewed& viewed) {
    const View view = viewOf(viewed.window_s, viewed.windows);
    std::vector<Shaped> shapes = bestOf(candidates, pick, view, viewed.shapesWalked);
    for (Shaped& shaped : shapes) walk(shaped, pick, view);
    sortByLeft(shapes);
    if (shapes.size() > viewed.fits) shapes.resize(viewed.fits);
    for (Shaped& shaped : shapes) {
      if (input_.enough()) break;
      const bool seen = shaped.left <= limits_.clearlyLess;
      Pick walked = pick;
      walked.parameters = std::move(shaped.parameters);
      const auto start = seen ? with(input_, model_, walked) : fittedTo(view, walked);
      if (start) fitFrom(*start, walked);
    }
  };
  const bool play = inPlay(pick);
  for (const Viewed& viewed : ofGrid) {
    lookFrom(grid(pick), viewed);
    if (!play || (best.usable && least > followed)) break;  // only what flies takes long
  }
  if (play && best.usable && least <= limits_.half * own) {
    for (const Viewed& viewed : ofSpread) {
      if (least > limits_.hardlyAny * own) lookFrom(spread(pick), viewed);
    }
  }
  if (!play && best.usable && worth_.floors(best) > limits_.atFloor) {
    FitResult plain = best;
    const double plainLeast = least;
    lookFrom(variants(grid(pick), pick), ofGrid.front());
    if (least > limits_.clearlyLess * plainLeast) {  // no sign of more than the plain load
      best = std::move(plain);
      least = plainLeast;
    }
  }
  for (int k = 0; k < mostContinuations && best.usable && least <= followed; ++k) {
    if (!fitFrom(best.model, pick)) break;
  }
  return best;
}

}  // namespace breakaway
