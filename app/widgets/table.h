// Tables that are read, not edited: right-aligned numbers under named columns.
#pragma once

#include <QString>
#include <QStringList>

class QTableWidget;
class QWidget;

namespace breakaway {

QTableWidget* readTable(QWidget* parent, const char* objectName, const QString& accessibleName,
                        const QStringList& columns);
void fillRow(QTableWidget& table, int row, const QStringList& cells);

}  // namespace breakaway
