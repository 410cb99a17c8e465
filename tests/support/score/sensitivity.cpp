#include "score/sensitivity.h"

#include <fmt/format.h>
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "diagnose/model/criteria.h"

namespace breakaway {

namespace {

using Which = std::pair<std::string, std::uint64_t>;  ///< family and seed

bool sameAnswer(const ScoredTrial& a, const ScoredTrial& b) {
  return a.verdict == b.verdict && a.answer == b.answer;
}

struct Changes {
  size_t trials = 0, changed = 0, spoilt = 0, mended = 0;
  std::string text() const { return fmt::format("{} of {} | {} | {}", changed, trials, spoilt, mended); }
};

}  // namespace

std::string variedLine(const VariedTrial& varied) {
  auto json = nlohmann::json::parse(scoredLine(varied.trial));
  json["criterion"] = varied.criterion;
  json["factor"] = varied.factor;
  return json.dump();
}

Result<VariedTrial> parseVariedLine(const std::string& text, const std::string& place) {
  VariedTrial varied;
  auto trial = parseScoredLine(text, place);
  if (!trial) return trial.error();
  varied.trial = std::move(*trial);
  try {
    const auto json = nlohmann::json::parse(text);
    json.at("criterion").get_to(varied.criterion);
    json.at("factor").get_to(varied.factor);
  } catch (const nlohmann::json::exception&) {
    return Error{place, "doesn't say which criterion was varied"};
  }
  return varied;
}

bool isRight(const ScoredTrial& trial) {
  if (!trial.error.empty()) return false;
  if (!trial.outside.empty()) return trial.answer.empty() && trial.verdict == "outside_catalogue";
  if (trial.truth.empty()) return trial.verdict == "nothing_missing";
  if (trial.answer.empty()) return false;
  const auto concealed = [&trial](const std::string& name) {
    return std::find(trial.truth.begin(), trial.truth.end(), name) != trial.truth.end();
  };
  const ScoredName& first = trial.answer.front();
  return concealed(first.effect) || std::any_of(first.rivals.begin(), first.rivals.end(), concealed);
}

std::string sensitivityTable(const std::vector<VariedTrial>& all) {
  std::map<Which, const ScoredTrial*> usual;
  for (const VariedTrial& one : all) {
    if (one.criterion.empty()) usual.emplace(Which{one.trial.family, one.trial.seed}, &one.trial);
  }
  std::map<std::pair<std::string, bool>, Changes> changes;  // by criterion, and whether it was larger
  for (const VariedTrial& one : all) {
    const auto known = usual.find({one.trial.family, one.trial.seed});
    if (one.criterion.empty() || known == usual.end()) continue;
    Changes& here = changes[{one.criterion, one.factor > 1.0}];
    ++here.trials;
    if (sameAnswer(one.trial, *known->second)) continue;
    ++here.changed;
    const bool was = isRight(*known->second), is = isRight(one.trial);
    here.spoilt += was && !is ? 1 : 0;
    here.mended += is && !was ? 1 : 0;
  }
  std::string text =
      "| criterion | a third less: changes | spoils | mends | a third more: changes | spoils | mends |\n"
      "|---|---|---|---|---|---|---|\n";
  for (const Criterion& one : criteriaTable()) {
    const std::string name(one.name);
    text += fmt::format("| `{}` | {} | {} |\n", name, changes[{name, false}].text(), changes[{name, true}].text());
  }
  return text;
}

}  // namespace breakaway
