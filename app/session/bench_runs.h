// The runs at the bench: steps of the bench job, each with what it needs, and what they leave; and motions beside them.
#pragma once

#include <QObject>
#include <QString>
#include <QThreadPool>
#include <map>
#include <optional>
#include <vector>

#include "commission/known.h"
#include "experiment/position_step.h"
#include "experiment/velocity_step.h"
#include "motor/bench.h"
#include "motor/maneuver.h"
#include "session/board_tuning.h"
#include "session/connection.h"
#include "session/hand_drive.h"
#include "session/jog.h"
#include "session/messages.h"

namespace breakaway {

class BenchRuns : public QObject {
  Q_OBJECT

 public:
  BenchRuns(Connection& connection, Messages& messages, QObject* parent = nullptr);
  ~BenchRuns() override;

  // Each replaces what runs; see the obstacles.
  void turnSlowly();
  /// An experiment's, within the board's limits; on a linear axis between its margins.
  void runManeuver(const Maneuver& motion);
  void measureStep(const VelocityStepOptions& wanted);
  /// On a homed linear axis forwards from the lower margin.
  void measureStep(const PositionStepOptions& wanted);
  /// Runs until the grip is let go.
  std::shared_ptr<HandGrip> driveByHand(const HandOptions& options);
  /// One step, as long as the grip is held.
  std::shared_ptr<HandGrip> jog(const JogOptions& options);
  /// Makes what the kind stands for, and before it whatever that needs and isn't known yet: identification, homing,
  /// either sweep (with the breakaway sweep all that the map takes), or a trial: tuning for use and a run with and
  /// without the map. What was interrupted goes on where it ended, unless `sweeps` are others now; what was complete is
  /// made anew.
  void make(RunKind kind, const SweepSettings& sweeps);
  /// With the sweeps' settings as they are: for what doesn't sweep.
  void make(RunKind kind) { make(kind, known_.sweeps); }
  /// What make() begins with, in words: "First: winding test, spin test"; empty when nothing is missing.
  QString missingFor(RunKind kind, const SweepSettings& sweeps) const;
  QString missingFor(RunKind kind) const { return missingFor(kind, known_.sweeps); }

  // Why it can't be started now; empty when it can.
  QString turningObstacle() const;
  QString stepObstacle() const;  ///< of either step
  QString handObstacle() const;
  QString obstacleToMake(RunKind kind) const;
  QString gainsObstacle() const;
  QString tuningObstacle() const;

  /// What the job knows; it outlives the connection. While another board is there, it waits for its own to come back.
  const Commission& known() const { return known_; }
  /// The index in the board's angle, from homing; the lower end of a linear axis without one.
  std::optional<Estimate> index_rad() const;
  /// A linear axis whose ends, index and pace are known.
  bool axisIsHomed() const { return connection_.linear() && known_.knows(Known::index); }
  /// Every measured step on this board, the newest last.
  const std::vector<StepResult>& steps() const { return steps_; }
  void forgetSteps();
  /// What an earlier program measured on this board before it was ended: the next run goes on from it.
  void takeUp(const Commission& earlier);
  /// What the sweeps have measured so far, so that the next ones begin anew.
  void forgetSweeps();

  /// The bench file that lies beside a simulated board's rig file, if any.
  const std::optional<Bench>& bench() const { return bench_; }
  /// As fast a step as the homed linear axis has room for.
  std::optional<double> highestStep() const;
  /// And as long a step in position.
  std::optional<double> longestStep() const;
  /// What is known of the motor so far, for tuning.
  KnownMotor motor() const { return knownMotor(connection_.settings(), bench_, known_); }
  /// Tunes `settings` to a stiffness from what is known of the motor, in the pool; tuned() brings the result. Nothing
  /// is sent to the board.
  void tune(Stiffness stiffness, const ControllerSettings& settings);

 signals:
  void measured();  ///< index or steps
  void knownChanged();
  void tookUp();  ///< with what an earlier program had measured, and its sweeps' settings
  void sweepsForgotten(const std::string& board);  ///< boardName()
  void tuningChanged();
  void tuned(const breakaway::ControllerSettings& settings);

 private:
  void meetBoard();
  void leaveBoard();
  void lineariseBoard();
  template <class Step>
  void measure(RunKind kind, const std::shared_ptr<Step>& step, const VelocityStepOptions& options);
  void keepResult(const RunSnapshot& snapshot);
  void keepKnown(const KnownPtr& now);
  Facts forgottenFor(RunKind kind, const SweepSettings& sweeps) const;
  CommissionOptions optionsWith(const SweepSettings& sweeps) const;
  void takeTuning(unsigned board, const Result<ControllerSettings>& tuned);

  Connection& connection_;
  Messages& messages_;
  unsigned board_ = 0;  ///< number of the connected one
  std::optional<Bench> bench_;
  std::vector<StepResult> steps_;
  Commission known_;
  std::map<std::string, Commission> otherBoards_;  ///< what is known of those that were here before, by boardName()
  KnownPtr last_;                                  ///< that was taken
  bool tookUp_ = false;                            ///< what is known has not been gone on with
  bool tuning_ = false;
  QThreadPool pool_;
};

}  // namespace breakaway
