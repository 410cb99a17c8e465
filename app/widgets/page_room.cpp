#include "widgets/page_room.h"

#include <QEvent>
#include <QScrollBar>

namespace breakaway {

PageRoom::PageRoom(QWidget* page, QWidget* parent) : QScrollArea(parent) {
  setObjectName("pageRoom");
  setFocusPolicy(Qt::NoFocus);
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setWidget(page);
  page->installEventFilter(this);
  setScrolls(false);
}

void PageRoom::setScrolls(bool scrolls) {
  scrolls_ = scrolls;
  widget()->setMinimumWidth(scrolls ? least_px_ : 0);
  const auto policy = scrolls ? Qt::ScrollBarAsNeeded : Qt::ScrollBarAlwaysOff;
  setHorizontalScrollBarPolicy(policy);
  setVerticalScrollBarPolicy(policy);
  updateGeometry();
}

void PageRoom::setLeast(int width_px) {
  least_px_ = width_px;
  setScrolls(scrolls_);
}

QSize PageRoom::sizeHint() const {
  return widget()->sizeHint();
}

QSize PageRoom::minimumSizeHint() const {
  return scrolls_ ? QSize(0, 0) : widget()->minimumSizeHint();
}

/// What the page asks for has changed.
bool PageRoom::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::LayoutRequest) updateGeometry();
  return QScrollArea::eventFilter(watched, event);
}

}  // namespace breakaway
