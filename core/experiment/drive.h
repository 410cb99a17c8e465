// The drive port: all that procedures, the window and the commands know of a board. Everything above sees decoded
// samples only.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "control/board_watch.h"
#include "experiment/identity.h"
#include "experiment/setting_range.h"
#include "motor/duty_curve.h"
#include "recording/sample.h"

namespace breakaway {

/// What the board is to do from its next control tick on.
struct Command {
  enum class Mode { off, voltage, current, velocity, position };
  Mode mode = Mode::off;
  double target = 0.0;           ///< V, A, rad/s or rad by mode; ignored when off (windings open)
  double current_limit_A = 0.0;  ///< further limit for this command; 0: the controller's own
  bool zeroCurrentSensor =
      false;  ///< with mode off: average the sensor while this is set and take the mean as its zero
  bool operator==(const Command&) const = default;
};

/// Friction that the board's controller takes off the shaft by feed-forward, from the map or on average.
struct FrictionCompensation {
  /// Whole motor torque per way (cw, ccw) in angle bins from the index, positive in the way's direction; all four
  /// equally long. One bin is an average, none ends the compensation.
  std::array<std::vector<double>, 2> coulomb_Nm;
  std::array<std::vector<double>, 2> viscous_Nm_s_per_rad;
  /// Likewise what starts motion from standstill, as long as the others, or empty: not known. A board that can't hold
  /// it compensates without.
  std::array<std::vector<double>, 2> static_Nm;
  double stribeck_rad_per_s = 0.0;  ///< speed over which friction falls from static to Coulomb; > 0 with static_Nm
  double indexAngle_rad = 0.0;      ///< as the encoder counts it, from homing
  double span_rad = 0.0;            ///< that the bins cover; 0: a turn
  double blend_rad_per_s = 0.5;     ///< up to this speed the Coulomb torque grows in proportion
  double cutoff_rad_per_s = 0.0;    ///< of a low pass on the whole (compensator B); 0: none
  bool operator==(const FrictionCompensation&) const = default;
};

struct Leg;

/// A pure state machine: sample in, command out, status readable at any time. It runs in the board's control tick, in a
/// simulation faster than real time, or on the host, always the same.
class Procedure {
 public:
  enum class State { running, finished, failed, stopped };
  struct Status {
    State state = State::running;
    double progress = 0.0;     ///< 0 … 1
    double remaining_s = 0.0;  ///< estimate of the time still needed
    Saying activity;           ///< what it does now, in words ("ramping counter-clockwise at 123°")
    Saying failure;            ///< why it ended early, in words; empty otherwise
  };

  virtual ~Procedure() = default;
  /// Called once per control tick. After the end it returns mode off.
  virtual Command step(const Sample& sample) = 0;
  virtual Status status() const = 0;
  /// The status' state alone; cheap enough for every tick.
  virtual State state() const { return status().state; }
  /// Ends the procedure; what it has measured stays.
  virtual void stop(const Saying& reason) = 0;

  /// The drive runs legs itself: from now on it looks after each step() whether there is one, and its samples tell how
  /// far it is. Otherwise step() runs them.
  virtual void leaveLegsToDrive() {}
  /// What a board is to run by itself now, in place of step()'s command; null: nothing.
  virtual const Leg* leg() const { return nullptr; }
  /// Another number for each leg.
  virtual unsigned legNumber() const { return 0; }
};

class Drive {
 public:
  virtual ~Drive() = default;
  virtual const Identity& identity() const = 0;
  virtual ControllerSettings settings() const = 0;
  /// What the board lets each setting be, in the order of profileParameters(); empty: it doesn't say.
  virtual std::vector<SettingRange> settingRanges() const { return {}; }
  /// Asks for settings; returns those that were accepted (clamped to the board's limits), or why not.
  virtual Result<ControllerSettings> configure(const ControllerSettings& wanted) = 0;
  /// From now on current, velocity and position commands add this friction's torque, until another one comes. Errors:
  /// values that aren't finite, lengths that differ, more bins than the board can hold, a board that can't do it.
  virtual Result<void> compensate(const FrictionCompensation&) {
    return Error{"board", "takes no friction compensation"};
  }
  /// From now on every voltage is asked for through the inverse of the bridge's curve, until another one comes; an
  /// unknown curve ends it. Samples still show what the bridge is asked for. Errors: a curve that doesn't rise, more
  /// points than the board can hold, a board that can't do it.
  virtual Result<void> linearise(const DutyCurve&) { return Error{"board", "takes no curve of its bridge"}; }
  /// What compensate() has left on the board, as the board holds it; empty when nothing is compensated.
  virtual Result<FrictionCompensation> compensation() { return Error{"board", "takes no friction compensation"}; }
  /// Holds until the next command; ends a running procedure.
  virtual void command(const Command& command) = 0;
  /// Runs a procedure, on the board where it can. It stays readable from the thread that calls advance().
  virtual void start(std::shared_ptr<Procedure> procedure) = 0;
  /// Stops the motor at once, whatever runs: windings open, procedure stopped, latched until the next command or start.
  virtual void stop(const Saying& reason) = 0;
  /// For what the board's watch opened the windings and ended the last procedure; none: that ended otherwise, or the
  /// board doesn't say.
  virtual Trip tripped() const { return Trip::none; }
  /// Lets `duration_s` of board time pass (a simulated board computes it; a real one waits) and appends the samples of
  /// every control tick. Returns the count of samples that were lost on the way.
  virtual Result<size_t> advance(double duration_s, std::vector<Sample>& samples) = 0;
};

}  // namespace breakaway
