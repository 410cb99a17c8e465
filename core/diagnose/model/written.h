// An effect written down for other programs, once and in no language of theirs; and what a robot's joint can hold of
// it.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace breakaway {

/// Formulas in the notation of export/portable/program.h, which reads like C. Parameters are p0, p1, … in the order of
/// Effect::parameters(); what they may depend on is called as in Situation: time_s, position, velocity, acceleration,
/// drive, known_load, direction, current, drive_input, supply_V, resistance, rest_s, span; and what it remembers m0,
/// m1, … Empty texts: nothing.
struct Written {
  std::string load = {};                 ///< as Term::load_Nm
  std::string drag = {};                 ///< likewise, where it is friction by its nature
  std::string friction = {};             ///< as Term::friction_Nm
  std::string voltage = {};              ///< as Term::voltage_V
  std::vector<std::string> memory = {};  ///< names of m0, m1, …, with their unit; they begin at 0
  std::string remember = {};             ///< statements that advance them by dt_s, as HiddenState::remember()
  std::string input = {};                ///< statements that make of drive_input what acts over dt_s
  std::string delay = {};                ///< by which the input acts late, s
  std::string shown = {};                ///< what the encoder shows at `position`
  std::string sensed = {};               ///< what the current's sensor shows at `current`
  std::string functions = {};            ///< of its own, called by the above
  std::string lacking = {};              ///< why it is not written down; empty: it is
};

/// What a joint of a robot simulator could be told of an effect. On a linear axis read N for Nm and m for rad.
struct JointShare {
  struct Stop {
    double place = 0.0;  ///< rad
    double side = 1.0;   ///< +1: at the upper end
  };
  double constantLoad = 0.0;              ///< Nm, as Term::load_Nm
  double breakaway = 0.0;                 ///< by which friction exceeds sliding at standstill, Nm
  double inputOffset = 0.0;               ///< by which the drive's input acts less than it says, in its unit
  std::optional<double> inputLimit = {};  ///< of |input|, in its unit
  std::optional<Stop> stop = {};
  std::string rest = {};  ///< what is lost of it all the same; empty: nothing
};

}  // namespace breakaway
