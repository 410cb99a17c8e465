// Whether a friction map can be one: what doesn't repeat, or contradicts itself, isn't.
#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "friction/friction_map.h"

namespace breakaway {

/// Why it isn't, each a part of a sentence with its figures; empty for a sound map. Breakaway below Coulomb friction on
/// average, by more than a tenth and its doubt; turns that correlate by less than a half where the torque varies by
/// more than a tenth; more than a fifth of a way's bins without a breakaway as near as `reach` bins: a coarse encoder
/// doesn't let a rotor be held nearer.
std::vector<Message> unsoundness(const FrictionMap& map, size_t reach = 0);

}  // namespace breakaway
