#include "diagnose/score_test.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/statistics.h"

namespace breakaway {

namespace {

constexpr size_t flips = 999;

/// What one candidate shape leaves behind.
struct Scored {
  const Effect* effect = nullptr;
  Shape shape;
  Eigen::VectorXd amplitude;
  Eigen::MatrixXd scores;     ///< one row per window
  Eigen::MatrixXd precision;  ///< inverse of the scores' second moment
  double gain = 0.0;
};

/// Tail of χ² with one or two degrees of freedom, as −log for comparison.
double surprise(double statistic, Eigen::Index freedom) {
  if (freedom == 2) return 0.5 * statistic;
  return -std::log(std::max(std::erfc(std::sqrt(0.5 * statistic)), 1e-300));
}

double typicalAmplitude(const Effect& effect, Axis axis, const Excitation& seen) {
  const std::string name = effect.parameters(axis).front().name;
  return typicalSize(name, std::max(seen.peakTorque, 1e-12), std::max(seen.highSpeed, 1e-9));
}

Model withEffect(const Model& model, const Effect& effect, const Shape& shape, const std::vector<double>& amplitude) {
  Model out = model;
  EffectTerm term{std::string(effect.name()), {}};
  const auto specs = effect.parameters(model.axis);
  const auto values = effect.fromAmplitudes(shape, amplitude);
  for (size_t k = 0; k < specs.size(); ++k) term.parameters.push_back({specs[k].name, values[k], values[k], values[k]});
  out.effects.push_back(std::move(term));
  return out;
}

}  // namespace

std::vector<Candidate> scoreTest(const FitResult& at, const ParameterVector& parameters,
                                 const std::vector<Track>& tracks, const std::vector<Window>& windows,
                                 const std::vector<const Effect*>& effects, const Excitation& seen, std::uint64_t seed,
                                 const std::vector<double>& windowWeights) {
  const Eigen::Index size = parameters.size();
  std::vector<WindowResidual> residuals;
  residuals.reserve(windows.size());
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(size, size);
  double squares = 0.0;
  for (size_t w = 0; w < windows.size(); ++w) {
    const double factor = windowWeights.empty() ? 1.0 : windowWeights[w];
    residuals.emplace_back(tracks[windows[w].track], windows[w],
                           Weights{factor * at.weights.position, factor * at.weights.current});
    residuals.back().fit(at.model);
    normal += at.windows[w].jacobian.transpose() * at.windows[w].jacobian;
    squares += at.windows[w].residual.squaredNorm();
  }
  normal.diagonal().array() += 1e-9 * normal.diagonal().maxCoeff();
  const Eigen::LDLT<Eigen::MatrixXd> solver(normal);

  std::vector<Scored> all;
  for (const Effect* effect : effects) {
    const auto size2 = static_cast<Eigen::Index>(effect->amplitudes());
    const double step = 1e-4 * typicalAmplitude(*effect, at.model.axis, seen);
    for (const Shape& shape : effect->shapes(seen)) {
      std::vector<Model> variants;
      for (Eigen::Index a = 0; a < size2; ++a) {
        std::vector<double> amplitude(static_cast<size_t>(size2), 0.0);
        amplitude[static_cast<size_t>(a)] = step;
        variants.push_back(withEffect(at.model, *effect, shape, amplitude));
      }
      Eigen::MatrixXd cross = Eigen::MatrixXd::Zero(size, size2), own = Eigen::MatrixXd::Zero(size2, size2);
      Eigen::MatrixXd raw(static_cast<Eigen::Index>(windows.size()), size2);
      for (size_t w = 0; w < windows.size(); ++w) {
        Eigen::MatrixXd column(residuals[w].rows(), size2);
        for (Eigen::Index a = 0; a < size2; ++a)
          column.col(a) = residuals[w].column(variants[static_cast<size_t>(a)], step);
        cross += at.windows[w].jacobian.transpose() * column;
        own += column.transpose() * column;
        raw.row(static_cast<Eigen::Index>(w)) = (column.transpose() * at.windows[w].residual).transpose();
      }
      const Eigen::MatrixXd share = solver.solve(cross);
      Eigen::MatrixXd free = own - cross.transpose() * share;
      // Nothing left that the base can't do: not a candidate.
      if (!(free.trace() > 1e-6 * own.trace())) continue;
      free.diagonal().array() += 1e-9 * free.trace();
      Scored scored{effect, shape, {}, raw, {}, 0.0};
      for (size_t w = 0; w < windows.size(); ++w) {
        scored.scores.row(static_cast<Eigen::Index>(w)) -=
            (at.windows[w].residual.transpose() * at.windows[w].jacobian) * share;
      }
      const Eigen::VectorXd total = scored.scores.colwise().sum().transpose();
      scored.amplitude = -free.ldlt().solve(total);
      scored.gain = std::clamp(-scored.amplitude.dot(total) / squares, 0.0, 1.0);
      Eigen::MatrixXd moment = scored.scores.transpose() * scored.scores;
      moment.diagonal().array() += 1e-9 * moment.trace() + 1e-300;
      scored.precision = moment.inverse();
      all.push_back(std::move(scored));
    }
  }

  std::vector<double> worst;
  Random random(seed);
  Eigen::RowVectorXd sign(static_cast<Eigen::Index>(windows.size()));
  for (size_t flip = 0; flip < flips; ++flip) {
    for (double& one : sign) one = random.bits() >> 63 ? 1.0 : -1.0;
    double most = 0.0;
    for (const Scored& scored : all) {
      const Eigen::VectorXd g = (sign * scored.scores).transpose();
      most = std::max(most, surprise(g.dot(scored.precision * g), g.size()));
    }
    worst.push_back(most);
  }
  std::vector<Candidate> best;
  for (const Scored& scored : all) {
    const Eigen::VectorXd total = scored.scores.colwise().sum().transpose();
    const double seenSurprise = surprise(total.dot(scored.precision * total), total.size());
    const auto beaten = std::count_if(worst.begin(), worst.end(), [=](double one) { return one >= seenSurprise; });
    Candidate candidate{scored.effect,
                        scored.shape,
                        {scored.amplitude.begin(), scored.amplitude.end()},
                        scored.gain,
                        static_cast<double>(1 + beaten) / static_cast<double>(1 + flips)};
    const auto same =
        std::find_if(best.begin(), best.end(), [&](const Candidate& one) { return one.effect == scored.effect; });
    if (same == best.end())
      best.push_back(std::move(candidate));
    else if (candidate.gain > same->gain)
      *same = std::move(candidate);
  }
  std::stable_sort(best.begin(), best.end(), [](const Candidate& a, const Candidate& b) { return a.gain > b.gain; });
  return best;
}

std::vector<double> crossValidated(const FitResult& fit, const ParameterVector& parameters,
                                   const std::vector<Track>& tracks, const std::vector<Window>& windows,
                                   const std::vector<double>& windowWeights, const std::vector<int>& fold,
                                   int foldCount) {
  const Eigen::Index size = fit.x.size();
  std::vector<double> squares(windows.size());
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(size, size);
  for (const WindowDerivative& window : fit.windows) normal += window.jacobian.transpose() * window.jacobian;
  for (int one = 0; one < foldCount; ++one) {
    Eigen::MatrixXd rest = normal;
    Eigen::VectorXd score = Eigen::VectorXd::Zero(size);
    for (size_t w = 0; w < windows.size(); ++w) {
      if (fold[w] != one) continue;
      rest -= fit.windows[w].jacobian.transpose() * fit.windows[w].jacobian;
      score += fit.windows[w].jacobian.transpose() * fit.windows[w].residual;
    }
    rest.diagonal() += 1e-4 * normal.diagonal() + fit.priorPrecision;
    rest.diagonal().array() += 1e-12 * normal.diagonal().maxCoeff();
    Eigen::VectorXd x = fit.x + rest.ldlt().solve(score);
    for (Eigen::Index k = 0; k < size; ++k) x[k] = std::clamp(x[k], parameters.lower(k), parameters.upper(k));
    const Model model = parameters.at(x);
    for (size_t w = 0; w < windows.size(); ++w) {
      if (fold[w] != one) continue;
      const double factor = windowWeights.empty() ? 1.0 : windowWeights[w];
      WindowResidual window(tracks[windows[w].track], windows[w], Weights{factor, 0.0});
      window.fit(model);
      squares[w] = window.residual().head(window.positions()).squaredNorm() / static_cast<double>(window.positions());
    }
  }
  return squares;
}

}  // namespace breakaway
