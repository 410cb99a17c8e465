#include "diagnose/fit/inverse_fit.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "diagnose/effects/catalogue.h"
#include "diagnose/fit/excitation_seen.h"
#include "diagnose/fit/inverse_regression.h"
#include "diagnose/simulate/physics.h"

namespace breakaway {

namespace {

void place(Model& model, const std::string& name, double value, double error) {
  for (Parameter& one : model.base) {
    if (one.name == name) one = {name, value, value - normal95 * error, value + normal95 * error};
  }
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
      at.direction = directionColumn(rows, k);
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
    const double half = normal95 * std::sqrt(std::max(0.0, slope.dot(covariance * slope)));
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
  const Column response = [torque, known = knownLoadColumn(model)](const InverseRows& rows, size_t k) {
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
    const bool linear = effect->isTorqueAlone(model.input);
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

}  // namespace breakaway
