// Completions of a program's commands, options and their values, for three shells.
#pragma once

#include <string>

#include "line/option_table.h"

namespace breakaway::line {

/// For bash-completion's folder of completions, under the program's name.
std::string bashCompletion(const Table& table);

/// For zsh's site-functions, as _PROGRAM.
std::string zshCompletion(const Table& table);

/// For fish's vendor_completions.d, as PROGRAM.fish.
std::string fishCompletion(const Table& table);

}  // namespace breakaway::line
