// One channel of a recording at several resolutions: a picture of any stretch costs the same, however long it is.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "recording/recording.h"

namespace breakaway {

class Overview {
 public:
  struct Point {
    double time_s = 0.0, value = 0.0;
  };

  /// Goes through all rows once; a channel that the recording doesn't have leaves it empty.
  Overview(const Recording& recording, const std::string& channel);

  /// What a picture `pixels` wide needs of the stretch: its rows where they are few, else the least and the greatest of
  /// each part, in the order in which they came; one row more on either side, so that lines leave the picture.
  std::vector<Point> between(double from_s, double to_s, size_t pixels) const;
  /// Least and greatest value of all; 0 and 0 where there is none.
  std::pair<double, double> range() const { return range_; }
  /// Where it first leaves its first value by a hundredth of its range: the time, and the first value; its first row
  /// where nothing moves, and 0 and 0 without values.
  Point begin() const { return begin_; }

 private:
  struct Extremes {
    std::size_t least = 0, greatest = 0;  ///< rows
  };

  bool missing(std::size_t row) const { return values_[row] != values_[row]; }
  void findBegin();
  Extremes extremesOf(std::size_t first, std::size_t last) const;
  void add(Extremes& all, const Extremes& part) const;

  Recording recording_;  ///< keeps the rows
  std::span<const double> time_, values_;
  std::vector<std::vector<Extremes>> levels_;  ///< of stretches of 64 rows, 512, …
  std::pair<double, double> range_{0.0, 0.0};
  Point begin_;
};

}  // namespace breakaway
