#include "widgets/click_guard.h"

#include <QAbstractButton>
#include <QApplication>
#include <QEvent>

namespace breakaway {

ClickGuard::ClickGuard(QObject* parent) : QObject(parent) {
  qApp->installEventFilter(this);
}

bool ClickGuard::eventFilter(QObject* watched, QEvent* event) {
  const bool again = event->type() == QEvent::MouseButtonDblClick;
  if (!again && event->type() != QEvent::MouseButtonPress) return false;
  auto* button = qobject_cast<QAbstractButton*>(watched);
  if (again && button != nullptr && pressed_ == button && button->text() != said_) return true;
  pressed_ = button;
  said_ = button != nullptr ? button->text() : QString();
  return false;
}

}  // namespace breakaway
