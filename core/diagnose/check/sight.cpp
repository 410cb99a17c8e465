#include "diagnose/check/sight.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "dense/dense_solve.h"
#include "diagnose/effects/catalogue.h"
#include "diagnose/fit/motion.h"
#include "diagnose/verdict/next_experiment.h"
#include "diagnose/verdict/worth_saying.h"

namespace breakaway {

namespace {

constexpr size_t mostSightRows = 24'000, mostLoadRows = 6'000;  ///< simulated for one shape
constexpr size_t mostShapes = 8;
constexpr double hardlyOwn = 1e-4;                      ///< of a squared change: the base's own parameters do the same
constexpr double few = 0.1, nearlyAll = 0.9;            ///< of the windows, of a squared change
constexpr double leastFactor = 1e-4, mostFactor = 1e4;  ///< of a shape's amplitude
constexpr double finer = 1.02;

/// Evenly spread numbers below `all`, about `wanted` of them.
std::vector<size_t> spread(size_t all, size_t wanted) {
  std::vector<size_t> some;
  const size_t count = std::min(all, std::max<size_t>(wanted, 1));
  some.reserve(count);
  for (size_t k = 0; k < count; ++k) some.push_back(count == 1 ? all / 2 : k * (all - 1) / (count - 1));
  return some;
}

/// What a shape changes in the windows, beyond what base and starts could take up.
struct SightChange {
  double position = 0.0;  ///< mean squared, rad² or m²
  double current = 0.0;   ///< A²
  bool inFew = false;     ///< nearly all of it in a tenth of the windows
  bool own = false;       ///< the base's own parameters do the same
};

class Sensitivity {
 public:
  Sensitivity(const SearchInput& input, const FitResult& base) : input_(input), base_(base) {
    size_t rows = 0;
    for (const Window& window : input.split.train) rows += window.last - window.first + 1;
    const size_t each = std::max<size_t>(1, rows / std::max<size_t>(1, input.split.train.size()));
    windows_ = spread(input.split.train.size(), mostSightRows / each);
    ofLoads_ = spread(windows_.size(), mostLoadRows / each);
    const auto hidden = hiddenStates(base.model, input.tracks, input.split.train);
    for (const size_t w : windows_) {
      const Window& window = input.split.train[w];
      const double weight = input.windowWeights.empty() ? 1.0 : input.windowWeights[w];
      residuals_.emplace_back(input.tracks[window.track], window,
                              Weights{weight * base.weights.position, weight * base.weights.current});
      residuals_.back().fit(base.model, hidden[w]);
    }
  }

  SightChange of(const Effect& effect, const std::vector<double>& parameters, size_t track) const {
    const Model variant = variantOf(effect, parameters, track);
    const auto hidden = hiddenStates(variant, input_.tracks, input_.split.train);
    const std::vector<size_t> all = spread(windows_.size(), windows_.size());
    const std::vector<size_t>& used = effect.load() != nullptr ? ofLoads_ : all;
    const double part = static_cast<double>(used.size()) / static_cast<double>(input_.split.train.size());
    const Eigen::Index size = base_.x.size();
    Eigen::MatrixXd normal = (part * base_.priorPrecision).asDiagonal();
    Eigen::VectorXd shared = Eigen::VectorXd::Zero(size);
    std::vector<Eigen::VectorXd> columns;
    for (const size_t u : used) {
      const Eigen::MatrixXd& jacobian = base_.windows[windows_[u]].jacobian;
      Eigen::VectorXd column = Eigen::VectorXd::Zero(jacobian.rows());
      if (acts(effect, parameters, track, input_.split.train[windows_[u]]) && residuals_[u].rows() == column.size())
        column = residuals_[u].column(variant, hidden[windows_[u]], 1.0);
      if (!column.allFinite()) column.setZero();
      normal += jacobian.transpose() * jacobian;
      shared += jacobian.transpose() * column;
      columns.push_back(std::move(column));
    }
    normal.diagonal().array() += 1e-12 * std::max(normal.diagonal().maxCoeff(), 1e-300);
    const Eigen::VectorXd taken = size > 0 ? solveSymmetric(normal, shared) : Eigen::VectorXd();
    SightChange change;
    double before = 0.0, after = 0.0;
    std::vector<double> squares;
    for (size_t k = 0; k < used.size(); ++k) {
      const WindowResidual& window = residuals_[used[k]];
      const size_t w = windows_[used[k]];
      Eigen::VectorXd left = columns[k];
      if (size > 0) left -= base_.windows[w].jacobian * taken;
      before += columns[k].squaredNorm();
      after += left.squaredNorm();
      const double weight = input_.windowWeights.empty() ? 1.0 : input_.windowWeights[w];
      squares.push_back(left.head(window.positions()).squaredNorm() / std::pow(weight * base_.weights.position, 2) /
                        static_cast<double>(window.positions()));
      if (window.currents() > 0)
        change.current += left.segment(window.positions(), window.currents()).squaredNorm() /
                          std::pow(weight * base_.weights.current, 2) / static_cast<double>(window.currents());
    }
    const auto n = static_cast<double>(used.size());
    change.position = std::accumulate(squares.begin(), squares.end(), 0.0) / n;
    change.current /= n;
    change.own = !(after > hardlyOwn * before);
    std::sort(squares.begin(), squares.end(), std::greater<>());
    const auto most = static_cast<std::ptrdiff_t>(std::max(1.0, few * n));
    change.inFew = std::accumulate(squares.begin(), squares.begin() + most, 0.0) > nearlyAll * n * change.position;
    return change;
  }

 private:
  Model variantOf(const Effect& effect, const std::vector<double>& parameters, size_t track) const {
    Pick pick;
    pick.effect = &effect;
    pick.parameters = parameters;
    pick.track = effect.happensOnce() ? track : everyTrack;
    return with(input_, base_.model, pick);
  }

  bool acts(const Effect& effect, const std::vector<double>& p, size_t track, const Window& window) const {
    if (!effect.happensOnce()) return true;
    if (window.track != track) return false;
    const std::vector<double>& time = input_.tracks[track].time;
    const double from = p[effect.once()->start], to = from + p[effect.once()->duration];
    return time[window.last] > from && time[window.first] < to;
  }

  const SearchInput& input_;
  const FitResult& base_;
  std::vector<size_t> windows_;  ///< of the training windows
  std::vector<size_t> ofLoads_;  ///< of windows_
  std::vector<WindowResidual> residuals_;
};

/// The smallest of one shape.
struct Smallest {
  std::vector<double> parameters;
  SightLimit limit = SightLimit::sensors;
  double size = 0.0;  ///< by which shapes are compared
};

class Looker {
 public:
  Looker(const SearchInput& input, const FitResult& base, const Worth& worth, const TorqueNoise& wander)
      : input_(input), base_(base), worth_(worth), wander_(wander), sensitivity_(input, base) {}

  Sight look(const Effect& effect) const {
    Sight sight;
    sight.effect = &effect;
    const auto shapes = effect.shapes(input_.seen);
    if (shapes.empty() && std::find(unseen_.begin(), unseen_.end(), effect.name()) == unseen_.end()) {
      sight.why = "no recording of this drive does";
      return sight;
    }
    sight.experiment = effect.neededExcitation(input_.seen).english();
    if (shapes.empty()) {
      sight.why = "these recordings don't hold what it takes";
      return sight;
    }
    std::optional<Smallest> best;
    bool own = true;
    for (const size_t k : spread(shapes.size(), mostShapes)) {
      const auto found = smallestOf(effect, shapes[k], own);
      if (found && (!best || found->size < best->size)) best = found;
    }
    if (!best) {
      sight.why = own ? "beside the base model's own parameters it makes no difference here"
                      : "any size that a rig can have drowns in sensors' noise, wander or other errors";
      return sight;
    }
    const auto specs = effect.parameters(input_.seen.axis);
    for (size_t p = 0; p < specs.size(); ++p)
      sight.smallest.push_back({specs[p].name, best->parameters[p], best->parameters[p], best->parameters[p]});
    sight.torque = torqueOf(specs.front().name, best->parameters.front(), input_.seen);
    sight.limit = best->limit;
    return sight;
  }

 private:
  std::vector<double> at(const Effect& effect, const Shape& shape, double factor) const {
    std::vector<double> amplitude(shape.size(), 0.0);
    amplitude.front() = factor;
    return effect.scaled(shape, amplitude);
  }
  bool enough(const SightChange& change) const {
    const auto current = worth_.leastCurrentBack();
    return change.position >= worth_.leastBack(change.inFew) || (current && change.current >= *current);
  }
  EffectTerm termAt(const Effect& effect, const std::vector<double>& p) const {
    EffectTerm term{std::string(effect.name()), {}};
    const auto specs = effect.parameters(input_.seen.axis);
    for (size_t k = 0; k < specs.size(); ++k) term.parameters.push_back({specs[k].name, p[k], p[k], p[k]});
    return term;
  }
  bool possible(const Effect& effect, const std::vector<double>& p) const { return plausible(effect, p, input_.seen); }
  bool saying(const Effect& effect, const std::vector<double>& p) const {
    return worthSaying(termAt(effect, p), base_.model, input_.seen, wander_, input_.criteria);
  }

  /// `own` stays true only while the base does all that shapes do.
  std::optional<Smallest> smallestOf(const Effect& effect, const Shape& shape, bool& own) const {
    const std::vector<double> one = at(effect, shape, 1.0), two = at(effect, shape, 2.0);
    const bool scales = std::abs(two.front() - 2.0 * one.front()) < 1e-9 * std::abs(two.front());
    const size_t track = input_.split.train.front().track;
    const SightChange change = sensitivity_.of(effect, one, track);
    own = own && change.own;
    if (change.own) return {};
    if (!scales) {
      if (!enough(change) || !possible(effect, one) || !saying(effect, one)) return {};
      return Smallest{one, SightLimit::grid, std::abs(one.front())};
    }
    // What it changes grows with its square.
    double factor = std::sqrt(worth_.leastBack(change.inFew) / std::max(change.position, 1e-300));
    if (const auto current = worth_.leastCurrentBack())
      factor = std::min(factor, std::sqrt(*current / std::max(change.current, 1e-300)));
    if (!(factor < mostFactor)) return {};
    factor = std::max(factor, leastFactor);
    SightLimit limit = SightLimit::sensors;
    const auto raise = [&](auto passes, SightLimit by) {
      while (factor < mostFactor && !passes(at(effect, shape, factor))) {
        factor *= finer;
        limit = by;
      }
    };
    // A size that is too large for any rig isn't mended by a larger one.
    raise([&](const std::vector<double>& p) { return possible(effect, p); }, SightLimit::smallness);
    raise([&](const std::vector<double>& p) { return saying(effect, p); }, SightLimit::wander);
    const std::vector<double> smallest = at(effect, shape, factor);
    if (!possible(effect, smallest) || !saying(effect, smallest)) return {};
    return Smallest{smallest, limit, std::abs(smallest.front())};
  }

  const SearchInput& input_;
  const FitResult& base_;
  const Worth& worth_;
  const TorqueNoise& wander_;
  Sensitivity sensitivity_;
  const std::vector<std::string> unseen_ = unseenEffects(input_.seen);
};

}  // namespace

const char* nameOf(SightLimit limit) {
  switch (limit) {
    case SightLimit::sensors:
      return "sensors";
    case SightLimit::wander:
      return "wander";
    case SightLimit::smallness:
      return "smallness";
    case SightLimit::grid:
      return "grid";
  }
  return "";
}

std::vector<Sight> sightOf(const SearchInput& input, const FitResult& base, const Worth& worth,
                           const TorqueNoise& wander) {
  const Looker looker(input, base, worth, wander);
  std::vector<Sight> sights;
  for (const Effect* effect : catalogue()) sights.push_back(looker.look(*effect));
  return sights;
}

}  // namespace breakaway
