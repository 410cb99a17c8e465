// What a model remembers of commands and motion, in the notation of portable programs.
#pragma once

#include <string>

namespace breakaway {

/// What was commanded earlier: note_input(&s, value), input_index(s, time), input_mean(s, from, to), and
/// advance_late(&s, delay, supply, dt), which goes on in the pieces in which a late input acts; `size` values are kept.
std::string delayText(size_t size);

/// What a servo's law needs: note_reference(&s, place, speed), reference_index(), reference_mean(s, from, to),
/// note_motion(&s), and where it was: motion_at(s, time).
std::string servoText(size_t size);

}  // namespace breakaway
