// Ticks of an axis of values whose labels never lie on each other, however low the plot is.
#pragma once

#include <qcustomplot.h>

#include "widgets/true_minus.h"

namespace breakaway {

class RoomyTicker : public PlainTicker {
 public:
  /// About so many, where there is room.
  RoomyTicker(const QCPAxis& axis, int count) : axis_(axis) { setTickCount(count); }

 protected:
  double getTickStep(const QCPRange& range) override {
    const double room_px = axis_.axisRect()->height(), least_px = QFontMetrics(axis_.tickLabelFont()).capHeight() + 3.0;
    double step = QCPAxisTicker::getTickStep(range);
    while (step > 0.0 && step < range.size() && room_px * step < least_px * range.size()) step *= 2.0;
    return step;
  }

 private:
  const QCPAxis& axis_;
};

}  // namespace breakaway
