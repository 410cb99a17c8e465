#include "recording/import/letters_beside.h"

#include <algorithm>
#include <map>
#include <set>

#include "recording/import/columns_beside.h"
#include "recording/import/name_parts.h"
#include "recording/import/quantity_words.h"

namespace breakaway {

namespace {

/// "joint_eff" beside "joint_pos" and "joint_vel" is an effort; alone it may be an efficiency.
void takeEfforts(const RawTable& table, std::vector<Choice>& choices) {
  std::set<Words> names;
  for (const RawColumn& column : table.columns) names.insert(wordsOf(column.channel.name, true));
  for (size_t c = 0; c < choices.size(); ++c) {
    Words words = wordsOf(table.columns[c].channel.name, true);
    const auto at = std::find(words.begin(), words.end(), "eff");
    if (at == words.end() || choices[c].name.understood() || choices[c].byMap || choices[c].byTool) continue;
    const auto with = [&](const char* word) {
      *at = word;
      return names.contains(words);
    };
    const bool alone = words.size() == 1 && std::any_of(choices.begin(), choices.end(), [](const Choice& one) {
                         return one.name.to == "velocity_rad_per_s";
                       });
    if (!alone && (!with("pos") || !with("vel"))) continue;
    with("effort");
    std::string name;
    for (const std::string& word : words) name += (name.empty() ? "" : "_") + word;
    choices[c].name = understandName(name, table.columns[c].unit);
  }
}

/// "tq" and "tqd" beside "q" and "qd" are where a joint shall be and how fast, no torque.
void takeTargetsOfJoints(const RawTable& table, std::vector<Choice>& choices) {
  std::set<std::string> names;
  for (const RawColumn& column : table.columns) names.insert(column.channel.name);
  for (size_t c = 0; c < choices.size(); ++c) {
    const std::string& name = table.columns[c].channel.name;
    const bool speed = name.starts_with("tqd");
    if (choices[c].byMap || !name.starts_with("tq")) continue;
    const std::string axis = name.substr(speed ? 3 : 2);
    const bool all = names.contains("q" + axis) && names.contains("qd" + axis) && names.contains("tq" + axis) &&
                     names.contains("tqd" + axis);
    if (all) choices[c].name = understandName((speed ? "qd" : "q") + axis + "_target");
  }
}

/// "FL_hip_q" beside "FL_hip_dq" is its angle; what else is called after it is of that axis.
void takeCoordinates(const RawTable& table, std::vector<Choice>& choices) {
  std::map<std::string, size_t> names;
  for (size_t c = 0; c < choices.size(); ++c) names[table.columns[c].channel.name] = c;
  for (const auto& [name, angle] : names) {
    const size_t mark = name.find_last_of("_.");
    if (mark == std::string::npos || mark == 0 || name.substr(mark + 1) != "q" || choices[angle].byMap) continue;
    const std::string whose = name.substr(0, mark + 1);
    const auto speed = names.contains(whose + "dq") ? names.find(whose + "dq") : names.find(whose + "qd");
    const NameParts parts = partsOfName(name.substr(0, mark), {});
    const bool open = !choices[angle].name.understood() && speed != names.end() && !choices[speed->second].byMap;
    if (!open || otherThingIn(parts.words) != nullptr) continue;
    choices[angle].name = understandName("q", table.columns[angle].unit);
    choices[speed->second].name = understandName("dq", table.columns[speed->second].unit);
    for (size_t c = 0; c < choices.size(); ++c) {
      if (choices[c].name.understood() && table.columns[c].channel.name.starts_with(whose))
        choices[c].name.group = name.substr(0, mark);
    }
  }
}

/// "motor_vol" beside "motor_vel" and "motor_cur" is no volume.
void takeVoltages(const RawTable& table, std::vector<Choice>& choices) {
  std::set<std::string> names;
  for (const RawColumn& column : table.columns) names.insert(column.channel.name);
  for (size_t c = 0; c < choices.size(); ++c) {
    const std::string& name = table.columns[c].channel.name;
    if (!name.ends_with("_vol") || choices[c].name.understood() || choices[c].byMap || choices[c].byTool) continue;
    const std::string whose = name.substr(0, name.size() - 3);
    if (names.contains(whose + "vel") && names.contains(whose + "cur"))
      choices[c].name = understandName(whose + "voltage", table.columns[c].unit);
  }
}

/// A DC motor has one winding: "u_a" with no "u_b" beside it is its armature's voltage, "ia" its current, beside which
/// "if" is that of its field.
void takeArmatures(const RawTable& table, std::vector<Choice>& choices) {
  std::set<std::string> names;
  const auto plain = [](const std::string& name) {
    std::string letters;
    const std::string own = name.substr(0, std::min(name.find_first_of("[("), name.find(" in ")));
    const size_t path = own.find_last_of("./");
    Words words = wordsOf(path == std::string::npos ? own : own.substr(path + 1), false);
    if (words.size() == 3 && (words[2] == "a" || words[2] == "v")) words.pop_back();  // the unit of "i_a_A"
    for (const std::string& word : words) letters += word;
    return letters;
  };
  for (const RawColumn& column : table.columns) names.insert(plain(column.channel.name));
  for (size_t c = 0; c < choices.size(); ++c) {
    const std::string name = plain(table.columns[c].channel.name);
    const bool field = name == "uf" || name == "vf" || name == "if";
    if (field && names.contains(name.substr(0, 1) + "a") && !choices[c].byMap)
      setAside(choices[c], message("is the field winding's, beside the armature's"));
    const bool armature = name == "ua" || name == "va" || name == "ia";
    if (!armature || choices[c].byMap || choices[c].name.understood()) continue;
    if (names.contains(name.substr(0, 1) + "b")) continue;
    const NameParts parts = partsOfName(table.columns[c].channel.name, table.columns[c].unit);
    const std::string& whole = table.columns[c].channel.name;
    const bool told = whole.find_first_of("[(") != std::string::npos || whole.find(" in ") != std::string::npos;
    choices[c].name =
        understandName(name == "ia" ? "motor_current" : "motor_voltage", told ? parts.unitText : table.columns[c].unit);
  }
}

/// "p" and "v" beside "p_des" or "v_des", or beside "kp" and "kd", are where a motor is and how fast, as the frames of
/// such motors call them.
void takeStateLetters(const RawTable& table, std::vector<Choice>& choices) {
  const auto wordsAt = [&table](size_t c) { return wordsOf(table.columns[c].channel.name, true); };
  const auto isLetter = [&](size_t c, std::string_view letter, bool reference) {
    Words words = wordsAt(c);
    const bool wanted = std::erase_if(words, [](const std::string& word) { return isIn(referenceWords, word); }) > 0;
    std::erase_if(words,
                  [](const std::string& word) { return word.size() > 1 && isIn(decorations, word); });  // "p_act"
    return wanted == reference && words.size() == 1 && words[0] == letter && table.columns[c].unit.empty();
  };
  const auto has = [&](std::string_view letter, bool reference) {
    for (size_t c = 0; c < choices.size(); ++c) {
      if (isLetter(c, letter, reference) && !choices[c].byMap && !choices[c].byTool) return true;
    }
    return false;
  };
  const bool gains = has("kp", false) && has("kd", false), wanted = has("p", true) || has("v", true);
  if (!has("p", false) || !has("v", false) || (!gains && !wanted)) return;
  for (size_t c = 0; c < choices.size(); ++c) {
    if (choices[c].byMap || choices[c].byTool) continue;
    for (const bool reference : {false, true}) {
      if (isLetter(c, "p", reference)) choices[c].name = understandName(reference ? "position_cmd" : "position");
      if (isLetter(c, "v", reference)) choices[c].name = understandName(reference ? "velocity_cmd" : "velocity");
    }
  }
}

/// "x" and "x_dot" beside "theta" and "theta_dot" are a cart's, which a motor drives; what hangs on it turns by itself.
void takeCarts(const RawTable& table, std::vector<Choice>& choices) {
  const auto columnOf = [&](std::initializer_list<std::string_view> names) {
    size_t c = 0;
    while (c < choices.size() && std::none_of(names.begin(), names.end(), [&](std::string_view name) {
             return isSameWord(table.columns[c].channel.name, name);
           }))
      ++c;
    return c;
  };
  const size_t x = columnOf({"x"}), speed = columnOf({"x_dot", "xdot", "x_d", "xd", "dx"}),
               theta = columnOf({"theta", "phi", "th"}),
               rate = columnOf({"theta_dot", "thetadot", "phi_dot", "thdot", "th_d", "thd", "dtheta"});
  const size_t last = std::max({x, speed, theta, rate});
  const bool free =
      last < choices.size() && columnOf({"y"}) == choices.size() &&
      std::none_of(choices.begin(), choices.end(), [&](const Choice& one) { return one.byMap || one.byTool; });
  if (!free) return;
  for (const size_t c : {theta, rate})
    setAside(choices[c], message("is what hangs on a cart, beside the cart's own motion"));
  choices[x].name = understandName("x", "m");
  choices[x].name.to = "position_m";
  choices[speed].name = choices[x].name;
  choices[speed].name.to = "velocity_m_per_s";
  for (const size_t c : {x, speed}) {
    choices[c].name.unit.clear();
    choices[c].name.guess = message("a cart's, of which a motor drives this motion");
  }
}

}  // namespace

void takeLettersBeside(const RawTable& table, std::vector<Choice>& choices) {
  takeEfforts(table, choices);
  takeVoltages(table, choices);
  takeCoordinates(table, choices);
  takeTargetsOfJoints(table, choices);
  takeArmatures(table, choices);
  takeStateLetters(table, choices);
  takeCarts(table, choices);
}

}  // namespace breakaway
