#include "widgets/fields.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QMetaProperty>
#include <QPlainTextEdit>
#include <QPointer>
#include <QTableWidget>
#include <vector>

namespace breakaway {

namespace {

using Widgets = std::vector<QPointer<QWidget>>;

/// Those inside first. What a box consists of is no field of its own.
void gather(QWidget& from, Widgets& found) {
  if (qobject_cast<QAbstractSpinBox*>(&from) == nullptr && qobject_cast<QComboBox*>(&from) == nullptr) {
    for (QObject* child : from.children()) {
      if (auto* widget = qobject_cast<QWidget*>(child)) gather(*widget, found);
    }
  }
  if (!from.objectName().isEmpty() && !from.objectName().startsWith("qt_")) found.emplace_back(&from);
}

bool holdsMore(const QWidget& widget) {
  return qstrcmp(widget.metaObject()->userProperty().name(), "kept") == 0;
}

/// Which cell is current, and each row's tick: none, or how it is.
QVariant heldBy(const QTableWidget& table) {
  QVariantList held{table.currentRow(), table.currentColumn()};
  for (int row = 0; row < table.rowCount(); ++row) {
    const QTableWidgetItem* first = table.item(row, 0);
    held << (first != nullptr ? first->data(Qt::CheckStateRole) : QVariant());
  }
  return held;
}

void set(QTableWidget& table, const QVariantList& held) {
  for (int row = 0; row < table.rowCount(); ++row) {
    QTableWidgetItem* first = table.item(row, 0);
    const QVariant tick = held.value(row + 2);
    if (first != nullptr && tick.isValid() && first->data(Qt::CheckStateRole) != tick)
      first->setData(Qt::CheckStateRole, tick);
  }
  if (held.value(0).toInt() >= 0) table.setCurrentCell(held.value(0).toInt(), held.value(1).toInt());
}

/// Nothing where it holds nothing.
QVariant heldBy(const QWidget& widget) {
  if (holdsMore(widget) || qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr ||
      qobject_cast<const QLineEdit*>(&widget) != nullptr || qobject_cast<const QPlainTextEdit*>(&widget) != nullptr)
    return widget.metaObject()->userProperty().read(&widget);
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
    return button->isCheckable() ? QVariant(button->isChecked()) : QVariant();
  if (const auto* box = qobject_cast<const QComboBox*>(&widget)) return box->currentIndex();
  if (const auto* list = qobject_cast<const QListWidget*>(&widget)) return list->currentRow();
  if (const auto* table = qobject_cast<const QTableWidget*>(&widget)) return heldBy(*table);
  return {};
}

void set(QWidget& widget, const QVariant& value) {
  if (auto* button = qobject_cast<QAbstractButton*>(&widget)) {
    button->click();
  } else if (auto* box = qobject_cast<QComboBox*>(&widget)) {
    box->setCurrentIndex(value.toInt());
  } else if (auto* list = qobject_cast<QListWidget*>(&widget); list != nullptr && !holdsMore(widget)) {
    list->setCurrentRow(value.toInt());
  } else if (auto* table = qobject_cast<QTableWidget*>(&widget)) {
    set(*table, value.toList());
  } else {
    widget.metaObject()->userProperty().write(&widget, value);
    if (auto* text = qobject_cast<QPlainTextEdit*>(&widget)) text->moveCursor(QTextCursor::End);
  }
}

}  // namespace

Fields fieldsIn(QWidget& window) {
  Widgets widgets;
  gather(window, widgets);
  Fields fields;
  for (const auto& widget : widgets) {
    if (const QVariant held = heldBy(*widget); held.isValid()) fields[widget->objectName()] = held;
  }
  return fields;
}

void setFields(QWidget& window, const Fields& fields) {
  Widgets widgets;
  gather(window, widgets);
  for (const auto& widget : widgets) {
    if (!widget) continue;  // an earlier one's value has put others in its place
    const QVariant value = fields.value(widget->objectName());
    if (value.isValid() && heldBy(*widget) != value) set(*widget, value);
  }
}

}  // namespace breakaway
