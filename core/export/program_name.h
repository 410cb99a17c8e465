// What a model's program may be called in its language.
#pragma once

#include <optional>
#include <string>

#include "diagnose/model/model.h"

namespace breakaway {

/// Why the program of `model` as c, python, matlab or modelica can't be called so, or nothing: no identifier, a word
/// that the language keeps for itself (MATLAB, iskeyword; Modelica Language Specification 3.6, 2.3.3), or a name within
/// it: of a function, of which MATLAB would make a constructor, of a constant or a variable. Joints may have any
/// identifier. Precondition: termsOf(model) succeeds.
std::optional<std::string> nameFault(const Model& model, const std::string& form, const std::string& name);
/// The same of what has no names of its own that could be in the way, such as a friction map's tables.
std::optional<std::string> nameFault(const std::string& form, const std::string& name);

}  // namespace breakaway
