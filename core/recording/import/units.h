// The units that logs use, each as a factor to the contract's.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace breakaway {

enum class UnitKind {
  time,
  angle,
  length,
  angularVelocity,
  linearVelocity,
  current,
  voltage,
  torque,
  force,
  temperature,
  ratio
};

/// What a factor is still lacking; no file says it.
enum class UnitNeeds { nothing, countsPerRev, polePairs };

struct Unit {
  const char* name;
  UnitKind kind;
  double scale;  ///< SI = scale × value + offset; where something is needed, divided by that
  double offset = 0.0;
  UnitNeeds needs = UnitNeeds::nothing;
};

/// Words in lower case of a name or unit; "/" is the word "per", the signs of units are spelt out. With `splitCamel`
/// "motorAngle" are two words, and so are "iq2" and "motorRPM".
std::vector<std::string> wordsOf(std::string_view text, bool splitCamel);

/// The unit of this text, however it is written ("rad.s", "1/min", "Deg C", "N·m"); nullptr when it is none.
const Unit* unitNamed(std::string_view text);
/// The unit made of words `from` to the last.
const Unit* unitOfWords(const std::vector<std::string>& words, size_t from);
bool isUnit(std::string_view text);

/// Equal but for the case; `lower` is in lower case.
bool isSameWord(std::string_view text, std::string_view lower);

}  // namespace breakaway
