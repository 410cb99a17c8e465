// What a drive and a motion have to do with each other, by their values alone.
#pragma once

#include <cstddef>
#include <vector>

namespace breakaway {

/// How much more of the drive acceleration and friction explain than of the same drive at other times (0 to 1; noise
/// reaches 0.1): a motion that repeats itself says nothing, as any wave of its period would go with it. 0 where the
/// drive takes energy out of the motion. Speed and drive in any unit, a value per row; `pauses`: rows after a pause.
double drivenBy(const std::vector<double>& time_s, const std::vector<double>& speed, const std::vector<double>& drive,
                const std::vector<size_t>& pauses);

}  // namespace breakaway
