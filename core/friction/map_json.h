// The map as `breakaway.map/1`.
#pragma once

#include <string>

#include "friction/friction_map.h"

namespace breakaway {

std::string mapJsonText(const FrictionMap& map);

}  // namespace breakaway
