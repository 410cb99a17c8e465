#include "export/joint_forms.h"

#include <fmt/core.h>
#include <cmath>

#include "diagnose/simulate/physics.h"
#include "diagnose/simulate/simulation.h"
#include "export/comment.h"

namespace breakaway {

namespace {

constexpr double window_s = 0.5;  ///< over which errors are taken, as a diagnosis does

JointAbility abilityOf(const std::string& form) {
  if (form == "mjcf")
    return {.constantLoad = true, .stop = true, .inputLimit = true, .springLoad = true, .weight = true};
  if (form == "sdf") return {.stop = true, .inputLimit = true, .springLoad = true, .weight = true};
  if (form == "urdf") return {.stop = true, .inputLimit = true, .weight = true};
  return {.breakaway = true, .inputLimit = true};
}

/// Windowed root mean square error of a model on a recording's measured channel.
Result<double> errorOf(const Model& model, const Recording& recording) {
  const auto trace = simulate(model, recording, {window_s});
  if (!trace) return trace.error();
  Bench names;
  names.axis = model.axis;
  const bool placed = recording.has(names.positionChannel());
  const auto measured = recording.channel(placed ? names.positionChannel() : names.velocityChannel());
  const std::vector<double>& simulated = placed ? trace->position : trace->velocity;
  double squares = 0.0, seen = 0.0;
  for (size_t k = 0; k < simulated.size() && k < measured.size(); ++k) {
    if (!std::isfinite(measured[k])) continue;
    squares += (simulated[k] - measured[k]) * (simulated[k] - measured[k]);
    seen += 1.0;
  }
  return std::sqrt(squares / std::max(seen, 1.0));
}

Result<std::string> errorText(const Model& model, const Joint& joint, const Recording& recording) {
  const auto all = errorOf(model, recording), held = errorOf(joint.held, recording);
  if (!all) return all.error();
  if (!held) return held.error();
  Bench names;
  names.axis = model.axis;
  const bool placed = recording.has(names.positionChannel());
  const char* unit = model.axis == Axis::rotary ? (placed ? "rad" : "rad/s") : (placed ? "m" : "m/s");
  return fmt::format(
      "On {}, in windows of {} s, the model's error is {:.3g} {} rms; of this joint's it is {:.3g} {}, "
      "{:.3g} times that.",
      commentable(recording.name()), window_s, *all, unit, *held, unit, *held / std::max(*all, 1e-300));
}

}  // namespace

HangingBody hangingBody(const Pendulum& pendulum) {
  const double mass = pendulum.mass_kg + pendulum.armMass_kg;
  const double depth =
      mass > 0.0 ? (pendulum.mass_kg + 0.5 * pendulum.armMass_kg) * pendulum.length_m / mass : pendulum.length_m;
  return {mass, depth, std::max(pendulumInertia(pendulum) - mass * depth * depth, 0.0)};
}

std::string xmlComment(const std::vector<std::string>& lines, const std::string& indent) {
  std::string out = indent + "<!--\n";
  for (const std::string& line : lines) out += indent + "  " + commentable(line) + "\n";
  return out + indent + "-->\n";
}

Result<ModelExport> jointText(const Model& model, const std::string& form, const std::vector<std::string>& head,
                              const ModelExportOptions& options) {
  const auto joint = jointOf(model, abilityOf(form));
  if (!joint) return joint.error();
  ModelExport out;
  for (const LeftOut& one : joint->leftOut)
    out.notes.push_back((one.partly ? "Lost of " : "Lost: ") + one.what + ": " + one.why + ".");
  if (options.recording != nullptr) {
    auto said = errorText(model, *joint, *options.recording);
    if (!said) return said.error();
    out.notes.push_back(std::move(*said));
  }
  std::vector<std::string> comment = head;
  if (joint->leftOut.empty()) comment.emplace_back("The joint holds all of the model.");
  comment.insert(comment.end(), out.notes.begin(), out.notes.end());
  out.text = form == "mjcf"   ? mjcfText(*joint, options.name, comment)
             : form == "urdf" ? urdfText(*joint, options.name, comment)
             : form == "sdf"  ? sdfText(*joint, options.name, comment)
                              : isaacLabText(*joint, options.name, comment);
  return out;
}

}  // namespace breakaway
