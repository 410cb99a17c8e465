// A log as import reads it, and what became of each column.
#pragma once

#include <QStringList>
#include <cmath>
#include <string>

#include "recording/import/import.h"
#include "support/temporary.h"

namespace breakaway::test {

/// Logs in a folder of their own.
class ImportedLogs {
 public:
  Result<Imported> imported(const QString& text) {
    return importRecording(folder_.write("log.csv", text.toStdString()));
  }
  /// A table of these columns, each a wave of its own.
  Result<Imported> waves(const QStringList& names) {
    QString text = "time_s,\"" + names.join("\",\"") + "\"\n";
    for (int k = 0; k < 80; ++k) {
      text += QString::number(0.01 * k);
      for (int c = 0; c < names.size(); ++c) text += QString(",%1").arg((1.0 + 0.1 * c) * std::sin(0.1 * k + c));
      text += "\n";
    }
    return imported(text);
  }

 private:
  TemporaryFolder folder_;
};

/// What the column was taken as; empty where it was set aside.
inline std::string meaning(const Imported& log, const QString& name) {
  for (const ColumnFate& fate : log.columns) {
    if (fate.from == name.toStdString()) return fate.kind == ColumnFate::Kind::used ? fate.to : std::string();
  }
  return "not there";
}

}  // namespace breakaway::test
