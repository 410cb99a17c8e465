#include "widgets/time_mark.h"

#include <qcustomplot.h>

namespace breakaway {

void placeOverTime(QCPAbstractItem& item, QCPAxisRect& rect) {
  for (QCPItemPosition* position : item.positions()) {
    position->setAxes(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
    position->setAxisRect(&rect);
    position->setTypeX(QCPItemPosition::ptPlotCoords);
    position->setTypeY(QCPItemPosition::ptAxisRectRatio);
  }
  item.setClipAxisRect(&rect);
  item.setVisible(false);
}

void TimeMark::addTo(QCPAxisRect& rect) {
  lines_.push_back(new QCPItemStraightLine(rect.parentPlot()));
  placeOverTime(*lines_.back(), rect);
}

void TimeMark::moveTo(double time_s) {
  time_s_ = time_s;
  for (QCPItemStraightLine* line : lines_) {
    line->point1->setCoords(time_s, 0.0);
    line->point2->setCoords(time_s, 1.0);
  }
}

void TimeMark::show(bool shown) {
  for (QCPItemStraightLine* line : lines_) line->setVisible(shown);
}

void TimeMark::setPen(const QPen& pen) {
  for (QCPItemStraightLine* line : lines_) line->setPen(pen);
}

}  // namespace breakaway
