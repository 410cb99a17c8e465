// What a board may say of itself: a number that no board has is refused before anything rests on it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>

#include "base/result.h"
#include "firmware_link/wire/messages.h"

namespace breakaway {

/// Errors: the field, what the board says, what was expected; for each of the three.
Result<void> checkHello(const std::string& place, const wire::Hello& hello);
Result<void> checkEntry(const std::string& place, const wire::DictionaryEntry& entry);
/// Of a parameter by the dictionary's name; one that nobody here reads may hold anything.
Result<void> checkValue(const std::string& place, const std::string& name, double value);

/// A name as the wire holds it: up to the first 0, or all of the room.
template <std::size_t size>
std::string textOf(const char (&room)[size]) {
  return {room, std::find(std::begin(room), std::end(room), '\0')};
}

}  // namespace breakaway
