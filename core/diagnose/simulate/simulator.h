// A model run along a track: the drive input as it acts, the motion, and what encoder and current sensor show of it.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "diagnose/model/model.h"
#include "diagnose/simulate/drive_reading.h"
#include "diagnose/simulate/servo_drive.h"
#include "diagnose/simulate/stepper.h"
#include "diagnose/simulate/track.h"

namespace breakaway {

/// Runs rows [from, to] of a track. Rows up to a quarter of a second on both sides are read for inputs that act late or
/// were recorded late; measured positions are read by restart() alone.
class Simulator {
 public:
  /// Precondition: termsOf(model) succeeds; `track` outlives the simulator.
  Simulator(const Model& model, const Track& track, size_t from, size_t to);
  Simulator(const Physics& physics, std::vector<CompiledTerm> terms, double horizon_s, const Track& track, size_t from,
            size_t to, std::optional<ServoDrive> servo = {});

  const Physics& physics() const { return stepper_.physics(); }
  const Stepper& stepper() const { return stepper_; }
  /// The same with the supply of a row, which is all that its forces know of where they are.
  const Stepper& stepperAt(size_t row) {
    stepper_.setSupply(track_.supplyAt(row));
    return stepper_;
  }
  const Track& track() const { return track_; }

  /// The state at `row` from measurements in rows up to and including it: a moving-horizon observer. The model runs
  /// along the last `horizon_s` of drive input; the position and velocity at its begin and a constant load, for what
  /// the model lacks, that fit the measured positions best (least squares, two Gauss–Newton steps) give the state. The
  /// load ends there. Where more than three times the reading noise is left, shorter horizons are tried. At the first
  /// row the axis is taken to rest. Hidden state is taken over from `carried`; a load that swings is found like
  /// position and velocity, over at least one and a half of its periods.
  MotionState restart(size_t row, const MotionState& carried);
  /// A load that swings against the motor (Effect::load()).
  struct SwingingLoad {
    CompiledTerm term;
    TwoMass load;
    size_t memory = 0;  ///< where its numbers begin in a state's hidden ones
    size_t size = 0;    ///< how many they are
  };
  const std::vector<SwingingLoad>& loads() const { return loads_; }
  /// How far back a restart looks, s.
  double horizon_s() const { return horizon_; }
  /// Places a load relative to the motor's present motion.
  static void place(const SwingingLoad& load, double place, double speed, double time_s, MotionState& state);
  /// Runs the state from one row to another.
  void run(MotionState& state, size_t from, size_t to);

  /// The drive input that acts from `row` on; where a servo's law answers to the motion, for this one in the middle of
  /// the row, as if it had been steady before.
  double input(size_t row, double position = 0.0, double velocity = 0.0) const;
  /// Whether that may be another than the recorded one.
  bool changesInput() const { return servo_ || !shaped_.empty(); }
  /// The law of a servo that a reference drives.
  const std::optional<ServoDrive>& servo() const { return servo_; }
  /// What the encoder shows at a state, and the true position behind what it shows.
  double shown(double position) const;
  /// What the track's sensor shows of a state: its position as `shown`, or its velocity where that alone was measured.
  double reading(const MotionState& state) const {
    return track_.speedAlone() ? state.velocity : shown(state.position);
  }
  double truePosition(double shown) const;
  /// What the current sensor shows.
  double sensed(double current, double slope) const;
  /// How much later than it flows the sensor shows a current, s; with the run at hand better than by `slope` above.
  double sensorLag_s() const;

 private:
  /// Where in its play a load is looked for; `followed`: where it is if it follows the encoder's readings.
  enum class Side { followed, middle, low, high };
  /// The observer over one horizon; `error` is what it leaves of the measured positions, rms.
  MotionState restartOver(double horizon_s, size_t row, const MotionState& carried, Side side, double& error);
  /// Place and speed of a load that has followed the encoder's readings up to `row`.
  Eigen::Vector2d followed(const SwingingLoad& load, size_t row) const;
  size_t horizonBegin(double horizon_s, size_t row) const;
  double settledCurrent(size_t row, double velocity) const;
  void shapeInput(size_t from, size_t to);
  void runLate(MotionState& state, size_t row);
  void runServo(MotionState& state, size_t row);
  PastMotion motionAt(double t, const MotionState& state, double now_s, size_t row) const;

  Stepper stepper_;
  std::optional<ServoDrive> servo_;
  std::vector<SwingingLoad> loads_;
  const Track& track_;
  double horizon_;
  size_t shapedFrom_ = 0;
  std::vector<double> shaped_;  ///< empty: as recorded
  std::optional<DriveReading> reading_;
  double delay_s_ = 0.0;  ///< with which the recorded input reaches a winding
};

/// Standard deviation of the velocity that restart() finds, from the track's reading noise alone: the end of a parabola
/// through n readings over `horizon_s` has a slope error of σ·√192/(√n·horizon), that of
/// a line through n speeds an error of 2σ/√n.
double restartVelocityNoise(const Track& track, double horizon_s);

/// Rows at which windows of `window_s` begin: the first with t ≥ k·window_s − 1e-9 s.
std::vector<size_t> restartRows(const Track& track, double window_s);

}  // namespace breakaway
