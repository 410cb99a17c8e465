#include "diagnose/simulate/physics.h"

#include <filesystem>

#include "diagnose/effects/catalogue.h"

namespace breakaway {

double pendulumInertia(const Pendulum& pendulum) {
  return (pendulum.mass_kg + pendulum.armMass_kg / 3.0) * pendulum.length_m * pendulum.length_m;
}

double pendulumTorque(const Pendulum& pendulum) {
  return (pendulum.mass_kg + 0.5 * pendulum.armMass_kg) * 9.81 * pendulum.length_m;
}

Physics physicsOf(const Model& model) {
  const MotorNames& names = motorNames(model.axis);
  const auto value = [&model](const char* name, double otherwise) { return model.baseValue(name).value_or(otherwise); };
  Physics physics;
  physics.axis = model.axis;
  physics.inertia = value(names.inertia, 1.0);
  physics.viscous = value(names.viscous, 0.0);
  physics.coulomb = value(names.coulomb, 0.0);
  physics.electrical = model.input == DriveInput::voltage || model.input == DriveInput::duty;
  physics.torqueConstant = model.input == DriveInput::torque ? 1.0 : value(names.torqueConstant, 1.0);
  if (physics.electrical) {
    physics.backEmf = value(names.backEmfConstant, physics.torqueConstant);
    physics.resistance = value(names.resistance, 1.0);
    physics.inductance = value(names.inductance, 0.0);
  }
  physics.driveLate_s = model.baseValue(driveLateName);
  physics.load = value(biasName(model.axis), 0.0);
  if (model.pendulum) {
    physics.inertia += pendulumInertia(*model.pendulum);
    physics.gravity = pendulumTorque(*model.pendulum);
    physics.downAngle = value("down_angle_rad", model.pendulum->downAngle_rad);
  }
  return physics;
}

std::string fileNameOf(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

Result<std::vector<CompiledTerm>> termsOf(const Model& model, const std::string& recording) {
  std::vector<CompiledTerm> terms;
  for (const EffectTerm& term : model.effects) {
    const Effect* effect = findEffect(term.effect);
    if (effect == nullptr) return Error{"effect " + term.effect, "is not in the catalogue"};
    CompiledTerm compiled{effect, {}};
    for (const ParameterSpec& spec : effect->parameters(model.axis)) {
      const Parameter* found = nullptr;
      for (const Parameter& one : term.parameters) {
        if (one.name == spec.name) found = &one;
      }
      if (found == nullptr) return Error{"effect " + term.effect, "has no parameter " + spec.name};
      compiled.parameters.push_back(found->value);
    }
    const bool elsewhere = !term.recording.empty() && !recording.empty() && term.recording != fileNameOf(recording);
    if (!elsewhere) terms.push_back(std::move(compiled));
  }
  return terms;
}

}  // namespace breakaway
