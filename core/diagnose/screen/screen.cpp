#include "diagnose/screen/screen.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "base/statistics.h"
#include "dense/dense_solve.h"

namespace breakaway {

namespace {

constexpr size_t flips = 199;
constexpr size_t mostEffects = 6, mostWaves = 5;  ///< waves beyond the first of each effect
constexpr size_t beamWidth = 3;

/// How many of them are of an effect that comes before.
size_t furtherWaves(const std::vector<Pick>& picks) {
  size_t further = 0;
  for (size_t k = 0; k < picks.size(); ++k)
    further += contains({picks.begin(), picks.begin() + static_cast<std::ptrdiff_t>(k)}, picks[k].effect) ? 1 : 0;
  return further;
}

/// Numbers of the parameters that differ from shape to shape and aren't held: the nonlinear ones that a search may
/// refine.
std::vector<size_t> refinable(const Effect& effect, const Shape& shape, const Excitation& seen) {
  std::vector<size_t> numbers;
  const auto all = effect.shapes(seen);
  const auto specs = effect.parameters(seen.axis);
  for (size_t k = 0; k < specs.size(); ++k) {
    bool differs = false, shared = true;
    for (const Shape& one : all) differs = differs || one.front()[k] != all.front().front()[k];
    for (const auto& one : shape) shared = shared && one[k] == shape.front()[k];
    if (differs && shared && !specs[k].held) numbers.push_back(k);
  }
  return numbers;
}

}  // namespace

bool same(const Effect* a, const Effect* b) {
  return a == b || (!a->twin().empty() && a->twin() == b->name());
}

bool contains(const std::vector<Pick>& picks, const Effect* effect) {
  return std::any_of(picks.begin(), picks.end(), [effect](const Pick& one) { return same(one.effect, effect); });
}

void sortByGain(std::vector<Pick>& picks) {
  std::stable_sort(picks.begin(), picks.end(), [](const Pick& a, const Pick& b) { return a.gain > b.gain; });
}

Screen::Screen(const LinearRig& rig, const std::vector<const Effect*>& effects, const Excitation& seen,
               const std::vector<int>& fold, int folds, std::uint64_t seed, const Criteria& criteria)
    : rig_(rig), seen_(seen), fold_(fold), folds_(folds), seed_(seed), limits_(criteria) {
  Eigen::Index width = 0;
  for (const Effect* effect : effects) {
    const bool twinListed =
        std::any_of(effects_.begin(), effects_.end(), [effect](const Effect* one) { return same(one, effect); });
    if (twinListed) continue;
    effects_.push_back(effect);
    const std::vector<size_t> tracks = effect->happensOnce() ? rig.tracksSeen() : std::vector<size_t>{everyTrack};
    for (const Shape& shape : effect->shapes(seen)) {
      const auto own = static_cast<Eigen::Index>(shape.size());
      for (const size_t track : tracks) {
        candidates_.push_back({effect, shape, track, width, own});
        width += own;
      }
    }
  }
  free_.resize(rig.response().size(), width);
  for (const Candidate& one : candidates_)
    free_.middleCols(one.at, one.width) = rig.rawColumnsOf(*one.effect, one.shape, one.track);
  rig.weigh(free_);
  for (Eigen::Index c = 0; c < width; ++c) {
    if (!free_.col(c).allFinite()) free_.col(c).setZero();
  }
  norms_ = free_.colwise().squaredNorm();
  base_.basis = orthonormal(rig.base());
  base_.response = rig.response() - base_.basis * (base_.basis.transpose() * rig.response());
  free_ -= base_.basis * (base_.basis.transpose() * free_).eval();
  base_.shared.resize(0, width);
  base_.scores = free_.transpose() * base_.response;
  for (const Candidate& one : candidates_) {
    const auto columns = free_.middleCols(one.at, one.width);
    own_.emplace_back(columns.transpose() * columns);
  }
}

const Eigen::MatrixXd& Screen::columnsOf(const Pick& pick) const {
  return known_.get({pick.effect, pick.shape, pick.track},
                    [&] { return rig_.columnsOf(*pick.effect, pick.shape, pick.track); });
}

Eigen::MatrixXd Screen::design(const std::vector<Pick>& chosen) const {
  Eigen::Index width = rig_.base().cols();
  for (const Pick& pick : chosen) width += static_cast<Eigen::Index>(pick.shape.size());
  Eigen::MatrixXd out(rig_.base().rows(), width);
  out.leftCols(rig_.base().cols()) = rig_.base();
  Eigen::Index at = rig_.base().cols();
  for (const Pick& pick : chosen) {
    const auto own = static_cast<Eigen::Index>(pick.shape.size());
    out.middleCols(at, own) = columnsOf(pick);
    at += own;
  }
  return out;
}

Eigen::VectorXd Screen::baseCoefficients(const std::vector<Pick>& chosen) const {
  const Eigen::MatrixXd all = design(chosen);
  const Eigen::VectorXd scale = all.colwise().norm().cwiseMax(1e-300).cwiseInverse().transpose();
  const Eigen::VectorXd solution = scale.cwiseProduct(leastSquares(all * scale.asDiagonal(), rig_.response()));
  return rig_.physical(solution.head(rig_.base().cols()));
}

Eigen::MatrixXd Screen::orthonormal(Eigen::MatrixXd columns) {
  const Eigen::VectorXd scale = columns.colwise().norm().cwiseMax(1e-300).cwiseInverse();
  columns = columns * scale.asDiagonal();
  return basisOfRank(columns);
}

Screen::Left Screen::leave(const std::vector<Pick>& chosen) const {
  if (chosen.empty()) return base_;
  Left left = leaveOnlyResponse(chosen);
  left.shared = left.basis.rightCols(left.basis.cols() - base_.basis.cols()).transpose() * free_;
  left.scores = free_.transpose() * left.response;
  return left;
}

Eigen::MatrixXd Screen::gramOf(const Candidate& candidate, const Left& left) const {
  const auto along = left.shared.middleCols(candidate.at, candidate.width);
  return own_[static_cast<size_t>(&candidate - candidates_.data())] - along.transpose() * along;
}

Screen::Left Screen::leaveOnlyResponse(const std::vector<Pick>& chosen) const {
  if (chosen.empty()) return {base_.basis, base_.response, {}, {}};
  Eigen::MatrixXd own(rig_.response().size(), 0);
  for (const Pick& pick : chosen) {
    const Eigen::MatrixXd& more = columnsOf(pick);
    own.conservativeResize(Eigen::NoChange, own.cols() + more.cols());
    own.rightCols(more.cols()) = more - base_.basis * (base_.basis.transpose() * more);
    // What the base explains wholly is not there.
    for (Eigen::Index c = 0; c < more.cols(); ++c) {
      auto column = own.col(own.cols() - more.cols() + c);
      if (column.squaredNorm() < 1e-10 * more.col(c).squaredNorm()) column.setZero();
    }
  }
  Left left;
  const Eigen::MatrixXd basis = orthonormal(std::move(own));
  left.basis.resize(rig_.response().size(), base_.basis.cols() + basis.cols());
  left.basis << base_.basis, basis;
  left.response = base_.response - basis * (basis.transpose() * base_.response);
  return left;
}

double Screen::gainOf(const Eigen::MatrixXd& columns, const Left& left, Eigen::VectorXd& amplitude) const {
  const Eigen::MatrixXd free = columns - left.basis * (left.basis.transpose() * columns);
  const Eigen::MatrixXd own = free.transpose() * free;
  const double before = columns.squaredNorm();
  if (!(own.trace() > 1e-5 * before) || !own.allFinite()) return 0.0;
  Eigen::MatrixXd ridged = own;
  ridged.diagonal().array() += 1e-9 * own.trace();
  const Eigen::VectorXd score = free.transpose() * left.response;
  amplitude = solveSymmetric(ridged, score);
  return amplitude.dot(score);
}

bool Screen::open(const Effect* effect, const std::vector<Pick>& chosen) const {
  // Of its waves, those that are chosen already leave nothing of their own shape.
  return effect->mayRepeat(seen_) || !contains(chosen, effect);
}

std::vector<Pick> Screen::bestOfEach(const Left& left, const std::vector<Pick>& chosen) const {
  std::vector<Pick> best;
  for (const Effect* effect : effects_) {
    if (!open(effect, chosen)) continue;
    Pick pick = bestOf(effect, left);
    if (pick.gain > 0.0) best.push_back(std::move(pick));
  }
  sortByGain(best);
  return best;
}

Pick Screen::bestOf(const Effect* effect, const Left& left) const {
  Pick best;
  best.effect = effect;
  for (const Candidate& one : candidates_) {
    if (one.effect != effect) continue;
    Eigen::MatrixXd own = gramOf(one, left);
    if (!(own.trace() > 1e-5 * norms_.segment(one.at, one.width).sum())) continue;
    own.diagonal().array() += 1e-9 * own.trace();
    const Eigen::VectorXd score = left.scores.segment(one.at, one.width);
    const Eigen::VectorXd amplitude = solveSymmetric(own, score);
    const double gain = amplitude.dot(score);
    if (gain <= best.gain) continue;
    auto parameters = effect->scaled(one.shape, {amplitude.data(), static_cast<size_t>(amplitude.size())});
    if (!effect->plausible(parameters, seen_)) continue;
    best.gain = gain;
    best.shape = one.shape;
    best.track = one.track;
    best.parameters = std::move(parameters);
  }
  return best;
}

Pick Screen::refined(Pick pick, const Left& left) const {
  const auto numbers = refinable(*pick.effect, pick.shape, seen_);
  double factor = numbers.empty() ? 1.0 : 1.35;
  for (; factor > 1.02; factor = std::sqrt(factor)) {
    for (const size_t number : numbers) {
      for (const double times : {factor, 1.0 / factor}) {
        Pick other = pick;
        for (auto& one : other.shape) one[number] *= times;
        Eigen::VectorXd amplitude;
        other.gain = gainOf(columnsOf(other), left, amplitude);
        if (other.gain <= pick.gain) continue;
        other.parameters = pick.effect->scaled(other.shape, {amplitude.data(), static_cast<size_t>(amplitude.size())});
        if (pick.effect->plausible(other.parameters, seen_)) pick = std::move(other);
      }
    }
  }
  return pick;
}

Pick Screen::best(const Effect& effect, const std::vector<Pick>& others) const {
  const Left left = leave(others);
  return refined(bestOf(&effect, left), left);
}

double Screen::pValueOf(const Pick& pick, const Left& before, double& chance) const {
  // What is left after the pick, window by window and column by column.
  Eigen::MatrixXd own = columnsOf(pick);
  own -= before.basis * (before.basis.transpose() * own);
  const Eigen::VectorXd after = leftByLeastSquares(own, before.response);
  const auto windows = static_cast<Eigen::Index>(rig_.windows());
  const Eigen::Index chosenColumns = before.shared.rows();
  Eigen::MatrixXd scores = Eigen::MatrixXd::Zero(windows, free_.cols());
  Eigen::MatrixXd along = Eigen::MatrixXd::Zero(windows, chosenColumns);
  for (Eigen::Index r = 0; r < after.size();) {
    const size_t window = rig_.window()[static_cast<size_t>(r)];
    Eigen::Index end = r;
    while (end < after.size() && rig_.window()[static_cast<size_t>(end)] == window) ++end;
    const auto row = static_cast<Eigen::Index>(window);
    scores.row(row).noalias() += after.segment(r, end - r).transpose() * free_.middleRows(r, end - r);
    along.row(row) +=
        after.segment(r, end - r).transpose() * before.basis.middleRows(r, end - r).rightCols(chosenColumns);
    r = end;
  }
  scores.noalias() -= along * before.shared;
  struct Inverse {
    double a, b, c;
    Eigen::Index at;
  };
  std::vector<Inverse> inverses;
  for (const Candidate& one : candidates_) {
    const Eigen::MatrixXd gram = gramOf(one, before);
    if (!(gram.trace() > 1e-5 * norms_.segment(one.at, one.width).sum())) continue;
    if (one.width == 1) {
      inverses.push_back({1.0 / gram(0, 0), 0.0, 0.0, one.at});
    } else {
      const double det = gram(0, 0) * gram(1, 1) - gram(0, 1) * gram(0, 1);
      if (det <= 1e-9 * gram(0, 0) * gram(1, 1)) continue;
      inverses.push_back({gram(1, 1) / det, -gram(0, 1) / det, gram(0, 0) / det, one.at});
    }
  }
  Random random(seed_);
  Eigen::MatrixXd signs(static_cast<Eigen::Index>(flips), windows);
  for (Eigen::Index f = 0; f < signs.rows(); ++f) {
    const Eigen::Index together = Eigen::Index{1} << (f % 2);  // slow noise hangs together over several windows
    for (Eigen::Index w = 0; w < windows; ++w)
      signs(f, w) = w % together != 0 ? signs(f, w - 1) : random.bits() >> 63 ? 1.0 : -1.0;
  }
  const Eigen::MatrixXd flipped = signs * scores;
  size_t beaten = 0;
  chance = 0.0;
  for (Eigen::Index f = 0; f < signs.rows(); ++f) {
    double most = 0.0;
    for (const Inverse& one : inverses) {
      const double a = flipped(f, one.at);
      double gain = one.a * a * a;
      if (one.c > 0.0) {
        const double b = flipped(f, one.at + 1);
        gain += 2.0 * one.b * a * b + one.c * b * b;
      }
      most = std::max(most, gain);
    }
    chance = std::max(chance, most);
    if (most >= pick.gain) ++beaten;
  }
  return static_cast<double>(1 + beaten) / static_cast<double>(1 + flips);
}

std::vector<double> Screen::validated(const std::vector<Pick>& chosen) const {
  const Eigen::MatrixXd all = design(chosen);
  const Eigen::VectorXd scale = all.colwise().norm().cwiseMax(1e-300).cwiseInverse();
  std::vector<Eigen::MatrixXd> grams(static_cast<size_t>(folds_), Eigen::MatrixXd::Zero(all.cols(), all.cols()));
  std::vector<Eigen::VectorXd> rights(static_cast<size_t>(folds_), Eigen::VectorXd::Zero(all.cols()));
  const auto& window = rig_.window();
  const auto eachRun = [&](auto act) {
    for (Eigen::Index r = 0; r < all.rows();) {
      Eigen::Index end = r;
      while (end < all.rows() && window[static_cast<size_t>(end)] == window[static_cast<size_t>(r)]) ++end;
      act(r, end - r, window[static_cast<size_t>(r)]);
      r = end;
    }
  };
  eachRun([&](Eigen::Index at, Eigen::Index rows, size_t w) {
    const Eigen::MatrixXd part = all.middleRows(at, rows) * scale.asDiagonal();
    grams[static_cast<size_t>(fold_[w])].noalias() += part.transpose() * part;
    rights[static_cast<size_t>(fold_[w])].noalias() += part.transpose() * rig_.response().segment(at, rows);
  });
  std::vector<Eigen::VectorXd> solutions;
  for (size_t f = 0; f < grams.size(); ++f) {
    Eigen::MatrixXd rest = Eigen::MatrixXd::Zero(all.cols(), all.cols());
    Eigen::VectorXd right = Eigen::VectorXd::Zero(all.cols());
    for (size_t other = 0; other < grams.size(); ++other) {
      if (other == f) continue;
      rest += grams[other];
      right += rights[other];
    }
    rest.diagonal().array() += 1e-9;
    solutions.push_back(scale.cwiseProduct(solveSymmetric(rest, right)));
  }
  std::vector<double> squares(rig_.windows(), 0.0);
  eachRun([&](Eigen::Index at, Eigen::Index rows, size_t w) {
    squares[w] +=
        (rig_.response().segment(at, rows) - all.middleRows(at, rows) * solutions[static_cast<size_t>(fold_[w])])
            .squaredNorm();
  });
  return squares;
}

void Screen::settle(std::vector<Pick>& chosen) const {
  for (size_t k = 0; k < chosen.size(); ++k) {
    std::vector<Pick> others = chosen;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
    const Left left = leaveOnlyResponse(others);
    Eigen::VectorXd amplitude;
    chosen[k].gain = gainOf(columnsOf(chosen[k]), left, amplitude);
    if (amplitude.size() == 0) continue;
    chosen[k].parameters =
        chosen[k].effect->scaled(chosen[k].shape, {amplitude.data(), static_cast<size_t>(amplitude.size())});
  }
  sortByGain(chosen);
}

std::vector<Pick> Screen::grow(std::vector<Pick> chosen) const {
  const double baseSquares = leave({}).response.squaredNorm();
  while (chosen.size() < mostEffects + mostWaves) {
    const Left left = leave(chosen);
    std::vector<Pick> best = bestOfEach(left, chosen);
    if (chosen.size() - furtherWaves(chosen) >= mostEffects)
      std::erase_if(best, [&chosen](const Pick& one) { return !contains(chosen, one.effect); });
    if (furtherWaves(chosen) >= mostWaves)
      std::erase_if(best, [&chosen](const Pick& one) { return contains(chosen, one.effect); });
    if (best.empty()) break;
    for (size_t k = 0; k < std::min<size_t>(3, best.size()); ++k) best[k] = refined(best[k], left);
    sortByGain(best);
    Pick& first = best.front();
    if (first.gain < limits_.hardlyAny * left.response.squaredNorm() || first.gain < limits_.negligible * baseSquares)
      break;
    double chance = 0.0;
    first.pValue = pValueOf(first, left, chance);
    if (first.pValue > limits_.largestPValue || first.gain < limits_.beyondChance * chance) break;
    chosen.push_back(first);
    settle(chosen);
  }
  return chosen;
}

std::vector<Pick> Screen::exchange(std::vector<Pick> chosen) const {
  for (size_t k = 0; k < chosen.size(); ++k) {
    std::vector<Pick> others = chosen;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
    const Left left = leave(others);
    std::vector<Pick> best = bestOfEach(left, others);
    for (size_t j = 0; j < std::min<size_t>(3, best.size()); ++j) {
      best[j] = refined(best[j], left);
      if (best[j].gain <= limits_.hardlyMore() * chosen[k].gain) continue;
      best[j].pValue = chosen[k].pValue;
      chosen[k] = best[j];
    }
  }
  settle(chosen);
  return chosen;
}

std::vector<Pick> Screen::prune(std::vector<Pick> chosen) const {
  for (bool changed = true; changed && !chosen.empty();) {
    changed = false;
    const auto with = validated(chosen);
    for (size_t k = chosen.size(); k-- > 0 && !changed;) {
      std::vector<Pick> others = chosen;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
      const auto without = validated(others);
      const double sumWith = mean(with), sumWithout = mean(without);
      if (sumWithout > (1.0 + limits_.negligible) * sumWith) continue;
      // An effect that lives in a few windows can't be confirmed by others.
      std::vector<double> gains(with.size());
      const Left left = leave(others);
      const Eigen::MatrixXd& own = columnsOf(chosen[k]);
      double local = 0.0, all = 0.0;
      for (Eigen::Index r = 0; r < own.rows(); ++r)
        gains[rig_.window()[static_cast<size_t>(r)]] += own.row(r).squaredNorm();
      for (const double gain : gains) all += gain;
      std::sort(gains.begin(), gains.end(), std::greater<>());
      const auto few = std::max<size_t>(2, static_cast<size_t>(limits_.little * static_cast<double>(gains.size())));
      for (size_t g = 0; g < std::min(few, gains.size()); ++g) local += gains[g];
      if (local > (1.0 - limits_.little) * all) continue;
      chosen = others;
      settle(chosen);
      changed = true;
    }
  }
  return chosen;
}

void Screen::findRivals(std::vector<Pick>& chosen) const {
  for (size_t k = 0; k < chosen.size(); ++k) {
    std::vector<Pick> others = chosen;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
    const Left left = leave(others);
    const auto own = validated(chosen);
    for (Pick& rival : bestOfEach(left, chosen)) {
      if (rival.gain < limits_.half * chosen[k].gain) break;
      if (contains(chosen, rival.effect)) continue;
      rival = refined(std::move(rival), left);
      std::vector<Pick> swapped = chosen;
      swapped[k] = rival;
      const auto other = validated(swapped);
      double sum = 0.0, squares = 0.0;
      for (size_t w = 0; w < own.size(); ++w) sum += other[w] - own[w];
      const double middle = sum / static_cast<double>(own.size());
      for (size_t w = 0; w < own.size(); ++w) squares += std::pow(other[w] - own[w] - middle, 2);
      const double error = std::sqrt(squares) / static_cast<double>(own.size());
      if (middle < limits_.apart * error) chosen[k].rivals.push_back(rival.effect);
    }
  }
}

ScreenResult Screen::run() const {
  ScreenResult result;
  const Left left = leave({});
  result.baseSquares = left.response.squaredNorm();
  result.leftSquares = result.baseSquares;
  std::vector<Pick> starts = bestOfEach(left, {});
  double least = mean(validated({}));
  for (size_t k = 0; k < std::min(beamWidth, starts.size()); ++k) {
    if (starts[k].gain < limits_.half * starts.front().gain) break;
    std::vector<Pick> chosen;
    if (k > 0) {
      Pick first = refined(starts[k], left);
      double chance = 0.0;
      first.pValue = pValueOf(first, left, chance);
      if (first.pValue > limits_.largestPValue || first.gain < limits_.beyondChance * chance) continue;
      chosen.push_back(first);
    }
    chosen = prune(exchange(grow(std::move(chosen))));
    if (chosen.empty()) continue;
    // A further effect has to pay for itself.
    const double error = mean(validated(chosen)) * (1.0 + limits_.hardlyAny * static_cast<double>(chosen.size()));
    if (error >= least && !result.chosen.empty()) continue;
    least = std::min(least, error);
    result.chosen = std::move(chosen);
  }
  if (!result.chosen.empty()) {
    result.leftSquares = leave(result.chosen).response.squaredNorm();
    findRivals(result.chosen);
  }
  return result;
}

}  // namespace breakaway
