// Rows printed as sentences: "10:20:10.125 Motor at 1.5 deg, speed is 12 rpm".
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace breakaway {

struct SentenceRows {
  std::string table;
  size_t leftOut = 0;  ///< lines that don't read like the others
};

enum class SentenceTime {
  any,
  clock  ///< only lines in which a time of day or a date stands
};

/// The text as a table, its names the words before each number, in brackets the unit behind it: "time;Motor [deg];speed
/// [rpm]". A clock in the line is the time. Nothing: most of the first lines don't read alike, or the words before the
/// numbers name no quantity.
std::optional<SentenceRows> withSentencesAsCells(std::string_view text, SentenceTime time);

}  // namespace breakaway
