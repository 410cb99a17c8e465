#include "recording/import/others_beside.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "recording/import/columns_beside.h"
#include "recording/import/name_parts.h"
#include "recording/import/quantity_words.h"

namespace breakaway {

namespace {

bool namesQuantity(const Words& words) {
  return std::any_of(words.begin(), words.end(), [](const std::string& one) { return quantityNamed(one) != nullptr; });
}

}  // namespace

void preferDriven(const RawTable& table, std::vector<Choice>& choices) {
  static constexpr auto drives =
      std::to_array<std::string_view>({"torque_Nm", "current_A", "voltage_V", "duty", "force_N"});
  static constexpr auto motions = std::to_array<std::string_view>({"angle_rad", "velocity_rad_per_s"});
  std::map<std::string, std::array<bool, 2>> devices;  // by what stands before the last stroke: moves, is driven
  const auto deviceOf = [&table](size_t c) {
    const std::string& name = table.columns[c].channel.name;
    const std::string bare = name.substr(0, name.find_first_of("[("));  // without "(rot/s)"
    const size_t stroke = bare.find_last_of('/');
    return stroke == std::string::npos ? std::string() : bare.substr(0, stroke);
  };
  for (size_t c = 0; c < choices.size(); ++c) {
    const bool path = !deviceOf(c).empty();
    if (choices[c].byMap || choices[c].byTool) return;
    if (!path && choices[c].name.understood() && choices[c].name.to != "time_s") return;
    if (!path) continue;
    devices[deviceOf(c)][0] |= isIn(motions, choices[c].name.to);
    devices[deviceOf(c)][1] |= isIn(drives, choices[c].name.to);
  }
  const auto driven =
      std::find_if(devices.begin(), devices.end(), [](const auto& one) { return one.second[0] && one.second[1]; });
  if (driven == devices.end()) return;
  for (size_t c = 0; c < choices.size(); ++c) {
    if (isIn(motions, choices[c].name.to) && !devices[deviceOf(c)][1])
      setAside(choices[c], message("nothing drives it, as {} is driven", driven->first));
  }
}

void setUnmovedReferencesAside(const RawTable& table, std::vector<Choice>& choices) {
  const auto wordsBut = [&table](size_t c) {
    Words words = wordsOf(table.columns[c].channel.name, true);
    std::erase_if(words, [](const std::string& word) { return isIn(referenceWords, word); });
    return words;
  };
  for (size_t r = 0; r < choices.size(); ++r) {
    const std::string to = choices[r].name.to;
    const size_t end = to.find("_reference");
    if (end == std::string::npos || choices[r].byMap || choices[r].byTool) continue;
    const bool named = namesQuantity(wordsOf(table.columns[r].channel.name, true));
    const bool followed = std::any_of(choices.begin(), choices.end(), [&](const Choice& one) {
      return one.name.to.starts_with(to.substr(0, end)) && one.name.to.find("_reference") == std::string::npos;
    });
    if (!named && !followed) {  // "target_deg" beside a heading
      setAside(choices[r], message("is what something shall be that isn't taken"));
      continue;
    }
    const Words words = wordsBut(r);
    const NameParts own = partsOfName(table.columns[r].channel.name, table.columns[r].unit);
    const bool alone =
        !named && own.unit != nullptr && std::none_of(choices.begin(), choices.end(), [&](const Choice& one) {
          return one.name.to == to.substr(0, end) + to.substr(end + std::string_view("_reference").size()) &&
                 unitNamed(one.name.unit) == own.unit;
        });
    bool itsOwn = false;  // "spd_fb" is taken, and "spd" isn't
    for (size_t c = 0; c < choices.size() && !itsOwn; ++c) {
      const std::string& of = choices[c].name.to;
      Words taken = wordsOf(table.columns[c].channel.name, true);
      const bool marked = std::erase_if(taken, [](const std::string& word) { return isIn(measuredWords, word); }) > 0;
      itsOwn =
          marked && taken == words && of.starts_with(to.substr(0, end)) && of.find("_reference") == std::string::npos;
    }
    if (itsOwn) continue;
    for (size_t c = 0; c < choices.size(); ++c) {
      const bool sameUnit = alone && c != r && !choices[c].name.understood() && !table.columns[c].fault &&
                            partsOfName(table.columns[c].channel.name, table.columns[c].unit).unit == own.unit;
      if (sameUnit && choices[r].name.understood()) {  // "target_deg" beside "heading_deg" and an encoder
        setAside(choices[r], message("is what {} shall be, which isn't taken", table.columns[c].channel.name));
        break;
      }
      const bool measured = c != r && !choices[c].name.understood() && !table.columns[c].fault &&
                            wordsOf(table.columns[c].channel.name, true) == words;
      if (measured)
        setAside(choices[r], message("is what {} shall be, which isn't taken", table.columns[c].channel.name));
    }
  }
}

}  // namespace breakaway
