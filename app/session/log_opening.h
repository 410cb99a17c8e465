// Another tool's log on its way to a recording: as it is understood, as the technician corrects it, and remembered.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <QThreadPool>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "recording/import/import.h"
#include "recording/import/read_table.h"
#include "session/messages.h"

namespace breakaway {

/// One column of the log as it is understood.
struct LogColumn {
  QString name;
  QString to;    ///< the recording's column; empty when it is none of those that mean something
  QString unit;  ///< as import names it
  Message why;
  bool guessed = false;
  std::vector<double> first;  ///< values as the file has them
};

class LogOpening : public QObject {
  Q_OBJECT

 public:
  explicit LogOpening(Messages& messages, QObject* parent = nullptr);
  ~LogOpening() override;

  /// Whether the file has the recording's own form, so that there is nothing to understand.
  static bool isRecording(const QString& path);
  /// Where corrections are remembered, each for logs with the same column names, as maps that `import --map` reads too.
  static QString memory();

  /// Reads in a pool thread and takes what was said of such a log before.
  void open(const QString& path);
  void close();
  /// What becomes of a column; an empty `to` leaves it aside, an empty unit is SI.
  void take(const QString& column, const QString& to, const QString& unit);
  /// What no file says: sample time, counts, pole pairs, gear ratio.
  void say(std::optional<double> ImportMap::*number, std::optional<double> value);
  /// Parts rows by the values of a column, as of several motors; an empty one doesn't. The first part is shown.
  void splitBy(const QString& column);
  /// Shows and opens another part.
  void takePart(int part);
  /// Forgets all corrections of such logs.
  void guessAgain();
  /// Remembers the corrections and hands the recording on. Precondition: fault() is empty.
  void accept();

  bool isOpen() const { return table_ != nullptr; }
  bool settling() const { return settling_; }
  const QString& path() const { return path_; }
  const std::vector<LogColumn>& columns() const { return columns_; }
  const ImportMap& map() const { return map_; }
  /// The values by which the rows are parted; empty when they aren't.
  const QStringList& parts() const { return parts_; }
  int part() const { return part_; }
  const std::vector<Message>& remarks() const { return remarks_; }
  /// Why it is no recording yet, in one line.
  const Message& fault() const { return fault_; }

 signals:
  void changed();
  void accepted(const breakaway::Recording& recording);

 private:
  void settle();
  void show(const Result<Imported>& imported, const QStringList& parts);
  QString memoryFile() const;

  Messages& messages_;
  QThreadPool pool_;
  QString path_;
  std::shared_ptr<const ReadTable> table_;
  ImportMap map_;
  std::optional<Recording> recording_;
  std::vector<LogColumn> columns_;
  std::vector<Message> remarks_;
  QStringList parts_;
  int part_ = 0;
  Message fault_;
  unsigned wanted_ = 0;  ///< number of the newest reading or settling; older answers are not shown
  bool settling_ = false;
};

}  // namespace breakaway
