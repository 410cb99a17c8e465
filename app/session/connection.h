// The board that the window is connected to: how it is reached, what it is and accepted, what it runs, and its stop.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <memory>
#include <vector>

#include "experiment/drive.h"
#include "session/board_opener.h"
#include "session/drive_loop.h"
#include "session/messages.h"
#include "session/run.h"
#include "session/sample_batch.h"

namespace breakaway {

class Connection : public QObject {
  Q_OBJECT

 public:
  explicit Connection(Messages& messages, const DriveLoopOptions& options = {}, QObject* parent = nullptr);

  /// `uri` as openBoard() takes it. A simulated board is connected on return, one on a port later or never: see
  /// state().
  void open(const QString& uri, unsigned seed = 1);
  /// Takes a drive that is open already.
  void adopt(std::unique_ptr<Drive> drive, const QString& uri);
  /// Stops the motor and lets the board go, or ends the trying.
  void close();
  bool connected() const { return loop_ != nullptr; }
  ConnectionState state() const { return opener_.state(); }
  /// Why it failed or was lost, in one line; empty otherwise.
  const Message& trouble() const { return opener_.trouble(); }
  /// Of the board that was asked for last.
  const QString& uri() const { return uri_; }
  /// Of the connected board; a default one without.
  const Identity& identity() const { return identity_; }
  /// Why the last board's link was lost, while that is so; empty where it was let go, or another one has come.
  const Message& loss() const { return loss_; }
  bool linear() const { return identity_.axis == Axis::linear; }
  const LinkStatus& link() const { return link_; }

  /// Reaches the I/O thread without waiting for anything.
  void stop();
  /// Replaces what runs. Nothing without a board.
  void start(Run run);
  const RunSnapshot& run() const { return run_; }
  /// Something was started since the board came.
  bool hasRun() const { return hasRun_; }
  bool runs(RunKind kind) const { return run_.kind == kind && run_.running(); }
  /// Windings powered in the newest sample.
  bool powered() const { return powered_; }
  /// What the motor is doing, in words for the bar.
  QString stateWords() const;
  /// Why no motion can be started now; empty when it can.
  QString obstacle() const;

  /// Settings are asked for, and what the board accepted comes back by settingsChanged().
  void configure(const ControllerSettings& wanted);
  /// What somebody else has set the board to.
  void takeSettings(const ControllerSettings& settings);
  const ControllerSettings& settings() const { return settings_; }
  /// What the board lets one be; without a bound where it names none, nothing offered without a board.
  SettingRange rangeOf(double ControllerSettings::*setting) const;
  /// Does `job`, which moves nothing, on the board in the I/O thread. Nothing without a board.
  void onBoard(std::function<void(Drive&)> job);

  /// Gives every sample from now on to the recorder, until finishRecording() or the link's end.
  void startRecording(std::shared_ptr<Recorder> recorder);
  void finishRecording();

  /// How many board seconds pass in one second, for a simulated board.
  void setPace(double pace);

 signals:
  /// A board is connected, or no longer: before changed(), for those that keep what belongs to a board.
  void came();
  void left();
  void changed();
  void linkChanged();
  void settingsChanged();
  /// What runs has come further or ended: before runChanged(), for those that keep its results.
  void runReported(const breakaway::RunSnapshot& snapshot);
  void runChanged();
  void samplesCame(const breakaway::SampleBatchPtr& batch);

 private:
  void begin(std::unique_ptr<Drive> drive);
  void listenToLoop();
  void letGo();
  void loseBoard(const Message& why);
  void takeRun(const RunSnapshot& snapshot);
  void takeStop(DriveLoop::StopCause cause);

  Messages& messages_;
  const DriveLoopOptions options_;
  BoardOpener opener_;
  QTimer heartbeat_;
  QString uri_;
  unsigned number_ = 0;  ///< of boards that came
  Identity identity_;
  ControllerSettings settings_;
  std::vector<SettingRange> ranges_;
  LinkStatus link_;
  RunSnapshot run_;
  bool hasRun_ = false;
  const char* lastStop_ = nullptr;  ///< for tr(): how it ended, if it was stopped
  Message loss_;
  bool powered_ = false;
  double pace_;
  std::unique_ptr<DriveLoop> loop_;  // last: it ends before what it reports to
};

}  // namespace breakaway
