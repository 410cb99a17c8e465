// Kinds of rigs on which the errors of a friction map's runs have something in common.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace breakaway::test {

struct MapFamily {
  std::string name, words;
  size_t turns = 2;  ///< of the breakaway sweep
};

const std::vector<MapFamily>& mapFamilies();

/// A rig file at random (random_rig.h) of that family.
std::string familyRig(const std::string& family, unsigned seed);
/// As many bins as its encoder can fill, at most as many as usual.
size_t familyBins(const std::string& family, unsigned seed);

}  // namespace breakaway::test
