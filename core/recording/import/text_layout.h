// How a table of text is laid out: what parts the cells and which mark the decimals have.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace breakaway {

constexpr char runsOfBlanks = ' ';  ///< as a separator: any run of blanks and tabs

struct TextLayout {
  char separator = ',';
  bool decimalComma = false;
  bool grouped = false;       ///< the mark that decimals don't have parts thousands: "1.234,5"
  bool labelled = false;      ///< each cell tells its name: "angle:1.5"
  bool stamped = false;       ///< a terminal put the time before each line: "10:20:10.123 -> 1,2,3"
  size_t cells = 0;           ///< of a row, with the stamp
  std::vector<bool> numeric;  ///< the columns that hold numbers or times in most rows
};

enum class TextCell { number, clock, missing, text };

/// A cell's value. Large ones are parted in a whole number and the rest, so that stamps of 19 digits lose nothing.
struct TextNumber {
  double value = 0.0;  ///< NaN when missing or text
  int64_t whole = 0;   ///< only if `large`, or a clock: value = whole + rest
  double rest = 0.0;
  bool large = false;
  std::string_view unit = {};  ///< that stands behind the number in the cell: "1.5 sec"
  bool hexadecimal = false;
};

std::string_view withoutBlanks(std::string_view text);

/// Takes the next line off `rest`; `end` is what ends lines in this text.
std::string_view takeLine(std::string_view& rest, char end);
/// '\n', or '\r' in a text that has no '\n'.
char lineEndOf(std::string_view text);

bool isComment(std::string_view trimmedLine);

/// The line's cells, without quotes and blanks around them.
void splitCells(std::string_view line, const TextLayout& layout, std::vector<std::string_view>& cells);

/// What a cell says.
TextCell readCell(std::string_view cell, const TextLayout& layout, TextNumber& number);

/// "angle" of "angle:1.5 deg", and the unit behind the number; empty where none is.
std::string_view labelOf(std::string_view cell);
std::string_view unitBehind(std::string_view cell);

/// The layout in which these lines hold the most numbers; `cells` is 0 when they hold no table.
TextLayout layoutOf(const std::vector<std::string_view>& lines);

}  // namespace breakaway
