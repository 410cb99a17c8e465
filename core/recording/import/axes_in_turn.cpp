#include "recording/import/axes_in_turn.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "base/exact_text.h"
#include "recording/import/name_parts.h"
#include "recording/import/units.h"

namespace breakaway {

namespace {

constexpr size_t mostAxes = 64;
constexpr auto axisWords = std::to_array<std::string_view>(
    {"motor", "joint", "axis", "servo", "actuator", "dof", "leg", "side", "motors", "achse", "moteur", "instance"});
constexpr auto numberWords =
    std::to_array<std::string_view>({"id", "ids", "name", "node", "device", "can", "address", "addr", "channel", "nr",
                                     "no", "index", "idx", "num", "number", "label"});

bool hasWordOf(const std::string& name, bool axesOnly) {
  const auto words = wordsOf(name, true);
  const bool axis = firstIn(words, axisWords) != nullptr;
  return axis || (!axesOnly && firstIn(words, numberWords) != nullptr);
}

/// "motor_name", "joint": nothing but which axis a row is of.
bool namesAxes(const std::string& name) {
  const auto words = wordsOf(name, true);
  return firstIn(words, axisWords) != nullptr && std::all_of(words.begin(), words.end(), [](const std::string& word) {
           return isIn(axisWords, word) || isIn(numberWords, word);
         });
}

/// How far the values go in all, from row to row or within each kind.
double wayOf(const std::vector<double>& values, const RowKinds* kinds) {
  std::vector<double> last(kinds == nullptr ? 1 : kinds->names.size() + 1, NAN);
  double way = 0.0;
  for (size_t k = 0; k < values.size(); ++k) {
    if (!std::isfinite(values[k])) continue;
    double& before = last[kinds == nullptr ? 0 : kinds->of[k]];
    if (std::isfinite(before)) way += std::abs(values[k] - before);
    before = values[k];
  }
  return way;
}

/// Rows at which the kind changes.
std::vector<size_t> bordersOf(const RowKinds& kinds) {
  std::vector<size_t> changes;
  for (size_t k = 1; k < kinds.of.size(); ++k) {
    if (kinds.of[k] != kinds.of[k - 1]) changes.push_back(k);
  }
  return changes;
}

/// 0, 1, 2 … or 1, 2, 3 …, or texts: what axes are told apart by, and no command is.
bool numberedOn(const RawColumn& column, const RowKinds& kinds) {
  if (!column.texts.empty()) return true;
  for (size_t k = 0; k < kinds.names.size(); ++k) {
    if (kinds.names[k] != std::to_string(k) && kinds.names[k] != std::to_string(k + 1)) return false;
  }
  return true;
}

bool eachHasRows(const RowKinds& kinds, size_t fewest) {
  std::vector<size_t> counts(kinds.names.size() + 1);
  for (const size_t kind : kinds.of) ++counts[kind];
  return std::all_of(counts.begin() + 1, counts.end(), [fewest](size_t count) { return count >= fewest; });
}

/// "T" and "R", "cmd" and "fb": what was sent and what came back, as texts.
bool tellsMessages(const RawColumn& column, const RowKinds& kinds) {
  using Ways = std::array<std::string_view, 2>;
  static constexpr auto ways = std::to_array<Ways>({{"t", "r"},
                                                    {"tx", "rx"},
                                                    {"send", "recv"},
                                                    {"sent", "received"},
                                                    {"cmd", "fb"},
                                                    {"cmd", "state"},
                                                    {"command", "feedback"},
                                                    {"command", "state"},
                                                    {"req", "resp"},
                                                    {"request", "response"}});
  if (column.texts.size() != 2 || kinds.names.size() != 2) return false;
  const std::string first = lowered(kinds.names[0]), second = lowered(kinds.names[1]);
  return std::any_of(ways.begin(), ways.end(), [&](const auto& way) {
    return (way[0] == first && way[1] == second) || (way[0] == second && way[1] == first);
  });
}

/// Several rows have the same stamp: each is of another axis, whatever the column that numbers them is called.
bool repeatOften(const std::vector<double>& stamps) {
  constexpr double share = 0.3;
  size_t repeats = 0;
  for (size_t k = 1; k < stamps.size(); ++k) repeats += stamps[k] == stamps[k - 1] ? 1 : 0;
  return static_cast<double>(repeats) > share * static_cast<double>(stamps.size());
}

}  // namespace

std::optional<RowKinds> rowKinds(const RawColumn& column) {
  RowKinds kinds;
  if (!column.texts.empty()) {
    kinds.names = column.texts;
    kinds.of.assign(column.textOf.begin(), column.textOf.end());
    kinds.of.resize(column.channel.values.size());
    return kinds.names.size() > mostAxes ? std::nullopt : std::optional(std::move(kinds));
  }
  if (column.fault) return std::nullopt;
  std::vector<double> seen;
  kinds.of.reserve(column.channel.values.size());
  for (const double value : column.channel.values) {
    if (!std::isfinite(value) || value != std::floor(value)) return std::nullopt;
    const auto at = std::find(seen.begin(), seen.end(), value);
    kinds.of.push_back(static_cast<size_t>(at - seen.begin()) + 1);
    if (at == seen.end()) seen.push_back(value);
    if (seen.size() > mostAxes) return std::nullopt;
  }
  for (const double value : seen) kinds.names.push_back(exactText(value + column.origin));
  return kinds;
}

std::optional<AxesInTurn> axesInTurn(const RawTable& table, const std::vector<bool>& free, size_t motion,
                                     std::optional<size_t> time) {
  constexpr double oftenChanges = 0.2, smoother = 0.35;
  constexpr size_t fewestRows = 4;
  const auto& values = table.columns[motion].channel.values;
  const bool shared = time && repeatOften(table.columns[*time].channel.values);
  std::optional<double> whole;
  for (size_t c = 0; c < table.columns.size(); ++c) {
    const RawColumn& column = table.columns[c];
    const bool named = !column.texts.empty() || hasWordOf(column.channel.name, false);
    if (!free[c] || (!named && !shared)) continue;
    const auto kinds = rowKinds(column);
    if (!kinds || kinds->names.size() < 2 || !eachHasRows(*kinds, fewestRows)) continue;
    if (!named && !numberedOn(column, *kinds)) continue;
    const auto changes = bordersOf(*kinds);
    if (tellsMessages(column, *kinds) && changes.size() > fewestRows) return AxesInTurn{c, kinds->names, true};
    if (static_cast<double>(changes.size()) > oftenChanges * static_cast<double>(values.size())) {
      if (namesAxes(column.channel.name)) return AxesInTurn{c, kinds->names};
      if (!whole) whole = wayOf(values, nullptr);
      if (wayOf(values, &*kinds) < smoother * *whole) return AxesInTurn{c, kinds->names};
    } else if (time && hasWordOf(column.channel.name, true)) {
      const auto& stamps = table.columns[*time].channel.values;
      if (std::all_of(changes.begin(), changes.end(), [&](size_t k) { return stamps[k] < stamps[k - 1]; }))
        return AxesInTurn{c, kinds->names};
    } else if (!time && namesAxes(column.channel.name) && changes.size() + 1 == kinds->names.size() &&
               numberedOn(column, *kinds)) {
      return AxesInTurn{c, kinds->names};
    }
  }
  return std::nullopt;
}

}  // namespace breakaway
