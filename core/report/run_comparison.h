// Two runs of a project side by side: what has changed beyond the intervals, in words, as a table and as pictures.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/catalogue.h"
#include "base/message.h"
#include "base/result.h"
#include "draw/svg_plot.h"
#include "friction/friction_map.h"
#include "project/project.h"
#include "report/recording_comparison.h"

namespace breakaway {

/// A result that both runs have.
struct ValueChange {
  RunValue before, after;
  /// Further apart than their 95 % intervals allow: more than the root of the half widths' squares. Never without
  /// intervals.
  bool beyond = false;
};

/// One quantity and way of two friction maps, bin by bin. In Nm; N on a linear axis.
struct MapChange {
  Message quantity;  ///< "static, clockwise"
  size_t bins = 0, beyond = 0;
  double byChance = 0.0;  ///< bins beyond that chance alone would make, a twentieth of those with intervals
  /// After − before, and half its 95 % interval as if all bins shared their errors, such as the current sensor's zero.
  double meanDifference = 0.0, meanHalfWidth = 0.0;
  double largest = 0.0, largestAt = 0.0;  ///< difference, and the place of its bin in rad or m
  /// The mean, or clearly more bins than by chance.
  bool isBeyond() const;
};

struct RunComparison {
  ProjectRun before, after;
  std::vector<ValueChange> values;
  std::vector<MapChange> maps;  ///< empty unless both have a map, of the same kind of axis
  std::optional<FrictionMap> mapBefore, mapAfter;
  std::vector<std::string> findingsGone, findingsNew;  ///< of diagnoses
  std::optional<RecordingComparison> recordings;       ///< of two runs that each are a recording
};

/// The older run first, whatever the order it was asked in. Errors: a map or a recording can't be read; the runs have
/// nothing in common.
Result<RunComparison> compareRuns(const Project& project, const ProjectRun& one, const ProjectRun& other);

/// Bin by bin, each of `after`'s beside the one of `before` that its centre lies in.
std::vector<MapChange> compareMaps(const FrictionMap& before, const FrictionMap& after);

/// After − before of one quantity, the mean of both ways, for each bin of `after`. In Nm, or in N; empty for maps of
/// different kinds of axis or without bins.
std::vector<Estimate> meanDifference(const FrictionMap& before, const FrictionMap& after,
                                     Estimate WayBin::*quantity = &WayBin::static_Nm);

/// One sentence a line, what lies beyond the intervals first.
Message inWords(const RunComparison& comparison);
/// What comparison.json holds, but for where it comes from (base/made.h).
std::string comparisonJson(const RunComparison& comparison);

/// The static friction of both maps, the earlier as a ghost, and around a turn the ring of differences outside.
Figure ghostFigure(const FrictionMap& before, const FrictionMap& after);
/// After − before over the place, with its band, by way.
Figure differenceFigure(const FrictionMap& before, const FrictionMap& after);

/// comparison.json, report.html and figures/*.svg into `folder`; report and figures in `language`.
Result<void> writeComparison(const RunComparison& comparison, const std::string& folder,
                             const Catalogue& language = {});

}  // namespace breakaway
