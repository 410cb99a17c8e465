// The runs at the bench: what can be started and why not, what was measured, and what follows for speeds and tuning.
#pragma once

#include <QObject>
#include <QString>
#include <QThreadPool>
#include <optional>
#include <string>
#include <vector>

#include "axis_job.h"
#include "experiment/homing.h"
#include "experiment/velocity_step.h"
#include "friction_survey.h"
#include "motor/bench.h"
#include "session/board_tuning.h"
#include "session/connection.h"
#include "session/messages.h"

namespace breakaway {

class BenchRuns : public QObject {
  Q_OBJECT

 public:
  BenchRuns(Connection& connection, Messages& messages, QObject* parent = nullptr);
  ~BenchRuns() override;

  // Each replaces what runs; see the obstacles.
  void turnSlowly();
  void home(const HomingOptions& options = {});
  void measureStep(const VelocityStepOptions& wanted);
  /// `bins`: of a linear axis, into which its strokes are taken apart.
  void sweepVelocity(double highest_rad_per_s, size_t speeds, double duration_s, size_t bins = 90);
  void sweepBreakaway(size_t bins, size_t turns);

  // Why it can't be started now; empty when it can.
  QString turningObstacle() const;
  QString homingObstacle() const;
  QString stepObstacle() const;
  QString sweepObstacle() const;
  QString breakawayObstacle(size_t bins) const;
  QString gainsObstacle() const;
  QString tuningObstacle() const;

  // What was measured since the connection; the survey outlives it, until another board comes.
  const FrictionSurvey& survey() const { return survey_; }
  /// The index in the board's angle, from homing; the lower end of a linear axis without one.
  const std::optional<Estimate>& index_rad() const { return index_rad_; }
  /// The homed axis as the encoder counts it; nothing on a rotor.
  std::optional<KnownAxis> axis() const;
  /// Every measured step, the newest last.
  const std::vector<StepResult>& steps() const { return steps_; }
  void forgetSteps();

  /// The bench file that lies beside a simulated board's rig file, if any.
  const std::optional<Bench>& bench() const { return bench_; }
  /// A speed that the supply can reach with room to spare, from what is known of the motor.
  double reachableSpeed_rad_per_s() const;
  /// As fast a step as the homed linear axis has room for.
  std::optional<double> highestStep_m_per_s() const;
  /// What is known of the motor so far, for tuning.
  KnownMotor motor() const { return knownMotor(connection_.settings(), bench_, survey_.identification); }
  /// Margins and αgT of what is set, in one line; empty without a board.
  QString marginLine() const;
  /// Tunes to a stiffness from what is known of the motor, in the pool, and asks the board for the result.
  void tune(Stiffness stiffness);

 signals:
  void measured();  ///< index or steps
  void surveyChanged();
  void tuningChanged();

 private:
  void meetBoard();
  void leaveBoard();
  void lineariseBoard();
  void keepResult(const RunSnapshot& snapshot);
  void keepSurvey(const RunSnapshot& snapshot);
  void estimateSurvey();
  void forgetSurvey();
  void takeTuning(unsigned board, const Result<ControllerSettings>& tuned);
  Run axisHoming() const;
  std::optional<AxisSweepRequest> axisSweep(size_t bins) const;

  Connection& connection_;
  Messages& messages_;
  unsigned board_ = 0;  ///< number of the connected one
  std::optional<Bench> bench_;
  std::optional<Estimate> index_rad_;
  std::vector<StepResult> steps_;
  FrictionSurvey survey_;
  std::string surveyedDevice_;  ///< the board that the survey was measured on
  unsigned surveyNumber_ = 0;
  bool tuning_ = false;
  QThreadPool pool_;
};

}  // namespace breakaway
