// From what people have on disk to a recording: contracts section 2.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "recording/import/import_map.h"
#include "recording/import/raw_table.h"
#include "recording/recording.h"

namespace breakaway {

/// What became of one column of the file.
struct ColumnFate {
  enum class Kind { used, kept, leftOut };
  Kind kind = Kind::kept;
  std::string from;
  std::string to;      ///< the contract's name, or its own
  std::string unit;    ///< the one it was taken to be in, as written; "SI" when none is told
  double scale = 1.0;  ///< SI = scale × value + offset
  double offset = 0.0;
  Message why;           ///< in words
  Message doubt = {};    ///< what may be otherwise beside the unit; empty when nothing says so
  bool guessed = false;  ///< nothing in the file tells it for sure

  /// "Winkel [°] → angle_rad, from ° (× 0.0174532925)".
  Message inWords() const;
};

struct Imported {
  Recording recording;
  std::vector<ColumnFate> columns;  ///< one per column of the file
  std::vector<Message> remarks;     ///< what was found, assumed and left out, in words
};

/// Reads a log of whatever form (its content tells which), and makes a recording of it by `map`, by what is known of
/// the tool, by names and units, and by the values themselves: see resources/help/import.md. Columns that mean nothing
/// to the contract keep their name and values. With `split` in the map there is one recording per value of that column,
/// else one. Errors: what the readers say; a map that doesn't fit; no time; neither angle nor speed; times that don't
/// increase; what no file says and the map must (counts per turn, pole pairs, the rate).
Result<std::vector<Imported>> importRecordings(const std::string& path, const ImportMap& map = {});

/// The same for a log without `split`.
Result<Imported> importRecording(const std::string& path, const ImportMap& map = {});

/// One table per value of the column, which stands in its last note. Errors: no such column, more than 1000 values.
Result<std::vector<RawTable>> partsByColumn(const RawTable& table, const std::string& column, const std::string& path);

/// From a table that was read to a recording, called `path`.
Result<Imported> settleTable(RawTable table, const ImportMap& map, const std::string& path,
                             const std::vector<size_t>& newFile = {});

}  // namespace breakaway
