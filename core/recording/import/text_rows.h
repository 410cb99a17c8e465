// The rows of one table of text, read line by line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "recording/import/raw_table.h"
#include "recording/import/text_layout.h"

namespace breakaway {

constexpr size_t mostCellsOfARow = 10000;

/// What a line is to the table.
enum class LineKind {
  row,
  flawedRow,  ///< text stands where numbers belong
  otherRow,   ///< numbers, but not as many cells
  text
};

/// Reads one table after the other line by line.
class TextRows {
 public:
  TextRows(const TextLayout& layout, std::string name, size_t expected);

  RawTable table;

  LineKind judge(std::string_view line);
  /// Takes the line that was judged last.
  void append(bool flawed);
  /// "RPM:" in each row, before a number, is its name, with the words before it: "Angular Velocity: 1.5".
  void takeLabelColumns();
  static bool endsLabel(std::string_view text) { return text.back() == ':' || text.back() == '='; }
  /// A column without a name, or called a unit, that holds the same unit in each row tells the one of the column before
  /// it: "12.3 deg".
  void takeUnitColumns();
  size_t cellsOfLast() const { return cells_.size(); }
  /// Leaves out the flawed rows after the last good one, and all of them when they are few.
  void settle(size_t lastGoodRow);

 private:
  struct Counts {
    size_t clocks = 0, numbers = 0;
    bool hexadecimal = false;
  };
  struct SeenText {
    size_t count = 0;
    std::string first;
    bool same = true;
  };

  LineKind judgeOther();
  /// What each row holds there, if it is text and in each the same.
  std::string_view sameTextOf(size_t c) const;
  /// "t 0.1, angle 0.3, rpm 12": a word before each number.
  bool labelsAlternate() const;
  void noteText(size_t c, size_t row);
  /// All cells of a column have one unit.
  void noteUnit(size_t c, size_t row);
  template <typename Value>
  void dropRows(std::vector<Value>& values) const;
  void settleClock(size_t c);

  const TextLayout& layout_;
  std::string name_;
  std::vector<std::string_view> cells_;
  std::vector<TextNumber> numbers_;
  std::vector<TextCell> kinds_;
  std::vector<Counts> counts_;
  std::vector<SeenText> texts_;
  std::vector<size_t> flawed_;
  size_t firstNumeric_ = 0;
  bool origins_ = false;
};

}  // namespace breakaway
