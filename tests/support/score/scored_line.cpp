// A scored trial as one line of JSON.
#include <nlohmann/json.hpp>

#include "score/scored_trial.h"

namespace breakaway {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ScoredName, effect, rivals)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ScoredParameter, effect, name, amplitude, truth, value, low95, high95)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ScoredTrial, family, seed, truth, outside, error, verdict, answer, parameters,
                                   before, after, floor, named_s, elapsed_s, agreementKnown, agrees, identifiable, size,
                                   achievable, unidentified, stepwise, thresholded)

std::string scoredLine(const ScoredTrial& trial) {
  return nlohmann::json(trial).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

Result<ScoredTrial> parseScoredLine(const std::string& text, const std::string& place) {
  try {
    return nlohmann::json::parse(text).get<ScoredTrial>();
  } catch (const nlohmann::json::exception&) {
    return Error{place, "is no scored trial"};
  }
}

}  // namespace breakaway
