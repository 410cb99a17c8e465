#include "widgets/stop_keys.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QDialog>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QTextEdit>

namespace breakaway {

namespace {

/// Whether Space is a letter here. A spin box holds a number: Space is none.
bool takesText(const QWidget* widget) {
  if (widget == nullptr) return false;
  if (const auto* line = qobject_cast<const QLineEdit*>(widget)) {
    return !line->isReadOnly() && qobject_cast<QAbstractSpinBox*>(line->parentWidget()) == nullptr;
  }
  if (const auto* text = qobject_cast<const QTextEdit*>(widget)) return !text->isReadOnly();
  if (const auto* text = qobject_cast<const QPlainTextEdit*>(widget)) return !text->isReadOnly();
  return false;
}

bool closesByEscape(const QWidget* widget) {
  return QApplication::activePopupWidget() != nullptr || qobject_cast<QDialog*>(widget->window()) != nullptr;
}

}  // namespace

StopKeys::StopKeys(std::function<void()> stop, QObject* parent) : QObject(parent), stop_(std::move(stop)) {
  qApp->installEventFilter(this);
}

bool StopKeys::eventFilter(QObject* watched, QEvent* event) {
  const bool press = event->type() == QEvent::KeyPress;
  if (!press && event->type() != QEvent::KeyRelease) return false;
  auto* widget = qobject_cast<QWidget*>(watched);
  if (widget == nullptr) return false;
  const auto* key = static_cast<QKeyEvent*>(event);
  const bool space = key->key() == Qt::Key_Space && !takesText(widget);
  if (key->key() == Qt::Key_Escape || space) {
    if (press && !key->isAutoRepeat()) stop_();
    return space || !closesByEscape(widget);
  }
  auto* button = qobject_cast<QAbstractButton*>(widget);
  if (press && button != nullptr && (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter)) {
    button->click();
    return true;
  }
  return false;
}

}  // namespace breakaway
