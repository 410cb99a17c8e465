// What a drive or a reference and a motion have to do with each other, by their values alone.
#pragma once

#include <cstddef>
#include <vector>

#include "recording/import/choose_columns.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// How much more of the drive acceleration and friction explain than of the same drive at other times (0 to 1; noise
/// reaches 0.1): a motion that repeats itself says nothing, as any wave of its period would go with it. 0 where the
/// drive takes energy out of the motion. Speed and drive in any unit, a value per row; `pauses`: rows after a pause.
double drivenBy(const std::vector<double>& time_s, const std::vector<double>& speed, const std::vector<double>& drive,
                const std::vector<size_t>& pauses);

/// How much two columns have in common about their means (−1 to 1), and how often the first stands in the second.
struct Following {
  double correlation = 0.0, slope = 0.0;
};
Following followingOf(const std::vector<double>& reference, const std::vector<double>& measured);

/// The most that the one has in common with the other, at once or up to a tenth of the rows later (−1 to 1).
double followedBy(const std::vector<double>& reference, const std::vector<double>& measured);

/// Of several drives, or several references, that only their place tells apart, and that differ, the motion's stays:
/// the one that goes with it far better than the first. A guess; the others are set aside. `ranks`: one per column, of
/// which the lowest is taken.
void preferMotionsOwn(const RawTable& table, const std::vector<int>& ranks, std::vector<Choice>& choices);

}  // namespace breakaway
