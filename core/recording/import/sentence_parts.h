// A line of text taken apart at its numbers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace breakaway {

/// A line as its values (numbers, times of day, dates) and the texts before, between and behind them: one text more
/// than values.
struct Sentence {
  std::vector<std::string_view> values, texts;
};

Sentence parted(std::string_view line);

/// What the texts say, however many blanks stand in them.
std::string reading(const Sentence& sentence);

bool isClock(std::string_view value);

/// The unit that stands behind a value; empty where none does.
std::string_view unitIn(std::string_view behind);

/// The unit behind a value with which the line begins, if it is one of time; else empty.
std::string_view stampUnit(const Sentence& sentence);

/// "[12.5] …" and, where the line begins with it, "12.5 s: …": the value is the row's time.
bool isStamp(const Sentence& sentence, size_t k);

/// The words before a value without the unit of the one before and what only makes it a sentence.
std::string labelIn(std::string_view text, std::string_view unitBefore);

}  // namespace breakaway
