#include "recording/import/name_words.h"

#include <algorithm>
#include <array>

#include "recording/import/foreign_words.h"
#include "recording/import/joined_words.h"
#include "recording/import/quantity_words.h"

namespace breakaway {

namespace {

/// "vsupply" is a voltage and of what; "vesc" is a controller's name.
void partSupplies(Words& words) {
  for (size_t k = 0; k < words.size(); ++k) {
    const std::string of = words[k].substr(1);
    if (words[k][0] != 'v' || of.size() < 4 || !isIn(supplyWords, of)) continue;
    words[k] = "v";
    words.insert(words.begin() + static_cast<std::ptrdiff_t>(k) + 1, of);
  }
}

/// "motorspeed" and "targetposition" are two words, "timems" a time and its unit.
void partEnglish(Words& words) {
  static constexpr auto ends = std::to_array<std::string_view>(
      {"speed", "velocity", "position", "angle", "torque", "current", "voltage", "temperature"});
  static constexpr auto begins = std::to_array<std::string_view>(
      {"motor", "rotor",  "shaft",   "joint",      "encoder", "axis",     "servo",   "actual", "measured",
       "mean",  "target", "desired", "reference",  "command", "setpoint", "set",     "ref",    "cmd",
       "act",   "left",   "right",   "battery",    "supply",  "bus",      "load",    "output", "input",
       "phase", "wheel",  "angular", "rotational", "rot",     "winding",  "ambient", "driver", "board"});
  for (size_t k = 0; k < words.size(); ++k) {
    if (quantityNamed(words[k]) != nullptr) continue;
    for (const std::string_view end : ends) {
      if (words[k].size() <= end.size() || !words[k].ends_with(end)) continue;
      const std::string begin = words[k].substr(0, words[k].size() - end.size());
      if (!isIn(begins, begin)) continue;
      words[k] = begin;
      words.insert(words.begin() + static_cast<std::ptrdiff_t>(k) + 1, std::string(end));
      break;
    }
  }
}

/// "LHip" is the left one.
void partSides(Words& words) {
  static constexpr auto joints =
      std::to_array<std::string_view>({"hip", "knee", "ankle", "shoulder", "elbow", "wrist", "hand", "arm", "leg"});
  for (size_t k = 0; k < words.size(); ++k) {
    if (words[k].size() < 4 || !isIn(joints, std::string_view(words[k]).substr(1))) continue;
    const char side = words[k][0];
    if (side != 'l' && side != 'r') continue;
    words[k].erase(0, 1);
    words.insert(words.begin() + static_cast<std::ptrdiff_t>(k), side == 'l' ? "left" : "right");
  }
}

/// "FPOS" is a feedback, "RVEL" a reference, as some drives call them; "iqf" is filtered.
void partLetters(Words& words) {
  static constexpr auto whole = std::to_array<std::array<std::string_view, 3>>({{"fpos", "feedback", "pos"},
                                                                                {"rpos", "reference", "pos"},
                                                                                {"fvel", "feedback", "vel"},
                                                                                {"rvel", "reference", "vel"},
                                                                                {"iqf", "iq", "filtered"}});
  for (size_t k = 0; k < words.size(); ++k) {
    for (const auto& [joined, first, second] : whole) {
      if (words[k] != joined) continue;
      words[k] = first;
      words.insert(words.begin() + static_cast<std::ptrdiff_t>(k) + 1, std::string(second));
    }
  }
}

/// "Tensión de alimentación" is a supply's voltage.
void translate(Words& words) {
  Words english;
  for (const std::string& word : words) {
    const auto known = std::find_if(foreignBeside.begin(), foreignBeside.end(),
                                    [&word](const auto& one) { return one.first == word; });
    if (known == foreignBeside.end()) {
      english.push_back(word);
    } else if (!known->second.empty()) {
      english.emplace_back(known->second);
    }
  }
  if (!english.empty()) words = std::move(english);  // else what it joins is all there is
}

/// "torque_from_current" is a torque, however it was come by.
void dropSource(Words& words) {
  const auto from = std::find(words.begin(), words.end(), "from");
  const bool named =
      std::any_of(words.begin(), from, [](const std::string& word) { return quantityNamed(word) != nullptr; });
  if (named) words.erase(from, words.end());
}

/// "abs_encoder" is an absolute one; the amount of a value is called so behind it.
void dropAbsolute(Words& words) {
  static constexpr auto measured =
      std::to_array<std::string_view>({"encoder", "enc", "position", "pos", "angle", "absolute"});
  for (size_t k = 0; k + 1 < words.size(); ++k) {
    if (words[k] == "abs" && isIn(measured, words[k + 1])) words.erase(words.begin() + static_cast<std::ptrdiff_t>(k));
  }
}

/// "dphi/dt" is a speed.
void joinDerivatives(Words& words) {
  for (size_t k = 0; k + 1 < words.size(); ++k) {
    const Word* word = quantityNamed(words[k]);
    const Word* behind = words[k][0] == 'd' ? quantityNamed(words[k].substr(1)) : nullptr;
    const bool moves = (word != nullptr && word->kind == UnitKind::angularVelocity) ||
                       (behind != nullptr && behind->kind == UnitKind::angle);
    if (!moves || words[k][0] != 'd' || words[k + 1] != "dt") continue;
    words[k] = "omega";
    words.erase(words.begin() + static_cast<std::ptrdiff_t>(k) + 1);
  }
}

}  // namespace

void partCompounds(Words& words) {
  static constexpr auto ends = std::to_array<std::string_view>({"istwert", "sollwert"});
  static constexpr auto begins =
      std::to_array<std::pair<std::string_view, std::string_view>>({{"ist", "ist"},
                                                                    {"soll", "soll"},
                                                                    {"motor", "motor"},
                                                                    {"antriebs", "motor"},
                                                                    {"last", "load"},
                                                                    {"reib", "friction"},
                                                                    {"nenn", "nominal"},
                                                                    {"grenz", "limit"},
                                                                    {"zwischenkreis", "dclink"},
                                                                    {"batterie", "battery"},
                                                                    {"versorgungs", "supply"}});
  static constexpr auto same =
      std::to_array<std::pair<std::string_view, std::string_view>>({{"momentenbildend", "producing"},
                                                                    {"drehmomentbildend", "producing"},
                                                                    {"motorgeber", "sensor"},
                                                                    {"geber", "sensor"},
                                                                    {"filter", "filtered"}});
  for (std::string& word : words) {
    for (const auto& [own, meaning] : same) {
      if (word == own) word = meaning;
    }
  }
  for (size_t k = 0; k < words.size(); ++k) {
    const auto part = [&](std::string first, std::string second) {
      words[k] = std::move(first);
      words.insert(words.begin() + static_cast<std::ptrdiff_t>(k) + 1, std::move(second));
    };
    for (const std::string_view end : ends) {
      if (words[k].size() <= end.size() + 2 || !words[k].ends_with(end)) continue;
      const std::string quantity = words[k].substr(0, words[k].size() - end.size());
      if (quantityNamed(quantity) != nullptr) part(quantity, std::string(end));
    }
    for (const auto& [begin, meaning] : begins) {
      if (words[k].size() <= begin.size() + 2 || !words[k].starts_with(begin)) continue;
      const std::string quantity = words[k].substr(begin.size());
      if (quantityNamed(quantity) != nullptr) part(std::string(meaning), quantity);
    }
  }
}

std::string withUnitsApart(const std::string& text) {
  static constexpr auto ends = std::to_array<std::string_view>({"rpm", "amps", "volts"});
  static constexpr auto begins = std::to_array<std::string_view>(
      {"mot", "motor", "wheel", "shaft", "rotor", "eng", "engine", "target", "actual", "set", "cmd", "ref"});
  const Words words = wordsOf(text, false);
  if (words.size() != 1 || words[0].size() != text.size()) return text;
  for (const std::string_view end : ends) {
    const bool joined = words[0].size() > end.size() && words[0].ends_with(end);
    const std::string begin = words[0].substr(0, words[0].size() - std::min(words[0].size(), end.size()));
    if (joined && isIn(begins, begin)) return begin + "_" + std::string(end);
  }
  return text;
}

std::string_view withoutSource(std::string_view text) {
  for (const std::string_view from : {"_from_", " from "}) {
    const size_t at = text.find(from);
    if (at == std::string_view::npos || at == 0) continue;
    const Words words = wordsOf(text.substr(0, at), false);
    for (size_t k = 0; k < words.size(); ++k) {
      if (words[k].size() > 1 && unitOfWords(words, k) != nullptr) return text.substr(0, at);
    }
  }
  return text;
}

void joinWords(Words& words) {
  dropAbsolute(words);
  joinDerivatives(words);
  for (size_t k = 0; k + 1 < words.size(); ++k) {
    const bool axis = words[k + 1] == "q" || words[k + 1] == "d";
    if (axis && (words[k] == "i" || words[k] == "u" || words[k] == "v")) {
      words[k] += words[k + 1];
      words.erase(words.begin() + static_cast<std::ptrdiff_t>(k) + 1);
      continue;
    }
    if (words[k] == "set" && words[k + 1] == "point") {
      words[k] = "setpoint";
      words.erase(words.begin() + static_cast<std::ptrdiff_t>(k) + 1);
      continue;
    }
    if (words[k] == "v" && words[k + 1] == "in") {
      words[k] = "vin";
      words.erase(words.begin() + static_cast<std::ptrdiff_t>(k) + 1);
      continue;
    }
    const bool index = k + 2 < words.size() && words[k + 2] == "dot" && words[k + 1].size() == 1;  // "theta_b_dot"
    if (const Word* angle = quantityNamed(words[k]); index && angle != nullptr && angle->kind == UnitKind::angle) {
      words[k] = "omega";
      words.erase(words.begin() + static_cast<std::ptrdiff_t>(k) + 2);
      continue;
    }
    const bool behind = words[k + 1] == "dot";
    const Word* word = quantityNamed(behind ? words[k] : words[k + 1]);
    if ((!behind && words[k] != "dot") || word == nullptr || word->kind != UnitKind::angle) continue;
    words[k] = "omega";
    words.erase(words.begin() + static_cast<std::ptrdiff_t>(k) + 1);
  }
}

void partGapless(Words& words) {
  for (size_t k = 0; k < words.size(); ++k) {
    const size_t begin = quantityAtEnd(words[k]);
    if (begin == 0) continue;
    std::string quantity = words[k].substr(begin);
    words[k].resize(begin);
    for (const std::string_view of : {"轴", "軸", "相"}) {  // "q轴电流", "A相电流"
      if (words[k].size() == 1 + of.size() && words[k].ends_with(of)) words[k].resize(1);
    }
    words.insert(words.begin() + static_cast<std::ptrdiff_t>(k) + 1, std::move(quantity));
  }
}

void partWords(Words& words) {
  partGapless(words);
  translate(words);
  partCompounds(words);
  partSides(words);
  partEnglish(words);
  partLetters(words);
  partSupplies(words);
  partJoined(words);
  dropSource(words);
}

}  // namespace breakaway
