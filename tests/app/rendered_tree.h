// What can be seen of a window: its controls, where they are, and whether anything is cut off or lies on something
// else.
#pragma once

#include <qcustomplot.h>

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
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTableView>
#include <QTest>

#include "widgets/elided_label.h"

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

/// Where an axis writes its labels, and what they are.
inline QList<std::pair<QRectF, QString>> tickLabels(const QCPAxis& axis) {
  QList<std::pair<QRectF, QString>> found;
  if (!axis.realVisibility() || !axis.tickLabels()) return found;
  QVector<double> ticks;
  QVector<QString> labels;
  axis.ticker()->generate(axis.range(), QLocale::c(), 'g', 6, ticks, nullptr, &labels);
  const QFontMetrics metrics(axis.tickLabelFont());
  const double height = metrics.capHeight();
  for (qsizetype k = 0; k < std::min(ticks.size(), labels.size()); ++k) {
    if (!axis.range().contains(ticks[k])) continue;
    const double at = axis.coordToPixel(ticks[k]), width = metrics.horizontalAdvance(labels[k]);
    const QRect rect = axis.axisRect()->rect();
    found << std::pair(axis.orientation() == Qt::Vertical
                           ? QRectF(rect.left() - 8.0 - width, at - 0.5 * height, width, height)
                           : QRectF(at - 0.5 * width, rect.bottom() + 8.0, width, height),
                       labels[k]);
  }
  return found;
}

/// One line for each title, name or label in a plot that is cut off, or that lies on another one.
inline QStringList crampedIn(QCustomPlot& plot) {
  plot.replot();
  QStringList found;
  const auto say = [&](const QString& what) { found << plot.parentWidget()->objectName() + ": " + what; };
  QList<std::pair<QRectF, QString>> words;
  for (QCPLayoutElement* element : plot.plotLayout()->elements(true)) {
    const auto* text = qobject_cast<QCPTextElement*>(element);
    if (text == nullptr || text->text().isEmpty() || !text->realVisibility()) continue;
    const QRect wanted = QFontMetrics(text->font()).boundingRect(0, 0, 0, 0, Qt::AlignCenter, text->text());
    const QRect has = text->rect();
    if (!plot.rect().contains(has) || has.width() + 1 < wanted.width() || has.height() + 1 < wanted.height())
      say(QString("\"%1\" is cut off").arg(text->text()));
    const bool right = text->textFlags() & Qt::AlignRight;
    words << std::pair(QRectF(right ? has.right() - wanted.width() : has.left(),
                              has.center().y() - 0.5 * QFontMetrics(text->font()).capHeight(), wanted.width(),
                              QFontMetrics(text->font()).capHeight()),
                       text->text());
  }
  for (const QCPAxisRect* rect : plot.axisRects()) {
    for (const QCPAxis* axis : rect->axes()) words << tickLabels(*axis);
  }
  for (qsizetype k = 0; k < words.size(); ++k) {
    for (qsizetype other = k + 1; other < words.size(); ++other) {
      if (words[k].first.intersects(words[other].first))
        say(QString("\"%1\" and \"%2\" lie on each other").arg(words[k].second, words[other].second));
    }
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
    const bool push = qobject_cast<const QPushButton*>(control) != nullptr;
    if (wanted + (push ? 18 : 8) > control->width()) found << name + ": \"" + text + "\" doesn't fit";
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
    constexpr int badgeMargin_px = 6;
    if (!label->property("badge").toString().isEmpty() &&
        label->fontMetrics().horizontalAdvance(label->text()) + 2 * badgeMargin_px > label->width())
      found << "badge \"" + label->text() + "\" has no margins";
  }
  for (const QScrollArea* area : window.findChildren<QScrollArea*>()) {
    const auto* outer = qobject_cast<const QScrollArea*>(scrolledBy(area));
    if (area->isVisible() && outer != nullptr && outer->objectName().endsWith("Settings") &&
        area->verticalScrollBar()->maximum() > 0)
      found << area->objectName() + " scrolls within what scrolls";
  }
  for (QCustomPlot* plot : window.findChildren<QCustomPlot*>()) {
    if (plot->isVisible() && plot->window() == &window) found << crampedIn(*plot);
  }
  return found;
}

/// One line for each visible line of text that ends in an ellipsis.
inline QStringList shortened(const QWidget& window) {
  QStringList found;
  for (const ElidedLabel* label : window.findChildren<ElidedLabel*>()) {
    if (!label->isVisible()) continue;
    if (label->fontMetrics().horizontalAdvance(label->shown()) > label->contentsRect().width())
      found << QString("%1: \"%2\"").arg(label->objectName(), label->text());
  }
  return found;
}

/// One line for each cell of a column of words that its row has no room for.
inline QStringList shortenedIn(const QTableView& table, int column) {
  QStringList found;
  const int margin_px = table.style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, &table) + 1;  // of a cell
  const int width = table.columnWidth(column) - 2 * margin_px;
  for (int row = 0; row < table.model()->rowCount(); ++row) {
    const QString text = table.model()->index(row, column).data().toString();
    const QRect wanted = table.fontMetrics().boundingRect(0, 0, width, 0, Qt::TextWordWrap, text);
    if (wanted.width() > width || wanted.height() > table.rowHeight(row)) found << text;
  }
  return found;
}

/// Numbers in the column that don't stand in one line.
inline QStringList wrappedIn(const QTableView& table, int column) {
  QStringList found;
  const int margin_px = table.style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, &table) + 1;  // of a cell
  for (int row = 0; row < table.model()->rowCount() && !table.isColumnHidden(column); ++row) {
    const QString text = table.model()->index(row, column).data().toString();
    if (table.fontMetrics().horizontalAdvance(text) > table.columnWidth(column) - 2 * margin_px) found << text;
  }
  return found;
}

/// On the page that is shown, at the sizes that have the least room.
inline QStringList clippedWhereSmall(QWidget& window) {
  QStringList found;
  for (const QSize size : {QSize(1280, 720), QSize(1366, 768)}) {
    window.resize(size);
    QTest::qWait(50);
    for (const QString& one : clipped(window)) found << QString("%1: %2").arg(size.width()).arg(one);
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
