// How controls are drawn: one style sheet of the application, its colours filled in from the look.
#pragma once

#include <QString>

namespace breakaway {

struct Look;

/// Roles of single widgets are their dynamic property "role": "primary", "chip", "segment", "card", "stop", "bare" …
QString styleSheet(const Look& look);

}  // namespace breakaway
