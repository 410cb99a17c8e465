#include "base/axis.h"

#include <utility>

namespace breakaway {

std::string nameOn(Axis axis, std::string name) {
  if (axis == Axis::rotary) return name;
  // In this order: a longer unit before the one that it holds.
  constexpr std::pair<const char*, const char*> words[] = {{"torque", "force"},    {"inertia_kg_m2", "mass_kg"},
                                                           {"_Nm", "_N"},          {"_per_rad", "_per_m"},
                                                           {"_rad_per", "_m_per"}, {"angle_rad", "position_m"}};
  for (const auto& [rotors, linear] : words) {
    const size_t place = name.find(rotors);
    if (place != std::string::npos) name.replace(place, std::string(rotors).size(), linear);
  }
  return name;
}

}  // namespace breakaway
