#include "export/model_export.h"

#include <algorithm>
#include <cmath>

#include "base/made.h"
#include "diagnose/effects/all.h"
#include "export/comment.h"
#include "export/joint_forms.h"
#include "export/portable/print.h"

namespace breakaway {

namespace {

std::string axisWord(const Model& model) {
  return model.axis == Axis::rotary ? "rotary axis" : "linear axis";
}

/// The first lines of every form.
std::vector<std::string> headOf(const Model& model, const ModelExportOptions& options) {
  return {"The fitted model of a " + axisWord(model) + ", from " + commentable(options.model) + ", by " + thisRun().by +
              ".",
          "SI units. Angle and position grow counter-clockwise or forwards."};
}

Result<void> finite(const Model& model) {
  const auto fault = [](const std::vector<Parameter>& parameters) -> std::string {
    for (const Parameter& one : parameters) {
      if (!std::isfinite(one.value)) return one.name;
    }
    return {};
  };
  if (const auto name = fault(model.base); !name.empty()) return Error{"field base." + name, "is not finite"};
  for (const EffectTerm& term : model.effects) {
    if (const auto name = fault(term.parameters); !name.empty())
      return Error{"effect " + term.effect + ", " + name, "is not finite"};
  }
  return {};
}

/// With the bias as the constant load that it is: one form in place of two.
Model withBiasAsLoad(Model model) {
  const auto bias = std::find_if(model.base.begin(), model.base.end(),
                                 [&](const Parameter& one) { return one.name == biasName(model.axis); });
  if (bias == model.base.end()) return model;
  Parameter load = *bias;
  model.base.erase(bias);
  if (load.value == 0.0) return model;
  load.name = constantLoad().parameters(model.axis).front().name;
  model.effects.push_back({std::string(constantLoad().name()), {std::move(load)}});
  return model;
}

ModelExport programText(const Model& model, const std::string& form, const ModelExportOptions& options) {
  std::vector<LeftOut> leftOut;
  Program program = programOf(model, leftOut);
  program.name = options.name;
  program.head = headOf(model, options);
  ModelExport out;
  for (const LeftOut& one : leftOut) out.notes.push_back("Left out: " + one.what + ": " + one.why + ".");
  if (out.notes.empty())
    program.head.emplace_back("All of the model's effects are in it.");
  else
    program.head.insert(program.head.end(), out.notes.begin(), out.notes.end());
  out.text = form == "c"        ? cText(program)
             : form == "python" ? pythonText(program)
             : form == "matlab" ? matlabText(program)
                                : modelicaText(program);
  return out;
}

}  // namespace

const std::vector<std::string>& modelForms() {
  static const std::vector<std::string> forms{"mjcf", "isaaclab", "urdf", "sdf", "c", "python", "modelica", "matlab"};
  return forms;
}

Result<ModelExport> exportModel(const Model& fitted, const std::string& form, const ModelExportOptions& options) {
  if (const auto good = finite(fitted); !good) return good.error();
  const Model model = withBiasAsLoad(fitted);
  if (form == "c" || form == "python" || form == "modelica" || form == "matlab")
    return programText(model, form, options);
  return jointText(model, form, headOf(model, options), options);
}

}  // namespace breakaway
