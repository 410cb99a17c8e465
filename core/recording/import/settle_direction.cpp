// Speeds and drives without a sign, beside a column that tells the direction.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "recording/import/name_parts.h"
#include "recording/import/quantity_words.h"
#include "recording/import/settling.h"

namespace breakaway {

namespace {

constexpr auto directionWords =
    std::to_array<std::string_view>({"dir", "direction", "sign", "richtung", "drehrichtung", "dirección", "direccion",
                                     "sentido", "direzione", "sens", "方向", "转向"});
constexpr auto forwardTexts = std::to_array<std::string_view>(
    {"fwd",      "forward", "forwards", "f",       "cw",       "clockwise", "pos",    "positive", "+",    "up", "vor",
     "vorwärts", "rechts",  "avant",    "horaire", "adelante", "horario",   "avanti", "orario",   "正转", "正"});
constexpr auto backwardTexts = std::to_array<std::string_view>({"rev",
                                                                "reverse",
                                                                "r",
                                                                "bwd",
                                                                "backward",
                                                                "backwards",
                                                                "b",
                                                                "ccw",
                                                                "counterclockwise",
                                                                "anticlockwise",
                                                                "neg",
                                                                "negative",
                                                                "-",
                                                                "down",
                                                                "back",
                                                                "counter-clockwise",
                                                                "anti-clockwise",
                                                                "zurück",
                                                                "rückwärts",
                                                                "links",
                                                                "arrière",
                                                                "arriere",
                                                                "antihoraire",
                                                                "atrás",
                                                                "atras",
                                                                "antihorario",
                                                                "indietro",
                                                                "antiorario",
                                                                "反转",
                                                                "反"});

/// 1 forward, −1 backward, 0 neither.
double signNamed(const std::string& text) {
  const std::string word = lowered(text);
  return isIn(forwardTexts, word) ? 1.0 : isIn(backwardTexts, word) ? -1.0 : 0.0;
}

/// Two texts of which none is known.
bool tellsUnknownWays(const RawColumn& column) {
  static constexpr auto rests = std::to_array<std::string_view>(
      {"stop", "stopped", "idle", "brake", "braking", "none", "off", "hold", "halt", "coast"});
  return column.texts.size() == 2 && std::none_of(column.texts.begin(), column.texts.end(), [](const std::string& one) {
           return signNamed(one) != 0.0 || isIn(rests, lowered(one));
         });
}

bool hasSign(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double value) { return value < 0.0; });
}

/// 1 and −1, or 1 and 0, as signs, with the last one where it stands still; empty when it is neither.
std::vector<double> signsOf(const std::vector<double>& values) {
  std::set<double> seen;
  for (const double value : values) {
    if (std::isfinite(value)) seen.insert(value);
    if (seen.size() > 3) return {};
  }
  const bool both = seen.contains(1.0) && seen.contains(-1.0), only = seen == std::set<double>{0.0, 1.0};
  if (!only && !(both && (seen.size() == 2 || seen.contains(0.0)))) return {};
  std::vector<double> signs(values.size());
  double last = 1.0;
  for (size_t k = 0; k < values.size(); ++k) {
    if (std::isfinite(values[k]) && (only || values[k] != 0.0)) last = values[k] > 0.0 ? 1.0 : -1.0;
    signs[k] = last;
  }
  return signs;
}

/// What turns round stands for a moment; at the top of a ramp ("up", "down") it doesn't.
bool turnsAtRest(const std::vector<double>& speed, const std::vector<double>& signs) {
  constexpr double slow = 0.3, most = 0.8;
  const double fastest = largest(speed);
  double turns = 0.0, atRest = 0.0;
  for (size_t k = 1; k < signs.size(); ++k) {
    if (signs[k] == signs[k - 1]) continue;
    turns += 1.0;
    atRest += std::min(speed[k - 1], speed[k]) <= slow * fastest ? 1.0 : 0.0;
  }
  return atRest >= most * turns;
}

}  // namespace

bool Settling::tellsDirection(size_t c) const {
  const ColumnFate& fate = fates_[c];
  const bool open = fate.kind != ColumnFate::Kind::used && !choices_[c].byMap && !choices_[c].byTool;
  const NameParts parts = partsOfName(fate.from, {});
  return open && firstIn(parts.words, directionWords) != nullptr &&
         std::all_of(parts.words.begin(), parts.words.end(), [](const std::string& word) {
           return isIn(directionWords, word) || isIn(jointWords, word) || isIn(decorations, word) ||
                  isIn(referenceWords, word);
         });
}

std::vector<double> Settling::directionsAt(size_t c) {
  const RawColumn& column = table_.columns[c];
  if (column.texts.empty()) return column.fault || column.manyTexts ? std::vector<double>{} : signsOf(values(c));
  std::vector<double> told;
  for (const size_t row : time_.rows) {
    const size_t text = row < column.textOf.size() ? column.textOf[row] : 0;
    const double sign = text == 0 ? 0.0 : signNamed(column.texts[text - 1]);
    told.push_back(sign == 0.0 ? NAN : sign);
  }
  return signsOf(told);
}

void Settling::signByDirection(std::initializer_list<const char*> names) {
  for (const char* name : names) {
    const auto unsignedOne = columnOf(name);
    if (!unsignedOne || choices_[*unsignedOne].byMap || hasSign(values(*unsignedOne))) continue;
    for (size_t c = 0; c < fates_.size(); ++c) {
      const std::string group = partsOfName(fates_[c].from, {}).group;
      const std::string& own = choices_[*unsignedOne].name.group;
      if (!tellsDirection(c) || (!group.empty() && !own.empty() && group != own)) continue;
      std::vector<double> signs = directionsAt(c);
      const bool fits = !signs.empty() && directionFits(*unsignedOne, signs);
      if (!fits && (!signs.empty() || !tellsUnknownWays(table_.columns[c]))) continue;
      for (size_t k = 0; k < signs.size(); ++k) values(*unsignedOne)[k] *= signs[k];
      ColumnFate& fate = fates_[*unsignedOne];
      fate.guessed = true;
      fate.why = fits ? message("its sign is the direction that {} tells", fates_[c].from)
                      : message("it is never negative, and which way {} says isn't understood", fates_[c].from);
      fate.doubt = fate.why;
      break;
    }
  }
}

bool Settling::directionFits(size_t c, std::vector<double>& signs) {
  const bool speed = fates_[c].to.starts_with("velocity");
  std::vector<double> driven = values(c);
  for (size_t k = 0; k < signs.size(); ++k) driven[k] *= signs[k];
  auto angle = columnOf("angle_rad");
  if (!angle) angle = columnOf("position_m");
  constexpr double agrees = 0.9, against = -0.3;
  double correlation = 0.0;
  if (speed) {
    if (!angle) return turnsAtRest(values(c), signs);
    const auto as = compareMotion(time_.time_s, values(*angle), values(c), time_.pauses);
    const auto turned = compareMotion(time_.time_s, values(*angle), driven, time_.pauses);
    if (as && as->correlation > agrees) return false;
    correlation = turned ? turned->correlation : 0.0;
  } else {
    auto moved = columnOf("velocity_rad_per_s");
    if (!moved) moved = columnOf("velocity_m_per_s");
    if (!moved && !angle) return false;
    const std::vector<double> motion = moved ? values(*moved) : changesOf(values(*angle));
    double both = 0.0, drives = 0.0, motions = 0.0;
    for (size_t k = 0; k < motion.size(); ++k) {
      if (!std::isfinite(motion[k]) || !std::isfinite(driven[k])) continue;
      both += driven[k] * motion[k];
      drives += driven[k] * driven[k];
      motions += motion[k] * motion[k];
    }
    correlation = drives > 0.0 && motions > 0.0 ? both / std::sqrt(drives * motions) : 0.0;
  }
  if (correlation < against) {
    for (double& sign : signs) sign = -sign;
  }
  return true;
}

}  // namespace breakaway
