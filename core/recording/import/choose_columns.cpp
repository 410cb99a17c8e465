#include "recording/import/choose_columns.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

#include "base/json_object.h"
#include "recording/columns.h"
#include "recording/import/name_parts.h"
#include "recording/import/quantity_words.h"
#include "recording/import/settling.h"

namespace breakaway {

namespace {

Choice guess(const RawColumn& column) {
  Choice choice;
  const std::string& name = column.channel.name;
  if (const Column* known = columnNamed(name); known != nullptr && column.unit.empty()) {
    choice.name.to = name;
    choice.name.unit = known->unit;
    choice.name.rank = -1;
    return choice;
  }
  if (name == "torque_enable" || name == "enable" || isSameWord(name, "enabled")) {
    choice.name.to = "enabled";
    choice.name.unit = "1";
    return choice;
  }
  choice.name = understandName(name, column.unit);
  return choice;
}

/// The name without its last word that reads so.
std::string nameWithout(std::string name, const std::string& word) {
  std::string lower = name;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const size_t at = lower.rfind(word);
  return at == std::string::npos ? name : name.replace(at, word.size(), " ");
}

/// An unknown word behind two different quantities is an axis' name: "pos_slew" beside "vel_slew".
void takeNamedAxes(const RawTable& table, std::vector<Choice>& choices) {
  std::map<std::string, std::set<std::string>> behind;
  std::vector<ColumnName> names(choices.size());
  for (size_t c = 0; c < choices.size(); ++c) {
    const std::string word = choices[c].name.unknownWord;
    if (word.size() < 2 || choices[c].byMap) continue;
    names[c] = understandName(nameWithout(table.columns[c].channel.name, word), table.columns[c].unit);
    const size_t reference = names[c].to.find("_reference");  // of the same quantity
    if (names[c].understood()) behind[word].insert(names[c].to.substr(0, std::min(reference, names[c].to.find('_'))));
  }
  for (size_t c = 0; c < choices.size(); ++c) {
    const std::string word = choices[c].name.unknownWord;
    if (!names[c].understood() || behind[word].size() < 2) continue;
    names[c].group += (names[c].group.empty() ? "" : ".") + word;
    ++names[c].rank;
    choices[c].name = names[c];
  }
}

void setAside(Choice& choice, const std::string& why) {
  choice.name = ColumnName{};
  choice.name.aside = why;
}

/// Whether the name, with its letter at `at` exchanged for the two others of a phase, is there, too.
bool hasPhasesBeside(const std::set<std::string>& names, const std::string& name, size_t at) {
  static constexpr auto phases = std::to_array<std::string_view>({"abc", "ABC", "uvw", "UVW"});
  return std::any_of(phases.begin(), phases.end(), [&](std::string_view letters) {
    if (letters.find(name[at]) == std::string_view::npos) return false;
    size_t beside = 0;
    for (const char letter : letters) {
      std::string other = name;
      other[at] = letter;
      beside += names.count(other);
    }
    return beside >= 2;
  });
}

/// "current_a" beside "current_b" is one phase's, and no current in A; so is "dutyA" beside "dutyB".
void setPhasesAside(const RawTable& table, std::vector<Choice>& choices) {
  std::set<std::string> names;
  for (const RawColumn& column : table.columns) names.insert(column.channel.name);
  for (size_t c = 0; c < choices.size(); ++c) {
    const std::string& name = table.columns[c].channel.name;
    const std::string& to = choices[c].name.to;
    const bool electrical =
        to == "duty" || to == "voltage_V" || to == "current_A" || to == "current_reference_A" || to == "supply_V";
    if (choices[c].byMap || choices[c].byTool || !electrical) continue;
    for (size_t at = 1; at < name.size(); ++at) {
      const bool endsWord = at + 1 == name.size() || std::isalnum(static_cast<unsigned char>(name[at + 1])) == 0;
      if (endsWord && hasPhasesBeside(names, name, at)) {
        setAside(choices[c], "is one phase's");
        break;
      }
    }
  }
}

/// Beside a rotary motion a linear speed is that of a vehicle or of what the motor drives.
void setVehiclesAside(std::vector<Choice>& choices) {
  const auto has = [&choices](const char* to) {
    return std::any_of(choices.begin(), choices.end(), [to](const Choice& one) { return one.name.to == to; });
  };
  if (has("position_m") || (!has("angle_rad") && !has("velocity_rad_per_s"))) return;
  for (Choice& choice : choices) {
    const bool linear = choice.name.to == "velocity_m_per_s" || choice.name.to == "velocity_reference_m_per_s";
    if (linear && !choice.byMap) setAside(choice, "is a linear speed, beside a motor that turns");
  }
}

/// "i" beside "p" and "d" is a controller's integral term, and no current.
void setPidTermsAside(const RawTable& table, std::vector<Choice>& choices) {
  size_t terms = 0;
  for (const RawColumn& column : table.columns)
    terms += isSameWord(column.channel.name, "p") || isSameWord(column.channel.name, "d") ? 1 : 0;
  for (size_t c = 0; c < choices.size(); ++c) {
    const bool term = terms >= 2 && isSameWord(table.columns[c].channel.name, "i") && table.columns[c].unit.empty();
    if (term && !choices[c].byMap) setAside(choices[c], "is a controller's integral term");
  }
}

/// "CurrX" beside "TargetX" is where something is now, and no current.
void setPresentAside(const RawTable& table, std::vector<Choice>& choices) {
  std::set<std::string> wanted;  // the words behind "target"
  for (const RawColumn& column : table.columns) {
    const auto words = wordsOf(column.channel.name, true);
    if (words.size() > 1 && isIn(referenceWords, words.front())) wanted.insert(words[1]);
  }
  for (size_t c = 0; c < choices.size(); ++c) {
    if (choices[c].name.to != "current_A" || choices[c].byMap || !choices[c].name.unit.empty()) continue;
    const auto words = wordsOf(table.columns[c].channel.name, true);
    const bool place = words.size() == 2 && words[0].starts_with("cur") && words[1].size() == 1 &&
                       std::string_view("xyz").find(words[1]) != std::string_view::npos;
    if (place && wanted.contains(words[1])) setAside(choices[c], "is where it is now, beside where it shall be");
  }
}

/// "i" that counts the rows is no current.
void setRowNumbersAside(const RawTable& table, std::vector<Choice>& choices) {
  for (size_t c = 0; c < choices.size(); ++c) {
    const auto& values = table.columns[c].channel.values;
    const bool letter = table.columns[c].channel.name.size() == 1 && choices[c].name.unit.empty();
    if (!letter || !choices[c].name.understood() || choices[c].byMap || choices[c].byTool) continue;
    const bool counts = values.size() > 2 && std::adjacent_find(values.begin(), values.end(), [](double a, double b) {
                                               return b != a + 1.0;
                                             }) == values.end();
    if (counts && choices[c].name.to != "time_s") setAside(choices[c], "counts the rows");
  }
}

/// "PosZ" beside a motor's rpm is a place in space.
void setPlacesAside(const RawTable& table, std::vector<Choice>& choices) {
  const auto letterOf = [&table](size_t c) {
    const auto words = wordsOf(table.columns[c].channel.name, true);
    if (isIn(words, "steering") || isIn(words, "steer")) return 's';
    const bool letter = words.size() > 1 && words.back().size() == 1 && std::strchr("xyz", words.back()[0]) != nullptr;
    return letter ? words.back()[0] : ' ';
  };
  bool turns = false;
  for (size_t c = 0; c < choices.size(); ++c)
    turns =
        turns || (choices[c].name.to == "velocity_rad_per_s" && !choices[c].name.unit.empty() && letterOf(c) == ' ');
  if (!turns) return;
  for (size_t c = 0; c < choices.size(); ++c) {
    const bool moves = choices[c].name.to == "angle_rad" || choices[c].name.to == "velocity_rad_per_s";
    const bool told = letterOf(c) != 's' && !choices[c].name.unit.empty();
    if (moves && !told && !choices[c].byMap && letterOf(c) != ' ')
      setAside(choices[c], letterOf(c) == 's' ? "is a vehicle's steering, beside a motor that turns"
                                              : "is a place in space, beside a motor that turns");
  }
}

/// A position beside a force is a linear axis' where no unit says otherwise.
void takeLinear(const RawTable& table, std::vector<Choice>& choices) {
  const auto namesForce = [&table](size_t c) {
    const auto words = wordsOf(table.columns[c].channel.name, true);
    return isIn(words, "force") || isIn(words, "kraft");
  };
  bool force = false, turns = false;
  for (size_t c = 0; c < choices.size(); ++c) {
    const ColumnName& name = choices[c].name;
    const bool moves = isAngle(name.to) || isSpeed(name.to);
    const auto words = wordsOf(table.columns[c].channel.name, true);
    const bool turning = moves && isAngle(name.to) && !isIn(words, "position") && !isIn(words, "pos");
    force = force || (name.to == "force_N" && namesForce(c));
    turns = turns || name.to == "torque_Nm" || turning || choices[c].byTool || (moves && !name.unit.empty());
  }
  if (!force || turns) return;
  for (Choice& choice : choices) {
    std::string& to = choice.name.to;
    if (choice.byMap) continue;
    if (to == "angle_rad") to = "position_m";
    if (to == "angle_reference_rad") to = "position_reference_m";
    if (to == "velocity_rad_per_s") to = "velocity_m_per_s";
    if (to == "velocity_reference_rad_per_s") to = "velocity_reference_m_per_s";
  }
}

/// "encA" that is only ever 0 or 1 is one of an encoder's lines, and no count.
void setLinesAside(const RawTable& table, std::vector<Choice>& choices) {
  for (size_t c = 0; c < choices.size(); ++c) {
    const auto words = wordsOf(table.columns[c].channel.name, true);
    const bool encoder =
        std::any_of(words.begin(), words.end(), [](const auto& one) { return one.starts_with("enc"); });
    const auto& values = table.columns[c].channel.values;
    const bool line = std::all_of(values.begin(), values.end(), [](double v) { return v == 0.0 || v == 1.0; });
    if (encoder && line && choices[c].name.to == "angle_rad" && !choices[c].byMap && values.size() > 1)
      setAside(choices[c], "is only ever 0 or 1: one of an encoder's lines");
  }
}

/// A column without a single number tells nothing, whatever it is called.
void setEmptyAside(const RawTable& table, std::vector<Choice>& choices) {
  for (size_t c = 0; c < choices.size(); ++c) {
    const RawColumn& column = table.columns[c];
    const auto& values = column.channel.values;
    const bool empty = std::none_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
    if (empty && !values.empty() && choices[c].name.understood() && !choices[c].byMap && !column.fault)
      setAside(choices[c], "holds no number");
  }
}

/// A time goes up, seldom down, and doesn't stand still.
bool goesUp(const RawColumn& column) {
  size_t up = 0, down = 0;
  double last = NAN;
  for (const double value : column.channel.values) {
    if (value > last) ++up;
    if (value < last) ++down;
    if (std::isfinite(value)) last = value;
  }
  return up > 0 && 20 * down <= up;
}

void checkTimes(const RawTable& table, std::vector<Choice>& choices) {
  for (size_t c = 0; c < choices.size(); ++c) {
    Choice& choice = choices[c];
    if (choice.name.to != "time_s" || choice.byMap) continue;
    const bool only =
        std::count_if(choices.begin(), choices.end(), [](const Choice& one) { return one.name.to == "time_s"; }) == 1;
    const bool needed = choice.name.rank <= 1 && only;  // then a time that falls is an error with its row
    if (!needed && !goesUp(table.columns[c])) setAside(choice, "doesn't go on increasing, as a time does");
  }
}

/// Where nothing else is the time, a "tick" that goes on in even steps is the clock's, not an encoder's.
void takeTicks(const RawTable& table, std::vector<Choice>& choices) {
  if (std::any_of(choices.begin(), choices.end(), [](const Choice& one) { return one.name.to == "time_s"; })) return;
  for (size_t c = 0; c < choices.size(); ++c) {
    const std::string& name = table.columns[c].channel.name;
    const auto& values = table.columns[c].channel.values;
    const bool tick = isSameWord(name, "tick") || isSameWord(name, "ticks") || isSameWord(name, "systick");
    if (!tick || choices[c].byMap || values.size() < 3 || !(values[1] > values[0])) continue;
    const bool even = std::adjacent_find(values.begin(), values.end(), [&](double a, double b) {
                        return !(b > a) || b - a > 3.0 * (values[1] - values[0]);
                      }) == values.end();
    if (!even) continue;
    choices[c].name = ColumnName{};
    choices[c].name.to = "time_s";
    choices[c].name.rank = 3;
    return;
  }
}

/// Where nothing else is the time, the first column, without a name of its own, that counts since 1970 is.
void takeNamelessStamps(const RawTable& table, std::vector<Choice>& choices) {
  if (choices.empty() || choices.front().name.understood()) return;
  if (std::any_of(choices.begin(), choices.end(), [](const Choice& one) { return one.name.to == "time_s"; })) return;
  const RawColumn& first = table.columns.front();
  const auto& values = first.channel.values;
  const std::string& name = first.channel.name;
  const bool nameless = name.starts_with("column_") || name.find_first_not_of("0123456789.") == std::string::npos;
  if (!nameless || first.fault || values.size() < 2 || !std::is_sorted(values.begin(), values.end())) return;
  constexpr double year2001_s = 1e9, year2065_s = 3e9;
  for (const double unit_s : {1.0, 1e-3, 1e-6, 1e-9}) {
    const double begin_s = (first.origin + values.front()) * unit_s, end_s = (first.origin + values.back()) * unit_s;
    if (begin_s < year2001_s || end_s > year2065_s || !(end_s > begin_s)) continue;
    choices.front().name = ColumnName{};
    choices.front().name.to = "time_s";
    choices.front().name.rank = 6;
    return;
  }
}

/// The axis of the angle, or of the speed; empty when names tell none.
std::string axisOf(const std::vector<Choice>& choices) {
  for (const char* to : {"angle_rad", "position_m", "velocity_rad_per_s", "velocity_m_per_s"}) {
    const Choice* best = nullptr;
    for (const Choice& choice : choices) {
      if (choice.name.to != to || choice.byMap) continue;
      if (best == nullptr || choice.name.rank < best->name.rank) best = &choice;
    }
    if (best != nullptr) return best->name.group;
  }
  return {};
}

/// Of several columns for one thing, one that never changes is the last to be taken; one in counts or electrical turns
/// stands behind one that needs no telling.
int rankOf(const RawColumn& column, const Choice& choice, const ImportMap& map) {
  const UnitNeeds needs = choice.name.needs;
  const bool lacks =
      (needs == UnitNeeds::countsPerRev && !map.counts_per_rev) || (needs == UnitNeeds::polePairs && !map.pole_pairs);
  const auto& values = column.channel.values;
  const bool changes = std::adjacent_find(values.begin(), values.end(), [](double a, double b) {
                         return std::isfinite(a) && std::isfinite(b) && a != b;
                       }) != values.end();
  return choice.name.rank + (changes ? 0 : 10) + (lacks ? 1 : 0);
}

Result<void> takeOneEach(const RawTable& table, const ImportMap& map, std::vector<Choice>& choices,
                         const std::string& place) {
  std::set<std::string> targets;
  for (const Choice& choice : choices) {
    if (choice.name.understood()) targets.insert(choice.name.to);
  }
  for (const std::string& to : targets) {
    size_t best = choices.size();
    for (size_t c = 0; c < choices.size(); ++c) {
      const Choice& choice = choices[c];
      if (choice.name.to != to) continue;
      if (best < choices.size() && choice.byMap && choices[best].byMap)
        return Error{place,
                     "two columns become " + to + "; name another one for \"" + table.columns[c].channel.name + "\""};
      const bool better = best == choices.size() || (choice.byMap && !choices[best].byMap) ||
                          (choice.byMap == choices[best].byMap &&
                           rankOf(table.columns[c], choice, map) < rankOf(table.columns[best], choices[best], map));
      if (better) best = c;
    }
    for (size_t c = 0; c < choices.size(); ++c) {
      if (c != best && choices[c].name.to == to)
        setAside(choices[c], "would be a second " + to + ", beside " + table.columns[best].channel.name);
    }
  }
  return {};
}

Result<void> checkMap(const RawTable& table, const ImportMap& map, const std::string& place) {
  std::vector<std::string> names;
  names.reserve(table.columns.size());
  for (const RawColumn& column : table.columns) names.push_back(column.channel.name);
  std::vector<std::string> wanted;
  wanted.reserve(map.columns.size());
  for (const auto& [name, rule] : map.columns) wanted.push_back(name);
  for (const std::string& name : {map.integrate, map.differentiate, map.split}) {
    if (!name.empty()) wanted.push_back(name);
  }
  for (const std::string& name : wanted) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    const auto suggestion = nearestName(name, names);
    return Error{place, "has no column \"" + name + "\", which the map names" +
                            (suggestion ? ", did you mean " + *suggestion + "?" : "")};
  }
  return {};
}

}  // namespace

ColumnName nameOf(const ColumnRule& rule) {
  ColumnName name;
  name.to = rule.to;
  name.scale = rule.scale;
  name.offset = rule.offset;
  name.unit = rule.unit.empty() ? "map" : rule.unit;
  name.rank = -2;
  if (const Unit* unit = rule.unit.empty() ? nullptr : unitNamed(rule.unit)) {
    name.scale = unit->scale;
    name.offset = unit->offset;
    name.needs = unit->needs;
  }
  return name;
}

Result<std::vector<Choice>> chooseColumns(const RawTable& table, const ImportMap& map, const ToolColumns& tool,
                                          const std::string& place) {
  if (const auto fits = checkMap(table, map, place); !fits) return fits.error();
  std::vector<Choice> choices;
  for (const RawColumn& column : table.columns) {
    const std::string& name = column.channel.name;
    Choice choice;
    if (const auto rule = map.columns.find(name); rule != map.columns.end()) {
      choice.name = nameOf(rule->second);
      choice.byMap = true;
    } else if (const auto known = tool.find(name); known != tool.end()) {
      choice.name = known->second;
      choice.byTool = true;
    } else {
      choice = guess(column);
    }
    if (map.sample_time_s && choice.name.to == "time_s" && !choice.byMap)
      setAside(choice, "the map's sample time takes its place");
    if (column.clock && choice.name.understood() && choice.name.to != "time_s") setAside(choice, "holds times of day");
    if (column.clock && !choice.byMap && !choice.name.understood()) {
      choice.name = ColumnName{};
      choice.name.to = "time_s";
      choice.name.unit = "clock";
      choice.name.rank = 6;
    }
    choices.push_back(std::move(choice));
  }
  takeNamedAxes(table, choices);
  checkTimes(table, choices);
  if (!map.sample_time_s) takeTicks(table, choices);
  if (!map.sample_time_s) takeNamelessStamps(table, choices);
  setPhasesAside(table, choices);
  setEmptyAside(table, choices);
  setPidTermsAside(table, choices);
  setPresentAside(table, choices);
  setLinesAside(table, choices);
  setRowNumbersAside(table, choices);
  setPlacesAside(table, choices);
  takeLinear(table, choices);
  setVehiclesAside(choices);
  const std::string axis = axisOf(choices);
  for (Choice& choice : choices) {
    if (!choice.name.understood() || choice.byMap || choice.name.to == "time_s") continue;
    if (!axis.empty() && !choice.name.group.empty() && choice.name.group != axis)
      setAside(choice, "belongs to another axis (" + choice.name.group + ") than the one taken (" + axis + ")");
  }
  if (const auto one = takeOneEach(table, map, choices, place); !one) return one.error();
  for (size_t c = 0; c < choices.size(); ++c) {
    const auto& fault = table.columns[c].fault;
    if (!fault) continue;
    if (choices[c].name.understood()) return *fault;
    choices[c].dropped = true;
    choices[c].name.aside = "holds text";
  }
  return choices;
}

}  // namespace breakaway
