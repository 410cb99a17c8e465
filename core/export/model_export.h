// A fitted model in the forms of other programs (resources/help/commands.md, export).
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "diagnose/model/model.h"
#include "export/model_program.h"
#include "recording/recording.h"

namespace breakaway {

/// What an export made.
struct ModelExport {
  std::string text;                ///< the file
  std::vector<std::string> notes;  ///< what the form can't hold, line by line; the file says the same in a comment
};

struct ModelExportOptions {
  std::string model;                     ///< where the model was read from, for the comment
  std::string name = "breakaway";        ///< of prefix, class, package or joint
  const Recording* recording = nullptr;  ///< on which a joint's form is held against the model, see errorComesBack()
};

/// The forms: mjcf, isaaclab, urdf, sdf, c, python, modelica, matlab.
const std::vector<std::string>& modelForms();

/// The model as `form`. Errors: what the form needs and the model lacks, by field; a number that isn't finite.
/// Precondition: one of modelForms(), termsOf(model) succeeds.
Result<ModelExport> exportModel(const Model& model, const std::string& form, const ModelExportOptions& options);

}  // namespace breakaway
