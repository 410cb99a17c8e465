// One sealed trial held against its diagnosis: what was concealed, what was answered, how well.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "diagnose/diagnosis.h"
#include "trial/sealed_trial.h"

namespace breakaway {

/// An answered effect and what it can't be told from.
struct ScoredName {
  std::string effect;
  std::vector<std::string> rivals;
  bool operator==(const ScoredName&) const = default;
};

/// A parameter that truth and answer share by name, each in its own unit.
struct ScoredParameter {
  std::string effect, name;
  bool amplitude = false;  ///< the effect's first parameter: its size
  double truth = 0.0;
  double value = 0.0, low95 = 0.0, high95 = 0.0;
  bool operator==(const ScoredParameter&) const = default;
};

/// Errors are RMSE on held-out windows, rad or m.
struct ScoredTrial {
  std::string family;
  std::uint64_t seed = 0;
  std::vector<std::string> truth;  ///< contract names; empty for clean and outside
  std::string outside;             ///< what an outside trial conceals
  std::string error;               ///< why there is no diagnosis; empty if there is one
  std::string verdict;             ///< contract name
  std::vector<ScoredName> answer;  ///< in order of importance
  std::vector<ScoredParameter> parameters;
  double before = 0.0, after = 0.0, floor = 0.0;  ///< as the diagnosis says
  double named_s = 0.0, elapsed_s = 0.0;
  bool agreementKnown = false;  ///< whether the diagnosis says what it named first
  bool agrees = false;          ///< those names are the final ones
  // From the truth, see identifiability.h:
  bool identifiable = false;
  double size = 0.0;         ///< error of the base model over the floor; 0: not known
  double achievable = 0.0;   ///< error of the true model, refitted; 0: not known
  std::string unidentified;  ///< why identifiability could not be decided
  // Names that the baselines gave, in order of importance:
  std::vector<std::string> stepwise, thresholded;
  bool operator==(const ScoredTrial&) const = default;
};

/// The trial with truth, answer, errors and times; identifiability and baselines are left open.
ScoredTrial judge(const SealedTrial& trial, const Result<Diagnosis>& diagnosis);

/// One line of JSON without its end, and back. Errors: the text is no such line.
std::string scoredLine(const ScoredTrial& trial);
Result<ScoredTrial> parseScoredLine(const std::string& text, const std::string& place);

}  // namespace breakaway
