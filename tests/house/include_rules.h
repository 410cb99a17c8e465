// Who may include whom, as rules over the text of the sources.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace breakaway::test {

/// Sources by their path below the repository, e.g. "core/base/result.h".
using Sources = std::map<std::string, std::string>;

/// All .h and .cpp below core, firmware_link and app of the repository at `root`.
Sources readSources(const std::string& root);

/// Every breach of the house's layering, as "FILE includes WHAT: why not", sorted.
std::vector<std::string> breaches(const Sources& sources);

/// Every place in diagnose, report, score and app that writes the name of one of `effects` as a string, as "FILE names
/// EFFECT", sorted: what is said of an effect stands in its own file.
std::vector<std::string> namedEffects(const Sources& sources, const std::vector<std::string>& effects);

}  // namespace breakaway::test
