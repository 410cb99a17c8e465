// What the kinds of runs are called.
#pragma once

#include <QString>

#include "session/run.h"

namespace breakaway {

QString nameOf(RunKind kind);
/// Slow turning goes on until somebody ends it.
bool endsByItself(RunKind kind);

}  // namespace breakaway
