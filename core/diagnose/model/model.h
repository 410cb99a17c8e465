// A model of a rig: the base physics and the effects added to it. Enough to simulate without the bench file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motor/bench.h"

namespace breakaway {

/// A fitted quantity, its name ending in its unit, with its 95 % interval; a value that was held has low95 == high95 ==
/// value.
struct Parameter {
  std::string name;
  double value = 0.0;
  double low95 = 0.0;
  double high95 = 0.0;
  bool operator==(const Parameter&) const = default;
};

/// One effect of the catalogue with its parameters, in the catalogue's order.
struct EffectTerm {
  std::string effect;
  std::vector<Parameter> parameters;
  std::string recording = {};  ///< file name of the only one it happens in; empty: it is always there
  bool operator==(const EffectTerm&) const = default;
};

/// A base parameter of measured drives: how much later than it acted a reading shows it, 0 to one row: from its row on,
/// at the row's instant (half a row), as the mean since the row before (a whole one), or between. Nobody writes it
/// down.
constexpr const char* driveLateName = "drive_late_s";
/// A base parameter: a load too small to be a finding, as an amplifier's offset or a cable makes it; Nm or N, against
/// positive motion if positive. A stiff drive at constant speed shows far less than what matters.
constexpr const char* biasName(Axis axis) {
  return axis == Axis::linear ? "bias_N" : "bias_Nm";
}

/// The parameters' values, in the effect's order.
std::vector<double> valuesOf(const EffectTerm& term);
/// Base and effects, `breakaway.model/1`.
struct Model {
  Axis axis = Axis::rotary;
  DriveInput input = DriveInput::torque;
  std::optional<double> supply_V;
  double count = 0.0;  ///< one encoder count in rad or m; 0: not declared
  /// Where a reference drives it, through a law whose gains, limit and delay are base parameters (servoNames()); only
  /// the rate is held here.
  std::optional<ServoLaw> servo;
  std::optional<Pendulum> pendulum;  ///< masses and lengths; its down angle is a base parameter
  double restartHorizon_s = 0.05;    ///< how far a restart looks back, see Simulator::restart()
  std::vector<Parameter> base;
  std::vector<EffectTerm> effects;

  /// The base parameter's value, or nothing.
  std::optional<double> baseValue(const std::string& name) const;
};

}  // namespace breakaway
