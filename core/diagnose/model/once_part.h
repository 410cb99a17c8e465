// The part of effects that happen in one recording only, at a time of their own.
#pragma once

#include <cstddef>

namespace breakaway {

/// Which of the effect's parameters say when: indices into Effect::parameters().
struct OncePart {
  size_t start;     ///< s since the recording's first row
  size_t duration;  ///< s
};

}  // namespace breakaway
