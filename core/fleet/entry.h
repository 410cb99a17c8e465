// A fleet's entries: what each line of a batch's results says.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"

namespace breakaway {

/// A number with its 95 % interval, in the unit of its name.
struct FleetValue {
  double value = 0.0, low95 = 0.0, high95 = 0.0;
};

using FleetParameters = std::vector<std::pair<std::string, FleetValue>>;

struct FleetFinding {
  std::string effect;
  FleetParameters parameters;
};

/// A rotor's friction map in Nm at as many angles from the encoder's index as each, evenly around the turn.
struct MapCurves {
  std::vector<double> staticCw_Nm, staticCcw_Nm, coulombCw_Nm, coulombCcw_Nm, position_Nm;
};

/// What held-out data says of the model, in the unit of the channel.
struct FleetFit {
  std::string channel;
  double before = 0.0, after = 0.0, floor = 0.0;
  FleetValue gain;  ///< 1 − after/before
};

struct FleetEntry {
  std::string id;       ///< a number as its text
  std::string error;    ///< one line; then there is no diagnosis
  std::string verdict;  ///< nothing_missing, named, …; "error" where it ended in one
  std::vector<FleetFinding> findings;
  FleetParameters parameters;  ///< the base's, "wander_rms_Nm" (without an interval), and what addMap() adds
  std::optional<FleetFit> fit;
  std::optional<MapCurves> map;
  std::string at;      ///< ISO 8601: the field `date` of the line, or else when it was diagnosed; may be empty
  std::string run;     ///< which run of a batch it is from; may be empty
  std::string report;  ///< a path from the page's folder, or an address; may be empty
  std::vector<std::pair<std::string, std::string>> further;  ///< of the manifest, as text

  std::string names() const;  ///< the findings', in order, with blanks between
};

/// What results are read from.
struct FleetText {
  std::vector<FleetEntry> entries;
  bool cutShort = false;  ///< the last line has no end: it was being written, and is left out
};

/// Reads results of a batch, one JSON object a line. `path` stands in errors. Relative reports lead from `reportsFrom`.
/// Errors, by line and field: no JSON, no result, a diagnosis in another form (of a later version), a field that is
/// missing or of another kind.
Result<FleetText> readFleet(std::string_view text, const std::string& path, const std::string& reportsFrom = {});

/// Leaves out what stands there twice, as the same id from the same run; how many.
size_t leaveOutRepeated(std::vector<FleetEntry>& entries);

/// How many ids have several results.
size_t idsWithSeveral(const std::vector<FleetEntry>& entries);

/// The days from 1970-01-01 to `at`, an ISO 8601 date with or without a time; nothing where it is none.
std::optional<double> daysOf(const std::string& at);

}  // namespace breakaway
