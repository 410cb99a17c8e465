// The name of a column taken apart: its words, its unit, and which axis it is of.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "recording/import/units.h"

namespace breakaway {

using Words = std::vector<std::string>;

/// A name taken apart.
struct NameParts {
  Words words;  ///< without the unit and the numbers
  Words plain;  ///< with the unit's words
  std::string group;
  const Unit* unit = nullptr;
  double factor = 1.0;  ///< of a unit like "0.1 rpm"
  std::string unitText;
  bool unitFirst = false;    ///< the unit is what the name begins with: "rpm_left"
  bool unknownUnit = false;  ///< a unit stands there, but none that is understood
};

/// A unit may stand in brackets anywhere, after " in ", after a slash, as the last words, or, as `unit`, apart; it may
/// have a factor before it ("0.1 rpm").
NameParts partsOfName(std::string_view name, std::string_view unit);

/// "°/s" of "°/s (Angular velocity)", where what it counts stands behind a unit; else nothing.
std::string_view unitBeforeQuantity(std::string_view text);

/// "torque_x1000", "angle*10": a name that holds a factor.
bool isMultiplied(std::string_view name);

/// In small letters, as far as they are ASCII's.
std::string lowered(std::string_view text);

template <typename Some>
bool isIn(const Some& list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

template <typename Some>
const std::string* firstIn(const Words& words, const Some& list) {
  const auto it = std::find_if(words.begin(), words.end(), [&list](const auto& word) { return isIn(list, word); });
  return it == words.end() ? nullptr : &*it;
}

inline bool isNumber(std::string_view word) {
  return !word.empty() && word.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace breakaway
