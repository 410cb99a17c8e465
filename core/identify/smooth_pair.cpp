#include "identify/smooth_pair.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

namespace breakaway {

namespace {

using Eigen::Index;

/// Of one curve: its spread, and the way over which it stays alike.
struct Kernel {
  double spread = 0.0, length = 1.0;
};

struct Problem {
  explicit Problem(const std::vector<double>& places)
      : place(places),
        measured(Eigen::VectorXd::Zero(2 * static_cast<Index>(places.size()))),
        noise(Eigen::MatrixXd::Zero(measured.size(), measured.size())) {}

  std::vector<double> place;
  Eigen::VectorXd measured;  // all first values, then all second ones
  Eigen::MatrixXd noise;
  double level[2] = {0.0, 0.0};
};

constexpr double lengths[] = {1.0 / 90.0, 1.0 / 50.0, 1.0 / 28.0, 1.0 / 15.0, 1.0 / 8.0, 1.0 / 4.0};
constexpr double spreads[] = {0.003, 0.01, 0.03, 0.1, 0.3};
constexpr double anyLevel = 10.0;  // times the level: what is known of the constant beforehand

/// Rounding may leave a variance a little below zero.
double rootOf(double variance) {
  return variance > 0.0 ? std::sqrt(variance) : 0.0;
}

Eigen::MatrixXd covarianceOf(const Problem& problem, const Kernel (&kernels)[2]) {
  const auto n = static_cast<Index>(problem.place.size());
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  for (Index c = 0; c < 2; ++c) {
    const double level = problem.level[c], constant = anyLevel * anyLevel * level * level;
    const double square = std::pow(kernels[c].spread * level, 2);
    for (Index i = 0; i < n; ++i) {
      for (Index j = 0; j < n; ++j) {
        const double d =
            (problem.place[static_cast<size_t>(i)] - problem.place[static_cast<size_t>(j)]) / kernels[c].length;
        K(c * n + i, c * n + j) = constant + square * std::exp(-0.5 * d * d);
      }
    }
  }
  return K;
}

double logLikelihood(const Problem& problem, const Kernel (&kernels)[2]) {
  const Eigen::MatrixXd whole = covarianceOf(problem, kernels) + problem.noise;
  const Eigen::LLT<Eigen::MatrixXd> factor = whole.llt();
  if (factor.info() != Eigen::Success) return -1e300;
  const Eigen::VectorXd half = factor.matrixL().solve(problem.measured);
  return -0.5 * half.squaredNorm() - factor.matrixLLT().diagonal().array().log().sum();
}

/// One curve's spread and length after the other, twice around.
void chooseKernels(const Problem& problem, Kernel (&kernels)[2]) {
  double best = logLikelihood(problem, kernels);
  for (int round = 0; round < 2; ++round) {
    for (Kernel& kernel : kernels) {
      const auto tryOne = [&](double Kernel::*part, double value) {
        const Kernel before = kernel;
        kernel.*part = value;
        const double likelihood = logLikelihood(problem, kernels);
        if (likelihood > best) {
          best = likelihood;
        } else {
          kernel = before;
        }
      };
      for (const double length : lengths) tryOne(&Kernel::length, length);
      for (const double spread : spreads) tryOne(&Kernel::spread, spread);
    }
  }
}

/// One curve at the places, over all spreads and ways that it might have, each as likely as the measured pairs are
/// under it: where they can't show how far or how finely it swings, it may swing all the same.
std::vector<Estimate> overKernels(const Problem& problem, const Kernel (&chosen)[2], Index c) {
  const auto n = static_cast<Index>(problem.place.size());
  constexpr size_t tries = std::size(spreads) * std::size(lengths);
  double likelihood[tries], most = -1e300;
  Eigen::MatrixXd means(n, tries), variances(n, tries);
  for (size_t t = 0; t < tries; ++t) {
    Kernel kernels[2] = {chosen[0], chosen[1]};
    kernels[c] = {spreads[t % std::size(spreads)], lengths[t / std::size(spreads)]};
    likelihood[t] = logLikelihood(problem, kernels);
    most = std::max(most, likelihood[t]);
    const Eigen::MatrixXd K = covarianceOf(problem, kernels);
    const Eigen::LLT<Eigen::MatrixXd> factor = (K + problem.noise).llt();
    const Eigen::MatrixXd half = factor.matrixL().solve(K.middleCols(c * n, n));
    const auto column = static_cast<Index>(t);
    means.col(column) = half.transpose() * factor.matrixL().solve(problem.measured);
    variances.col(column) = K.diagonal().segment(c * n, n) - half.colwise().squaredNorm().transpose();
  }
  double sum = 0.0;
  Eigen::VectorXd weights(tries);
  for (size_t t = 0; t < tries; ++t) sum += weights[static_cast<Index>(t)] = std::exp(likelihood[t] - most);
  weights /= sum;
  const Eigen::VectorXd mean = means * weights;
  const Eigen::VectorXd apart = (means.colwise() - mean).array().square().matrix() * weights;
  const Eigen::VectorXd variance = variances * weights + apart;
  std::vector<Estimate> curve;
  curve.reserve(problem.place.size());
  for (Index k = 0; k < n; ++k) curve.push_back({mean[k], rootOf(variance[k])});
  return curve;
}

}  // namespace

SmoothPair smoothPair(const std::vector<double>& place, const std::vector<Eigen::Vector2d>& measured,
                      const std::vector<Eigen::Matrix2d>& covariance) {
  assert(place.size() >= 2 && measured.size() == place.size() && covariance.size() == place.size());
  const auto n = static_cast<Index>(place.size());
  Problem problem(place);
  double weights[2] = {0.0, 0.0};
  for (Index k = 0; k < n; ++k) {
    const auto at = static_cast<size_t>(k);
    for (Index c = 0; c < 2; ++c) {
      problem.measured[c * n + k] = measured[at][c];
      const double weight = 1.0 / covariance[at](c, c);
      problem.level[c] += weight * measured[at][c], weights[c] += weight;
      for (Index d = 0; d < 2; ++d) problem.noise(c * n + k, d * n + k) = covariance[at](c, d);
    }
  }
  for (Index c = 0; c < 2; ++c) problem.level[c] = 1e-12 + std::abs(problem.level[c] / weights[c]);
  Kernel kernels[2];
  kernels[0] = {0.1, 1.0 / 28.0};
  kernels[1] = {0.1, 0.25};
  chooseKernels(problem, kernels);
  const Eigen::MatrixXd K = covarianceOf(problem, kernels), whole = K + problem.noise;
  const Eigen::LLT<Eigen::MatrixXd> factor = whole.llt();
  const Eigen::VectorXd mean = K * factor.solve(problem.measured);
  const Eigen::MatrixXd spread = K - K * factor.solve(K);
  SmoothPair result;
  for (Index c = 0; c < 2; ++c) {
    (c == 0 ? result.first : result.second) = overKernels(problem, kernels, c);
    const Eigen::VectorXd share = Eigen::VectorXd::Constant(n, 1.0 / static_cast<double>(n));
    const double variance = share.dot(spread.block(c * n, c * n, n, n) * share);
    Estimate& average = c == 0 ? result.firstMean : result.secondMean;
    average.value = share.dot(mean.segment(c * n, n));
    average.standardError = rootOf(variance);
  }
  return result;
}

}  // namespace breakaway
