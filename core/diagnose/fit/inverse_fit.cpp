#include "diagnose/fit/inverse_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "base/statistics.h"
#include "diagnose/effects/catalogue.h"
#include "diagnose/fit/inverse_rows.h"
#include "diagnose/fit/motion.h"
#include "diagnose/simulate/physics.h"

namespace breakaway {

namespace {

constexpr double parallelCutoff_Hz = 50.0;
constexpr double usualWinding_s = 1e-3;  ///< a winding's time constant

using Column = std::function<double(const InverseRows&, size_t)>;

struct Regression {
  Eigen::VectorXd value;
  Eigen::MatrixXd covariance;
  double relativeError = 0.0;
  size_t rows = 0;
};

double signOf(double v) {
  return v > 0.0 ? 1.0 : v < 0.0 ? -1.0 : 0.0;
}

/// Least squares of `response` on `columns` over all tracks, both sides filtered alike; the covariance is clustered by
/// second.
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
  const Eigen::MatrixXd inverse = scale.asDiagonal() * scaled.inverse() * scale.asDiagonal();
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
  out.relativeError = std::sqrt(squares / std::max(total, 1e-300));
  return out;
}

Column gravityColumn(const Model& model) {
  const Physics physics = physicsOf(model);
  return [physics](const InverseRows& rows, size_t k) { return physics.knownLoad(rows.position[k]); };
}

const Column accelerationColumn = [](const InverseRows& rows, size_t k) { return rows.acceleration[k]; };
const Column velocityColumn = [](const InverseRows& rows, size_t k) { return rows.velocity[k]; };
const Column directionColumn = [](const InverseRows& rows, size_t k) { return signOf(rows.velocity[k]); };
const Column inputColumn = [](const InverseRows& rows, size_t k) { return rows.input[k]; };

void place(Model& model, const std::string& name, double value, double error) {
  for (Parameter& one : model.base) {
    if (one.name == name) one = {name, value, value - 1.959964 * error, value + 1.959964 * error};
  }
}

/// Whether an effect is a torque at every instant, so that the inverse model can hold it.
bool instantTorque(const Effect& effect, DriveInput drive) {
  return effect.hidden() == nullptr && !effect.losesVoltage() && effect.input(drive) == nullptr &&
         effect.elastic() == nullptr && effect.encoder() == nullptr;
}

/// The columns of one effect at a shape.
void addEffect(std::vector<Column>& columns, const Effect& effect, const Shape& shape, const Column& torque,
               const Physics& physics) {
  for (const std::vector<double>& set : shape) {
    columns.push_back([&effect, set, torque, physics](const InverseRows& rows, size_t k) {
      Situation at;
      at.axis = physics.axis;
      at.time_s = rows.time[k];
      at.position = rows.position[k];
      at.velocity = rows.velocity[k];
      at.acceleration = rows.acceleration[k];
      at.driveTorque = torque(rows, k);
      at.direction = signOf(rows.velocity[k]);
      at.current = at.driveTorque / physics.torqueConstant;
      at.knownLoad = physics.knownLoad(at.position);
      at.input = rows.input[k];
      const Term term = effect.term(set, at);
      return term.load_Nm + at.direction * term.friction_Nm;
    });
  }
}

/// The smallest and largest parameters that amplitudes within their intervals give, by moving each amplitude alone.
std::vector<Parameter> effectParameters(const Effect& effect, Axis axis, const Shape& shape,
                                        const Eigen::VectorXd& amplitude, const Eigen::MatrixXd& covariance) {
  const std::vector<double> best(amplitude.data(), amplitude.data() + amplitude.size());
  const std::vector<double> value = effect.scaled(shape, best);
  std::vector<Parameter> parameters;
  const auto specs = effect.parameters(axis);
  for (size_t k = 0; k < specs.size(); ++k) {
    Eigen::VectorXd slope = Eigen::VectorXd::Zero(amplitude.size());
    for (Eigen::Index a = 0; a < amplitude.size(); ++a) {
      const double step = 1e-6 * std::max(amplitude.norm(), 1e-12);
      std::vector<double> near = best;
      near[static_cast<size_t>(a)] += step;
      slope[a] = (effect.scaled(shape, near)[k] - value[k]) / step;
    }
    const double half = 1.959964 * std::sqrt(std::max(0.0, slope.dot(covariance * slope)));
    parameters.push_back({specs[k].name, value[k], value[k] - half, value[k] + half});
  }
  return parameters;
}

}  // namespace

Result<InverseFit> fitInverse(const Model& model, const std::vector<Track>& tracks) {
  const MotorNames& names = motorNames(model.axis);
  const Physics physics = physicsOf(model);
  const Column torque = [physics](const InverseRows& rows, size_t k) {
    if (!physics.electrical) return physics.torqueConstant * rows.input[k];
    return physics.torqueConstant * (rows.input[k] - physics.backEmf * rows.velocity[k]) / physics.resistance;
  };
  const double hanging = model.pendulum ? pendulumInertia(*model.pendulum) : 0.0;
  const Column known = [gravity = gravityColumn(model), hanging](const InverseRows& rows, size_t k) {
    return gravity(rows, k) + hanging * rows.acceleration[k];
  };
  const Column response = [torque, known](const InverseRows& rows, size_t k) {
    return torque(rows, k) - known(rows, k);
  };
  std::vector<Column> columns{accelerationColumn, velocityColumn, directionColumn};
  const Excitation seen = excitationOf(tracks, model);
  std::vector<Shape> chosen;
  for (const EffectTerm& term : model.effects) {
    const Effect* effect = findEffect(term.effect);
    if (effect == nullptr) return Error{"effect " + term.effect, "is not in the catalogue"};
    double best = 1e300;
    Shape bestShape;
    const bool linear = instantTorque(*effect, model.input);
    for (const Shape& shape : linear ? effect->shapes(seen) : std::vector<Shape>{}) {
      auto trial = columns;
      addEffect(trial, *effect, shape, torque, physics);
      const auto got = regress(tracks, trial, response, true);
      if (!got || got->relativeError >= best) continue;
      best = got->relativeError;
      bestShape = shape;
    }
    if (best == 1e300)
      return Error{tracks.front().name, "can't show the effect " + term.effect + " to the inverse model"};
    addEffect(columns, *effect, bestShape, torque, physics);
    chosen.push_back(bestShape);
  }
  const auto got = regress(tracks, columns, response, true);
  if (!got) return got.error();
  InverseFit fit;
  fit.model = model;
  const char* base[]{names.inertia, names.viscous, names.coulomb};
  for (Eigen::Index k = 0; k < 3; ++k) place(fit.model, base[k], got->value[k], std::sqrt(got->covariance(k, k)));
  Eigen::Index at = 3;
  for (size_t e = 0; e < fit.model.effects.size(); ++e) {
    const Effect& effect = *findEffect(fit.model.effects[e].effect);
    const auto size = static_cast<Eigen::Index>(chosen[e].size());
    fit.model.effects[e].parameters = effectParameters(effect, model.axis, chosen[e], got->value.segment(at, size),
                                                       got->covariance.block(at, at, size, size));
    at += size;
  }
  fit.relativeError = got->relativeError;
  fit.rows = got->rows;
  return fit;
}

namespace {

/// The bench's motor before anything is known of its motion: constants, winding and down angle.
Model believedDrive(const Bench& bench) {
  const MotorNames& names = motorNames(bench.axis);
  Model model;
  model.axis = bench.axis;
  model.input = bench.input;
  model.supply_V = bench.supply_V;
  model.count = bench.count();
  model.pendulum = bench.pendulum;
  const MotorBelief& belief = bench.motor;
  const auto add = [&model](const char* name, double value) { model.base.push_back({name, value, value, value}); };
  if (bench.input != DriveInput::torque) {
    add(names.torqueConstant,
        belief.torqueConstant.value_or(belief.backEmfConstant.value_or(bench.electrical() ? 0.1 : 1.0)));
  }
  if (bench.electrical()) {
    add(names.backEmfConstant, belief.backEmfConstant.value_or(model.base.front().value));
    add(names.resistance, belief.resistance_ohm.value_or(1.0));
    if (belief.inductance_H) add(names.inductance, *belief.inductance_H);
  }
  if (bench.pendulum) add("down_angle_rad", bench.pendulum->downAngle_rad);
  return model;
}

/// input = a·(J/k) + ω·(B/k) + s·(F/k) + gravity/k (+ Ke ω): ratios to the drive's gain k, Kt or Kt/R, come out
/// linearly.
struct GainRatios {
  double inertia = 0.0, viscous = 0.0, coulomb = 0.0;
  double gravity = 0.0;  ///< 1/k; 0 without a pendulum
};

Result<GainRatios> gainRatios(const Model& model, const std::vector<Track>& tracks) {
  std::vector<Column> columns{accelerationColumn, velocityColumn, directionColumn};
  const bool hangs = physicsOf(model).gravity > 0.0;
  if (hangs) {
    columns.push_back(
        [gravity = gravityColumn(model), hanging = pendulumInertia(*model.pendulum)](
            const InverseRows& rows, size_t k) { return gravity(rows, k) + hanging * rows.acceleration[k]; });
  }
  columns.push_back([](const InverseRows&, size_t) { return 1.0; });  // a constant load must not bend the others
  const auto got = regress(tracks, columns, inputColumn, false);
  if (!got) return got.error();
  return GainRatios{got->value[0], got->value[1], got->value[2], hangs ? got->value[3] : 0.0};
}

}  // namespace

std::optional<AssumedResistance> assumedResistance(const Bench& bench, const std::vector<Track>& tracks) {
  const Model model = believedDrive(bench);
  const auto ratios = gainRatios(model, tracks);
  const MotorNames& names = motorNames(bench.axis);
  const MotorBelief& belief = bench.motor;
  const double kt = physicsOf(model).torqueConstant;
  if (ratios) {
    if (ratios->gravity > 0.0) return AssumedResistance{kt * ratios->gravity, "pendulum"};
    if (belief.inertia && ratios->inertia > 0.0)
      return AssumedResistance{kt * ratios->inertia / *belief.inertia, names.inertia};
    if (belief.coulomb && *belief.coulomb > 0.0 && ratios->coulomb > 0.0)
      return AssumedResistance{kt * ratios->coulomb / *belief.coulomb, names.coulomb};
  }
  if (belief.inductance_H) return AssumedResistance{*belief.inductance_H / usualWinding_s, names.inductance};
  return std::nullopt;
}

Result<std::vector<Model>> startModels(const Bench& bench, const std::vector<Track>& tracks) {
  const MotorNames& names = motorNames(bench.axis);
  Model model = believedDrive(bench);
  const MotorBelief& belief = bench.motor;
  const auto trusts = [&bench](const char* name) { return bench.trusted.count(name) > 0; };
  const Model believed = model;
  const double hanging = bench.pendulum ? pendulumInertia(*bench.pendulum) : 0.0;
  const auto ratios = gainRatios(model, tracks);
  double gain = physicsOf(model).torquePerInput();
  double inertia = belief.inertia.value_or(0.0), viscous = belief.viscous.value_or(0.0),
         coulomb = belief.coulomb.value_or(0.0);
  if (ratios) {
    if (ratios->gravity > 0.0 && !trusts(names.torqueConstant)) {
      const double factor = std::clamp(1.0 / ratios->gravity / gain, 0.05, 20.0);
      for (Parameter& one : model.base) {
        const bool electrical = one.name == names.torqueConstant || one.name == names.backEmfConstant;
        if (electrical) one = {one.name, one.value * factor, one.value * factor, one.value * factor};
      }
      gain *= factor;
    } else if (trusts(names.inertia) && ratios->inertia > 0.0 && !trusts(names.torqueConstant) &&
               bench.input != DriveInput::torque) {
      const double factor = inertia / ratios->inertia / gain;
      for (Parameter& one : model.base) {
        if (one.name == names.torqueConstant || one.name == names.backEmfConstant) one.value *= factor;
      }
      gain *= factor;
    }
    const double emf = physicsOf(model).electrical ? physicsOf(model).backEmf * gain : 0.0;
    const double foundInertia = ratios->inertia * gain - (physicsOf(model).gravity > 0.0 ? 0.0 : hanging);
    if (!trusts(names.inertia) && foundInertia > 0.0) inertia = foundInertia;
    if (!trusts(names.viscous)) viscous = std::max(0.0, ratios->viscous * gain - emf);
    if (!trusts(names.coulomb)) coulomb = std::max(0.0, ratios->coulomb * gain);
  }
  if (inertia <= 0.0) {
    if (!ratios) return ratios.error();
    return Error{tracks.front().name, "doesn't show the inertia, and the bench doesn't say it"};
  }
  const auto finish = [&names](Model start, double j, double b, double f) {
    start.base.push_back({names.inertia, j, j, j});
    start.base.push_back({names.viscous, b, b, b});
    start.base.push_back({names.coulomb, f, f, f});
    return start;
  };
  std::vector<Model> starts{finish(model, inertia, viscous, coulomb)};
  if (belief.inertia) {
    starts.push_back(
        finish(believed, *belief.inertia, belief.viscous.value_or(0.1 * viscous), belief.coulomb.value_or(coulomb)));
  }
  return starts;
}

Excitation excitationOf(const std::vector<Track>& tracks, const Model& model) {
  Excitation seen;
  seen.axis = model.axis;
  seen.count = model.count;
  const Physics physics = physicsOf(model);
  seen.inertia = physics.inertia;
  seen.coulomb = physics.coulomb;
  seen.electrical = physics.electrical;
  seen.currentDrive = model.input == DriveInput::current;
  seen.currentSeen = physics.electrical && std::all_of(tracks.begin(), tracks.end(),
                                                       [](const Track& track) { return !track.current.empty(); });
  seen.supply_V = tracks.front().supplyAt(0);
  seen.supplySeen = model.supply_V.value_or(0.0) > 0.0 || !tracks.front().supply.empty();
  seen.step_s = tracks.front().time.back() / static_cast<double>(tracks.front().rows() - 1);
  std::vector<double> speeds, torques, currents, accelerations;
  double forwards = 0.0, heat = 0.0, rows = 0.0;  // heat: A²
  seen.lowest = 1e300;
  seen.highest = -1e300;
  for (const Track& track : tracks) {
    const Motion motion = track.motion.velocity.empty() ? motionOf(track) : track.motion;
    seen.duration_s = std::max(seen.duration_s, track.time.back());
    for (size_t k = 0; k < track.rows(); ++k) {
      if (!track.connected[k]) continue;
      seen.lowest = std::min(seen.lowest, track.position[k]);
      seen.highest = std::max(seen.highest, track.position[k]);
      seen.peakInput = std::max(seen.peakInput, std::abs(track.input[k]));
      seen.longestRest_s = std::max(seen.longestRest_s, motion.resting[k] ? motion.rest_s[k] : 0.0);
      if (k > 0 && motion.resting[k - 1] && !motion.resting[k]) ++seen.starts;
      if (k > 0 && motion.way[k] * motion.way[k - 1] < 0.0) ++seen.reversals;
      const double drive = physics.electrical
                               ? (track.input[k] - physics.backEmf * motion.velocity[k]) / physics.resistance
                               : track.input[k];
      heat += drive * drive;
      rows += 1.0;
      if (motion.resting[k] || std::abs(motion.velocity[k]) < 4.0 * motion.velocityNoise) continue;
      speeds.push_back(std::abs(motion.velocity[k]));
      accelerations.push_back(std::abs(motion.acceleration[k]));
      forwards += motion.velocity[k] > 0.0 ? 1.0 : 0.0;
      torques.push_back(std::abs(physics.torqueConstant * drive));
      currents.push_back(model.input == DriveInput::torque ? 0.0 : std::abs(drive));
    }
  }
  seen.travel = std::max(0.0, seen.highest - seen.lowest);
  if (speeds.empty()) return seen;
  const double part = forwards / static_cast<double>(speeds.size());
  seen.bothWays = part > 0.1 && part < 0.9;
  seen.lowSpeed = quantile(speeds, 0.1);
  seen.highSpeed = quantile(speeds, 0.95);
  seen.peakTorque = quantile(torques, 0.99);
  seen.knownLoad = std::abs(physics.gravity);
  seen.peakCurrent = quantile(currents, 0.99);
  seen.usualCurrent = model.input == DriveInput::torque ? 0.0 : std::sqrt(heat / rows);
  seen.peakAcceleration = quantile(accelerations, 0.99);
  return seen;
}

}  // namespace breakaway
