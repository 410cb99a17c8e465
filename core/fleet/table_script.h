// What makes the fleet's table sort and filter, as plain JavaScript, and its style.
#pragma once

namespace breakaway {

extern const char* const fleetTableScript;
extern const char* const fleetTableStyle;

}  // namespace breakaway
