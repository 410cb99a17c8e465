#include "recording/import/foreign_names.h"

#include <algorithm>
#include <array>
#include <utility>

#include "recording/import/foreign_words.h"
#include "recording/import/name_parts.h"
#include "recording/import/quantity_words.h"

namespace breakaway {

namespace {

/// Letters beyond those of formulas ("θ", "Δt"), or a word that is known to be another language's.
bool isForeign(const std::string& name) {
  constexpr size_t shortest = 4;  // in bytes: two letters of other alphabets
  const Words words = wordsOf(name, false);
  return std::any_of(words.begin(), words.end(), [](const std::string& word) {
    const bool letters =
        std::any_of(word.begin(), word.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x80U; });
    const bool known = std::any_of(foreignQuantities.begin(), foreignQuantities.end(),
                                   [&word](const Word& one) { return one.text == word && !one.weak; });
    return word.size() >= shortest && (known || (letters && unitNamed(word) == nullptr));
  });
}

}  // namespace

void takeForeignNames(const RawTable& table, std::vector<Choice>& choices) {
  constexpr size_t fewest = 2;
  const auto foreign = std::count_if(table.columns.begin(), table.columns.end(),
                                     [](const RawColumn& column) { return isForeign(column.channel.name); });
  if (static_cast<size_t>(foreign) < fewest) return;
  static constexpr auto quantities =
      std::to_array<std::pair<UnitKind, const char*>>({{UnitKind::angle, "angle"},
                                                       {UnitKind::current, "motor_current"},
                                                       {UnitKind::voltage, "motor_voltage"},
                                                       {UnitKind::torque, "torque"},
                                                       {UnitKind::temperature, "motor_temperature"}});
  for (const auto& [kind, word] : quantities) {
    size_t only = choices.size(), count = 0;
    std::string unit;
    for (size_t c = 0; c < choices.size(); ++c) {
      const NameParts parts = partsOfName(table.columns[c].channel.name, table.columns[c].unit);
      if (parts.unit == nullptr || parts.unit->kind != kind || parts.words.empty()) continue;
      const bool other = otherThingIn(parts.words) != nullptr || firstIn(parts.words, loadWords) != nullptr ||
                         firstIn(parts.words, supplyWords) != nullptr;
      const bool open =
          !choices[c].name.understood() && !choices[c].byMap && !choices[c].byTool && !table.columns[c].fault && !other;
      only = open ? c : only;
      unit = open ? parts.unitText : unit;
      ++count;
    }
    if (only == choices.size() || count != 1) continue;
    choices[only].name = understandName(word, unit);
    choices[only].name.byUnit = true;
  }
}

}  // namespace breakaway
