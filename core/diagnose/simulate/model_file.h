// A model as a file, `breakaway.model/1`.
#pragma once

#include <string>

#include "base/result.h"
#include "diagnose/model/model.h"

namespace breakaway {

/// Errors name the field, or the effect and what it lacks.
Result<Model> readModel(const std::string& path);
/// What writeModel() writes, but for where it comes from (base/made.h).
std::string modelText(const Model& model);
Result<void> writeModel(const Model& model, const std::string& path);

}  // namespace breakaway
