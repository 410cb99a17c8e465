#include "diagnose/fit/inverse_regression.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "dense/dense_solve.h"
#include "diagnose/simulate/physics.h"

namespace breakaway {

namespace {

constexpr double parallelCutoff_Hz = 50.0;

}  // namespace

double accelerationColumn(const InverseRows& rows, size_t k) {
  return rows.acceleration[k];
}

double velocityColumn(const InverseRows& rows, size_t k) {
  return rows.velocity[k];
}

double directionColumn(const InverseRows& rows, size_t k) {
  return rows.velocity[k] > 0.0 ? 1.0 : rows.velocity[k] < 0.0 ? -1.0 : 0.0;
}

Column knownLoadColumn(const Model& model) {
  const double hanging = model.pendulum ? pendulumInertia(*model.pendulum) : 0.0;
  return [physics = physicsOf(model), hanging](const InverseRows& rows, size_t k) {
    return physics.knownLoad(rows.position[k]) + hanging * rows.acceleration[k];
  };
}

Result<Regression> regress(const std::vector<Track>& tracks, const std::vector<Column>& columns, const Column& response,
                           bool creeping) {
  const auto size = static_cast<Eigen::Index>(columns.size());
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
  std::vector<std::pair<Eigen::MatrixXd, Eigen::VectorXd>> blocks;
  Regression out;
  for (const Track& track : tracks) {
    const InverseRows rows = inverseRows(track);
    const auto n = static_cast<Eigen::Index>(rows.time.size());
    Eigen::MatrixXd x(n, size);
    Eigen::VectorXd y(n);
    for (Eigen::Index k = 0; k < n; ++k) {
      for (Eigen::Index c = 0; c < size; ++c) x(k, c) = columns[static_cast<size_t>(c)](rows, static_cast<size_t>(k));
      y[k] = response(rows, static_cast<size_t>(k));
    }
    const double cutoff = std::min(parallelCutoff_Hz, 0.05 / rows.step_s);
    filterAlike(x, y, creeping ? rows.usable : rows.moving, rows.step_s, cutoff);
    const auto block = std::max<Eigen::Index>(4, static_cast<Eigen::Index>(5.0 * cutoff));
    for (Eigen::Index from = 0; from < y.size(); from += block) {
      const Eigen::Index length = std::min(block, y.size() - from);
      blocks.emplace_back(x.middleRows(from, length), y.segment(from, length));
    }
    normal += x.transpose() * x;
    right += x.transpose() * y;
    out.rows += static_cast<size_t>(y.size());
  }
  if (out.rows < 10 * columns.size()) {
    return Error{tracks.empty() ? "" : tracks.front().name, "holds too little motion for the inverse model"};
  }
  const Eigen::VectorXd scale = normal.diagonal().cwiseSqrt().cwiseMax(1e-300).cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * normal * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled);
  if (eigen.eigenvalues().minCoeff() < 1e-9) {
    return Error{tracks.front().name, "moves too evenly to tell the parameters of the inverse model apart"};
  }
  const Eigen::MatrixXd inverse = scale.asDiagonal() * inverseOf(scaled) * scale.asDiagonal();
  out.value = inverse * right;
  Eigen::MatrixXd meat = Eigen::MatrixXd::Zero(size, size);
  double squares = 0.0, total = 0.0;
  for (const auto& [x, y] : blocks) {
    const Eigen::VectorXd r = y - x * out.value;
    const Eigen::VectorXd score = x.transpose() * r;
    meat += score * score.transpose();
    squares += r.squaredNorm();
    total += y.squaredNorm();
  }
  out.covariance = inverse * meat * inverse;
  // So few stretches leave as little over as there are columns to follow them: what they leave says nothing then.
  const auto clusters = static_cast<double>(blocks.size()), freedom = clusters - static_cast<double>(size);
  out.fewStretches = freedom > 0.0 ? std::sqrt(clusters / freedom) : std::numeric_limits<double>::infinity();
  out.relativeError = std::sqrt(squares / std::max(total, 1e-300));
  return out;
}

}  // namespace breakaway
