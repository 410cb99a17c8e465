#include "session/profile_comparison.h"

#include <QFileInfo>
#include <QPointer>

namespace breakaway {

ProfileComparison::ProfileComparison(Connection& connection, const BenchRuns& bench, Messages& messages,
                                     QObject* parent)
    : QObject(parent), connection_(connection), bench_(bench), messages_(messages) {
  connect(&connection_, &Connection::changed, this, &ProfileComparison::forget);
  connect(&connection_, &Connection::settingsChanged, this, &ProfileComparison::compare);
}

QString profileObstacle(const Connection& connection) {
  if (!connection.connected()) return ProfileComparison::tr("No board is connected");
  return connection.linear()
             ? ProfileComparison::tr("Profiles are for boards with a rotor; this one moves a linear axis")
             : QString();
}

QString ProfileComparison::source() const {
  if (!profile_) return {};
  return tr("%1, saved from %2 (%3)")
      .arg(QFileInfo(path_).fileName(), QString::fromStdString(profile_->device),
           QString::fromStdString(profile_->firmware));
}

void ProfileComparison::forget() {
  if (connection_.connected() || !profile_) return;
  profile_.reset();
  rows_.clear();
  emit changed();
}

void ProfileComparison::save(const QString& path) {
  connection_.onBoard([messages = &messages_, path](Drive& board) {
    const auto here = profileOf(board);
    const auto written = here ? writeProfile(*here, path.toStdString()) : Result<void>(here.error());
    QMetaObject::invokeMethod(
        messages, [messages, path, written] { messages->say(written, tr("%1 is written").arg(path)); },
        Qt::QueuedConnection);
  });
}

void ProfileComparison::open(const QString& path) {
  auto read = readProfile(path.toStdString());
  if (!read) return messages_.warn(read.error());
  path_ = path;
  profile_ = std::move(*read);
  rows_.clear();
  compare();
}

void ProfileComparison::compare() {
  if (!profile_) return;
  // The answer comes to the messages, which live longer than this.
  connection_.onBoard([messages = &messages_, self = QPointer(this)](Drive& board) {
    const auto here = profileOf(board);
    QMetaObject::invokeMethod(
        messages,
        [self, here] {
          if (self) self->takeComparison(here);
        },
        Qt::QueuedConnection);
  });
}

void ProfileComparison::takeComparison(const Result<Profile>& here) {
  if (!here) return messages_.warn(here.error());
  if (!profile_) return;
  std::vector<Row> rows;
  for (const ProfileRow& one : compareProfiles(*here, *profile_)) {
    QString accepted;
    for (const Row& before : rows_) {
      if (before.values.name == one.name) accepted = before.accepted;
    }
    rows.push_back({one, accepted});
  }
  rows_ = std::move(rows);
  emit changed();
}

void ProfileComparison::restore(const QStringList& names) {
  if (!profile_ || names.isEmpty()) return;
  RestoreOptions options;
  for (const QString& one : names) options.only.push_back(one.toStdString());
  if (bench_.index_rad()) options.index_rad = bench_.index_rad()->value;
  options.anyBoard = true;  // the person has seen whose it is, and has chosen parameter by parameter
  connection_.onBoard([messages = &messages_, self = QPointer(this), options, profile = *profile_](Drive& board) {
    const auto restored = restoreProfile(board, profile, options);
    QMetaObject::invokeMethod(
        messages,
        [self, restored, settings = board.settings()] {
          if (self) self->takeRestored(restored, settings);
        },
        Qt::QueuedConnection);
  });
}

void ProfileComparison::takeRestored(const Result<std::vector<RestoredRow>>& restored,
                                     const ControllerSettings& settings) {
  if (!restored) return messages_.warn(restored.error());
  size_t otherwise = 0;
  for (const RestoredRow& one : *restored) {
    if (!one.same) ++otherwise;
    for (Row& row : rows_) {
      if (row.values.name == one.name) row.accepted = QString::fromStdString(one.accepted);
    }
  }
  if (otherwise == 0) {
    messages_.say(tr("The board accepted all that was asked for"));
  } else {
    messages_.warn(tr("The board took %1 of %2 parameters otherwise than asked for: see the table")
                       .arg(otherwise)
                       .arg(restored->size()));
  }
  connection_.takeSettings(settings);  // which compares again
}

}  // namespace breakaway
