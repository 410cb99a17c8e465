// Joints of robot simulators: MJCF (MuJoCo), URDF, SDF (Gazebo), and an actuator's configuration for Isaac Lab.
#pragma once

#include <string>
#include <vector>

#include "export/joint.h"
#include "export/model_export.h"

namespace breakaway {

/// The model as `form`: mjcf, urdf, sdf or isaaclab. `head` goes into its first comment. Errors: jointOf()'s.
Result<ModelExport> jointText(const Model& model, const std::string& form, const std::vector<std::string>& head,
                              const ModelExportOptions& options);

// The forms themselves; `comment` stands at the top.

std::string mjcfText(const Joint& joint, const std::string& name, const std::vector<std::string>& comment);
std::string urdfText(const Joint& joint, const std::string& name, const std::vector<std::string>& comment);
std::string sdfText(const Joint& joint, const std::string& name, const std::vector<std::string>& comment);
std::string isaacLabText(const Joint& joint, const std::string& name, const std::vector<std::string>& comment);

/// Mass, centre of mass below the axis and inertia around it of a pendulum with its arm, a uniform rod.
struct HangingBody {
  double mass_kg = 0.0, depth_m = 0.0, inertia_kg_m2 = 0.0;
};
HangingBody hangingBody(const Pendulum& pendulum);

/// An XML comment of these lines.
std::string xmlComment(const std::vector<std::string>& lines, const std::string& indent);

}  // namespace breakaway
