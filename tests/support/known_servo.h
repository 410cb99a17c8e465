// A servo whose numbers are known: as physics for the stepper, as a model, and with any effect of the catalogue.
#pragma once

#include <cassert>
#include <string>
#include <vector>

#include "diagnose/effects/catalogue.h"
#include "diagnose/model/model.h"
#include "diagnose/simulate/stepper.h"

namespace breakaway::test {

inline Physics torqueDriven() {
  Physics p;
  p.inertia = 6e-5;
  p.viscous = 2e-4;
  p.coulomb = 0.012;
  return p;
}

inline Physics voltageDriven() {
  Physics p = torqueDriven();
  p.electrical = true;
  p.torqueConstant = p.backEmf = 0.07;
  p.resistance = 1.2;
  p.inductance = 0.0011;
  return p;
}

inline CompiledTerm compiled(const char* effect, std::vector<double> parameters) {
  return {findEffect(effect), std::move(parameters)};
}

/// A parameter known to 10 %.
inline Parameter known(const std::string& name, double value) {
  return {name, value, 0.9 * value, 1.1 * value};
}

/// The same servo as a model; a current drive knows the torque constant, a torque drive needs none.
inline Model servoModel(DriveInput input) {
  const Physics p = voltageDriven();
  Model model;
  model.input = input;
  if (input != DriveInput::torque) model.base.push_back(known("torque_constant_Nm_per_A", p.torqueConstant));
  if (input == DriveInput::voltage || input == DriveInput::duty) {
    model.base.push_back(known("back_emf_constant_V_s_per_rad", p.backEmf));
    model.base.push_back(known("resistance_ohm", p.resistance));
    model.base.push_back(known("inductance_H", p.inductance));
  }
  model.base.push_back(known("inertia_kg_m2", p.inertia));
  model.base.push_back(known("viscous_Nm_s_per_rad", p.viscous));
  model.base.push_back(known("coulomb_Nm", p.coulomb));
  return model;
}

/// An effect with values in the catalogue's order.
inline EffectTerm effectTerm(const Effect& effect, const std::vector<double>& values, Axis axis = Axis::rotary) {
  const auto specs = effect.parameters(axis);
  assert(specs.size() == values.size());
  EffectTerm term{std::string(effect.name()), {}};
  for (size_t k = 0; k < specs.size(); ++k) term.parameters.push_back(known(specs[k].name, values.at(k)));
  return term;
}

inline Model servoWith(DriveInput input, const char* effect, const std::vector<double>& values) {
  Model model = servoModel(input);
  model.effects = {effectTerm(*findEffect(effect), values)};
  return model;
}

}  // namespace breakaway::test
