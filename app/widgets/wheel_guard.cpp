#include "widgets/wheel_guard.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QScrollBar>

namespace breakaway {

namespace {

bool holdsValue(const QObject* object) {
  const bool slider = qobject_cast<const QAbstractSlider*>(object) && !qobject_cast<const QScrollBar*>(object);
  return slider || qobject_cast<const QAbstractSpinBox*>(object) || qobject_cast<const QComboBox*>(object);
}

}  // namespace

WheelGuard::WheelGuard(QObject* parent) : QObject(parent) {
  qApp->installEventFilter(this);
}

bool WheelGuard::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Polish && holdsValue(watched)) {
    auto* widget = static_cast<QWidget*>(watched);
    // Else the first turn of the wheel would take the focus and change the value.
    if (widget->focusPolicy() == Qt::WheelFocus) widget->setFocusPolicy(Qt::StrongFocus);
  }
  if (event->type() != QEvent::Wheel || !holdsValue(watched)) return false;
  if (static_cast<QWidget*>(watched)->hasFocus()) return false;
  event->ignore();  // whatever scrolls around it gets it
  return true;
}

}  // namespace breakaway
