// The language that windows are made in.
#pragma once

#include "session/language.h"

namespace breakaway::test {

/// As long as it lives, windows that are made speak it.
class Spoken {
 public:
  explicit Spoken(Language language) { speak(language); }
  Spoken(const Spoken&) = delete;
  ~Spoken() { speak(Language::english); }
};

}  // namespace breakaway::test
