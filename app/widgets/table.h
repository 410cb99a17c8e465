// Tables that are read, not edited: numbers at the right, words at the left, each under the name of its column.
#pragma once

#include <QList>
#include <QString>
#include <QStringList>

class QTableWidget;
class QWidget;

namespace breakaway {

/// Makes `table` one of them. `words`: columns that hold words; the others hold numbers.
void dressAsReadTable(QTableWidget& table, const char* objectName, const QString& accessibleName,
                      const QStringList& columns, const QList<int>& words = {0});
QTableWidget* readTable(QWidget* parent, const char* objectName, const QString& accessibleName,
                        const QStringList& columns, const QList<int>& words = {0});
/// Cells stand as the names of their columns do.
void fillRow(QTableWidget& table, int row, const QStringList& cells);

}  // namespace breakaway
