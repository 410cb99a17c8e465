#include <cmath>

#include "base/exact_text.h"
#include "export/joint_forms.h"

namespace breakaway {

namespace {

constexpr double notKnown = 1e6;  ///< where the format wants a limit and nobody knows one

std::string number(double value) {
  return "\"" + exactText(value) + "\"";
}

/// The link with its mass where it is at angle 0.
std::string linkText(const Joint& joint, const std::string& name) {
  const bool rotary = joint.axis == Axis::rotary;
  double mass = rotary ? 1.0 : joint.inertia, inertia = rotary ? joint.inertia : 1.0, x = 0.0, z = 0.0;
  if (joint.pendulum) {
    const HangingBody body = hangingBody(*joint.pendulum);
    mass = body.mass_kg;
    inertia += body.inertia_kg_m2;
    x = body.depth_m * std::sin(joint.pendulum->downAngle_rad);
    z = -body.depth_m * std::cos(joint.pendulum->downAngle_rad);
  }
  const std::string i = number(inertia);
  return "  <link name=\"" + name + "\">\n    <inertial>\n      <origin xyz=\"" + exactText(x) + " 0 " + exactText(z) +
         "\"/>\n      <mass value=" + number(mass) + "/>\n      <inertia ixx=" + i + " ixy=\"0\" ixz=\"0\" iyy=" + i +
         " iyz=\"0\" izz=" + i + "/>\n    </inertial>\n  </link>\n";
}

double effortOf(const Joint& joint) {
  if (joint.law) return joint.law->limit.value_or(notKnown);
  return joint.inputLimit ? *joint.inputLimit * joint.torquePerInput : notKnown;
}

}  // namespace

std::string urdfText(const Joint& joint, const std::string& name, const std::vector<std::string>& comment) {
  const bool rotary = joint.axis == Axis::rotary, stopped = joint.lower || joint.upper;
  std::vector<std::string> lines = comment;
  lines.emplace_back(rotary ? "The link's inertia is the rotor's with all that turns with it: a joint has no armature."
                            : "The link's mass is all that slides: a joint has no armature.");
  if (rotary && !joint.pendulum)
    lines.emplace_back("Its mass of 1 kg stands for one that nobody measured; on the axis it does nothing.");
  if (joint.backEmfDamping > 0.0)
    lines.push_back("A voltage u gives the effort " + exactText(joint.torquePerInput) + " u - " +
                    exactText(joint.backEmfDamping) + " velocity.");
  else if (joint.input == DriveInput::current)
    lines.push_back("A current i gives the effort " + exactText(joint.torquePerInput) + " i.");
  lines.push_back("Limits of " + exactText(notKnown) + " are not known.");
  const char* kind = !rotary ? "prismatic" : stopped ? "revolute" : "continuous";
  std::string text = "<?xml version=\"1.0\"?>\n<robot name=\"" + name + "\">\n" + xmlComment(lines, "  ");
  text += "  <link name=\"world\"/>\n" + linkText(joint, name) + "  <joint name=\"" + name + "_joint\" type=\"" + kind +
          "\">\n    <parent link=\"world\"/>\n    <child link=\"" + name + "\"/>\n    <axis xyz=\"" +
          (rotary ? "0 1 0" : "1 0 0") + "\"/>\n    <dynamics damping=" + number(joint.viscous) +
          " friction=" + number(joint.coulomb) + "/>\n    <limit";
  if (!rotary || stopped)
    text += " lower=" + number(joint.lower.value_or(-notKnown)) + " upper=" + number(joint.upper.value_or(notKnown));
  return text + " effort=" + number(effortOf(joint)) + " velocity=" + number(notKnown) + "/>\n  </joint>\n</robot>\n";
}

}  // namespace breakaway
