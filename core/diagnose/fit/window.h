// A stretch of one track, as fits and scores cut it.
#pragma once

#include <cstddef>
#include <vector>

#include "diagnose/simulate/track.h"

namespace breakaway {

/// In what a window's errors are counted: in its motion, restarted and simulated, or in the torque along it.
enum class ErrorIn : char { motion, torque };

/// Rows [first, last] of one track.
struct Window {
  size_t track = 0;
  size_t first = 0;
  size_t last = 0;
  ErrorIn errorIn = ErrorIn::motion;
  bool operator==(const Window&) const = default;
};

/// The windows of a track that begin at restartRows() and lie wholly within rows [from, to); windows of fewer than 8
/// rows are left out.
std::vector<Window> windowsOf(const std::vector<Track>& tracks, size_t track, size_t from, size_t to, double window_s);

/// Whether what is read changes over the window by more than its noise makes.
bool moves(const Window& window, const std::vector<Track>& tracks);

}  // namespace breakaway
