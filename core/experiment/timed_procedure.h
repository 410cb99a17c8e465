// What all procedures share: a clock that starts with the first sample, one end, a reason for it, and an eye on the
// current sensor.
#pragma once

#include <optional>
#include <string>

#include "experiment/dead_sensor.h"
#include "experiment/drive.h"
#include "experiment/leg.h"

namespace breakaway {

class TimedProcedure : public Procedure {
 public:
  Command step(const Sample& sample) final;
  Status status() const final;
  State state() const final { return state_; }
  void stop(const Saying& reason) final;
  void leaveLegsToDrive() final { legsElsewhere_ = true; }
  const Leg* leg() const final { return leg_ && state_ == State::running ? &*leg_ : nullptr; }
  unsigned legNumber() const final { return legNumber_; }

 protected:
  /// One tick while running.
  virtual Command run(const Sample& sample) = 0;
  /// What status() says of it.
  struct Progress {
    double part = 0.0;  ///< 0 … 1
    double remaining_s = 0.0;
    Saying activity;
  };
  virtual Progress progress() const = 0;
  /// Of a procedure whose whole time is known before.
  static Progress timed(double gone_s, double whole_s, const Saying& activity);

  /// From now on this leg commands, whatever run() returns, until another one or endLeg(). `countsPerRev` of the
  /// encoder; 0: unknown.
  void beginLeg(const Leg& leg, double countsPerRev);
  void endLeg() { leg_.reset(); }
  /// How far the leg is after this sample.
  LegPhase legPhase() const { return phase_; }

  void finish();
  void fail(const Saying& reason);
  /// Whether this is the first sample.
  bool isFirst() const { return first_; }
  /// Time since the first sample.
  double elapsed_s(const Sample& sample) const { return sample.time_s - start_s_; }
  /// Duration of a tick; 0 in the first one.
  double tick_s() const { return tick_s_; }

 private:
  State state_ = State::running;
  Saying failure_;
  double start_s_ = 0.0, last_s_ = 0.0, tick_s_ = 0.0;
  bool begun_ = false, first_ = false, legsElsewhere_ = false;
  std::optional<Leg> leg_;
  std::optional<LegRunner> runner_;
  LegPhase phase_ = notBegun;
  DeadSensor sensor_;
  unsigned legNumber_ = 0;
};

/// "123°" of an angle in rad, taken into one turn.
std::string degreesText(double angle_rad);
/// "counter-clockwise" for growing angle, "forwards" for growing position.
Message wayText(bool ccw, Axis axis = Axis::rotary);
/// "the rotor", or "the axis" where it is a linear one.
Message bodyText(Axis axis);
/// That a load turns it that way by itself.
Message heavyLoadText(bool ccw, Axis axis);

}  // namespace breakaway
