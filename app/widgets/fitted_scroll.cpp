#include "widgets/fitted_scroll.h"

#include <QEvent>
#include <QLayout>
#include <algorithm>

namespace breakaway {

FittedScroll::FittedScroll(const char* objectName, QWidget* parent) : QScrollArea(parent) {
  setObjectName(objectName);
  setFocusPolicy(Qt::NoFocus);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setWidgetResizable(true);
}

void FittedScroll::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  fit();
}

bool FittedScroll::eventFilter(QObject* watched, QEvent* event) {
  if (watched == widget() && event->type() == QEvent::LayoutRequest) fit();
  return QScrollArea::eventFilter(watched, event);
}

/// As high as its words are in this width.
void FittedScroll::fit() {
  if (widget() == nullptr) return;
  const int wanted = widget()->layout()->totalHeightForWidth(viewport()->width());
  setMaximumHeight(std::max({1, wanted, widget()->layout()->totalMinimumSize().height()}));
}

}  // namespace breakaway
