// What can be read in a window, page by page: texts, tooltips, names for screen readers, choices, and words in plots.
#pragma once

#include <qcustomplot.h>

#include <QAction>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QSet>
#include <QTableView>

#include "app/rendered_tree.h"
#include "app/window_support.h"

namespace breakaway::test {

inline const QStringList pages{"connectPage", "identifyPage", "tunePage", "homePage", "frictionPage",
                               "comparePage", "reportPage",   "handPage", "runsPage"};

using Texts = QSet<QString>;
using PageTexts = QMap<QString, Texts>;

inline QString shownPage(const QWidget& window) {
  for (const QString& page : pages) {
    if (window.findChild<QWidget*>(page)->isVisible()) return page;
  }
  return {};
}

inline Texts textsInPlot(QCustomPlot& plot) {
  Texts texts;
  for (QCPLayoutElement* element : plot.plotLayout()->elements(true)) {
    if (const auto* text = qobject_cast<QCPTextElement*>(element); text != nullptr && text->realVisibility())
      texts << text->text();
    const auto* rect = qobject_cast<QCPAxisRect*>(element);
    for (const QCPAxis* axis : rect != nullptr ? rect->axes() : QList<QCPAxis*>()) {
      if (axis->realVisibility()) texts << axis->label();
    }
  }
  return texts;
}

/// Of one widget, whether it is seen or not.
inline Texts textsOf(QWidget& widget) {
  Texts texts{widget.toolTip(), widget.accessibleName()};
  if (const auto* label = qobject_cast<QLabel*>(&widget)) texts << label->text();
  if (const auto* button = qobject_cast<QAbstractButton*>(&widget)) texts << button->text();
  if (const auto* button = qobject_cast<QPushButton*>(&widget); button != nullptr && button->menu() != nullptr) {
    for (const QAction* action : button->menu()->actions()) texts << action->text();
  }
  if (const auto* line = qobject_cast<QLineEdit*>(&widget)) texts << line->placeholderText();
  if (const auto* spin = qobject_cast<QAbstractSpinBox*>(&widget)) texts << spin->text();
  if (auto* plot = qobject_cast<QCustomPlot*>(&widget)) texts += textsInPlot(*plot);
  const auto* box = qobject_cast<QComboBox*>(&widget);
  for (int k = 0; box != nullptr && k < box->count(); ++k) texts << box->itemText(k);
  const auto* list = qobject_cast<QListWidget*>(&widget);
  for (int row = 0; list != nullptr && row < list->count(); ++row)
    texts << list->item(row)->text() << list->item(row)->toolTip()
          << list->item(row)->data(Qt::AccessibleDescriptionRole).toString();
  const auto* view = qobject_cast<QTableView*>(&widget);
  if (view == nullptr) return texts;
  const QAbstractItemModel& model = *view->model();
  for (int column = 0; column < model.columnCount(); ++column) {
    texts << model.headerData(column, Qt::Horizontal).toString();
    for (int row = 0; row < model.rowCount(); ++row) texts << model.index(row, column).data().toString();
  }
  return texts;
}

/// Numbers become #: they go on.
inline Texts visibleTexts(const QWidget& window) {
  static const QRegularExpression number("[-−]?\\d+([.,]\\d+)?(e[-+]?\\d+)?");
  // What was said stays as it was said, reports are English, and numbers come and go here.
  static const QSet<QString> left{"logTable",       "toast",           "messageLine",
                                  "reportChapters", "spectrumReading", "triggerState"};
  Texts texts;
  for (QWidget* widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisible() || widget->window() != &window || left.contains(widget->objectName())) continue;
    for (QString text : textsOf(*widget)) texts << text.replace(number, "#");
  }
  return texts;
}

/// Of all pages; the one that was shown is shown again.
inline PageTexts textsByPage(MainWindow& window) {
  PageTexts texts;
  const QString before = shownPage(window);
  for (const QString& page : pages) {
    window.showPage(page);
    QTest::qWait(250);  // for what comes later: a preview, a list of runs
    texts[page] = visibleTexts(window);
  }
  window.showPage(before);
  return texts;
}

/// Fails with the texts that one has and the other lacks.
inline void compareTexts(const PageTexts& one, const PageTexts& other) {
  for (const QString& page : pages) {
    const QStringList more = (one[page] - other[page]).values(), less = (other[page] - one[page]).values();
    QVERIFY2(more.isEmpty() && less.isEmpty(),
             qPrintable(page + " has: " + more.join(" | ") + "\nand lacks: " + less.join(" | ")));
  }
}

/// Of what is said in both languages, whatever holds an English word.
inline QStringList englishIn(const Texts& german, const Texts& english) {
  static const QRegularExpression word(
      "\\b(the|of|and|is|are|to|with|what|not|no|from|nothing|step|speed|run|open|turn|write|save)\\b",
      QRegularExpression::CaseInsensitiveOption);
  QStringList found;
  for (const QString& text : german& english) {
    if (text.contains(word)) found << text;
  }
  return found;
}

inline QStringList englishIn(const PageTexts& german, const PageTexts& english) {
  QStringList found;
  for (const QString& page : pages) {
    for (const QString& text : englishIn(german[page], english[page])) found << page + ": " + text;
  }
  return found;
}

}  // namespace breakaway::test
