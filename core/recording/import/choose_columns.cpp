#include "recording/import/choose_columns.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

#include "base/json_object.h"
#include "recording/columns.h"
#include "recording/import/assign_motion.h"
#include "recording/import/columns_beside.h"
#include "recording/import/drive_evidence.h"
#include "recording/import/drives_beside.h"
#include "recording/import/foreign_names.h"
#include "recording/import/joined_words.h"
#include "recording/import/motion_beside.h"
#include "recording/import/name_parts.h"
#include "recording/import/names_beside.h"
#include "recording/import/others_beside.h"
#include "recording/import/quantity_words.h"
#include "recording/import/settle_motion.h"
#include "recording/import/settling.h"
#include "recording/import/trials.h"
#include "recording/import/turns_beside.h"

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

/// The one word without which the name would be understood; empty when there is none, or several.
std::string strangeWord(const RawColumn& column, const Choice& choice) {
  if (!choice.name.unknownWord.empty() || choice.name.understood() || column.fault) return choice.name.unknownWord;
  std::string strange;
  for (const std::string& word : partsOfName(column.channel.name, column.unit).plain) {
    const std::string_view bare = std::string_view(word).substr(0, word.find_last_not_of("0123456789") + 1);
    if (word.size() < 2 || isKnownWord(word) || isNumber(word) || isIn(otherSources, bare)) continue;  // "mppt0"
    if (!strange.empty()) return {};
    strange = word;
  }
  return strange;
}

/// An unknown word beside two different quantities is an axis' name: "pos_slew" beside "vel_slew", "RPM_vl" beside
/// "PWM_vl".
void takeNamedAxes(const RawTable& table, std::vector<Choice>& choices) {
  std::map<std::string, std::set<std::string>> behind;
  std::vector<ColumnName> names(choices.size());
  std::vector<std::string> words(choices.size());
  for (size_t c = 0; c < choices.size(); ++c) {
    words[c] = strangeWord(table.columns[c], choices[c]);
    const std::string& word = words[c];
    if (word.size() < 2 || choices[c].byMap || choices[c].byTool) continue;
    names[c] = understandName(nameWithout(table.columns[c].channel.name, word), table.columns[c].unit);
    const size_t reference = names[c].to.find("_reference");  // of the same quantity
    if (names[c].understood()) behind[word].insert(names[c].to.substr(0, std::min(reference, names[c].to.find('_'))));
  }
  std::set<std::string> plain;  // quantities that a column has without such a word
  for (const Choice& choice : choices) {
    const std::string& to = choice.name.to;
    if (choice.name.understood() && !choice.name.qualified && to.find("_reference") == std::string::npos)
      plain.insert(to.substr(0, to.find('_')));
  }
  std::set<std::string> axes;
  for (size_t c = 0; c < choices.size(); ++c) {
    const std::string& word = words[c];
    if (!names[c].understood() || behind[word].size() < 2) continue;
    const bool other = std::any_of(behind[word].begin(), behind[word].end(), [&](const std::string& quantity) {
      return (quantity == "angle" || quantity == "velocity") && plain.contains(quantity);
    });
    if (other) continue;  // "omega_column" beside "omega_motor"
    names[c].group += (names[c].group.empty() ? "" : ".") + word;
    ++names[c].rank;
    choices[c].name = names[c];
    axes.insert(word);
  }
  for (size_t c = 0; c < choices.size(); ++c) {  // what was understood in spite of the word is of that axis, too
    if (!choices[c].name.qualified || names[c].understood() || choices[c].byMap || choices[c].byTool) continue;
    const Words all = partsOfName(table.columns[c].channel.name, table.columns[c].unit).words;
    const std::string* axis = firstIn(all, axes);
    if (axis != nullptr) choices[c].name.group += (choices[c].name.group.empty() ? "" : ".") + *axis;
  }
}

bool namesTime(const RawColumn& column) {
  const NameParts parts = partsOfName(column.channel.name, column.unit);
  return parts.words.empty() || std::any_of(parts.words.begin(), parts.words.end(), [](const std::string& word) {
           const Word* quantity = quantityNamed(word);
           return quantity != nullptr && quantity->kind == UnitKind::time;
         });
}

bool seldomFalls(const std::vector<double>& values) {
  constexpr size_t rows = 100;  // of which one may
  size_t falls = 0;
  for (size_t k = 1; k < values.size(); ++k) falls += values[k] < values[k - 1] ? 1 : 0;
  return rows * falls <= values.size();
}

void checkTimes(const RawTable& table, std::vector<Choice>& choices) {
  for (size_t c = 0; c < choices.size(); ++c) {
    Choice& choice = choices[c];
    if (choice.name.to != "time_s" || choice.byMap) continue;
    const bool only =
        std::count_if(choices.begin(), choices.end(), [](const Choice& one) { return one.name.to == "time_s"; }) == 1;
    const bool needed = choice.name.rank <= 1 && only;  // then a time that falls is an error with its row
    if (needed) continue;
    const auto& values = table.columns[c].channel.values;
    const bool onlyUnit = !namesTime(table.columns[c]);  // "total_us" may be how long something took
    if (goesUpInTrials(values, {}) && (!onlyUnit || seldomFalls(values))) continue;
    const auto trials = trialsIn(table);
    if (!trials || onlyUnit || !goesUpInTrials(values, trials->borders))
      setAside(choice, message("doesn't go on increasing, as a time does"));
  }
}

/// Goes up in steps that are alike, those of one row or, where several axes' rows stand in turn, of several.
bool hasEvenSteps(const std::vector<double>& values) {
  constexpr size_t mostAxes = 16;
  constexpr double alike = 3.0;
  if (values.size() < 3 || !std::is_sorted(values.begin(), values.end())) return false;
  for (size_t stride = 1; stride <= mostAxes && values.size() > 2 * stride; ++stride) {
    const double first = values[stride] - values[0];
    bool even = first > 0.0;
    for (size_t k = 0; k + stride < values.size() && even; ++k) {
      const double step = values[k + stride] - values[k];
      even = step > 0.0 && step <= alike * first;
    }
    if (even) return true;
  }
  return false;
}

/// Goes up by one from row to row, as a number of rows does, too.
bool goesByOnes(const std::vector<double>& values) {
  return std::adjacent_find(values.begin(), values.end(), [](double a, double b) { return b - a != 1.0; }) ==
         values.end();
}

/// Where nothing else is the time, a "tick" that goes on in even steps is the clock's, not an encoder's, and a
/// "duration" is that of the run. By ones it may be in ms, or count the rows: that is asked.
void takeTicks(const RawTable& table, std::vector<Choice>& choices) {
  if (std::any_of(choices.begin(), choices.end(), [](const Choice& one) { return one.name.to == "time_s"; })) return;
  for (size_t c = 0; c < choices.size(); ++c) {
    const std::string& name = table.columns[c].channel.name;
    const auto& values = table.columns[c].channel.values;
    const bool tick = isSameWord(name, "tick") || isSameWord(name, "ticks") || isSameWord(name, "systick") ||
                      isSameWord(name, "duration");
    if (!tick || choices[c].byMap || !hasEvenSteps(values)) continue;
    if (!isSameWord(name, "duration") && goesByOnes(values)) {
      choices[c].name = ColumnName{};
      choices[c].name.aside = message("may count rows as well as milliseconds");
      continue;
    }
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

/// Where nothing else is the time, the first column is, if it goes on in even steps other than those of rows by number
/// and its name says nothing that is known.
void takeFirstAsTime(const RawTable& table, std::vector<Choice>& choices) {
  if (choices.empty() || choices.front().name.understood() || choices.front().byMap || choices.front().byTool) return;
  if (std::any_of(choices.begin(), choices.end(), [](const Choice& one) { return one.name.to == "time_s"; })) return;
  const RawColumn& first = table.columns.front();
  const auto& values = first.channel.values;
  constexpr size_t fewestRows = 50;
  const NameParts parts = partsOfName(first.channel.name, first.unit);
  static constexpr auto numbers = std::to_array<std::string_view>(
      {"index", "idx", "sample", "samples", "frame", "step", "row", "id", "seq", "count", "counter", "no", "nr", "k"});
  // What may go up in even steps and is no time: where something is, how much of it, how often.
  static constexpr auto others = std::to_array<std::string_view>(
      {"x",        "y",       "z",        "value",  "distance", "dist",    "way",    "length", "depth",     "height",
       "level",    "width",   "range",    "radius", "place",    "volume",  "mass",   "weight", "load",      "freq",
       "f",        "order",   "lap",      "turn",   "cycle",    "cycles",  "loop",   "iter",   "iteration", "epochs",
       "point",    "pixel",   "line",     "node",   "block",    "address", "code",   "adc",    "dac",       "raw",
       "register", "percent", "throttle", "gain",   "slip",     "stress",  "strain", "energy", "charge",    "soc",
       "year",     "trial",   "episode",  "run",    "clk"});
  const bool strange = !first.channel.name.starts_with("column_") && !parts.words.empty() &&
                       std::none_of(parts.words.begin(), parts.words.end(), [](const std::string& word) {
                         const Word* quantity = quantityNamed(word);
                         return (quantity != nullptr && !quantity->weak) || isIn(numbers, word) || isNumber(word) ||
                                isIn(referenceWords, word) || isIn(otherThings, word) || isIn(others, word);
                       });
  const bool timely = parts.unit == nullptr ? !parts.unknownUnit : parts.unit->kind == UnitKind::time;
  if (first.fault || values.size() < fewestRows || !strange || !timely || !hasEvenSteps(values)) return;
  if (values[1] - values[0] == 1.0 && values.back() - values.front() == static_cast<double>(values.size() - 1)) return;
  choices.front().name = ColumnName{};
  choices.front().name.to = "time_s";
  choices.front().name.rank = 6;
  choices.front().name.unit = parts.unitText;
  choices.front().name.scale = parts.unit == nullptr ? 1.0 : parts.unit->scale * parts.factor;
  choices.front().name.guess = message("goes on in even steps, and nothing else is a time");
}

/// The lower, the sooner a column is taken: of two alike the one whose name has no unknown word.
int standing(const Choice& choice) {
  return 2 * choice.name.rank + (choice.name.qualified ? 1 : 0);
}

/// The axis of the angle, or of the speed; empty when names tell none.
std::string axisOf(const std::vector<Choice>& choices) {
  for (const char* to : {"angle_rad", "position_m", "velocity_rad_per_s", "velocity_m_per_s"}) {
    const Choice* best = nullptr;
    for (const Choice& choice : choices) {
      if (choice.name.to != to || choice.byMap) continue;
      if (best == nullptr || standing(choice) < standing(*best)) best = &choice;
    }
    if (best != nullptr) return best->name.group;
  }
  return {};
}

/// Of several columns for one thing, one that never changes is the last to be taken; one in counts or electrical turns
/// stands behind one that needs no telling.
int rankOf(const RawColumn& column, const Choice& choice, const ImportMap& map) {
  const UnitNeeds needs = choice.name.needs;
  constexpr double manyTurns = 30.0;  // whole numbers that go so far are counted, and nobody says in what
  const auto& values = column.channel.values;
  const bool counted =
      choice.name.to == "angle_rad" && choice.name.unit.empty() && areWhole(values) && rangeOf(values) >= manyTurns;
  const bool lacks = ((needs == UnitNeeds::countsPerRev || counted) && !map.counts_per_rev) ||
                     (needs == UnitNeeds::polePairs && !map.pole_pairs);
  const bool changes = std::adjacent_find(values.begin(), values.end(), [](double a, double b) {
                         return std::isfinite(a) && std::isfinite(b) && a != b;
                       }) != values.end();
  return standing(choice) + (changes ? 0 : 20) + (lacks ? 4 : 0);
}

/// The column that would be taken as `to`; the number of columns where there is none.
size_t bestFor(const RawTable& table, const ImportMap& map, const std::vector<Choice>& choices, const std::string& to) {
  size_t best = choices.size();
  for (size_t c = 0; c < choices.size(); ++c) {
    if (choices[c].name.to != to) continue;
    const auto standingOf = [&](size_t k) {  // who says so counts first: the map, the tool's own names, what names tell
      const int told = choices[k].byMap ? 0 : choices[k].byTool ? 1 : 2;
      return std::pair(told, rankOf(table.columns[k], choices[k], map));
    };
    if (best == choices.size() || standingOf(c) < standingOf(best)) best = c;
  }
  return best;
}

std::vector<int> ranksOf(const RawTable& table, const ImportMap& map, const std::vector<Choice>& choices) {
  std::vector<int> ranks;
  ranks.reserve(choices.size());
  for (size_t c = 0; c < choices.size(); ++c) ranks.push_back(rankOf(table.columns[c], choices[c], map));
  return ranks;
}

/// Angles and speeds that don't go with those that would be taken.
void dropStrangers(const RawTable& table, const ImportMap& map, std::vector<Choice>& choices) {
  const size_t place = bestFor(table, map, choices, "position_m"),
               rotation = bestFor(table, map, choices, "velocity_rad_per_s");
  if (std::max(place, rotation) < choices.size()) setStrangePlaceAside(table, place, rotation, choices);
  assignMotion(table, ranksOf(table, map, choices), choices);
}

/// The columns that would be taken as the angle and the speed.
std::vector<size_t> motionOf(const RawTable& table, const ImportMap& map, const std::vector<Choice>& choices) {
  std::vector<size_t> motion;
  for (const char* to : {"angle_rad", "velocity_rad_per_s", "position_m", "velocity_m_per_s"}) {
    const size_t best = bestFor(table, map, choices, to);
    if (best < choices.size()) motion.push_back(best);
  }
  return motion;
}

/// Of columns for one thing that stand alike and that are called by as many words that aren't known, nobody can tell
/// the motor's: of three drives, parts of a balance of torques, say; of two motions that their unit alone tells, one of
/// which may be what is set, or another machine's.
void setSeveralAside(const RawTable& table, const ImportMap& map, std::vector<Choice>& choices) {
  const auto setAsideOf = [&](const std::string& to, size_t fewest, bool (*open)(const ColumnName&)) {
    const size_t best = bestFor(table, map, choices, to);
    if (best == choices.size()) return;
    std::set<Words> called;
    std::vector<size_t> alike;
    for (size_t c = 0; c < choices.size(); ++c) {
      if (choices[c].name.to != to || choices[c].byMap || choices[c].byTool || !open(choices[c].name)) continue;
      if (rankOf(table.columns[c], choices[c], map) != rankOf(table.columns[best], choices[best], map)) continue;
      called.insert(ownerOf(table.columns[c].channel.name));
      alike.push_back(c);
    }
    if (called.size() < fewest || std::find(alike.begin(), alike.end(), best) == alike.end()) return;
    for (const size_t c : alike) setAside(choices[c], message("is one of several, and no name tells the motor's"));
  };
  for (const char* to : {"torque_Nm", "current_A", "voltage_V", "force_N"})
    setAsideOf(to, 3, [](const ColumnName& name) { return !name.guess.empty() && name.qualified; });
  for (const char* to : {"angle_rad", "position_m", "velocity_rad_per_s", "velocity_m_per_s"})
    setAsideOf(to, 2, [](const ColumnName& name) { return name.byUnit; });
}

/// Where only the order of the columns decided for a motion or a drive, of those that are called by different words and
/// differ, the choice is a guess.
void doubtArbitrary(const RawTable& table, const ImportMap& map, std::vector<Choice>& choices, size_t best) {
  static constexpr auto doubtful = std::to_array<std::string_view>(
      {"angle_rad", "position_m", "velocity_rad_per_s", "velocity_m_per_s", "current_A", "torque_Nm", "voltage_V"});
  ColumnName& taken = choices[best].name;
  const Words called = ownerOf(table.columns[best].channel.name);
  if (!isIn(doubtful, taken.to) || choices[best].byMap || choices[best].byTool || !taken.guess.empty()) return;
  for (size_t c = 0; c < choices.size(); ++c) {
    const bool alike = c != best && choices[c].name.to == taken.to && !choices[c].byMap && !choices[c].byTool &&
                       rankOf(table.columns[c], choices[c], map) == rankOf(table.columns[best], choices[best], map);
    if (!alike || ownerOf(table.columns[c].channel.name) == called) continue;
    constexpr double alikeValues = 0.95;  // in another unit, or filtered
    const auto& own = table.columns[best].channel.values;
    if (likenessOf(own, table.columns[c].channel.values).correlation >= alikeValues) continue;
    taken.guess = message("{} may be meant as well; only its place decided", table.columns[c].channel.name);
    return;
  }
}

Result<void> takeOneEach(const RawTable& table, const ImportMap& map, std::vector<Choice>& choices,
                         const std::string& place) {
  std::set<std::string> targets;
  for (const Choice& choice : choices) {
    if (choice.name.understood()) targets.insert(choice.name.to);
  }
  for (const std::string& to : targets) {
    size_t byMap = choices.size();
    for (size_t c = 0; c < choices.size(); ++c) {
      if (choices[c].name.to != to || !choices[c].byMap) continue;
      if (byMap < choices.size())
        return Error{place,
                     message("two columns become {}; name another one for \"{}\"", to, table.columns[c].channel.name)};
      byMap = c;
    }
    const size_t best = bestFor(table, map, choices, to);
    doubtArbitrary(table, map, choices, best);
    for (size_t c = 0; c < choices.size(); ++c) {
      if (c != best && choices[c].name.to == to)
        setAside(choices[c], message("would be a second {}, beside {}", to, table.columns[best].channel.name));
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
    return Error{place, suggestion
                            ? message("has no column \"{}\", which the map names, did you mean {}?", name, *suggestion)
                            : message("has no column \"{}\", which the map names", name)};
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
      setAside(choice, message("the map's sample time takes its place"));
    if (column.clock && choice.name.understood() && choice.name.to != "time_s")
      setAside(choice, message("holds times of day"));
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
  if (!map.sample_time_s) takeTimesInSteps(table, choices);
  if (!map.sample_time_s) takeTicks(table, choices);
  if (!map.sample_time_s) takeNamelessStamps(table, choices);
  if (!map.sample_time_s) takeFirstAsTime(table, choices);
  takeByNeighbours(table, map, choices);
  judgeByNeighbours(table, choices);
  takeDoubtful(table, choices);
  takeForeignNames(table, choices);
  takeAnglesByValues(table, choices);
  takeMotionByValues(table, choices);
  takeJointsAlone(table, choices);
  takeOnlyAngle(table, choices);
  setElectricalAside(table, choices);
  preferDriven(table, choices);
  const std::string axis = axisOf(choices);
  for (Choice& choice : choices) {
    if (!choice.name.understood() || choice.byMap || choice.name.to == "time_s") continue;
    if (!axis.empty() && !choice.name.group.empty() && choice.name.group != axis)
      setAside(choice, message("belongs to another axis ({}) than the one taken ({})", choice.name.group, axis));
  }
  dropStrangers(table, map, choices);
  setOthersDrivesAside(table, motionOf(table, map, choices), choices);
  setSeveralAside(table, map, choices);
  preferMotionsOwn(table, ranksOf(table, map, choices), choices);
  if (const auto one = takeOneEach(table, map, choices, place); !one) return one.error();
  setUnmovedReferencesAside(table, choices);
  for (size_t c = 0; c < choices.size(); ++c) {
    const auto& fault = table.columns[c].fault;
    if (!fault) continue;
    if (choices[c].name.understood()) return *fault;
    choices[c].dropped = true;
    choices[c].name.aside = message("holds text");
  }
  return choices;
}

}  // namespace breakaway
