#include "recording/import/names_beside.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

#include "recording/import/columns_beside.h"
#include "recording/import/letters_beside.h"
#include "recording/import/name_parts.h"
#include "recording/import/quantity_words.h"
#include "recording/import/settle_motion.h"
#include "recording/import/vehicles_beside.h"

namespace breakaway {

namespace {

/// "Power Max [3]" of "Power Max [3] Velocity", "Power Max [3] Position"…: a device's name, whatever its words mean.
void takeBehindDevices(const RawTable& table, std::vector<Choice>& choices) {
  constexpr size_t fewest = 3;
  const auto deviceOf = [&table](size_t c) {
    const std::string& name = table.columns[c].channel.name;
    const size_t open = name.find('['), close = name.find("] ");
    const bool numbered = open != std::string::npos && open > 1 && close != std::string::npos && open < close &&
                          isNumber(name.substr(open + 1, close - open - 1));
    if (!numbered) return std::string();
    const Words words = wordsOf(name.substr(0, open), true);
    const bool meant = std::any_of(words.begin(), words.end(), [](const std::string& word) {
      return isIn(jointWords, word) || isIn(drivenWords, word) || isIn(referenceWords, word) ||
             quantityNamed(word) != nullptr;
    });
    return meant ? std::string() : name.substr(0, close + 1);  // "Joint Max [1] Velocity" is a limit
  };
  std::map<std::string, size_t> devices;
  for (size_t c = 0; c < choices.size(); ++c) ++devices[deviceOf(c)];
  for (size_t c = 0; c < choices.size(); ++c) {
    const std::string device = deviceOf(c);
    if (device.empty() || devices[device] < fewest || choices[c].name.understood() || choices[c].byMap ||
        choices[c].byTool)
      continue;
    const std::string number = device.substr(device.find('[') + 1, device.size() - device.find('[') - 2);
    choices[c].name =
        understandName(number + table.columns[c].channel.name.substr(device.size()), table.columns[c].unit);
  }
}

bool isMotion(const std::string& to) {
  return to == "angle_rad" || to == "position_m" || to == "velocity_rad_per_s" || to == "velocity_m_per_s";
}

/// "/lowstate/motor_state[0]/q", "inertia1.w": what stands behind the last stroke or dot is the name, what before it
/// whose; it must be a motor's or a joint's, or the path of another name that is understood.
void takeBehindPaths(const RawTable& table, std::vector<Choice>& choices) {
  const auto pathOf = [&table](size_t c) {
    const std::string& name = table.columns[c].channel.name;
    const size_t end = name.find_last_of("/.");
    return end == std::string::npos || end == 0 || end + 1 == name.size() ? std::string() : name.substr(0, end + 1);
  };
  const auto folderOf = [](const std::string& path) {
    const size_t mark = path.size() < 2 ? std::string::npos : path.find_last_of("/.", path.size() - 2);
    return path.substr(mark == std::string::npos ? 0 : mark + 1);
  };
  std::set<std::string> known, folders, names;
  for (const RawColumn& column : table.columns) names.insert(column.channel.name);
  for (size_t c = 0; c < choices.size(); ++c) {
    if (!choices[c].name.understood() || choices[c].name.to == "time_s") continue;
    known.insert(pathOf(c));
    folders.insert(folderOf(pathOf(c)));
  }
  for (size_t c = 0; c < choices.size(); ++c) {
    const std::string whose = pathOf(c);
    if (whose.empty() || choices[c].name.understood() || choices[c].byMap || choices[c].byTool) continue;
    const NameParts path = partsOfName(whose.substr(0, whose.size() - 1), {});
    const bool joints = whose.back() == '/' && firstIn(path.words, jointWords) != nullptr;
    const auto words = wordsOf(table.columns[c].channel.name.substr(whose.size()), true);
    const bool goal = firstIn(words, referenceWords) != nullptr && folders.contains(folderOf(whose));
    if (!joints && !known.contains(whose) && !goal) continue;
    if (otherThingIn(path.words) != nullptr || path.unit != nullptr) continue;
    const bool wanted = firstIn(path.words, referenceWords) != nullptr;
    const bool speed = words == Words{"v"} && names.contains(whose + "q");  // "joint_0.v" beside "joint_0.q"
    const std::string last = speed ? "velocity" : table.columns[c].channel.name.substr(whose.size());
    ColumnName own = understandName(last + (wanted ? "_cmd" : ""), table.columns[c].unit);
    if (!own.understood()) continue;
    own.group = path.group + (path.group.empty() || own.group.empty() ? "" : ".") + own.group;
    choices[c].name = own;
  }
}

/// "joint_pos/FL_hip" beside "joint_pos/FL_thigh": what stands before the last stroke is the name, what behind it
/// whose.
void takeBeforePaths(const RawTable& table, std::vector<Choice>& choices) {
  const auto strokeOf = [&table](size_t c) { return table.columns[c].channel.name.find_last_of("/."); };
  std::map<std::string, std::set<std::string>> owners;
  for (size_t c = 0; c < choices.size(); ++c) {
    const std::string& name = table.columns[c].channel.name;
    const size_t at = strokeOf(c);
    if (at == std::string::npos || at == 0 || at + 1 == name.size()) continue;
    owners[name.substr(0, at)].insert(name.substr(at + 1));
  }
  for (size_t c = 0; c < choices.size(); ++c) {
    const std::string& name = table.columns[c].channel.name;
    const size_t at = strokeOf(c);
    if (at == std::string::npos || choices[c].name.understood() || choices[c].byMap || choices[c].byTool) continue;
    const auto known = owners.find(name.substr(0, at));
    if (known == owners.end() || known->second.size() < 2) continue;
    ColumnName own = understandName(known->first, table.columns[c].unit);
    const Words behind = wordsOf(name.substr(at + 1), true);
    const bool quantity = std::any_of(behind.begin(), behind.end(), [](const std::string& word) {
      const Word* named = quantityNamed(word);
      return named != nullptr && !named->weak;
    });
    if (!own.understood() || quantity || otherThingIn(behind) != nullptr) continue;
    own.group += (own.group.empty() ? "" : ".") + name.substr(at + 1);
    choices[c].name = std::move(own);
  }
}

/// "DC_Motor.i (A)": a letter with its unit says enough behind a path that names nothing else, and so does, as a guess,
/// what is understood by itself behind a model's block ("Controller/u_cmd [V]").
void takeLettersWithUnits(const RawTable& table, std::vector<Choice>& choices) {
  for (size_t c = 0; c < choices.size(); ++c) {
    const std::string& name = table.columns[c].channel.name;
    const size_t bracket = std::min(name.find_first_of("[("), name.size());
    const size_t at = name.substr(0, bracket).find_last_of("/.");
    if (at == std::string::npos || at == 0 || choices[c].name.understood() || choices[c].byMap || choices[c].byTool)
      continue;
    const NameParts path = partsOfName(name.substr(0, at), {}), last = partsOfName(name.substr(at + 1), {});
    const bool letter = last.unit != nullptr && last.words.size() == 1 && last.words[0].size() == 1;
    const bool another = otherThingIn(path.words) != nullptr || firstIn(path.words, supplyWords) != nullptr ||
                         firstIn(path.words, loadWords) != nullptr || firstIn(path.words, driverWords) != nullptr;
    const bool motors = firstIn(path.words, jointWords) != nullptr || isIn(path.words, "machine");
    const bool block = last.unit != nullptr && last.words.size() > 1 && name[at] == '/' &&
                       choices[c].name.saysNothing && otherThingIn(path.words) == nullptr &&
                       firstIn(path.words, supplyWords) == nullptr && firstIn(path.words, loadWords) == nullptr;
    if (!block && (!letter || !motors || (another && path.words.front() != "dc"))) continue;
    ColumnName own = understandName(name.substr(at + 1), table.columns[c].unit);
    if (block) own.guess = message("what \"{}\" says of it is unknown", name.substr(0, at));
    if (own.understood()) choices[c].name = std::move(own);
  }
}

/// "l_pwm" beside "r_pwm" is of the axis of "left_counts", and so is "rpm_L_real" beside "rpm_R_real".
void takeSides(const RawTable& table, std::vector<Choice>& choices) {
  constexpr std::string_view marks = "_ .";
  std::set<std::string> names;
  for (const RawColumn& column : table.columns) names.insert(column.channel.name);
  for (size_t c = 0; c < choices.size(); ++c) {
    const std::string& name = table.columns[c].channel.name;
    if (choices[c].byMap) continue;
    for (size_t at = 0; at + 2 < name.size(); ++at) {
      const size_t side = std::string_view("lrLR").find(name[at]);
      const bool apart = (at == 0 || marks.find(name[at - 1]) != std::string_view::npos) &&
                         marks.find(name[at + 1]) != std::string_view::npos && (at > 0 || name[1] == '_');
      if (side == std::string_view::npos || !apart) continue;
      std::string other = name;
      other[at] = "rlRL"[side];
      if (!names.contains(other)) continue;
      if (!choices[c].byTool)
        choices[c].name = understandName(name.substr(0, at) + name.substr(at + 2), table.columns[c].unit);
      std::string& group = choices[c].name.group;
      group = std::string(side % 2 == 0 ? "left" : "right") + (group.empty() ? "" : "." + group);
      break;
    }
  }
}

/// "spd" beside "spd_fb" and no other reference is what "spd_fb" shall be; beside another one it is neither.
void takeUnmarkedReferences(const RawTable& table, std::vector<Choice>& choices) {
  const auto told = [&](size_t c) {
    return choices[c].name.understood() && !choices[c].byMap && !choices[c].byTool && !table.columns[c].fault;
  };
  for (size_t k = 0; k < choices.size(); ++k) {
    Words words = wordsOf(table.columns[k].channel.name, true);
    const bool marked = std::erase_if(words, [](const std::string& word) { return isIn(measuredWords, word); }) > 0;
    const std::string to = choices[k].name.to;
    const std::string reference =
        to.empty() ? "" : std::string(to).insert(std::min(to.find('_'), to.size()), "_reference");
    if (!marked || words.empty() || !told(k) || (!isMotion(to) && to != "current_A")) continue;
    const bool another = std::any_of(choices.begin(), choices.end(), [&](const Choice& one) {
      return one.name.to == reference && one.name.group == choices[k].name.group;
    });
    for (size_t c = 0; c < choices.size(); ++c) {
      const bool plain = c != k && told(c) && choices[c].name.to == to &&
                         choices[c].name.unit == choices[k].name.unit &&
                         wordsOf(table.columns[c].channel.name, true) == words;
      if (!plain) continue;
      const std::string& of = table.columns[k].channel.name;
      if (another) {
        setAside(choices[c], message("isn't called measured, as {} is", of));
      } else {
        choices[c].name.to = reference;
        choices[c].name.guess = message("what {} shall be", of);
      }
    }
  }
}

/// "com_pos" beside "enc_pos" is what was commanded, and so is all that is called "com" there.
void takeCommanded(const RawTable& table, std::vector<Choice>& choices) {
  static constexpr auto measured = std::to_array<std::string_view>(
      {"enc", "encoder", "act", "actual", "meas", "measured", "fb", "feedback", "real", "mot", "motor"});
  std::set<Words> names;
  for (const RawColumn& column : table.columns) names.insert(wordsOf(column.channel.name, true));
  const bool commands = std::any_of(names.begin(), names.end(), [&](Words words) {
    const auto com = std::find(words.begin(), words.end(), "com");
    return com != words.end() && words.size() > 1 && std::any_of(measured.begin(), measured.end(), [&](auto word) {
             *com = word;
             return names.contains(words);
           });
  });
  for (size_t c = 0; c < choices.size() && commands; ++c) {
    const std::string& name = table.columns[c].channel.name;
    if (choices[c].byMap || choices[c].byTool || !isIn(wordsOf(name, true), "com")) continue;
    choices[c].name = understandName("cmd " + nameWithout(name, "com"), table.columns[c].unit);
  }
}

/// "torque_cur" beside "torque_ref" is the torque now, and no current.
void takePresent(const RawTable& table, std::vector<Choice>& choices) {
  std::set<Words> wanted;  // without the word of reference
  for (const RawColumn& column : table.columns) {
    Words words = wordsOf(column.channel.name, true);
    if (std::erase_if(words, [](const std::string& word) { return isIn(referenceWords, word); }) > 0)
      wanted.insert(std::move(words));
  }
  for (size_t c = 0; c < choices.size(); ++c) {
    Words words = wordsOf(table.columns[c].channel.name, true);
    const auto now = std::erase_if(
        words, [](const std::string& word) { return word == "cur" || word == "curr" || word == "current"; });
    const bool current = choices[c].name.to == "current_A" && choices[c].name.unit.empty();
    if (now != 1 || !current || choices[c].byMap || choices[c].byTool || !wanted.contains(words)) continue;
    std::string name;
    for (const std::string& word : words) name += (name.empty() ? "" : "_") + word;
    const ColumnName own = understandName(name, table.columns[c].unit);
    if (own.understood()) choices[c].name = own;
  }
}

/// "joint1_ref" beside "joint1_angle", with no other motion of that joint, is what the angle shall be.
void takeOwnersReferences(const RawTable& table, std::vector<Choice>& choices) {
  for (size_t c = 0; c < choices.size(); ++c) {
    const std::string& name = table.columns[c].channel.name;
    const Words words = wordsOf(name, true), owner = ownerOf(name);
    const bool quantity =
        std::any_of(words.begin(), words.end(), [](const std::string& one) { return quantityNamed(one) != nullptr; });
    const bool open =
        !choices[c].name.understood() && !choices[c].byMap && !choices[c].byTool && !table.columns[c].fault;
    if (!open || quantity || owner.empty() || firstIn(words, referenceWords) == nullptr) continue;
    const NameParts parts = partsOfName(name, table.columns[c].unit);
    if (otherThingIn(words) != nullptr || parts.unknownUnit) continue;
    std::set<std::string> motions;
    size_t of = choices.size();
    for (size_t k = 0; k < choices.size(); ++k) {
      const std::string& to = choices[k].name.to;
      if (!isMotion(to) || ownerOf(table.columns[k].channel.name) != owner) continue;
      motions.insert(to);
      of = k;
    }
    if (motions.size() != 1) continue;
    ColumnName reference = choices[of].name;
    if (parts.unit != nullptr) {  // "extruder_cmd_mm" beside "extruder_pos_mm"
      const Unit* measured = unitNamed(reference.unit);
      if (measured == nullptr || measured->kind != parts.unit->kind) continue;
      reference.unit = parts.unitText;
      reference.scale = parts.unit->scale * parts.factor;
      reference.needs = parts.unit->needs;
    }
    reference.to.insert(reference.to.find('_'), "_reference");
    reference.guess = message("what {} shall be", table.columns[of].channel.name);
    choices[c].name = reference;
  }
}

/// A gear's input turns as its output does, times a number that isn't one.
bool areGeared(const std::vector<double>& input, const std::vector<double>& output) {
  constexpr double alike = 0.999, ratio = 1.05;
  const Likeness one = likenessOf(input, output);
  return one.correlation > alike && std::abs(std::log(one.times)) > std::log(ratio);
}

/// "input_speed" and "output_speed" (or "speed_in", "speed_out") are a gear's two sides, of which the motor's is the
/// first, where torques stand beside them, or are all that is told of both, or the one is a multiple of the other. Else
/// what goes in is a reference.
void takeGearSides(const RawTable& table, std::vector<Choice>& choices) {
  const auto sideOf = [&table](size_t c, std::string_view side) {
    Words words = wordsOf(table.columns[c].channel.name, true);
    return std::erase_if(words, [&](const std::string& word) { return word == side; }) == 1 ? words : Words{};
  };
  const auto withoutSide = [&](size_t c, bool brief) {  // "in" changes nothing
    const RawColumn& column = table.columns[c];
    return brief ? choices[c].name : understandName(nameWithout(column.channel.name, "input"), column.unit);
  };
  struct Pair {
    size_t input, output;
    bool brief;  // "in" and "out"
  };
  std::vector<Pair> pairs;
  bool torque = false;
  for (size_t c = 0; c < choices.size(); ++c) {
    const bool brief = sideOf(c, "input").empty();
    const Words input = sideOf(c, brief ? "in" : "input");
    if (input.empty() || choices[c].byMap || choices[c].byTool || !withoutSide(c, brief).understood()) continue;
    for (size_t k = 0; k < choices.size(); ++k) {
      if (sideOf(k, brief ? "out" : "output") != input || choices[k].byMap || choices[k].byTool) continue;
      pairs.push_back({c, k, brief});
      torque = torque || choices[k].name.to == "torque_Nm";
    }
  }
  const bool outputs = std::any_of(choices.begin(), choices.end(), [&](const Choice& one) {
    const Words words = wordsOf(table.columns[static_cast<size_t>(&one - choices.data())].channel.name, true);
    return isMotion(one.name.to) && isIn(words, "output");  // a motion on the output's side keeps its torque
  });
  const bool torques = pairs.size() == 1 && torque && !pairs.front().brief && !outputs;
  const bool sides = (pairs.size() > 1 && torque) || torques;
  for (const auto& [input, output, brief] : pairs) {
    const RawColumn& in = table.columns[input];
    const std::string& to = choices[output].name.to;
    const bool moves = to == "angle_rad" || to == "velocity_rad_per_s";
    if (sides || (moves && areGeared(in.channel.values, table.columns[output].channel.values))) {
      choices[input].name = withoutSide(input, brief);
      setAside(choices[output], message("is behind a gear, beside {}", in.channel.name));
    } else if (brief && moves && choices[input].name.to == to) {
      choices[input].name.to.insert(to.find('_'), "_reference");
      choices[input].name.guess = message("what {} shall be", table.columns[output].channel.name);
    }
  }
}

/// "Output_%", "command_pct" where nothing else drives is a controller's output, and so the motor's duty.
void takeOutputs(const RawTable& table, std::vector<Choice>& choices) {
  static constexpr auto drives =
      std::to_array<std::string_view>({"duty", "voltage_V", "current_A", "torque_Nm", "force_N"});
  const bool driven =
      std::any_of(choices.begin(), choices.end(), [](const Choice& one) { return isIn(drives, one.name.to); });
  if (driven || isOfVehicle(table)) return;
  static constexpr auto meant =
      std::to_array<std::string_view>({"output", "out", "control", "controller", "pid", "motor", "mot", "drive",
                                       "command", "cmd", "actuation", "level", "throttle", "effort", "signal"});
  for (size_t c = 0; c < choices.size(); ++c) {
    if (choices[c].name.understood() || choices[c].byMap || table.columns[c].fault) continue;
    const NameParts parts = partsOfName(table.columns[c].channel.name, table.columns[c].unit);
    const bool percent = parts.unit != nullptr && parts.unit->kind == UnitKind::ratio && parts.unit->scale == 1e-2;
    const bool command = parts.words.size() == 1 && (parts.words[0] == "command" || parts.words[0] == "cmd");
    static constexpr auto outputs =
        std::to_array<std::string_view>({"output", "out", "actuation", "throttle", "effort"});
    const bool output = command || firstIn(parts.words, outputs) != nullptr;
    const bool plain =
        std::all_of(parts.words.begin(), parts.words.end(), [](const std::string& word) { return isIn(meant, word); });
    const auto& values = table.columns[c].channel.values;
    const bool within = std::none_of(values.begin(), values.end(), [](double v) { return std::abs(v) > 100.0; });
    if (!percent || !output || !plain || !within) continue;
    choices[c].name = understandName("duty", parts.unitText);
    choices[c].name.guess = message("a controller's output was taken for the motor's duty");
  }
}

/// Beside a position in metres, counts that no file says how many are a turn tell nothing new.
void setCountsBesideMetresAside(const RawTable& table, const ImportMap& map, std::vector<Choice>& choices) {
  const bool metres = std::any_of(choices.begin(), choices.end(), [](const Choice& one) {
    return one.name.to == "position_m" && !one.name.unit.empty();
  });
  if (!metres || map.counts_per_rev) return;
  constexpr double manyTurns = 30.0;
  for (size_t c = 0; c < choices.size(); ++c) {
    const auto& values = table.columns[c].channel.values;
    const ColumnName& name = choices[c].name;
    const bool whole = name.unit.empty() && areWhole(values) && rangeOf(values) >= manyTurns;
    const bool counts = name.needs == UnitNeeds::countsPerRev || whole;
    if (name.to == "angle_rad" && counts && !choices[c].byMap)
      setAside(choices[c], message("is in counts, beside a position whose unit is told"));
  }
}

bool hasMotion(const std::vector<Choice>& choices) {
  return std::any_of(choices.begin(), choices.end(), [](const Choice& one) { return isMotion(one.name.to); });
}

/// What the name says without the words that aren't known.
ColumnName withoutUnknown(const RawColumn& column, ColumnName name) {
  constexpr int mostWords = 3;
  std::string text = column.channel.name, unknown;
  for (int k = 0; k < mostWords && !name.unknownWord.empty(); ++k) {
    if (unknown.empty()) unknown = name.unknownWord;
    text = nameWithout(text, name.unknownWord);
    name = understandName(text, column.unit);
  }
  if (name.understood()) name.guess = message("what \"{}\" makes of it is unknown", unknown);
  return name;
}

}  // namespace

Words ownerOf(const std::string& name) {
  Words words = wordsOf(name, true);
  std::erase_if(words, [](const std::string& word) {
    return isIn(referenceWords, word) || isIn(decorations, word) || quantityNamed(word) != nullptr;
  });
  return words;
}

std::string nameWithout(std::string name, const std::string& word) {
  const size_t at = lowered(name).rfind(word);
  return at == std::string::npos ? name : name.replace(at, word.size(), " ");
}

void takeByNeighbours(const RawTable& table, const ImportMap& map, std::vector<Choice>& choices) {
  takeBehindDevices(table, choices);
  takeBehindPaths(table, choices);
  takeBeforePaths(table, choices);
  takeLettersWithUnits(table, choices);
  takeSides(table, choices);
  takeCommanded(table, choices);
  takePresent(table, choices);
  takeUnmarkedReferences(table, choices);
  takeLettersBeside(table, choices);
  setVehiclesWayAside(table, choices);
  setCountsBesideMetresAside(table, map, choices);
  takeGearSides(table, choices);
  takeOwnersReferences(table, choices);
  takeOutputs(table, choices);
}

void takeDoubtful(const RawTable& table, std::vector<Choice>& choices) {
  if (hasMotion(choices)) return;
  const auto open = [&](size_t c) { return !choices[c].name.understood() && !choices[c].byMap && !choices[c].byTool; };
  for (size_t c = 0; c < choices.size(); ++c) {
    if (!open(c) || table.columns[c].fault || choices[c].name.unknownWord.empty()) continue;
    const ColumnName name = withoutUnknown(table.columns[c], choices[c].name);
    if (isMotion(name.to) && !name.unit.empty()) choices[c].name = name;
  }
  static constexpr auto converters =
      std::to_array<std::string_view>({"adc", "load", "cell", "force", "raw", "dac", "pwm", "sent", "lux"});
  for (size_t c = 0; c < choices.size() && !hasMotion(choices); ++c) {
    if (!open(c) || table.columns[c].fault || !choices[c].name.unknownWord.empty()) continue;
    const NameParts parts = partsOfName(table.columns[c].channel.name, table.columns[c].unit);
    const bool counts =
        parts.unit != nullptr && parts.unit->kind == UnitKind::angle && parts.unit->needs == UnitNeeds::countsPerRev;
    if (!counts || parts.words.empty() || firstIn(parts.words, converters) != nullptr) continue;
    choices[c].name = understandName("angle", parts.unitText);
    choices[c].name.byUnit = true;
  }
}

}  // namespace breakaway
