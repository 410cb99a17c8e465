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
  double time_s = 0.0;        ///< since the recording's first row
  double position = 0.0;      ///< rad
  double velocity = 0.0;      ///< rad/s
  double acceleration = 0.0;  ///< rad/s²
  double driveTorque = 0.0;   ///< the model's motor torque, never a measured one, Nm
  double direction = 0.0;     ///< ±1: of motion, or of the motion that is about to start
};

/// What an effect adds to the base physics.
struct Term {
  double load_Nm = 0.0;      ///< opposes growing position whatever the direction: drive = J a + … + load
  double friction_Nm = 0.0;  ///< opposes motion in `direction`; it also holds at standstill
};

/// One parameter of an effect: public name with its unit, and the range in which it makes sense.
struct ParameterSpec {
  std::string name;
  double lower;
  double upper;
  bool held = false;  ///< chosen by the search and then kept, such as an order
};

/// What the search needs to know of the data to offer shapes: ranges seen in the recordings.
struct Excitation {
  Axis axis = Axis::rotary;
  double lowSpeed = 0.0;    ///< 10 % quantile of |velocity| while moving, rad/s
  double highSpeed = 0.0;   ///< its 95 % quantile
  double travel = 0.0;      ///< largest minus smallest position, rad
  double count = 0.0;       ///< one encoder count, rad
  double peakTorque = 0.0;  ///< of the drive, Nm
  bool bothWays = false;    ///< at least 10 % of the motion goes each way
};

/// Fixed nonlinear parameters of a candidate, such as an order or a Stribeck velocity.
using Shape = std::vector<double>;

class Effect {
 public:
  virtual ~Effect() = default;

  /// The contract's name.
  virtual std::string_view name() const = 0;
  /// The formula in the notation of resources/help/notation.md, and where it comes from.
  virtual std::string_view formula() const = 0;
  virtual std::string_view source() const = 0;
  virtual std::vector<ParameterSpec> parameters(Axis axis) const = 0;

  /// The term at one instant; `p` in the order of parameters().
  virtual Term term(std::span<const double> p, const Situation& at) const = 0;

  /// Candidate shapes for the search; empty when the data can't show the effect at all.
  virtual std::vector<Shape> shapes(const Excitation& seen) const = 0;
  /// Number of amplitudes that enter linearly, given a shape.
  virtual size_t amplitudes() const = 0;
  /// The term's derivative by each amplitude: torque that opposes growing position, Nm per unit of amplitude.
  virtual void columns(const Shape& shape, const Situation& at, std::span<double> out) const = 0;
  /// The shape behind given parameters.
  virtual Shape shapeOf(std::span<const double>) const { return {}; }
  /// Parameters from a shape and its amplitudes.
  virtual std::vector<double> fromAmplitudes(const Shape& shape, std::span<const double> amplitude) const = 0;

  /// Other held parameters worth a fit of their own once the effect is in.
  virtual std::vector<std::vector<double>> variants(std::span<const double>) const { return {}; }

  /// What is missing, where it shows and how big it is, in a technician's words.
  virtual std::string sentence(std::span<const double> p, const Excitation& seen) const = 0;
  /// Effects that look the same on poor data.
  virtual std::vector<std::string_view> lookAlikes() const = 0;
  /// Inseparable twin: one and the same thing for a recording; empty for most.
  virtual std::string_view twin() const { return {}; }
  /// The experiment that makes the effect visible.
  virtual std::string neededExcitation(const Excitation& seen) const = 0;
};

}  // namespace breakaway
