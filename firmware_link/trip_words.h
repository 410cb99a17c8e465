// Why a board opened the windings by itself, for a person.
#pragma once

#include <string>

#include "control/board_watch.h"

namespace breakaway {

/// What happened and what to do about it, with the figures of that tick.
std::string tripWords(Trip trip, const BoardWatch<double>& watch, const BoardWatch<double>::Seen& seen);

/// The same for a link that is gone; `silent_s` is how long nothing has come.
std::string linkLossWords(double silent_s);

}  // namespace breakaway
