// How much of a test is run. Under sanitizers everything takes five times as long. There a long fit runs on a short
// recording, whose way through memory is the same; whether its numbers are right is for the optimised build to say.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace breakaway::test {

#ifdef __SANITIZE_ADDRESS__
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

/// How much of a recording to fit that an optimised build fits whole.
inline double secondsToFit(double seconds) {
  return sanitized ? std::min(seconds, 6.0) : seconds;
}

/// How many seeds of `optimised`: another one takes the same way.
inline unsigned seedsToTry(unsigned optimised) {
  return sanitized ? 1 : optimised;
}

inline constexpr const char* likeOthers = "takes too long under sanitizers: a diagnosis like others";

/// Whether a table's row is run whose neighbours take the same way with other numbers: under sanitizers one in `of`.
inline bool alsoRun(size_t row, size_t of) {
  return !sanitized || row % of == 0;
}

/// Whether trials are run that take long and show what a quicker one shows, too: by `./dev test thorough` only.
inline bool thorough() {
  return !sanitized && std::getenv("BREAKAWAY_THOROUGH") != nullptr;
}

inline constexpr const char* onlyThorough = "takes long: ./dev test thorough";

}  // namespace breakaway::test
