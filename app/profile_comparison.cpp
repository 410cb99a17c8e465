#include "profile_comparison.h"

#include <QFileInfo>
#include <QPointer>

namespace breakaway {

ProfileComparison::ProfileComparison(Session& session, QObject* parent) : QObject(parent), session_(session) {
  connect(&session_, &Session::connectionChanged, this, &ProfileComparison::forget);
  connect(&session_, &Session::settingsChanged, this, &ProfileComparison::compare);
}

QString ProfileComparison::obstacle() const {
  if (!session_.connected()) return tr("No board is connected");
  return session_.linear() ? tr("Profiles are of a rotor's board; this one moves a linear axis") : QString();
}

QString ProfileComparison::source() const {
  if (!profile_) return {};
  return tr("%1, saved from %2 (%3)")
      .arg(QFileInfo(path_).fileName(), QString::fromStdString(profile_->device),
           QString::fromStdString(profile_->firmware));
}

void ProfileComparison::forget() {
  if (session_.connected() || !profile_) return;
  profile_.reset();
  rows_.clear();
  emit changed();
}

void ProfileComparison::save(const QString& path) {
  session_.onBoard([session = &session_, path](Drive& board) {
    const auto here = profileOf(board);
    const auto written = here ? writeProfile(*here, path.toStdString()) : Result<void>(here.error());
    QMetaObject::invokeMethod(
        session,
        [session, path, written] {
          session->say(written ? tr("%1 is written").arg(path) : QString::fromStdString(written.error().message()),
                       !written);
        },
        Qt::QueuedConnection);
  });
}

void ProfileComparison::open(const QString& path) {
  auto read = readProfile(path.toStdString());
  if (!read) return session_.say(QString::fromStdString(read.error().message()), true);
  path_ = path;
  profile_ = std::move(*read);
  rows_.clear();
  compare();
}

void ProfileComparison::compare() {
  if (!profile_) return;
  // The answer comes to the session, which lives longer than this.
  session_.onBoard([session = &session_, self = QPointer(this)](Drive& board) {
    const auto here = profileOf(board);
    QMetaObject::invokeMethod(
        session,
        [self, here] {
          if (self) self->takeComparison(here);
        },
        Qt::QueuedConnection);
  });
}

void ProfileComparison::takeComparison(const Result<Profile>& here) {
  if (!here) return session_.say(QString::fromStdString(here.error().message()), true);
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
  if (session_.index_rad()) options.index_rad = session_.index_rad()->value;
  options.anyBoard = true;  // the person has seen whose it is, and has chosen parameter by parameter
  session_.onBoard([session = &session_, self = QPointer(this), options, profile = *profile_](Drive& board) {
    const auto restored = restoreProfile(board, profile, options);
    QMetaObject::invokeMethod(
        session,
        [self, restored, settings = board.settings()] {
          if (self) self->takeRestored(restored, settings);
        },
        Qt::QueuedConnection);
  });
}

void ProfileComparison::takeRestored(const Result<std::vector<RestoredRow>>& restored,
                                     const ControllerSettings& settings) {
  if (!restored) return session_.say(QString::fromStdString(restored.error().message()), true);
  size_t otherwise = 0;
  for (const RestoredRow& one : *restored) {
    if (!one.same) ++otherwise;
    for (Row& row : rows_) {
      if (row.values.name == one.name) row.accepted = QString::fromStdString(one.accepted);
    }
  }
  session_.say(otherwise == 0 ? tr("The board accepted all that was asked for")
                              : tr("The board took %1 of %2 parameters otherwise than asked for: see the table")
                                    .arg(otherwise)
                                    .arg(restored->size()),
               otherwise > 0);
  session_.takeSettings(settings);  // which compares again
}

}  // namespace breakaway
