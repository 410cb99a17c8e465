#include "diagnose/fit/inverse_proposals.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "diagnose/fit/inverse_rows.h"
#include "diagnose/simulate/physics.h"

namespace breakaway {

namespace {

constexpr double parallelCutoff_Hz = 50.0;
constexpr double leastGain = 0.03;
constexpr Eigen::Index mostRows = 20000;

/// Filtered columns of all tracks, one below the other.
class FilteredColumns {
 public:
  FilteredColumns(const Model& model, const std::vector<Track>& tracks) : model_(model), physics_(physicsOf(model)) {
    Eigen::Index rows = 0;
    for (const Track& track : tracks) {
      tracks_.push_back(inverseRows(track));
      rows += static_cast<Eigen::Index>(tracks_.back().time.size());
    }
    // Long recordings are decimated further, through a lower cutoff, so that all candidates fit into memory.
    slower_ = std::max(1.0, static_cast<double>(rows) / 4.0 / static_cast<double>(mostRows));
  }

  /// `fill` writes one row for an instant.
  template <typename Fill>
  Eigen::MatrixXd columns(Eigen::Index count, Fill fill) const {
    std::vector<Eigen::MatrixXd> parts;
    Eigen::Index total = 0;
    for (const InverseRows& rows : tracks_) {
      const auto n = static_cast<Eigen::Index>(rows.time.size());
      Eigen::MatrixXd x(n, count);
      std::array<double, 8> out{};
      for (Eigen::Index k = 0; k < n; ++k) {
        fill(situation(rows, static_cast<size_t>(k)), out);
        for (Eigen::Index c = 0; c < count; ++c) x(k, c) = out[static_cast<size_t>(c)];
      }
      Eigen::VectorXd none = Eigen::VectorXd::Zero(n);
      filterAlike(x, none, rows.moving, rows.step_s, std::min(parallelCutoff_Hz, 0.05 / rows.step_s) / slower_);
      total += x.rows();
      parts.push_back(std::move(x));
    }
    Eigen::MatrixXd all(total, count);
    Eigen::Index at = 0;
    for (const Eigen::MatrixXd& part : parts) {
      all.middleRows(at, part.rows()) = part;
      at += part.rows();
    }
    return all;
  }

  const Physics& physics() const { return physics_; }

 private:
  Situation situation(const InverseRows& rows, size_t k) const {
    const double drive = physics_.electrical
                             ? (rows.input[k] - physics_.backEmf * rows.velocity[k]) / physics_.resistance
                             : rows.input[k];
    return {model_.axis,
            rows.time[k],
            rows.position[k],
            rows.velocity[k],
            rows.acceleration[k],
            physics_.torqueConstant * drive,
            rows.velocity[k] >= 0.0 ? 1.0 : -1.0};
  }

  const Model& model_;
  Physics physics_;
  std::vector<InverseRows> tracks_;
  double slower_ = 1.0;
};

struct Offer {
  const Effect* effect;
  Shape shape;
  Eigen::MatrixXd columns;
};

}  // namespace

std::vector<Proposal> inverseProposals(const Model& model, const std::vector<Track>& tracks,
                                       const std::vector<const Effect*>& effects, const Excitation& seen, size_t most) {
  const FilteredColumns filtered(model, tracks);
  const Physics& p = filtered.physics();
  const auto terms = termsOf(model);
  const Eigen::MatrixXd response = filtered.columns(1, [&](const Situation& at, auto& out) {
    double known = p.gravity * std::sin(at.position - p.downAngle);
    for (const CompiledTerm& term : *terms) {
      const Term part = term.effect->term(term.parameters, at);
      known += part.load_Nm + at.direction * part.friction_Nm;
    }
    out[0] = at.driveTorque - known;
  });
  Eigen::MatrixXd chosen = filtered.columns(3, [](const Situation& at, auto& out) {
    out[0] = at.acceleration;
    out[1] = at.velocity;
    out[2] = at.direction;
  });
  std::vector<Proposal> proposals;
  if (response.rows() < 100) return proposals;
  std::vector<Offer> offers;
  for (const Effect* effect : effects) {
    for (const Shape& shape : effect->shapes(seen)) {
      offers.push_back({effect, shape,
                        filtered.columns(static_cast<Eigen::Index>(effect->amplitudes()),
                                         [&](const Situation& at, auto& out) { effect->columns(shape, at, out); })});
    }
  }
  std::vector<const Offer*> taken;
  while (taken.size() < most) {
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(chosen);
    const Eigen::MatrixXd basis = qr.householderQ() * Eigen::MatrixXd::Identity(chosen.rows(), chosen.cols());
    const Eigen::VectorXd residual = response.col(0) - basis * (basis.transpose() * response.col(0));
    const Offer* best = nullptr;
    double bestGain = leastGain * residual.squaredNorm();
    for (const Offer& offer : offers) {
      const bool again =
          std::any_of(taken.begin(), taken.end(), [&](const Offer* one) { return one->effect == offer.effect; });
      if (again) continue;
      const Eigen::MatrixXd free = offer.columns - basis * (basis.transpose() * offer.columns);
      if (!(free.squaredNorm() > 1e-4 * offer.columns.squaredNorm())) continue;
      const Eigen::VectorXd right = free.transpose() * residual;
      const double gain = right.dot((free.transpose() * free).ldlt().solve(right));
      if (gain <= bestGain) continue;
      bestGain = gain;
      best = &offer;
    }
    if (best == nullptr) break;
    taken.push_back(best);
    chosen.conservativeResize(Eigen::NoChange, chosen.cols() + best->columns.cols());
    chosen.rightCols(best->columns.cols()) = best->columns;
  }
  const Eigen::VectorXd value = chosen.colPivHouseholderQr().solve(response.col(0));
  Eigen::Index at = 3;
  for (const Offer* offer : taken) {
    const Eigen::VectorXd amplitude = value.segment(at, offer->columns.cols());
    proposals.push_back({offer->effect, offer->shape, {amplitude.begin(), amplitude.end()}});
    at += offer->columns.cols();
  }
  return proposals;
}

}  // namespace breakaway
