// Rigs as other people have them: six makes of motors and axes, six ways to drive them and six to move them, logged
// with what sensors and loggers do, and one piece of physics that the bench file doesn't tell. Their plant
// (foreign_plant.h) shares no code with the simulated boards, the trials or the search.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "motor/bench.h"
#include "recording/recording.h"

namespace breakaway::test {

struct ForeignRig {
  Bench bench;
  std::vector<Recording> recordings;
  std::string words;  ///< make, drive, rate, moves, and how large what is concealed is
};

enum class Conceals { nothing, anEffect, physicsOutside };

struct ForeignFamily {
  std::string name;  ///< of the effect, where the catalogue has it
  Conceals conceals = Conceals::nothing;
};

/// "sound", each effect that this plant knows, and physics that the catalogue lacks.
const std::vector<ForeignFamily>& foreignFamilies();

/// 6 to 40 s in one to three recordings of 100 Hz to 2 kHz. What is concealed makes 5 to 50 % of the friction, or as
/// much as people meet of a thing that isn't counted so. `family` is one of foreignFamilies().
ForeignRig foreignRig(const std::string& family, std::uint64_t seed);

}  // namespace breakaway::test
