#include "recording/import/joined_words.h"

#include <algorithm>
#include <array>
#include <string>

#include "recording/import/quantity_words.h"

namespace breakaway {

namespace {

bool standsBeside(std::string_view word) {
  constexpr size_t shortest = 3;  // of decorations: single letters and "in" begin too many words
  static constexpr auto sides = std::to_array<std::string_view>({"left", "right", "wheel"});
  return isIn(referenceWords, word) || isIn(jointWords, word) || isIn(supplyWords, word) || isIn(loadWords, word) ||
         isIn(drivenWords, word) || isIn(driverWords, word) || isIn(otherThings, word) || isIn(electricalWords, word) ||
         isIn(sides, word) || (word.size() >= shortest && isIn(decorations, word));
}

/// Of the weak words those that name nothing else within another word.
bool surelyNamesQuantity(std::string_view word) {
  static constexpr auto sure = std::to_array<std::string_view>({"enc", "ang", "dq"});
  const Word* quantity = quantityNamed(word);
  return quantity != nullptr && (!quantity->weak || isIn(sure, word));
}

/// Where a second word begins; 0 when the word is one.
size_t secondWordIn(std::string_view word) {
  constexpr size_t shortestPart = 2, shortestWord = 5;
  if (word.size() < shortestWord || isKnownWord(word)) return 0;
  for (size_t at = word.size() - shortestPart; at >= shortestPart; --at) {
    const std::string_view first = word.substr(0, at), second = word.substr(at);
    const bool parts =
        (surelyNamesQuantity(first) && standsBeside(second)) || (standsBeside(first) && surelyNamesQuantity(second)) ||
        (surelyNamesQuantity(first) && surelyNamesQuantity(second) && first.size() > 2 && second.size() > 2);
    if (parts) return at;
  }
  return 0;
}

}  // namespace

bool isKnownWord(std::string_view word) {
  return quantityNamed(word) != nullptr || standsBeside(word) || isIn(decorations, word) || isIn(headings, word) ||
         isIn(loopWords, word) || unitNamed(word) != nullptr;
}

void partJoined(Words& words) {
  for (size_t k = 0; k < words.size(); ++k) {
    const size_t at = secondWordIn(words[k]);
    if (at == 0) continue;
    std::string first = words[k].substr(0, at), second = words[k].substr(at);
    if (isIn(jointWords, second)) std::swap(first, second);  // whose it is stands before
    words[k] = std::move(first);
    words.insert(words.begin() + static_cast<std::ptrdiff_t>(k) + 1, std::move(second));
  }
}

}  // namespace breakaway
