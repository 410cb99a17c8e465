// Words that are written as one, by the words that are known.
#pragma once

#include <string_view>

#include "recording/import/name_parts.h"

namespace breakaway {

/// "velcmd", "posref", "encleft" and "batvolt" are two words each: one that surely names a quantity, and one that is
/// known to stand beside such. What is known as a word itself stays whole.
void partJoined(Words& words);

/// Whether the word is any that this program knows, of a quantity or beside one.
bool isKnownWord(std::string_view word);

}  // namespace breakaway
