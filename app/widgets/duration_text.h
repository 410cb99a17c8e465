// How long something takes, in words.
#pragma once

#include <QString>

namespace breakaway {

/// "3 min 20 s" or "12 s".
QString durationText(double duration_s);

}  // namespace breakaway
