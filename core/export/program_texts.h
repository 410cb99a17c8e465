// What a model's own functions say, in the notation of portable programs.
#pragma once

#include <string>
#include <vector>

#include "diagnose/model/written.h"
#include "export/motion_text.h"
#include "motor/bench.h"

namespace breakaway {

/// What the texts need to know of a model.
struct WrittenModel {
  Axis axis = Axis::rotary;
  DriveInput input = DriveInput::torque;
  bool byReference = false;  ///< a servo's law drives
  MotionKind motion = {};
  bool gravity = false;             ///< of a declared pendulum
  bool rounds = false;              ///< the encoder's count is known
  double torquePerInput = 1.0;      ///< Nm per unit of the input
  std::vector<Written> terms = {};  ///< with the names of their parameters and memory in this model
  std::string delay = {};           ///< by which the input is late; empty: not
  bool inPieces = false;            ///< a late input acts in pieces of a step; else means over it will do
};

/// Whether `text` asks for a name.
bool mentions(const std::string& text, const std::string& name);

// How states and arguments are called.
std::string placeName(Axis axis);
std::string speedName(Axis axis);

/// The forces and the history that motionText() calls, and the shown functions: friction(), load(), reading(), step(),
/// and where voltage or duty drives coast() and current_reading(). Names are inner ones, but for arguments and results
/// of what is shown.
std::string functionTexts(const WrittenModel& of);

}  // namespace breakaway
