// One moment, marked by a line through several plots over time.
#pragma once

#include <vector>

class QCPAbstractItem;
class QCPAxisRect;
class QCPItemStraightLine;
class QPen;

namespace breakaway {

/// Lets an item stand at a time of this plot, and at a part of its height (0 above, 1 below); hidden at first.
void placeOverTime(QCPAbstractItem& item, QCPAxisRect& rect);

class TimeMark {
 public:
  /// The line belongs to the rectangle's plot.
  void addTo(QCPAxisRect& rect);
  void moveTo(double time_s);
  double time_s() const { return time_s_; }
  void show(bool shown);
  void setPen(const QPen& pen);

 private:
  std::vector<QCPItemStraightLine*> lines_;
  double time_s_ = 0.0;
};

}  // namespace breakaway
