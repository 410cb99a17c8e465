// What a file held, before its names and units were understood.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "recording/recording.h"

namespace breakaway {

struct RawColumn {
  Channel channel;                      ///< name as in the file, values in the file's unit, counted from `origin`
  std::optional<Error> fault;           ///< the first cell that is text; an error only if the column is used
  std::string unit = {};                ///< as the file gives it apart from the name; empty when it doesn't
  double origin = 0.0;                  ///< a whole number; stamps of 19 digits keep all of them this way
  bool clock = false;                   ///< values are s that were read from times of day or dates
  std::vector<std::string> texts = {};  ///< the texts that stand there; empty when there are too many to be kinds
  std::vector<uint16_t> textOf = {};    ///< per row the place in `texts`, from 1 on, 0 for a number or none
  bool manyTexts = false;               ///< more than 64, or long ones
};

/// Notes that in this row a text stands; those that return are kinds of rows: names of joints, states.
void rememberText(RawColumn& column, size_t row, std::string_view text);

struct RawTable {
  std::vector<RawColumn> columns;  ///< all of the same length
  std::vector<std::pair<std::string, std::string>> notes;
  std::vector<std::pair<std::string, std::string>> beside;  ///< fields beside the rows, deeper than notes
  std::vector<Message> remarks;                             ///< what was left out or assumed, in words
  std::vector<std::string> preamble;  ///< lines before the table, for tools that are known by them
  std::string tool = {};              ///< the program whose form this is, if its container tells

  size_t rows() const { return columns.empty() ? 0 : columns.front().channel.values.size(); }
};

}  // namespace breakaway
