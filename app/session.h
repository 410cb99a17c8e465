// Everything the window shows, without a window: the connection, what runs, what was measured, and the comparison.
#pragma once

#include <QObject>
#include <QString>
#include <QThreadPool>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "axis_job.h"
#include "board_connection.h"
#include "board_tuning.h"
#include "drive_loop.h"
#include "experiment/drive.h"
#include "experiment/homing.h"
#include "experiment/velocity_step.h"
#include "friction_survey.h"
#include "live_history.h"
#include "motor/bench.h"
#include "recording/recording.h"
#include "run.h"

namespace breakaway {

class Session : public QObject {
  Q_OBJECT

 public:
  explicit Session(const DriveLoopOptions& options = {}, QObject* parent = nullptr);
  ~Session() override;

  // The connection. `connectTo` takes a board's URI as openBoard() does: a simulated board is connected on return, one
  // on a port later or never, see connection(). `adopt` takes a drive that is open already.
  void connectTo(const QString& uri, unsigned seed = 1);
  void adopt(std::unique_ptr<Drive> drive, const QString& uri);
  /// Connects as connectTo() does, and lets a simulated board turn slowly.
  void open(const QString& uri);
  void disconnectBoard();
  bool connected() const { return loop_ != nullptr; }
  const BoardConnection& connection() const { return board_; }
  const QString& uri() const { return uri_; }
  const Identity& identity() const { return identity_; }
  bool linear() const { return identity_.axis == Axis::linear; }
  const LinkStatus& link() const { return link_; }
  const LiveHistory& history() const { return history_; }
  /// What the motor is doing, in words for the bar.
  QString stateWords() const;
  bool powered() const;

  /// Passes one line to whoever shows lines.
  void say(const QString& line, bool trouble) { emit said(line, trouble); }

  // Motion. Each start replaces what runs; stop() reaches the I/O thread without waiting for anything.
  void stop();
  void turnSlowly();
  void home(const HomingOptions& options = {});
  void measureStep(const VelocityStepOptions& wanted);
  void identify();
  /// `bins`: of a linear axis, into which its strokes are taken apart.
  void sweepVelocity(double highest_rad_per_s, size_t speeds, double duration_s, size_t bins = 90);
  void sweepBreakaway(size_t bins, size_t turns);
  const RunSnapshot& run() const { return run_; }
  bool runs(RunKind kind) const { return run_.kind == kind && run_.running(); }
  /// Why no motion can be started now; empty when it can.
  QString obstacle() const;
  /// The same for homing, which needs an index around a rotor.
  QString homingObstacle() const;
  /// The same for turnSlowly(), and for measureStep(): a linear axis must know its ends.
  QString turningObstacle() const;
  QString stepObstacle() const;
  /// As fast a step as the homed linear axis has room for.
  std::optional<double> highestStep_m_per_s() const;

  // The controller: settings are asked for, and what the board accepted comes back by settingsChanged().
  void configure(const ControllerSettings& wanted);
  /// Does `job`, which moves nothing, on the board in the I/O thread. Nothing without a board.
  void onBoard(std::function<void(Drive&)> job);
  /// What somebody else has set the board to.
  void takeSettings(const ControllerSettings& settings);
  const ControllerSettings& settings() const { return settings_; }
  /// Tunes to a stiffness from what is known of the motor, in the pool, and asks for the result by configure().
  void tune(Stiffness stiffness);
  /// Why tune() can't begin now; empty when it can.
  QString tuningObstacle() const;
  /// Why no gain can be set; empty when it can.
  QString gainsObstacle() const;
  /// What is known of the motor so far, for tuning.
  KnownMotor motor() const { return knownMotor(settings_, bench_, survey_.identification); }
  /// Margins and αgT of what is set, in one line; empty without a board.
  QString marginLine() const;

  /// Why no sweep can be started now; empty when it can.
  QString sweepObstacle() const;
  /// The same for the breakaway sweep, which a linear axis can't begin with.
  QString breakawayObstacle(size_t bins) const;
  /// How many board seconds pass in one second, for a simulated board.
  void setPace(double pace);
  double pace() const { return pace_; }

  // What was measured since the connection.
  const FrictionSurvey& survey() const { return survey_; }
  /// The bench file that lies beside a simulated board's rig file, if any.
  const std::optional<Bench>& bench() const { return bench_; }
  /// A speed that the supply can reach with room to spare, from what is known of the motor.
  double reachableSpeed_rad_per_s() const;
  /// The index in the board's angle, from homing; the lower end of a linear axis without one.
  const std::optional<Estimate>& index_rad() const { return index_rad_; }
  /// The homed axis as the encoder counts it; nothing on a rotor.
  std::optional<KnownAxis> axis() const;
  /// Every measured step, the newest last.
  const std::vector<StepResult>& steps() const { return steps_; }
  void forgetSteps();

  // A recording of everything at the full rate.
  void startRecording();
  void finishRecording();
  bool recording() const { return recording_; }
  const std::optional<Recording>& lastRecording() const { return lastRecording_; }

 signals:
  void connectionChanged();
  void linkChanged();
  void samplesArrived();
  void runChanged();
  void settingsChanged();
  void recordingChanged();
  void measured();
  void surveyChanged();
  /// One line for the person at the bench; `trouble` when something failed.
  void said(const QString& line, bool trouble);

 private:
  void takeBatch(const SampleBatchPtr& batch);
  void takeLink(const LinkStatus& status);
  void takeTuning(unsigned connection, const Result<ControllerSettings>& tuned);
  void takeRun(const RunSnapshot& snapshot);
  void takeStop(DriveLoop::StopCause cause);
  void takeRecording(const std::shared_ptr<const std::vector<Sample>>& samples);
  void begin(std::unique_ptr<Drive> drive, const QString& uri);
  void letGo();
  void loseBoard(const QString& why);
  void listenToLoop();
  void start(Run run);
  void keepResult(const RunSnapshot& snapshot);
  void keepSurvey(const RunSnapshot& snapshot);
  void estimateSurvey();
  void forgetSurvey();
  void forgetMeasurements();
  Run axisHoming() const;
  std::optional<AxisSweepRequest> axisSweep(size_t bins) const;

  const DriveLoopOptions options_;
  BoardConnection board_;
  unsigned connection_ = 0;
  bool tuning_ = false;
  QTimer heartbeat_;
  QString uri_;
  Identity identity_;
  ControllerSettings settings_;
  LinkStatus link_;
  LiveHistory history_;
  RunSnapshot run_;
  QString lastStop_;
  std::optional<Estimate> index_rad_;
  std::vector<StepResult> steps_;
  FrictionSurvey survey_;
  std::string surveyedDevice_;  ///< the board that the survey was measured on
  unsigned surveyNumber_ = 0;
  std::optional<Bench> bench_;
  double pace_ = 1.0;
  QThreadPool pool_;
  bool recording_ = false;
  std::optional<Recording> lastRecording_;
  std::unique_ptr<DriveLoop> loop_;
};

}  // namespace breakaway
