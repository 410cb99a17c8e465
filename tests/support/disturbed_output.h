// What is left of a command's output when the command is killed, the disk is full, or another command writes there,
// too.
#pragma once

#include <QByteArray>
#include <QMap>
#include <QString>
#include <QStringList>

namespace breakaway::test {

/// A command whose output is called "out" and lies in the folder in which it runs.
struct OutputJob {
  enum class Kind { folder, file, lines };
  QString name;
  QStringList words;  ///< of its command line
  Kind kind = Kind::folder;
  QStringList anew = {};  ///< words more after a kill, which give up what the killed run would go on with
};

/// Contents by file name below a folder.
using Contents = QMap<QString, QByteArray>;

/// What is there after a disturbance.
enum class Left {
  whole,   ///< what an undisturbed run leaves, but for times and the run's identifier
  before,  ///< what was there before, byte by byte; or nothing, as before
  half
};

/// How a run ended that was left to itself.
struct Ended {
  int status = -1;  ///< -1: by a signal
  QByteArray said;  ///< on standard error
};

/// A job, its undisturbed output, and trials of it.
class DisturbedOutput {
 public:
  /// `program` is the one that is run.
  DisturbedOutput(QString program, OutputJob job) : program_(std::move(program)), job_(std::move(job)) {}

  /// Runs it twice and keeps the first; the fault in words where it fails or the two differ.
  QString measure();
  qint64 took_ms() const { return took_ms_; }
  qint64 bytes() const { return bytes_; }  ///< on a disk of pages of 4 KB

  /// Each in the folder `place`, in which an earlier run's output may lie.
  void lay(const QString& place) const;  ///< the undisturbed output, as an earlier run's
  void kill(const QString& place, int after_ms) const;
  Ended run(const QString& place, bool anew = false) const;
  /// Two at once; true: the output went to one and the other was refused in one line (a file: both are done).
  bool runTwo(const QString& place) const;
  /// What is left in `place`, where `lay()` came first with `overEarlier`.
  Left left(const QString& place, bool overEarlier) const;
  /// Whether only the output, whole, is in `place`: no part of an earlier run.
  bool onlyWhole(const QString& place) const;
  /// Names of what differs from the undisturbed output.
  QString difference(const QString& place) const;

 private:
  Contents contents(const QString& place) const;
  QByteArray withoutAnew(QByteArray content) const;

  QString program_;
  OutputJob job_;
  Contents undisturbed_, lasting_;  ///< as they are, and without what runs differ in
  qint64 took_ms_ = 0, bytes_ = 0;
};

}  // namespace breakaway::test
