#include "recording/import/unit_texts.h"

#include <string_view>

namespace breakaway {

std::optional<std::string> toldUnitOf(const std::string& key) {
  for (const std::string_view end : {"units", "unit", "Units", "Unit"}) {
    if (!key.ends_with(end)) continue;
    std::string base = key.substr(0, key.size() - end.size());
    const bool parted = base.empty() || base.back() == '_' || base.back() == '.' || end.front() == 'U';
    while (!base.empty() && (base.back() == '_' || base.back() == '.')) base.pop_back();
    if (parted) return base;
  }
  return std::nullopt;
}

void giveUnits(const UnitTexts& units, RawTable& table) {
  for (RawColumn& column : table.columns) {
    const std::string& name = column.channel.name;
    const size_t dot = name.rfind('.');
    const std::string last = dot == std::string::npos ? name : name.substr(dot + 1);
    const bool unsaid = last == "value" || last == "val" || last == "values" || last == "data";
    const std::string outer = !unsaid ? name : dot == std::string::npos ? std::string() : name.substr(0, dot);
    for (const std::string& key : {name, outer}) {
      const auto told = units.find(key);
      if (told != units.end() && column.unit.empty()) column.unit = told->second;
    }
  }
}

}  // namespace breakaway
