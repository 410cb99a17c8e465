#include "widgets/controls.h"

#include <QCoreApplication>
#include <QEvent>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/look.h"

namespace breakaway {

namespace {

template <class Layout>
Layout* layOut(QWidget* widget, int spacing, const QMargins& margins) {
  auto* layout = new Layout(widget);
  layout->setContentsMargins(margins);
  layout->setSpacing(spacing);
  return layout;
}

}  // namespace

QToolButton* toolButton(QWidget* parent, const char* objectName, const QString& text, const QString& tip) {
  auto* button = new QToolButton(parent);
  button->setObjectName(objectName);
  button->setText(text);
  button->setAccessibleName(text);
  button->setToolTip(tip);
  button->setToolButtonStyle(Qt::ToolButtonTextOnly);
  button->setFocusPolicy(Qt::StrongFocus);
  return button;
}

QPushButton* pushButton(QWidget* parent, const char* objectName, const QString& text, const QString& tip) {
  auto* button = new QPushButton(text, parent);
  button->setObjectName(objectName);
  button->setAccessibleName(text);
  button->setToolTip(tip);
  return button;
}

QPushButton* chipButton(QWidget* parent, const char* objectName, const QString& text, const QString& tip) {
  auto* button = pushButton(parent, objectName, text, tip);
  button->setCheckable(true);
  button->setProperty("role", "chip");
  return button;
}

void dressAs(QWidget* widget, const char* property, const QString& value) {
  if (widget->property(property).toString() == value) return;
  widget->setProperty(property, value);
  widget->style()->unpolish(widget);
  widget->style()->polish(widget);
  QEvent change(QEvent::StyleChange);  // its margins may be others now, and with them its size
  QCoreApplication::sendEvent(widget, &change);
  widget->updateGeometry();
}

void setAvailable(QWidget* control, bool available, const QString& tip, const QString& reason) {
  control->setEnabled(available);
  control->setToolTip(available ? tip : reason);
}

void setAvailable(QWidget* control, const QString& tip, const QString& reason) {
  setAvailable(control, reason.isEmpty(), tip, reason);
}

QVBoxLayout* columnIn(QWidget* widget, int spacing, const QMargins& margins) {
  return layOut<QVBoxLayout>(widget, spacing, margins);
}

QHBoxLayout* rowIn(QWidget* widget, int spacing, const QMargins& margins) {
  return layOut<QHBoxLayout>(widget, spacing, margins);
}

QFrame* card(QWidget* parent) {
  auto* frame = new QFrame(parent);
  frame->setProperty("role", "card");
  columnIn(frame, 8, {16, 12, 16, 12});
  return frame;
}

QVBoxLayout* columnOf(QFrame* card) {
  return static_cast<QVBoxLayout*>(card->layout());
}

QLabel* section(QWidget* parent, const QString& text) {
  auto* label = new QLabel(text, parent);
  label->setFont(typed(Type::section));
  return label;
}

QLabel* explanation(QWidget* parent, const QString& text, const char* objectName) {
  auto* label = new QLabel(text, parent);
  label->setObjectName(objectName);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

QLabel* caption(QWidget* parent, const QString& text) {
  auto* label = new QLabel(text, parent);
  label->setFont(typed(Type::caption));
  label->setProperty("tone", "muted");
  return label;
}

}  // namespace breakaway
