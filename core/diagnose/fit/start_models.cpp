#include "diagnose/fit/start_models.h"

#include <algorithm>
#include <cmath>

#include "diagnose/fit/inverse_regression.h"
#include "diagnose/simulate/physics.h"

namespace breakaway {

namespace {

constexpr double usualWinding_s = 1e-3;  ///< a winding's time constant

}  // namespace

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
  if (bench.servo) {
    model.servo = ServoLaw{.rate_Hz = bench.servo->rate_Hz};
    const ServoNames& law = servoNames(bench.input, bench.axis);
    add(law.kp, bench.servo->kp.value_or(1.0));
    add(law.kd, bench.servo->kd.value_or(0.0));
    if (bench.servo->limit) add(law.limit, *bench.servo->limit);
    add(servoDelayName, bench.servo->delay_s.value_or(0.0));
  }
  return model;
}

namespace {

/// input = a·(J/k) + ω·(B/k) + s·(F/k) + gravity/k (+ Ke ω): ratios to the drive's gain k, Kt or Kt/R, come out
/// linearly.
struct GainRatios {
  double inertia = 0.0, viscous = 0.0, coulomb = 0.0;
  double gravity = 0.0;       ///< 1/k; 0 without a pendulum
  double inertiaError = 0.0;  ///< standard error
};

Result<GainRatios> gainRatios(const Model& model, const std::vector<Track>& tracks) {
  std::vector<Column> columns{accelerationColumn, velocityColumn, directionColumn};
  const bool hangs = physicsOf(model).gravity > 0.0;
  if (hangs) {
    columns.push_back(knownLoadColumn(model));
  }
  columns.push_back([](const InverseRows&, size_t) { return 1.0; });  // a constant load must not bend the others
  const auto got = regress(
      tracks, columns, [](const InverseRows& rows, size_t k) { return rows.input[k]; }, false);
  if (!got) return got.error();
  return GainRatios{got->value[0], got->value[1], got->value[2], hangs ? got->value[3] : 0.0,
                    std::sqrt(got->covariance(0, 0))};
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
  constexpr double errors95 = 1.96;
  const MotorNames& names = motorNames(bench.axis);
  Model model = believedDrive(bench);
  const MotorBelief& belief = bench.motor;
  const auto trusts = [&bench](const char* name) { return bench.trusted.count(name) > 0; };
  const Model believed = model;
  const double hanging = bench.pendulum ? pendulumInertia(*bench.pendulum) : 0.0;
  const auto ratios = gainRatios(model, tracks);
  double gain = physicsOf(model).torquePerInput();
  double inertiaError = 0.0;
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
    if (!trusts(names.inertia) && foundInertia > 0.0) {
      inertia = foundInertia;
      inertiaError = ratios->inertiaError * gain;
    }
    if (!trusts(names.viscous)) viscous = std::max(0.0, ratios->viscous * gain - emf);
    if (!trusts(names.coulomb)) coulomb = std::max(0.0, ratios->coulomb * gain);
  }
  if (inertia <= 0.0) {
    if (!ratios) return ratios.error();
    return Error{tracks.front().name, "doesn't show the inertia, and the bench doesn't say it"};
  }
  const auto finish = [&names](Model start, double j, double b, double f, double error = 0.0) {
    start.base.push_back({names.inertia, j, j - errors95 * error, j + errors95 * error});
    start.base.push_back({names.viscous, b, b, b});
    start.base.push_back({names.coulomb, f, f, f});
    return start;
  };
  std::vector<Model> starts{finish(model, inertia, viscous, coulomb, inertiaError)};
  if (belief.inertia) {
    starts.push_back(
        finish(believed, *belief.inertia, belief.viscous.value_or(0.1 * viscous), belief.coulomb.value_or(coulomb)));
  }
  return starts;
}

}  // namespace breakaway
