// How a fleet's numbers lie, and which entries lie apart.
#pragma once

#include <string>
#include <vector>

#include "fleet/entry.h"

namespace breakaway {

/// Robust deviations from the fleet's median beyond which an entry stands out (Iglewicz and Hoaglin, "How to Detect and
/// Handle Outliers", 1993).
inline constexpr double standsOutFrom = 3.5;
/// Values that are needed to tell what is usual.
inline constexpr size_t fewestForOutliers = 5;

/// One parameter over the fleet.
struct FleetColumn {
  std::string name;                     ///< with its unit; of a finding's "EFFECT.PARAMETER"
  std::vector<size_t> entries = {};     ///< that have it
  std::vector<FleetValue> values = {};  ///< theirs, in the same order
  bool intervals = true;                ///< false: of what wanders and of maps' means, which have none
  double median = 0.0;
  /// 1.4826 times the median distance from the median; where that is 0, 1.2533 times the mean distance.
  double deviation = 0.0;

  /// The value below which this part of them lies.
  double quantileOf(double fraction) const;
  /// How many deviations the nearer end of the value's interval lies from the median, with its sign; 0 where the
  /// interval holds the median, and where too few are there to tell.
  double distance(const FleetValue& value) const;
};

/// Where an entry lies furthest from the others.
struct StandsOut {
  size_t entry = 0;
  std::string parameter;  ///< empty where it has none
  double distance = 0.0;  ///< as FleetColumn::distance()
};

/// The base's parameters over the fleet, in the order in which they come.
std::vector<FleetColumn> baseColumns(const std::vector<FleetEntry>& entries);
/// The findings' parameters.
std::vector<FleetColumn> findingColumns(const std::vector<FleetEntry>& entries);

/// Every entry, the one furthest from the others first; those that nothing tells apart in their own order, and the
/// ones that ended in an error last.
std::vector<StandsOut> outliersFirst(const std::vector<FleetEntry>& entries, const std::vector<FleetColumn>& columns);

}  // namespace breakaway
