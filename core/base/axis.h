// Whether a rig turns or runs to and fro, and how its quantities are called then.
#pragma once

#include <string>

namespace breakaway {

enum class Axis { rotary, linear };

/// A rotor's quantity's name as it is on the axis: `coulomb_average_Nm` is `coulomb_average_N` on a linear one;
/// names are those of resources/help/files.md.
std::string nameOn(Axis axis, std::string rotorsName);

}  // namespace breakaway
