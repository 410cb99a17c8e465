// What the board is set to beside what a profile holds: saved, opened, compared, and given back in part.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "experiment/profile.h"
#include "session/bench_runs.h"
#include "session/connection.h"
#include "session/messages.h"

namespace breakaway {

/// Why a profile can't be saved or opened now; empty when it can.
QString profileObstacle(const Connection& connection);

class ProfileComparison : public QObject {
  Q_OBJECT

 public:
  ProfileComparison(Connection& connection, const BenchRuns& bench, Messages& messages, QObject* parent = nullptr);

  /// Reads what the board is set to and writes it to `path`.
  void save(const QString& path);
  /// Reads a profile and compares it with what the board is set to now.
  void open(const QString& path);
  /// Asks the board for the profile's values of these parameters, and compares again.
  void restore(const QStringList& names);

  /// One parameter of the open profile; `accepted` is what the board took when it was restored, empty before.
  struct Row {
    ProfileRow values;
    QString accepted;
  };
  const std::vector<Row>& rows() const { return rows_; }
  /// Where the profile came from: file, board and firmware.
  QString source() const;

 signals:
  void changed();

 private:
  void compare();
  void takeComparison(const Result<Profile>& here);
  void takeRestored(const Result<std::vector<RestoredRow>>& restored, const ControllerSettings& settings);
  void forget();

  Connection& connection_;
  const BenchRuns& bench_;
  Messages& messages_;
  QString path_;
  std::optional<Profile> profile_;
  std::vector<Row> rows_;
};

}  // namespace breakaway
