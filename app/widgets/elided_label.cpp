#include "widgets/elided_label.h"

#include <QEvent>
#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

namespace breakaway {

namespace {
constexpr int leastWidth = 16;
}  // namespace

ElidedLabel::ElidedLabel(const char* objectName, QWidget* parent) : QLabel(parent) {
  setObjectName(objectName);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

QSize ElidedLabel::sizeHint() const {
  return {leastWidth, fontMetrics().height() + 2};
}

QSize ElidedLabel::minimumSizeHint() const {
  return sizeHint();
}

void ElidedLabel::setShorter(const QString& text) {
  shorter_ = text;
  update();
}

QString ElidedLabel::shown() const {
  const bool fits = fontMetrics().horizontalAdvance(text()) <= contentsRect().width();
  return fits || shorter_.isEmpty() ? text() : shorter_;
}

void ElidedLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setPen(palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, foregroundRole()));
  painter.drawText(contentsRect(), static_cast<int>(alignment()) | Qt::TextSingleLine,
                   fontMetrics().elidedText(shown(), Qt::ElideRight, contentsRect().width()));
}

bool ElidedLabel::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip || !toolTip().isEmpty()) return QLabel::event(event);
  if (fontMetrics().horizontalAdvance(text()) > contentsRect().width())
    QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), text(), this);
  return true;
}

}  // namespace breakaway
