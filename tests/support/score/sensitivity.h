// What becomes of answers if a criterion is a third larger or smaller.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "score/scored_trial.h"

namespace breakaway {

/// A trial's answer where one criterion was multiplied; of no criterion, as they are.
struct VariedTrial {
  std::string criterion;
  double factor = 1.0;
  ScoredTrial trial;
};

/// One line of JSON without its end, and back. Errors: the text is no such line.
std::string variedLine(const VariedTrial& varied);
Result<VariedTrial> parseVariedLine(const std::string& text, const std::string& place);

/// Whether the answer is what the truth asks for: the first name is concealed (or a rival of the first is), or nothing
/// is named where nothing of the catalogue was concealed.
bool isRight(const ScoredTrial& trial);

/// As Markdown, a line per criterion: how many answers change, and how many of these were right before or are so now.
/// Of trials that both have been answered with and without the change.
std::string sensitivityTable(const std::vector<VariedTrial>& all);

}  // namespace breakaway
