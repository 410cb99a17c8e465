// Constant speeds both ways: average Coulomb and viscous friction, and both around the rotor.
#pragma once

#include <optional>
#include <vector>

#include "experiment/angle_cells.h"
#include "experiment/index_watch.h"
#include "experiment/timed_procedure.h"
#include "experiment/zeroing.h"
#include "friction/measurements.h"

namespace breakaway {

struct VelocitySweepOptions {
  std::vector<double> speeds_rad_per_s;  ///< positive; each is run ccw and cw
  double countsPerRev = 0.0;             ///< of the encoder; 0: unknown
  double indexAngle_rad = 0.0;           ///< from homing
  size_t bins = 360;
  double settle_s = 0.6;
  double run_s = 15.0;  ///< at least this long, then on to the end of the turn
  size_t leastTurns = 2;
  double wobble = 0.015;   ///< slow triangle on the speed, one per run: without it a steady rotor would meet the
                           ///< encoder's counts and the control tick in step, and their rounding would not average
  size_t blocks = 8;       ///< stretches of whole turns, at most, whose scatter gives the standard errors
  double zeroing_s = 0.5;  ///< the current sensor is zeroed before each run and after the last; 0: never
  double current_limit_A = 0.0;     ///< 0: the controller's own
  double indexTolerance_rad = 0.0;  ///< between the index and where homing found it; 0: not watched
  double mostDrift_A = 0.1;         ///< of the current sensor's zero, from one zeroing to the next
};

/// By how much the samples of a bin lie beyond its middle, where a bin holds whole counts: angles are whole counts,
/// those of the index too where all approaches saw it on the same one.
double beyondBins_rad(double countsPerRev, size_t bins, double indexAngle_rad);

/// Runs each speed over whole turns, as one leg, and sums current and speed per bin of rotor angle. A slow speed at
/// which the rotor only sticks and slips is left out. Fails in words when a speed isn't reached or not held, when the
/// index comes elsewhere or not at all, and when the current sensor drifts.
class VelocitySweep : public TimedProcedure {
 public:
  /// `earlier` are runs of an interrupted sweep; those with the options' speeds and bins are kept. Of a speed that was
  /// broken off only what is left is run.
  explicit VelocitySweep(VelocitySweepOptions options, const std::vector<VelocityRun>& earlier = {});
  /// Those that are complete, and those that were broken off before.
  const std::vector<VelocityRun>& runs() const { return runs_; }
  /// What is complete of the one under way: its whole turns, as if it were broken off now. Nothing before the first,
  /// and of a run that failed.
  const VelocityRun* underWay() const { return underWay_ && state() != State::failed ? &*underWay_ : nullptr; }
  /// Commanded speeds at which the rotor sticks and slips.
  const std::vector<double>& leftOut_rad_per_s() const { return leftOut_rad_per_s_; }
  /// The sensor's zeros on the way.
  const std::vector<ZeroReading>& zeros() const { return zeroing_.readings(); }

 protected:
  Command run(const Sample& sample) override;
  Progress progress() const override;

 private:
  enum class Stage { zero, speed };
  using Machine = SpeedLeg<double>;
  double target() const;
  double targetOf(size_t number) const;
  bool isDone(double target_rad_per_s) const;
  void skipDone();
  bool slips(const Sample& sample) const;
  void goOn(const Sample& sample);
  Command zero(const Sample& sample);
  double wobbleAt(double time_s) const;
  void enter(Stage stage, const Sample& sample);
  void begin();
  void follow(const Sample& sample);
  void beginRun(const Sample& sample);
  void sum(const Sample& sample);
  void keepTurns(double time_s);
  VelocityRun closed(double time_s) const;
  void dateBlocks(VelocityRun& run) const;
  void endRun(const Sample& sample);
  double left_s() const;

  VelocitySweepOptions options_;
  Zeroing zeroing_;
  Stage stage_ = Stage::zero;
  size_t next_ = 0, turnsPerBlock_ = 1, perBin_ = 1;
  std::vector<VelocityRun> runs_;
  std::vector<double> leftOut_rad_per_s_;
  double legStart_s_ = 0.0, legStart_rad_ = 0.0;
  VelocityRun open_;
  std::optional<VelocityRun> underWay_;
  double kept_s_ = 0.0;     ///< when that was taken
  double thisRun_s_ = 0.0;  ///< for so long this run goes on
  double stageStart_s_ = 0.0, now_s_ = 0.0, runStart_s_ = 0.0, startAngle_rad_ = 0.0;
  std::vector<double> angles_rad_, currents_A_;  ///< of the last 2·span_ + 1 samples, in a ring
  std::vector<double> turnEnds_s_;
  std::vector<double> turnSpeeds_rad_per_s_;  ///< mean of each turn of the open run
  double turnAngle_rad_ = 0.0, turnStart_s_ = 0.0;
  size_t span_ = 1, taken_ = 0;
  AngleCells cells_;                    ///< of the open run
  std::vector<AngleCells> blockCells_;  ///< and of its stretches of whole turns
  double mean_rad_per_s_ = 0.0;         ///< smoothed speed
  LegPhase seen_ = notBegun;            ///< of the speed's leg
  IndexWatch index_;
};

}  // namespace breakaway
