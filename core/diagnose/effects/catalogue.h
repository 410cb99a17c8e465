// The catalogue of effects: to add physics is to add one file and one line in catalogue.cpp.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "diagnose/model/effect.h"
#include "diagnose/model/model.h"

namespace breakaway {

/// All effects, in the order of preference among equals.
std::span<const Effect* const> catalogue();

/// The effect of that name, or nullptr.
const Effect* findEffect(std::string_view name);

/// What counts as one and the same name: an effect and its inseparable twin have one.
std::string countedAs(const std::string& effect);

/// What people and files are shown: without parameters that are absent at zero and are zero.
std::vector<Parameter> presentParameters(const EffectTerm& term, Axis axis);

}  // namespace breakaway
