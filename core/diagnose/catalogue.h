// The catalogue of effects: to add physics is to add one file and one line in catalogue.cpp.
#pragma once

#include <span>
#include <string_view>

#include "diagnose/effect.h"

namespace breakaway {

/// All effects, in the order of preference among equals.
std::span<const Effect* const> catalogue();

/// The effect of that name, or nullptr.
const Effect* findEffect(std::string_view name);

}  // namespace breakaway
