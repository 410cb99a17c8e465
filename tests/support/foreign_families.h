// What foreign rigs conceal, and how large: effects of the catalogue, and physics that it lacks.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "support/foreign_concealed.h"
#include "support/foreign_draw.h"
#include "support/foreign_motor.h"
#include "support/foreign_rig.h"

namespace breakaway::test {

/// What a family's rigs must be, beside what they conceal.
struct Family {
  ForeignFamily known;
  bool rotary = false, volts = false, travels = false, quick = false;
  /// Makes it, with its size in words; `length_s` of the recording, `rate_Hz` of its rows.
  std::function<std::string(Concealed&, const Motor&, Draw&, double length_s, double rate_Hz)> conceal;
};

/// In the order of foreignFamilies().
const std::vector<Family>& families();

}  // namespace breakaway::test
