// Entries of several lines, each line with a name and a value: "Speed: 12 rpm", below it "Current: 0.5 A".
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace breakaway {

struct LineEntries {
  std::string table;
  size_t lines = 0;    ///< kinds of lines that make an entry
  size_t leftOut = 0;  ///< lines of other kinds
};

/// The text as a table with a row for each entry, its names the words before each number, in brackets the unit behind
/// it. An entry ends where a kind of line comes again; a stamp (a time of day, a number in brackets) is the time.
/// Nothing: the lines aren't of a few kinds that return, one kind is most of them, or none names a motion.
std::optional<LineEntries> withEntriesAsRows(std::string_view text);

}  // namespace breakaway
