#include <algorithm>

#include "base/exact_text.h"
#include "export/joint_forms.h"

namespace breakaway {

namespace {

constexpr double noStop = 1e6;       ///< rad or m, where no stop was seen
constexpr double nearlyNone = 1e-9;  ///< of the armature: MuJoCo wants every body to have some mass of its own
constexpr double leastMass = 1e-12;
/// Time constant in s and damping ratio with which friction holds: as hard as the time step lets it, for MuJoCo takes
/// two time steps in place of what is shorter. Its own, 0.02 s, gives way.
constexpr const char* hardFriction = "0.0002 1";

std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + value + "\"";
}
std::string attribute(const char* name, double value) {
  return attribute(name, exactText(value));
}
std::string triple(double a, double b, double c) {
  return exactText(a) + " " + exactText(b) + " " + exactText(c);
}

std::string inertialText(double mass, const std::string& place, double inertia) {
  return "<inertial" + attribute("pos", place) + attribute("mass", mass) +
         attribute("diaginertia", triple(inertia, inertia, inertia)) + "/>\n";
}

/// The link that the armature turns: the pendulum, or hardly anything.
std::string ownInertial(const Joint& joint) {
  const double little = std::max(nearlyNone * joint.inertia, leastMass);
  if (!joint.pendulum) return inertialText(little, "0 0 0", little);
  const HangingBody body = hangingBody(*joint.pendulum);
  return inertialText(std::max(body.mass_kg, leastMass), triple(0.0, 0.0, -body.depth_m),
                      std::max(body.inertia_kg_m2, leastMass));
}

std::string loadText(const Joint& joint, const std::string& name, const std::string& kind) {
  const TwoMass& load = *joint.springLoad;
  const double damping = 2.0 * load.dampingRatio * load.frequency * load.inertia;
  return "      <body" + attribute("name", name + "_load") + ">\n        <joint" + attribute("name", name + "_spring") +
         kind + attribute("stiffness", load.stiffness()) + attribute("springref", 0.0) + attribute("damping", damping) +
         "/>\n        " + inertialText(load.inertia, "0 0 0", load.inertia) + "      </body>\n";
}

/// What turns the control into torque.
std::string actuatorText(const Joint& joint, const std::string& name) {
  const std::string of = attribute("name", name) + attribute("joint", name);
  if (joint.law) {
    std::string text = "    <position" + of + attribute("kp", joint.law->kp) + attribute("kv", joint.law->kd);
    if (joint.law->limit)
      text += attribute("forcelimited", "true") +
              attribute("forcerange", exactText(-*joint.law->limit) + " " + exactText(*joint.law->limit));
    return text + "/> <!-- control: the reference -->\n";
  }
  const bool duty = joint.input == DriveInput::duty && joint.supply_V.has_value();
  const double unit = duty ? *joint.supply_V : 1.0;
  std::string limits;
  if (joint.inputLimit) {
    const double most = *joint.inputLimit / unit;
    limits = attribute("ctrllimited", "true") + attribute("ctrlrange", exactText(-most) + " " + exactText(most));
  }
  const char* control = joint.input == DriveInput::torque    ? "torque or force"
                        : joint.input == DriveInput::current ? "current in A"
                        : duty                               ? "duty"
                                                             : "voltage in V";
  if (joint.backEmfDamping == 0.0)
    return "    <motor" + of + attribute("gear", joint.torquePerInput) + limits + "/> <!-- control: " + control +
           " -->\n";
  return "    <general" + of + attribute("gaintype", "fixed") + attribute("gainprm", joint.torquePerInput * unit) +
         attribute("biastype", "affine") + attribute("biasprm", triple(0.0, 0.0, -joint.backEmfDamping)) + limits +
         "/> <!-- control: " + control + "; the bias is the back-EMF -->\n";
}

}  // namespace

std::string mjcfText(const Joint& joint, const std::string& name, const std::vector<std::string>& comment) {
  const bool rotary = joint.axis == Axis::rotary;
  const std::string kind =
      attribute("type", rotary ? "hinge" : "slide") + attribute("axis", rotary ? "0 1 0" : "1 0 0");
  std::string text = "<mujoco" + attribute("model", name) + ">\n" + xmlComment(comment, "  ");
  text += "  <compiler angle=\"radian\"/>\n  <option timestep=\"0.001\" gravity=\"0 0 -9.81\"/>\n  <worldbody>\n";
  text += "    <body" + attribute("name", name) + ">\n      <joint" + attribute("name", name) + kind +
          attribute("armature", joint.inertia) +
          attribute("damping", joint.viscous + (joint.law ? joint.backEmfDamping : 0.0)) +
          attribute("frictionloss", joint.coulomb) + attribute("solreffriction", hardFriction);
  if (joint.pendulum) text += attribute("ref", joint.pendulum->downAngle_rad);
  if (joint.lower || joint.upper)
    text += attribute("limited", "true") + attribute("range", exactText(joint.lower.value_or(-noStop)) + " " +
                                                                  exactText(joint.upper.value_or(noStop)));
  text += "/>\n      " + ownInertial(joint);
  if (joint.springLoad) text += loadText(joint, name, kind);
  text += "    </body>\n  </worldbody>\n  <actuator>\n" + actuatorText(joint, name);
  if (joint.constantLoad != 0.0)
    text += "    <general" + attribute("name", name + "_constant_load") + attribute("joint", name) +
            attribute("gainprm", 0.0) + attribute("biastype", "affine") +
            attribute("biasprm", triple(-joint.constantLoad, 0.0, 0.0)) + "/> <!-- no control: it always pushes -->\n";
  return text + "  </actuator>\n</mujoco>\n";
}

}  // namespace breakaway
