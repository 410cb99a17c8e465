#include "base/exact_text.h"
#include "export/joint_forms.h"

namespace breakaway {

std::string isaacLabText(const Joint& joint, const std::string& name, const std::vector<std::string>& comment) {
  const bool rotary = joint.axis == Axis::rotary;
  const std::string torque = rotary ? "Nm" : "N", perPlace = rotary ? "Nm/rad" : "N/m",
                    perSpeed = rotary ? "Nm s/rad" : "N s/m";
  std::string text;
  for (const std::string& line : comment) text += "# " + line + "\n";
  text +=
      "#\n# Friction has the meanings of Isaac Lab 2.3 and later: efforts in " + torque +
      ", not coefficients. `friction` holds at\n# standstill, `dynamic_friction` while it moves, `viscous_friction` "
      "grows with speed.\n";
  if (!joint.law && joint.backEmfDamping > 0.0)
    text += "# A voltage u gives the effort " + exactText(joint.torquePerInput) + " u - " +
            exactText(joint.backEmfDamping) + " velocity.\n";
  if (!joint.law && joint.input == DriveInput::current)
    text += "# A current i gives the effort " + exactText(joint.torquePerInput) + " i.\n";
  text += "from isaaclab.actuators import ImplicitActuatorCfg\n\n" + name + " = ImplicitActuatorCfg(\n";
  const auto line = [&text](const char* field, double value, const std::string& unit) {
    text += std::string("    ") + field + "=" + exactText(value) + ",  # " + unit + "\n";
  };
  text += "    joint_names_expr=[\"" + name + "\"],\n";
  line("stiffness", joint.law ? joint.law->kp : 0.0, perPlace + (joint.law ? "" : "; efforts are commanded"));
  line("damping", joint.law ? joint.law->kd + joint.backEmfDamping : 0.0,
       perSpeed + (joint.law && joint.backEmfDamping > 0.0 ? ", with the back-EMF's" : ""));
  line("armature", joint.inertia, rotary ? "kg m2" : "kg");
  line("friction", joint.coulomb + joint.breakaway, torque + ", static");
  line("dynamic_friction", joint.coulomb, torque + ", sliding");
  line("viscous_friction", joint.viscous, perSpeed);
  if (joint.law && joint.law->limit) line("effort_limit_sim", *joint.law->limit, torque);
  if (!joint.law && joint.inputLimit) line("effort_limit_sim", *joint.inputLimit * joint.torquePerInput, torque);
  return text + ")\n";
}

}  // namespace breakaway
