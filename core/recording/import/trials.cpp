#include "recording/import/trials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>

#include "recording/import/name_parts.h"
#include "recording/import/quantity_words.h"
#include "recording/import/units.h"

namespace breakaway {

namespace {

constexpr auto trialWords = std::to_array<std::string_view>(
    {"trial",   "trials", "episode",    "run",    "rollout",     "trajectory", "traj",         "experiment",
     "exp",     "test",   "repetition", "rep",    "session",     "sequence",   "segment",      "demo",
     "attempt", "shot",   "versuch",    "lauf",   "messung",     "essai",      "ensayo",       "prova",
     "profile", "batch",  "maneuver",   "motion", "measurement", "manoeuvre",  "demonstration"});
constexpr auto whichWords =
    std::to_array<std::string_view>({"id", "ids", "index", "idx", "no", "nr", "num", "number", "name", "label", "n"});

bool namesTrials(const std::string& name) {
  const auto words = wordsOf(name, true);
  return firstIn(words, trialWords) != nullptr && std::all_of(words.begin(), words.end(), [](const std::string& word) {
           return isIn(trialWords, word) || isIn(whichWords, word);
         });
}

/// Rows at which the value or the text changes, if none returns and blocks are no single rows.
std::optional<std::vector<size_t>> blocksOf(const RawColumn& column) {
  constexpr size_t fewestRows = 3;
  const size_t rows = column.channel.values.size();
  const bool texts = !column.texts.empty();
  if ((!texts && column.fault) || column.manyTexts || rows == 0) return std::nullopt;
  const auto at = [&](size_t k) {
    return texts ? static_cast<double>(k < column.textOf.size() ? column.textOf[k] : 0) : column.channel.values[k];
  };
  std::vector<size_t> borders;
  std::set<double> seen{at(0)};
  for (size_t k = 0; k < rows; ++k) {
    if (!std::isfinite(at(k)) || at(k) != std::floor(at(k))) return std::nullopt;
    if (k == 0 || at(k) == at(k - 1)) continue;
    if (!seen.insert(at(k)).second) return std::nullopt;
    borders.push_back(k);
    if (fewestRows * borders.size() > rows) return std::nullopt;
  }
  return borders;
}

/// Within each block the steps are alike, and not all of them 1, as where rows are counted.
bool hasEvenStepsInTrials(const std::vector<double>& values, const std::vector<size_t>& borders) {
  constexpr double alike = 3.0;
  if (values.size() < 3) return false;
  double first = 0.0;
  bool counts = true;
  for (size_t k = 1; k < values.size(); ++k) {
    if (std::binary_search(borders.begin(), borders.end(), k)) continue;
    const double step = values[k] - values[k - 1];
    if (!(step > 0.0)) return false;
    if (first == 0.0) first = step;
    if (step > alike * first || alike * step < first) return false;
    counts = counts && step == 1.0;
  }
  return first > 0.0 && !counts;
}

}  // namespace

std::optional<Trials> trialsIn(const RawTable& table) {
  std::optional<Trials> most;
  for (size_t c = 0; c < table.columns.size(); ++c) {
    if (!namesTrials(table.columns[c].channel.name)) continue;
    auto borders = blocksOf(table.columns[c]);
    if (!borders || borders->empty() || (most && borders->size() <= most->borders.size())) continue;
    most = Trials{c, std::move(*borders)};
  }
  return most;
}

bool goesUpInTrials(const std::vector<double>& values, const std::vector<size_t>& borders) {
  size_t up = 0, down = 0;
  double last = NAN;
  for (size_t k = 0; k < values.size(); ++k) {
    const double value = values[k];
    if (value > last) ++up;
    if (value < last && !std::binary_search(borders.begin(), borders.end(), k)) ++down;
    if (std::isfinite(value)) last = value;
  }
  return up > 0 && 20 * down <= up;
}

void takeTimesInSteps(const RawTable& table, std::vector<Choice>& choices) {
  if (std::any_of(choices.begin(), choices.end(), [](const Choice& one) { return one.name.to == "time_s"; })) return;
  static constexpr auto others =
      std::to_array<std::string_view>({"dt", "delta", "delay", "duration", "diff", "between"});
  std::optional<Trials> trials;
  bool sought = false;
  for (size_t c = 0; c < choices.size(); ++c) {
    const RawColumn& column = table.columns[c];
    const Choice& choice = choices[c];
    if (choice.name.understood() || choice.byMap || choice.byTool || column.fault || column.clock) continue;
    const NameParts parts = partsOfName(column.channel.name, column.unit);
    const bool timely = std::any_of(parts.words.begin(), parts.words.end(), [](const std::string& word) {
      const Word* quantity = quantityNamed(word);
      return (quantity != nullptr && quantity->kind == UnitKind::time && !quantity->weak) || word == "timestep";
    });
    const bool fits = parts.unit == nullptr ? !parts.unknownUnit : parts.unit->kind == UnitKind::time;
    if (!timely || !fits || firstIn(parts.words, others) != nullptr) continue;
    if (!sought) trials = trialsIn(table);
    sought = true;
    if (!hasEvenStepsInTrials(column.channel.values, trials ? trials->borders : std::vector<size_t>{})) continue;
    ColumnName name;
    name.to = "time_s";
    name.rank = 6;
    name.unit = parts.unitText;
    name.scale = parts.unit == nullptr ? 1.0 : parts.unit->scale * parts.factor;
    name.guess = message("goes on in even steps, and nothing else is a time");
    choices[c].name = std::move(name);
    return;
  }
}

}  // namespace breakaway
