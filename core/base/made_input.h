// Inputs of a run that are too large to be read at once.
#pragma once

#include "base/made.h"

namespace breakaway {

/// As noteInput() (made.h), for a file whose hash is known.
void noteInputFile(InputFile input);

}  // namespace breakaway
