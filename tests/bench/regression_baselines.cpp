#include "bench/regression_baselines.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnose/effects/catalogue.h"
#include "diagnose/fit/inverse_rows.h"
#include "diagnose/simulate/physics.h"

namespace breakaway::test {

namespace {

constexpr double parallelCutoff_Hz = 50.0;
constexpr size_t mostGroups = 12;
constexpr double ridge = 1e-6;  ///< of unit columns

using Columns = std::vector<Eigen::Index>;

/// What each row of one track is: everything a term may look at.
std::vector<Situation> situationsOf(const InverseRows& rows, const Model& model, const Physics& physics) {
  std::vector<Situation> all(rows.time.size());
  double direction = 1.0, turned = rows.position.empty() ? 0.0 : rows.position.front(), stillSince = 0.0, rest = 0.0;
  for (size_t k = 0; k < all.size(); ++k) {
    const double v = rows.velocity[k];
    if (std::abs(v) > rows.velocityNoise) {
      if (v * direction < 0.0) turned = rows.position[k];
      direction = v > 0.0 ? 1.0 : -1.0;
      stillSince = rows.time[k];
    } else {
      rest = rows.time[k] - stillSince;
    }
    Situation& at = all[k];
    at.axis = model.axis;
    at.time_s = rows.time[k];
    at.position = rows.position[k];
    at.velocity = v;
    at.acceleration = rows.acceleration[k];
    at.direction = direction;
    at.current = physics.electrical ? (rows.input[k] - physics.backEmf * v) / physics.resistance : rows.input[k];
    at.driveTorque = physics.torqueConstant * at.current;
    at.input = rows.input[k];
    at.supply_V = model.supply_V.value_or(0.0);
    at.rest_s = rest;
    at.travel = rows.position[k] - turned;
  }
  return all;
}

/// Columns of all tracks, filtered alike; `fill` gives one value per situation and column.
template <typename Value>
Eigen::MatrixXd filtered(const std::vector<InverseRows>& tracks, const std::vector<std::vector<Situation>>& situations,
                         size_t count, Value value) {
  std::vector<Eigen::MatrixXd> parts;
  Eigen::Index total = 0;
  for (size_t t = 0; t < tracks.size(); ++t) {
    const auto n = static_cast<Eigen::Index>(situations[t].size());
    Eigen::MatrixXd x(n, static_cast<Eigen::Index>(count));
    for (Eigen::Index k = 0; k < n; ++k) {
      for (size_t c = 0; c < count; ++c)
        x(k, static_cast<Eigen::Index>(c)) = value(situations[t][static_cast<size_t>(k)], c);
    }
    Eigen::VectorXd none = Eigen::VectorXd::Zero(n);
    const double step_s = tracks[t].step_s;
    filterAlike(x, none, tracks[t].moving, step_s, std::min(parallelCutoff_Hz, 0.05 / step_s));
    total += x.rows();
    parts.push_back(std::move(x));
  }
  Eigen::MatrixXd all(total, static_cast<Eigen::Index>(count));
  Eigen::Index at = 0;
  for (const Eigen::MatrixXd& part : parts) {
    all.middleRows(at, part.rows()) = part;
    at += part.rows();
  }
  return all;
}

/// Squared residual of least squares on these columns.
double squaresLeft(const TorqueColumns& c, const Columns& columns) {
  Eigen::MatrixXd gram = c.gram(columns, columns);
  gram.diagonal().array() += ridge;
  const Eigen::VectorXd right = c.right(columns);
  return std::max(c.squares - right.dot(gram.ldlt().solve(right)), 1e-12 * c.squares);
}

double criterion(const TorqueColumns& c, const Columns& columns) {
  const auto n = static_cast<double>(c.rows);
  return n * std::log(squaresLeft(c, columns) / n) + static_cast<double>(columns.size()) * std::log(n);
}

Columns joined(const TorqueColumns& c, const std::vector<size_t>& groups) {
  Columns columns = c.base;
  for (const size_t group : groups)
    columns.insert(columns.end(), c.groups[group].columns.begin(), c.groups[group].columns.end());
  return columns;
}

/// Drops groups while that lowers the criterion.
void dropIdle(const TorqueColumns& c, std::vector<size_t>& groups) {
  for (bool dropped = true; dropped && !groups.empty();) {
    dropped = false;
    for (const size_t idle : groups) {
      std::vector<size_t> fewer;
      for (const size_t group : groups) {
        if (group != idle) fewer.push_back(group);
      }
      if (criterion(c, joined(c, fewer)) > criterion(c, joined(c, groups))) continue;
      groups = std::move(fewer);
      dropped = true;
      break;
    }
  }
}

/// What is left when columns below `threshold` (of the response's length) are dropped again and again.
Columns thresholded(const TorqueColumns& c, double threshold, Eigen::VectorXd& value) {
  Columns kept(static_cast<size_t>(c.right.size()));
  for (size_t k = 0; k < kept.size(); ++k) kept[k] = static_cast<Eigen::Index>(k);
  const double least = threshold * std::sqrt(c.squares);
  for (int round = 0; round < 20; ++round) {
    Eigen::MatrixXd gram = c.gram(kept, kept);
    gram.diagonal().array() += 1e-3;
    value = gram.ldlt().solve(Eigen::VectorXd(c.right(kept)));
    Columns next;
    for (size_t k = 0; k < kept.size(); ++k) {
      const bool base = static_cast<size_t>(kept[k]) < c.base.size();
      if (base || std::abs(value[static_cast<Eigen::Index>(k)]) >= least) next.push_back(kept[k]);
    }
    if (next.size() == kept.size()) break;
    kept = next;
  }
  return kept;
}

}  // namespace

TorqueColumns torqueColumns(const Preparation& prepared) {
  const Model& model = prepared.starts.front();
  const Physics physics = physicsOf(model);
  std::vector<InverseRows> tracks;
  std::vector<std::vector<Situation>> situations;
  for (const Track& track : prepared.training) {
    tracks.push_back(inverseRows(track));
    situations.push_back(situationsOf(tracks.back(), model, physics));
  }
  TorqueColumns out;
  std::vector<Eigen::MatrixXd> blocks{filtered(tracks, situations, 3, [](const Situation& at, size_t c) {
    return c == 0 ? at.acceleration : c == 1 ? at.velocity : at.direction;
  })};
  out.base = {0, 1, 2};
  Eigen::Index size = 3;
  for (const Effect* effect : catalogue()) {
    if (effect->hidden() != nullptr) continue;
    for (const Shape& shape : effect->shapes(prepared.seen)) {
      Eigen::MatrixXd block = filtered(tracks, situations, shape.size(), [&](const Situation& at, size_t c) {
        const Term term = effect->term(shape[c], at);
        return term.load_Nm + at.direction * term.friction_Nm +
               physics.torqueConstant / physics.resistance * term.voltage_V;
      });
      if (!block.allFinite() || block.colwise().norm().minCoeff() <= 0.0) continue;
      TorqueColumns::Group group{effect, {}};
      for (size_t c = 0; c < shape.size(); ++c) group.columns.push_back(size++);
      out.groups.push_back(std::move(group));
      blocks.push_back(std::move(block));
    }
  }
  const Eigen::VectorXd response = filtered(tracks, situations, 1, [&physics](const Situation& at, size_t) {
    return at.driveTorque - physics.gravity * std::sin(at.position - physics.downAngle);
  });
  out.rows = response.size();
  Eigen::MatrixXd all(out.rows, size);
  Eigen::Index at = 0;
  for (Eigen::MatrixXd& block : blocks) {
    all.middleCols(at, block.cols()) = block;
    at += block.cols();
    block.resize(0, 0);
  }
  for (Eigen::Index c = 0; c < size; ++c) all.col(c) /= std::max(all.col(c).norm(), 1e-300);
  all = (all.array().abs() < 1e-30).select(0.0, all);  // a filter's tails end in denormals, which take long
  out.gram.setZero(size, size);
  out.gram.selfadjointView<Eigen::Lower>().rankUpdate(all.transpose());
  out.gram.triangularView<Eigen::StrictlyUpper>() = out.gram.transpose();
  out.right = all.transpose() * response;
  out.squares = response.squaredNorm();
  return out;
}

std::vector<std::string> stepwiseNames(const TorqueColumns& c) {
  std::vector<size_t> chosen;
  if (c.rows < 100) return {};
  while (chosen.size() < mostGroups) {
    double best = criterion(c, joined(c, chosen));
    size_t winner = c.groups.size();
    for (size_t group = 0; group < c.groups.size(); ++group) {
      const bool again = std::any_of(chosen.begin(), chosen.end(),
                                     [&](size_t one) { return c.groups[one].effect == c.groups[group].effect; });
      if (again) continue;
      auto more = chosen;
      more.push_back(group);
      const double value = criterion(c, joined(c, more));
      if (value >= best) continue;
      best = value;
      winner = group;
    }
    if (winner == c.groups.size()) break;
    chosen.push_back(winner);
  }
  dropIdle(c, chosen);
  std::vector<std::string> names;
  names.reserve(chosen.size());
  for (const size_t group : chosen) names.emplace_back(c.groups[group].effect->name());
  return names;
}

std::vector<std::string> thresholdedNames(const TorqueColumns& c) {
  if (c.rows < 100) return {};
  double best = std::numeric_limits<double>::infinity();
  Columns kept;
  Eigen::VectorXd value;
  for (const double threshold : {0.005, 0.01, 0.02, 0.05, 0.1, 0.2}) {
    Eigen::VectorXd tried;
    const Columns columns = thresholded(c, threshold, tried);
    const double now = criterion(c, columns);
    if (now >= best) continue;
    best = now;
    kept = columns;
    value = tried;
  }
  std::vector<std::pair<double, std::string>> sized;
  for (const TorqueColumns::Group& group : c.groups) {
    double size = 0.0;
    for (size_t k = 0; k < kept.size(); ++k) {
      if (std::find(group.columns.begin(), group.columns.end(), kept[k]) != group.columns.end())
        size = std::max(size, std::abs(value[static_cast<Eigen::Index>(k)]));
    }
    if (size > 0.0) sized.emplace_back(size, std::string(group.effect->name()));
  }
  std::stable_sort(sized.begin(), sized.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::string> names;
  for (const auto& [size, name] : sized) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

}  // namespace breakaway::test
