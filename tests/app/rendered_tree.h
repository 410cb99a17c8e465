// What can be seen of a window: its controls, where they are, and whether anything is cut off or lies on something
// else.
#pragma once

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMap>
#include <QScrollArea>
#include <QScrollBar>

namespace breakaway::test {

inline bool isControl(const QWidget* widget) {
  if (widget->objectName().startsWith("qt_") || widget->inherits("QTableCornerButton")) return false;
  if (qobject_cast<const QScrollBar*>(widget)) return false;
  if (qobject_cast<const QAbstractSpinBox*>(widget->parentWidget())) return false;  // its line
  if (qobject_cast<const QComboBox*>(widget->parentWidget())) return false;
  return qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget) ||
         qobject_cast<const QComboBox*>(widget) || qobject_cast<const QLineEdit*>(widget) ||
         qobject_cast<const QAbstractSlider*>(widget);
}

inline QList<QWidget*> visibleControls(const QWidget& window) {
  QList<QWidget*> controls;
  for (QWidget* widget : window.findChildren<QWidget*>()) {
    if (widget->isVisibleTo(&window) && widget->isVisible() && widget->window() == &window && isControl(widget))
      controls << widget;
  }
  return controls;
}

/// The scroll area or view that it moves in, if any: what is outside of that comes by scrolling.
inline const QAbstractScrollArea* scrolledBy(const QWidget* widget) {
  for (const QWidget* up = widget->parentWidget(); up != nullptr; up = up->parentWidget()) {
    const auto* area = qobject_cast<const QAbstractScrollArea*>(up);
    if (area == nullptr) continue;
    const bool fixed = area->horizontalScrollBarPolicy() == Qt::ScrollBarAlwaysOff &&
                       area->verticalScrollBarPolicy() == Qt::ScrollBarAlwaysOff;
    if (!fixed) return area;
  }
  return nullptr;
}

inline QRect placeIn(const QWidget* widget, const QWidget& window) {
  return {widget->mapTo(&window, QPoint(0, 0)), widget->size()};
}

/// Where every control is that has a name, in the window.
inline QMap<QString, QRect> places(const QWidget& window) {
  QMap<QString, QRect> found;
  for (const QWidget* control : visibleControls(window)) {
    if (!control->objectName().isEmpty()) found[control->objectName()] = placeIn(control, window);
  }
  return found;
}

/// One line for each control that is cut off by the window or by its parent, or too narrow for its words.
inline QStringList clipped(const QWidget& window) {
  QStringList found;
  for (const QWidget* control : visibleControls(window)) {
    const QAbstractScrollArea* area = scrolledBy(control);
    const QRect place = placeIn(control, window);
    const QString name = control->objectName();
    if (area == nullptr && !window.rect().contains(place)) found << name + " is cut off by the window";
    if (area != nullptr && place.width() > area->width()) found << name + " is wider than what scrolls it";
    const QWidget* parent = control->parentWidget();
    if (!parent->rect().contains(control->geometry())) found << name + " is cut off by its parent";
    const auto* button = qobject_cast<const QAbstractButton*>(control);
    if (button == nullptr || button->text().isEmpty()) continue;
    QString text = button->text();
    const int wanted = button->fontMetrics().horizontalAdvance(text.remove('&'));
    if (wanted + 8 > control->width()) found << name + ": \"" + text + "\" doesn't fit";
  }
  for (const QScrollArea* area : window.findChildren<QScrollArea*>()) {
    if (!area->isVisible() || area->widget() == nullptr) continue;
    if (area->horizontalScrollBarPolicy() != Qt::ScrollBarAlwaysOff) continue;
    if (area->widget()->minimumSizeHint().width() > area->viewport()->width())
      found << QString("what %1 scrolls is %2 wide, in %3")
                   .arg(area->objectName())
                   .arg(area->widget()->minimumSizeHint().width())
                   .arg(area->viewport()->width());
  }
  for (const QLabel* label : window.findChildren<QLabel*>()) {
    if (!label->isVisible() || label->window() != &window || label->text().isEmpty()) continue;
    if (label->wordWrap() || label->inherits("breakaway::ElidedLabel") || label->textFormat() == Qt::RichText) continue;
    if (label->sizePolicy().horizontalPolicy() == QSizePolicy::Ignored) {
      found << "label \"" + label->text() + "\" is cut off without saying so";
      continue;
    }
    if (label->width() + 1 < label->sizeHint().width()) found << "label \"" + label->text() + "\" is cut off";
  }
  return found;
}

/// One line for each pair of controls of which neither holds the other and which overlap.
inline QStringList overlapping(const QWidget& window) {
  QStringList found;
  const QList<QWidget*> controls = visibleControls(window);
  for (qsizetype k = 0; k < controls.size(); ++k) {
    for (qsizetype other = k + 1; other < controls.size(); ++other) {
      QWidget *a = controls[k], *b = controls[other];
      if (a->isAncestorOf(b) || b->isAncestorOf(a) || scrolledBy(a) != scrolledBy(b)) continue;
      if (placeIn(a, window).intersects(placeIn(b, window))) found << a->objectName() + " and " + b->objectName();
    }
  }
  return found;
}

}  // namespace breakaway::test
