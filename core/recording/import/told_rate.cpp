#include "recording/import/told_rate.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "recording/import/name_parts.h"
#include "recording/import/units.h"

namespace breakaway {

namespace {

enum class RateKind { none, step, rate };

/// What the words before a number tell of; their unit is taken off.
RateKind kindOf(Words words) {
  static constexpr auto samples =
      std::to_array<std::string_view>({"sample", "samples", "sampling", "logging", "log", "logger", "recording",
                                       "record", "control", "loop", "abtast"});
  static constexpr auto steps = std::to_array<std::string_view>({"time", "period", "interval", "step", "zeit", "dt"});
  static constexpr auto rates = std::to_array<std::string_view>({"rate", "frequency", "freq", "hz"});
  static constexpr auto alone = std::to_array<std::string_view>(
      {"dt", "ts", "period", "abtastzeit", "sampletime", "samplingtime", "sampleperiod", "samplingperiod"});
  static constexpr auto rateAlone =
      std::to_array<std::string_view>({"fs", "hz", "samplerate", "samplingrate", "rate", "abtastrate"});
  std::erase_if(words, [](const std::string& word) { return word == "s" || word == "ms" || word == "us"; });
  const bool ofSamples = firstIn(words, samples) != nullptr && words.size() <= 4;
  if (ofSamples && firstIn(words, rates) != nullptr) return RateKind::rate;
  if (ofSamples && firstIn(words, steps) != nullptr) return RateKind::step;
  if (words.size() == 2 && words[0] == "rate" && words[1] == "hz") return RateKind::rate;
  if (words.size() != 1) return RateKind::none;
  return isIn(alone, words[0]) ? RateKind::step : isIn(rateAlone, words[0]) ? RateKind::rate : RateKind::none;
}

std::optional<double> stepOf(std::string_view key, std::string_view text) {
  const Words words = wordsOf(key, true);
  const RateKind kind = words.empty() ? RateKind::none : kindOf(words);
  if (kind == RateKind::none) return std::nullopt;
  double value = 0.0;
  const auto [stop, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc() || !(value > 0.0) || !std::isfinite(value)) return std::nullopt;
  std::string_view behind = text.substr(static_cast<size_t>(stop - text.data()));
  behind = behind.substr(std::min(behind.find_first_not_of(" \t;,[("), behind.size()));
  behind = behind.substr(0, behind.find_first_of(" \t;,])\r"));
  for (const auto& [name, factor] : {std::pair{"khz", 1e3}, {"mhz", 1e6}}) {
    if (isSameWord(behind, name)) return 1.0 / (value * factor);
  }
  const Unit* unit = !behind.empty() ? unitNamed(behind) : words.size() > 1 ? unitNamed(words.back()) : nullptr;
  if (!behind.empty() && unit == nullptr) return std::nullopt;
  const bool hertz = unit != nullptr && std::string_view(unit->name) == "hz";
  if (unit != nullptr && !hertz && unit->kind != UnitKind::time) return std::nullopt;
  if (hertz || (kind == RateKind::rate && unit == nullptr)) return 1.0 / value;
  if (unit == nullptr && value >= 1.0) return std::nullopt;  // of what?
  return unit == nullptr ? value : value * unit->scale;
}

}  // namespace

std::optional<double> toldStep_s(const RawTable& table) {
  constexpr double least_s = 1e-6, most_s = 100.0, alike = 1e-3;
  std::optional<double> told;
  bool contradicted = false;
  const auto look = [&](std::string_view key, std::string_view value) {
    const auto step_s = stepOf(key, value);
    if (!step_s || *step_s < least_s || *step_s > most_s) return;
    contradicted = contradicted || (told && std::abs(std::log(*step_s / *told)) > alike);
    if (!told) told = step_s;
  };
  for (const auto* fields : {&table.notes, &table.beside}) {
    for (const auto& [key, value] : *fields) look(key, value);
  }
  for (const std::string& line : table.preamble) {
    const size_t begin = std::min(line.find_first_not_of("#%/ \t"), line.size());
    const std::string_view text = std::string_view(line).substr(begin);
    const size_t mark = text.find_first_of(":=;,\t");
    if (mark == std::string_view::npos) continue;
    std::string_view value = text.substr(mark + 1);
    value = value.substr(std::min(value.find_first_not_of(" \t"), value.size()));
    look(text.substr(0, mark), value);
  }
  return contradicted ? std::nullopt : told;
}

}  // namespace breakaway
