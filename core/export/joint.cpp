#include "export/joint.h"

#include <fmt/core.h>
#include <algorithm>

#include "diagnose/effects/catalogue.h"
#include "diagnose/simulate/physics.h"

namespace breakaway {

namespace {

void addStop(Joint& joint, const JointShare::Stop& stop) {
  std::optional<double>& end = stop.side > 0.0 ? joint.upper : joint.lower;
  const bool nearer = !end || (stop.side > 0.0 ? stop.place < *end : stop.place > *end);
  if (nearer) end = stop.place;
}

/// Whether the joint takes all of it that joints hold at all.
bool take(Joint& joint, const JointShare& share, const JointAbility& can, bool inputActs) {
  if (share.stop && can.stop) addStop(joint, *share.stop);
  if (share.breakaway > 0.0 && can.breakaway) joint.breakaway += share.breakaway;
  if (can.constantLoad) {
    joint.constantLoad += share.constantLoad;
    if (inputActs) joint.constantLoad += share.inputOffset * joint.torquePerInput;
  }
  if (share.inputLimit && can.inputLimit && inputActs) joint.inputLimit = share.inputLimit;
  return (!share.stop || can.stop) && (share.breakaway == 0.0 || can.breakaway) &&
         (share.constantLoad == 0.0 || can.constantLoad) && (share.inputOffset == 0.0 || can.constantLoad) &&
         (!share.inputLimit || can.inputLimit);
}

/// A load on a spring that a second joint holds; one alone.
bool takeLoad(Joint& joint, const TwoMass& load, const JointAbility& can) {
  if (!can.springLoad || joint.springLoad || load.halfGap > 0.0 || load.friction > 0.0) return false;
  joint.springLoad = load;
  joint.inertia -= load.inertia;
  return true;
}

void addEffect(Joint& joint, const EffectTerm& term, const JointAbility& can) {
  const Effect& effect = *findEffect(term.effect);
  const std::vector<double> p = valuesOf(term);
  if (const LoadPart* load = effect.load()) {
    if (takeLoad(joint, load->loadOf(p), can))
      joint.held.effects.push_back(term);
    else
      joint.leftOut.push_back({inWords(term), "a joint has one inertia; the load's is in it all the same"});
    return;
  }
  const bool inputActs = effect.input(joint.input) != nullptr && !joint.law;
  const auto share = effect.joint(p);
  const bool held = share && take(joint, *share, can, inputActs);
  if (held && share->breakaway == 0.0) joint.held.effects.push_back(term);
  if (!held)
    joint.leftOut.push_back({inWords(term), "this joint has no place for it"});
  else if (!share->rest.empty())
    joint.leftOut.push_back({inWords(term), share->rest, true});
}

Result<Joint::Law> lawOf(const Model& model, const Joint& joint) {
  const ServoNames& names = servoNames(model.input, model.axis);
  double unit = joint.torquePerInput;
  if (model.input == DriveInput::duty) {
    if (!model.supply_V) return Error{"field supply_V", "is missing, expected the supply that the law's duty is of"};
    unit *= *model.supply_V;
  }
  Joint::Law law{model.baseValue(names.kp).value_or(0.0) * unit, model.baseValue(names.kd).value_or(0.0) * unit};
  if (const auto limit = model.baseValue(names.limit); limit && *limit > 0.0) law.limit = *limit * unit;
  return law;
}

}  // namespace

Result<Joint> jointOf(const Model& model, const JointAbility& ability) {
  const Physics physics = physicsOf(model);
  Joint joint;
  joint.axis = model.axis;
  joint.input = model.input;
  joint.viscous = physics.viscous;
  joint.coulomb = physics.coulomb;
  joint.inertia = physics.inertia;
  joint.torquePerInput = physics.torquePerInput();
  joint.supply_V = model.supply_V;
  joint.held = model;
  joint.held.effects.clear();
  if (physics.electrical) joint.backEmfDamping = physics.torquePerInput() * physics.backEmf;
  if (model.pendulum) {
    joint.inertia -= pendulumInertia(*model.pendulum);
    joint.pendulum = model.pendulum;
    joint.pendulum->downAngle_rad = physics.downAngle;
    if (!ability.weight)
      joint.leftOut.push_back(
          {"the pendulum (" + fmt::format("{:.4g} kg at {:.4g} m", model.pendulum->mass_kg, model.pendulum->length_m) +
               ")",
           "give the asset's link its mass"});
  }
  if (model.servo) {
    const auto law = lawOf(model, joint);
    if (!law) return law.error();
    joint.law = *law;
    const double late_s = model.baseValue(servoDelayName).value_or(0.0);
    if (late_s > 0.0)
      joint.leftOut.push_back(
          {fmt::format("the law's delay ({} {:.4g})", servoDelayName, late_s), "it acts at once here"});
  }
  if (physics.electrical && physics.inductance > 0.0) {
    joint.leftOut.push_back({fmt::format("the winding's lag (inductance_H {:.4g}, L/R {:.3g} s)", physics.inductance,
                                         physics.inductance / physics.resistance),
                             "the current follows at once here"});
    for (Parameter& one : joint.held.base) {
      if (one.name == motorNames(model.axis).inductance) one.value = 0.0;
    }
  }
  for (const EffectTerm& term : model.effects) addEffect(joint, term, ability);
  joint.inertia = std::max(joint.inertia, 0.0);
  return joint;
}

}  // namespace breakaway
