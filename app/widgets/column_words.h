// What a recording's columns are called in words; their names stay what files have.
#pragma once

#include <QString>

#include "recording/columns.h"

namespace breakaway {

/// "speed asked for" of velocity_reference_rad_per_s; each column's words are its own.
QString wordsOf(const Column& column);

}  // namespace breakaway
