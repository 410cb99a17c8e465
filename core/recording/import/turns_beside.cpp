#include "recording/import/turns_beside.h"

#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "recording/import/columns_beside.h"
#include "recording/import/name_parts.h"
#include "recording/import/quantity_words.h"
#include "recording/import/settle_motion.h"

namespace breakaway {

namespace {

/// The changes of an angle from row to row, counted on where it starts anew with each turn.
std::vector<double> goneBy(std::vector<double> angle) {
  if (const auto period = periodOf(angle, {}, std::nullopt)) unwind(angle, *period, {});
  return changesOf(angle);
}

/// Called the rotor's own.
bool isShafts(const RawColumn& column) {
  static constexpr auto own =
      std::to_array<std::string_view>({"motor", "mot", "rotor", "shaft", "mech", "mechanical", "encoder", "enc"});
  const Words words = wordsOf(column.channel.name, true);
  return firstIn(words, own) != nullptr && firstIn(words, drivenWords) == nullptr;
}

}  // namespace

void setElectricalAside(const RawTable& table, std::vector<Choice>& choices) {
  constexpr double mostPolePairs = 40.0, within = 0.03, alikeMotion = 0.99;
  constexpr size_t fewestRows = 50, mostColumns = 60;
  if (table.rows() < fewestRows || choices.size() > mostColumns) return;
  const auto isOpen = [&](size_t c) {
    return !choices[c].byMap && !choices[c].byTool && choices[c].name.needs == UnitNeeds::nothing &&
           !table.columns[c].fault;
  };
  for (const std::string_view to : {"velocity_rad_per_s", "angle_rad"}) {
    const auto motionOf = [&](size_t c) {
      const auto& values = table.columns[c].channel.values;
      return to == "angle_rad" ? goneBy(values) : values;
    };
    for (size_t slow = 0; slow < choices.size(); ++slow) {
      if (choices[slow].name.to != to || !isOpen(slow) || !isShafts(table.columns[slow])) continue;
      const std::vector<double> own = motionOf(slow);
      for (size_t fast = 0; fast < choices.size(); ++fast) {
        const bool alike = fast != slow && choices[fast].name.to == to && isOpen(fast) &&
                           choices[fast].name.scale == choices[slow].name.scale && !isShafts(table.columns[fast]);
        if (!alike) continue;
        const auto [correlation, times] = likenessOf(motionOf(fast), own);
        const double whole = std::round(times);
        if (correlation < alikeMotion || whole < 2.0 || whole > mostPolePairs || std::abs(times / whole - 1.0) > within)
          continue;
        setAside(choices[fast], message("turns {} times as fast as {}, as in electrical turns",
                                        std::to_string(static_cast<int>(whole)), table.columns[slow].channel.name));
      }
    }
  }
}

}  // namespace breakaway
