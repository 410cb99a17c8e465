// The seam of the catalogue: everything Breakaway knows about one effect stands in one file behind this interface.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "diagnose/model/excitation.h"
#include "diagnose/model/situation.h"
#include "motor/bench.h"

namespace breakaway {

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
