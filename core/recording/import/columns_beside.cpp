#include "recording/import/columns_beside.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <set>

#include "recording/import/name_parts.h"
#include "recording/import/quantity_words.h"
#include "recording/import/settling.h"
#include "recording/import/vehicles_beside.h"

namespace breakaway {

namespace {

/// Whether the name, with its letter at `at` exchanged for the two others of a phase, is there, too; with letters one
/// other is enough, as two numbers are two motors.
bool hasPhasesBeside(const std::set<std::string>& names, const std::string& name, size_t at) {
  static constexpr auto phases = std::to_array<std::string_view>({"abc", "ABC", "uvw", "UVW", "123"});
  return std::any_of(phases.begin(), phases.end(), [&](std::string_view letters) {
    if (letters.find(name[at]) == std::string_view::npos) return false;
    size_t beside = 0;
    for (const char letter : letters) {
      std::string other = name;
      other[at] = letter;
      beside += names.count(other);
    }
    return beside >= (letters == "123" ? 3U : 2U);
  });
}

/// "current_a" beside "current_b" is one phase's, and no current in A; so is "dutyA" beside "dutyB", and "current:1"
/// beside two others where no motion is numbered.
void setPhasesAside(const RawTable& table, std::vector<Choice>& choices) {
  std::set<std::string> names;
  for (const RawColumn& column : table.columns) names.insert(column.channel.name);
  const bool numbered = std::any_of(choices.begin(), choices.end(), [](const Choice& one) {
    return (isAngle(one.name.to) || isSpeed(one.name.to)) && !one.name.group.empty();
  });
  for (size_t c = 0; c < choices.size(); ++c) {
    const std::string& name = table.columns[c].channel.name;
    const std::string& to = choices[c].name.to;
    const bool electrical =
        to == "duty" || to == "voltage_V" || to == "current_A" || to == "current_reference_A" || to == "supply_V";
    if (choices[c].byMap || choices[c].byTool || !electrical) continue;
    for (size_t at = 1; at < name.size(); ++at) {
      const bool digit = std::isdigit(static_cast<unsigned char>(name[at])) != 0;
      const bool endsWord = at + 1 == name.size() || std::isalnum(static_cast<unsigned char>(name[at + 1])) == 0;
      const bool index = !digit ||
                         std::none_of(name.begin() + static_cast<std::ptrdiff_t>(at) + 1, name.end(),
                                      [](char one) { return one == '_' || one == ' ' || one == '/'; }) ||
                         partsOfName(name.substr(at + 1), {}).words.size() < 2;  // not "Blade1_MotorCurrent"
      if (endsWord && index && !(digit && numbered) && hasPhasesBeside(names, name, at)) {
        setAside(choices[c], message("is one phase's"));
        break;
      }
    }
  }
}

/// "i" beside "p" and "d" is a controller's integral term, and no current.
void setPidTermsAside(const RawTable& table, std::vector<Choice>& choices) {
  size_t terms = 0;
  for (const RawColumn& column : table.columns)
    terms += isSameWord(column.channel.name, "p") || isSameWord(column.channel.name, "d") ? 1 : 0;
  for (size_t c = 0; c < choices.size(); ++c) {
    const bool term = terms >= 2 && isSameWord(table.columns[c].channel.name, "i") && table.columns[c].unit.empty();
    if (term && !choices[c].byMap) setAside(choices[c], message("is a controller's integral term"));
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
    if (place && wanted.contains(words[1]))
      setAside(choices[c], message("is where it is now, beside where it shall be"));
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
    if (counts && choices[c].name.to != "time_s") setAside(choices[c], message("counts the rows"));
  }
}

/// A "tension" among English names is a rope's or a belt's, and no voltage as in French and Spanish.
void setTensionsAside(const RawTable& table, std::vector<Choice>& choices) {
  static constexpr auto others = std::to_array<std::string_view>(
      {"temps",    "tiempo", "vitesse",    "velocidad", "courant",  "corriente",  "intensidad",
       "couple",   "par",    "angulo",     "ángulo",    "posicion", "posición",   "consigne",
       "consigna", "moteur", "referencia", "mesure",    "mesurée",  "temperatura"});
  const bool romance = std::any_of(table.columns.begin(), table.columns.end(), [](const RawColumn& column) {
    return firstIn(wordsOf(column.channel.name, true), others) != nullptr;
  });
  for (size_t c = 0; c < choices.size(); ++c) {
    const std::string& to = choices[c].name.to;
    const auto words = wordsOf(table.columns[c].channel.name, true);
    const bool tension =
        std::any_of(words.begin(), words.end(), [](const std::string& word) { return word.starts_with("tension"); });
    if (tension && !romance && (to == "voltage_V" || to == "supply_V") && choices[c].name.unit.empty() &&
        !choices[c].byMap)
      setAside(choices[c], message("may be a rope's or a belt's tension"));
  }
}

/// "current" beside "phase_current" is what the supply gives.
void setSupplysCurrentAside(const RawTable& table, std::vector<Choice>& choices) {
  const auto isCalled = [&](size_t c, bool phase) {
    Words words = partsOfName(table.columns[c].channel.name, table.columns[c].unit).words;
    const bool phases = std::erase(words, "phase") > 0;
    return choices[c].name.to == "current_A" && !choices[c].byMap && !choices[c].byTool && phases == phase &&
           words.size() == 1;
  };
  for (size_t motors = 0; motors < choices.size(); ++motors) {
    if (!isCalled(motors, true)) continue;
    for (size_t c = 0; c < choices.size(); ++c) {
      if (c != motors && isCalled(c, false) && choices[c].name.group == choices[motors].name.group)
        setAside(choices[c], message("is the supply's current, not the motor's"));
    }
  }
}

/// "u" within ±1 that goes with the duty is a controller's output, and no voltage.
void setOutputsAside(const RawTable& table, std::vector<Choice>& choices) {
  const auto duty =
      std::find_if(choices.begin(), choices.end(), [](const Choice& one) { return one.name.to == "duty"; });
  if (duty == choices.end()) return;
  const auto& duties = table.columns[static_cast<size_t>(duty - choices.begin())].channel.values;
  for (size_t c = 0; c < choices.size(); ++c) {
    const auto& values = table.columns[c].channel.values;
    const bool letter = isSameWord(table.columns[c].channel.name, "u") && choices[c].name.unit.empty();
    if (!letter || choices[c].name.to != "voltage_V" || choices[c].byMap || choices[c].byTool) continue;
    double both = 0.0, own = 0.0, others = 0.0, most = 0.0;
    for (size_t k = 0; k < values.size(); ++k) {
      if (!std::isfinite(values[k]) || !std::isfinite(duties[k])) continue;
      both += values[k] * duties[k];
      own += values[k] * values[k];
      others += duties[k] * duties[k];
      most = std::max(most, std::abs(values[k]));
    }
    if (most <= 1.0 && both > 0.99 * std::sqrt(own * others) && own > 0.0)
      setAside(choices[c], message("goes with {}, so it is no voltage",
                                   table.columns[static_cast<size_t>(duty - choices.begin())].channel.name));
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

/// Beside an encoder's counts, steps are a stepper's, of which there are others in a turn.
void setStepsAside(const RawTable& table, std::vector<Choice>& choices) {
  const auto inSteps = [&choices](size_t c) { return choices[c].name.unit.find("step") != std::string::npos; };
  bool encoder = false;
  for (size_t c = 0; c < choices.size(); ++c) {
    const auto words = wordsOf(table.columns[c].channel.name, true);
    const bool named = std::any_of(words.begin(), words.end(), [](const auto& one) { return one.starts_with("enc"); });
    encoder = encoder || (named && isAngle(choices[c].name.to) && !inSteps(c));
  }
  if (!encoder) return;
  for (size_t c = 0; c < choices.size(); ++c) {
    const ColumnName& name = choices[c].name;
    const bool moves = isAngle(name.to) || name.to == "angle_reference_rad";
    if (moves && name.needs == UnitNeeds::countsPerRev && inSteps(c) && !choices[c].byMap)
      setAside(choices[c], message("counts a stepper's steps, beside an encoder"));
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
      setAside(choices[c], message("is only ever 0 or 1: one of an encoder's lines"));
  }
}

/// "TIME" in each row of a column called Time: where another column is as well called, that one is taken.
void setTextsAside(const RawTable& table, std::vector<Choice>& choices) {
  const auto holdsNumbers = [&table](size_t c) {
    const auto& values = table.columns[c].channel.values;
    return std::any_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  };
  for (size_t c = 0; c < choices.size(); ++c) {
    if (!table.columns[c].fault || !choices[c].name.understood() || choices[c].byMap || holdsNumbers(c)) continue;
    // A time or a motion is asked for rather than missed.
    static constexpr auto needed = std::to_array<std::string_view>(
        {"time_s", "angle_rad", "position_m", "velocity_rad_per_s", "velocity_m_per_s"});
    bool other = !isIn(needed, choices[c].name.to);
    for (size_t k = 0; k < choices.size(); ++k)
      other = other || (k != c && choices[k].name.to == choices[c].name.to && holdsNumbers(k));
    if (other) setAside(choices[c], message("holds text"));
  }
}

/// "total_torque" beside the speeds of two rotors is that of both.
void setSumsAside(const RawTable& table, std::vector<Choice>& choices) {
  static constexpr auto sums = std::to_array<std::string_view>({"total", "combined", "overall", "net", "gesamt"});
  std::set<std::string> axes;
  for (const Choice& one : choices) {
    if (one.name.to == "velocity_rad_per_s" || one.name.to == "angle_rad") axes.insert(one.name.group);
  }
  axes.erase("");
  if (axes.size() < 2) return;
  for (size_t c = 0; c < choices.size(); ++c) {
    const std::string& to = choices[c].name.to;
    const bool drives = to == "torque_Nm" || to == "force_N" || to == "current_A";
    if (!drives || !choices[c].name.group.empty() || choices[c].byMap || choices[c].byTool) continue;
    if (firstIn(wordsOf(table.columns[c].channel.name, true), sums) != nullptr)
      setAside(choices[c], message("is that of all motors together"));
  }
}

/// A column without a single number tells nothing, whatever it is called.
void setEmptyAside(const RawTable& table, std::vector<Choice>& choices) {
  for (size_t c = 0; c < choices.size(); ++c) {
    const RawColumn& column = table.columns[c];
    const auto& values = column.channel.values;
    const bool empty = std::none_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
    if (empty && !values.empty() && choices[c].name.understood() && !choices[c].byMap && !column.fault)
      setAside(choices[c], message("holds no number"));
  }
}

}  // namespace

void setAside(Choice& choice, Message why) {
  choice.name = ColumnName{};
  choice.name.aside = std::move(why);
}

void judgeByNeighbours(const RawTable& table, std::vector<Choice>& choices) {
  setPhasesAside(table, choices);
  setSumsAside(table, choices);
  setEmptyAside(table, choices);
  setTextsAside(table, choices);
  setVectorsAside(table, choices);
  setVehiclesSpeedAside(table, choices);
  setPlanesAside(table, choices);
  setTiltAside(table, choices);
  setHangingAside(table, choices);
  preferWheelsAndCarts(table, choices);
  setPidTermsAside(table, choices);
  setSupplysCurrentAside(table, choices);
  setPresentAside(table, choices);
  setLinesAside(table, choices);
  setStepsAside(table, choices);
  setRowNumbersAside(table, choices);
  setTensionsAside(table, choices);
  setOutputsAside(table, choices);
  setPlacesAside(table, choices);
  setTurningAside(table, choices);
  takeLinear(table, choices);
  setVehiclesAside(choices);
}

}  // namespace breakaway
