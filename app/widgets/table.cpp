#include "widgets/table.h"

#include <QHeaderView>
#include <QTableWidget>

namespace breakaway {

namespace {
constexpr int tableRowHeight = 24;
}  // namespace

void dressAsReadTable(QTableWidget& table, const char* objectName, const QString& accessibleName,
                      const QStringList& columns, const QList<int>& words) {
  table.setColumnCount(static_cast<int>(columns.size()));
  table.setObjectName(objectName);
  table.setAccessibleName(accessibleName);
  table.setHorizontalHeaderLabels(columns);
  for (int column = 0; column < table.columnCount(); ++column)
    table.horizontalHeaderItem(column)->setTextAlignment((words.contains(column) ? Qt::AlignLeft : Qt::AlignRight) |
                                                         Qt::AlignVCenter);
  table.setShowGrid(false);
  table.setEditTriggers(QAbstractItemView::NoEditTriggers);
  table.setSelectionBehavior(QAbstractItemView::SelectRows);
  table.setAlternatingRowColors(true);
  table.setCornerButtonEnabled(false);
  table.setTabKeyNavigation(false);
  table.verticalHeader()->hide();
  table.verticalHeader()->setDefaultSectionSize(tableRowHeight);
  table.horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table.horizontalHeader()->setHighlightSections(false);
}

QTableWidget* readTable(QWidget* parent, const char* objectName, const QString& accessibleName,
                        const QStringList& columns, const QList<int>& words) {
  auto* table = new QTableWidget(parent);
  dressAsReadTable(*table, objectName, accessibleName, columns, words);
  return table;
}

void fillRow(QTableWidget& table, int row, const QStringList& cells) {
  for (int column = 0; column < cells.size(); ++column) {
    auto* item = new QTableWidgetItem(cells[column]);
    item->setData(Qt::TextAlignmentRole, table.horizontalHeaderItem(column)->data(Qt::TextAlignmentRole));
    table.setItem(row, column, item);
  }
}

}  // namespace breakaway
