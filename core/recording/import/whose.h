// Whose a column is by its name: of two joints, of both sides of a gear, of a motor and what hangs on it.
#pragma once

#include <string>

#include "recording/import/choose_columns.h"
#include "recording/import/name_parts.h"

namespace breakaway {

/// What a name tells of whose the column is; empty where it tells nothing.
struct Whose {
  enum class Side { untold, motor, driven };
  Words owner = {};  ///< "left", "hip", "pedal": words of no quantity, unit or way of measuring
  Side side = Side::untold;
  std::string axis = {};  ///< "2"
};

Whose whoseIs(const RawColumn& column, const Choice& choice);

/// What two columns have to do with each other: they are called by the same, by different things, or nobody can tell.
enum class Kinship { apart, untold, own };
Kinship kinshipOf(const Whose& one, const Whose& other);

/// "shoulder" beside "elbow".
bool areDifferentJoints(const Whose& one, const Whose& other);

}  // namespace breakaway
