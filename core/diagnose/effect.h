// The seam of the catalogue: everything Breakaway knows about one effect stands in one file behind this interface.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "motor/bench.h"

namespace breakaway {

/// What a term may depend on, at one instant. On a linear axis read m for rad and N for Nm.
struct Situation {
  Axis axis = Axis::rotary;
  double time_s = 0.0;             ///< since the recording's first row
  double position = 0.0;           ///< rad
  double velocity = 0.0;           ///< rad/s
  double acceleration = 0.0;       ///< rad/s²
  double driveTorque = 0.0;        ///< the model's motor torque, never a measured one, Nm
  double knownLoad = 0.0;          ///< torque of the load that the bench declares, Nm; sign as in Term
  double direction = 0.0;          ///< ±1: of motion, or of the motion that is about to start
  double current = 0.0;            ///< the model's motor current, A; 0 where torque drives
  double input = 0.0;              ///< the drive input: V, A or Nm
  double supply_V = 0.0;           ///< of the bridge; 0: not known
  double resistance_ohm = 0.0;     ///< of the winding without the effect; 0: not known
  double rest_s = 0.0;             ///< how long the standstill lasted that ended last, or lasts by now
  double travel = 0.0;             ///< since the last reversal, rad
  double span = 0.0;               ///< how far it moves while this stands for all of a step, rad
  std::span<const double> memory;  ///< the effect's own hidden state, as remember() left it
};

/// What an effect adds to the base physics at one instant.
struct Term {
  double load_Nm = 0.0;      ///< opposes growing position whatever the direction: drive = J a + … + load
  double friction_Nm = 0.0;  ///< opposes motion in `direction`; it also holds at standstill
  double voltage_V = 0.0;    ///< lost before the windings; only where voltage or duty drives
};

/// One parameter of an effect: public name with its unit, and the range in which it makes sense.
struct ParameterSpec {
  std::string name;
  double lower;
  double upper;
  bool held = false;          ///< chosen by the search and then kept, such as an order
  bool freeInTheEnd = false;  ///< but fitted with the last refinement
  double doubt =
      0.01;  ///< relative standard deviation that least squares can't know: no rig keeps to a model more closely
  bool absentAtZero = false;  ///< not fitted while it is 0
};

/// What the search needs to know of the data to offer shapes: ranges seen in the recordings.
struct Excitation {
  Axis axis = Axis::rotary;
  bool electrical = false;        ///< voltage or duty drives
  bool currentDrive = false;      ///< current drives
  bool currentSeen = false;       ///< voltage or duty drives, and the current was recorded, too
  bool supplySeen = false;        ///< the bridge's supply is known
  double supply_V = 0.0;          ///< of the bench, or the recorded one at the first row; 0: not known
  bool bothWays = false;          ///< at least 10 % of the motion goes each way
  double step_s = 0.0;            ///< median time from row to row
  double duration_s = 0.0;        ///< of the longest recording
  double lowSpeed = 0.0;          ///< 10 % quantile of |velocity| while moving, rad/s
  double highSpeed = 0.0;         ///< its 95 % quantile
  double lowest = 0.0;            ///< smallest position, rad
  double highest = 0.0;           ///< largest position, rad
  double travel = 0.0;            ///< their difference
  double count = 0.0;             ///< one encoder count, rad
  double peakTorque = 0.0;        ///< of the drive, 99 % quantile while moving, Nm
  double knownLoad = 0.0;         ///< largest torque of the load that the bench declares, Nm; 0: none
  double peakCurrent = 0.0;       ///< the same of the current, A; 0 where torque drives
  double usualCurrent = 0.0;      ///< its root mean square, A
  double peakInput = 0.0;         ///< largest |drive input|: V, A or Nm
  double peakAcceleration = 0.0;  ///< 99 % quantile, rad/s²
  double longestRest_s = 0.0;     ///< standstill
  int starts = 0;                 ///< from standstill
  int reversals = 0;
  double inertia = 0.0;  ///< of the base model, kg m²
  double coulomb = 0.0;  ///< of the base model, Nm
};

/// A candidate for the search: parameters at a typical size, one set per amplitude that enters linearly (a wave has
/// two: cosine and sine). All sets share the nonlinear parameters.
using Shape = std::vector<std::vector<double>>;

class Effect {
 public:
  virtual ~Effect() = default;

  /// The contract's name.
  virtual std::string_view name() const = 0;
  /// The formula in the notation of resources/help/notation.md, and where it comes from.
  virtual std::string_view formula() const = 0;
  virtual std::string_view source() const = 0;
  virtual std::vector<ParameterSpec> parameters(Axis axis) const = 0;

  // What it does in a simulation; `p` is in the order of parameters(). Each does nothing unless overridden.

  virtual Term term(std::span<const double>, const Situation&) const { return {}; }
  /// Whether it happens in one recording only, at a time of its own.
  virtual bool happensOnce() const { return false; }
  /// Whether several of it may be there at once: waves of different orders, both ends of a travel.
  virtual bool mayRepeat(const Excitation&) const { return false; }
  /// Whether it grows while the axis stands still.
  virtual bool growsAtRest() const { return false; }
  /// Whether term() loses voltage.
  virtual bool losesVoltage() const { return false; }
  /// Numbers of hidden state (temperature, the load's deflection …), at most 4; all start at 0.
  virtual size_t memory() const { return 0; }
  /// Advances the hidden state over dt_s that ended in `at`, whose `memory` is the state before. Must be stable for any
  /// dt_s up to longestStep_s().
  virtual void remember(std::span<const double>, const Situation&, double /*dt_s*/,
                        std::span<double> /*memory*/) const {}
  /// Period in s with which a load swings against the motor, whose place and speed relative to it are the first two
  /// numbers of hidden state: a restart finds them from the measured motion. 0: there is none.
  virtual double loadPeriod_s(std::span<const double>) const { return 0.0; }
  /// The play between that load and the motor, rad.
  virtual double loadPlay(std::span<const double>) const { return 0.0; }
  /// Sets the hidden state for a load at this place and speed relative to a motor that moves at `velocity`.
  virtual void placeLoad(double /*place*/, double /*speed*/, double /*velocity*/, double /*time_s*/,
                         std::span<double> /*memory*/) const {}
  /// The longest step at which term() and remember() stay accurate.
  virtual double longestStep_s(std::span<const double>) const { return 2e-3; }
  /// Inertia that the motor's side loses because a term carries it, kg m².
  virtual double detachedInertia(std::span<const double>) const { return 0.0; }
  /// Coulomb friction that the motor's side loses because a term carries it, Nm.
  virtual double detachedFriction(std::span<const double>) const { return 0.0; }
  /// Stiffness with which friction builds up over a reversal, Nm/rad; 0: friction is rigid.
  virtual double frictionStiffness(std::span<const double>) const { return 0.0; }
  /// Damping while it builds up, as a part of what would be critical for the whole inertia on that stiffness.
  virtual double frictionDampingRatio(std::span<const double>) const { return 0.0; }
  /// The drive input as it acts, in place of `input` (row k acts from time[k] until time[k + 1]); the first rows may
  /// lack their past.
  virtual bool shapesInput(DriveInput) const { return false; }
  virtual void shapeInput(std::span<const double>, std::span<const double> /*time_s*/,
                          std::span<double> /*input*/) const {}
  /// How late the recorded input acts, s: for a winding, whose current follows within a row, better than shapeInput().
  virtual double inputDelay_s(std::span<const double>) const { return 0.0; }
  /// What the encoder shows at a true position.
  virtual double shown(std::span<const double>, double position) const { return position; }
  /// What the current sensor shows, given the true current and its slope in A/s.
  virtual double sensed(std::span<const double>, double current, double /*slope*/) const { return current; }
  /// How much later the current sensor shows what flows, s; sensed() has it to the first order.
  virtual double sensorLag_s(std::span<const double>) const { return 0.0; }

  // What the search asks.

  /// Candidate shapes; empty when the data can't show the effect at all.
  virtual std::vector<Shape> shapes(const Excitation& seen) const = 0;
  /// Parameters at which it is tried in the place of what it looks like, whatever the regression says of it.
  virtual std::vector<std::vector<double>> asRival(const Excitation&) const { return {}; }
  /// Parameters at `amplitude` times the sets of a shape. Without its own: the first parameter is multiplied.
  virtual std::vector<double> scaled(const Shape& shape, std::span<const double> amplitude) const {
    std::vector<double> p = shape.front();
    p.front() *= amplitude.front();
    return p;
  }
  /// Whether these parameters make sense: a searched amplitude of the wrong sign doesn't.
  virtual bool plausible(std::span<const double>, const Excitation&) const { return true; }
  /// Other held parameters worth a fit of their own once the effect is in.
  virtual std::vector<std::vector<double>> variants(std::span<const double>, const Excitation&) const { return {}; }

  // What people read.

  /// What is missing, where it shows and how big it is, in a technician's words, with what to look at.
  virtual std::string sentence(std::span<const double> p, const Excitation& seen) const = 0;
  /// Effects that look the same on poor data.
  virtual std::vector<std::string_view> lookAlikes() const = 0;
  /// Inseparable twin: one and the same thing for a recording; empty for most.
  virtual std::string_view twin() const { return {}; }
  /// The experiment that makes the effect visible, with speeds and amplitudes within what was seen.
  virtual std::string neededExcitation(const Excitation& seen) const = 0;
  /// The axis over which the report draws the term: velocity, angle, time, current, travel, frequency; empty: no curve.
  virtual std::string_view drawnOver() const { return {}; }
};

}  // namespace breakaway
