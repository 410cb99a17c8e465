#include <cmath>

#include "base/exact_text.h"
#include "export/joint_forms.h"

namespace breakaway {

namespace {

std::string element(const std::string& name, double value) {
  return "<" + name + ">" + exactText(value) + "</" + name + ">";
}

std::string linkText(const std::string& name, double mass, double inertia, double x, double z) {
  std::string text = "    <link name=\"" + name + "\">\n      <inertial>\n        <pose>" + exactText(x) + " 0 " +
                     exactText(z) + " 0 0 0</pose>\n        " + element("mass", mass) + "\n        <inertia>";
  for (const char* one : {"ixx", "iyy", "izz"}) text += element(one, inertia);
  for (const char* one : {"ixy", "ixz", "iyz"}) text += element(one, 0.0);
  return text + "</inertia>\n      </inertial>\n    </link>\n";
}

std::string ownLink(const Joint& joint, const std::string& name) {
  if (joint.axis == Axis::linear) return linkText(name, joint.inertia, 1.0, 0.0, 0.0);
  if (!joint.pendulum) return linkText(name, 1.0, joint.inertia, 0.0, 0.0);
  const HangingBody body = hangingBody(*joint.pendulum);
  const double down = joint.pendulum->downAngle_rad;
  return linkText(name, body.mass_kg, joint.inertia + body.inertia_kg_m2, body.depth_m * std::sin(down),
                  -body.depth_m * std::cos(down));
}

std::string jointHead(const Joint& joint, const std::string& name, const std::string& parent,
                      const std::string& child) {
  const bool rotary = joint.axis == Axis::rotary;
  return "    <joint name=\"" + name + "\" type=\"" + (rotary ? "revolute" : "prismatic") + "\">\n      <parent>" +
         parent + "</parent>\n      <child>" + child + "</child>\n      <axis>\n        <xyz>" +
         (rotary ? "0 1 0" : "1 0 0") + "</xyz>\n";
}

std::string limitText(const Joint& joint) {
  std::string text;
  if (joint.lower) text += element("lower", *joint.lower);
  if (joint.upper) text += element("upper", *joint.upper);
  if (joint.law && joint.law->limit) text += element("effort", *joint.law->limit);
  if (!joint.law && joint.inputLimit) text += element("effort", *joint.inputLimit * joint.torquePerInput);
  return text.empty() ? text : "        <limit>" + text + "</limit>\n";
}

}  // namespace

std::string sdfText(const Joint& joint, const std::string& name, const std::vector<std::string>& comment) {
  std::vector<std::string> lines = comment;
  if (joint.axis == Axis::rotary && !joint.pendulum)
    lines.emplace_back("The link's mass of 1 kg stands for one that nobody measured; on the axis it does nothing.");
  if (joint.pendulum) lines.emplace_back("Its weight is meant at 9.81 m/s2: set the world's gravity so.");
  if (joint.backEmfDamping > 0.0)
    lines.push_back("A voltage u gives the effort " + exactText(joint.torquePerInput) + " u - " +
                    exactText(joint.backEmfDamping) + " velocity.");
  else if (joint.input == DriveInput::current)
    lines.push_back("A current i gives the effort " + exactText(joint.torquePerInput) + " i.");
  std::string text = "<?xml version=\"1.0\"?>\n<sdf version=\"1.9\">\n" + xmlComment(lines, "  ") + "  <model name=\"" +
                     name + "\">\n" + ownLink(joint, name) + jointHead(joint, name + "_joint", "world", name) +
                     limitText(joint) + "        <dynamics>" + element("damping", joint.viscous) +
                     element("friction", joint.coulomb) + "</dynamics>\n      </axis>\n    </joint>\n";
  if (joint.springLoad) {
    const TwoMass& load = *joint.springLoad;
    const bool rotary = joint.axis == Axis::rotary;
    text += linkText(name + "_load", rotary ? 1.0 : load.inertia, rotary ? load.inertia : 1.0, 0.0, 0.0) +
            jointHead(joint, name + "_spring", name, name + "_load") + "        <dynamics>" +
            element("damping", 2.0 * load.dampingRatio * load.frequency * load.inertia) + element("friction", 0.0) +
            element("spring_reference", 0.0) + element("spring_stiffness", load.stiffness()) +
            "</dynamics>\n      </axis>\n    </joint>\n";
  }
  return text + "  </model>\n</sdf>\n";
}

}  // namespace breakaway
