#include "recording/import/vehicles_beside.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <set>
#include <string>
#include <string_view>

#include "recording/import/columns_beside.h"
#include "recording/import/name_parts.h"
#include "recording/import/quantity_words.h"
#include "recording/import/settling.h"

namespace breakaway {

namespace {

/// Whether this coordinate is there: "x", "x(in)", "x_mm"; `placed`: in a unit of length.
bool hasCoordinate(const RawTable& table, std::string_view letter, bool& placed) {
  return std::any_of(table.columns.begin(), table.columns.end(), [&](const RawColumn& column) {
    const NameParts parts = partsOfName(column.channel.name, column.unit);
    const bool length = parts.unit != nullptr && parts.unit->kind == UnitKind::length;
    const bool found = parts.group.empty() && parts.words.size() == 1 && parts.words[0] == letter &&
                       (length || isSameWord(column.channel.name, letter));
    placed = placed || (found && length);
    return found;
  });
}

/// "angleX", "gyro_y": about an axis of space.
bool isTurnInSpace(const std::string& name) {
  const Words words = wordsOf(name, true);
  return words.size() > 1 && words.back().size() == 1 && std::strchr("xyz", words.back()[0]) != nullptr;
}

}  // namespace

bool isOfVehicle(const RawTable& table) {
  static constexpr auto words =
      std::to_array<std::string_view>({"brake", "kmh", "kph", "mph", "gear", "soc", "odometer"});
  return std::any_of(table.columns.begin(), table.columns.end(), [](const RawColumn& column) {
    return firstIn(wordsOf(column.channel.name, true), words) != nullptr;
  });
}

bool tellsVehiclesWay(const RawTable& table) {
  static constexpr auto words =
      std::to_array<std::string_view>({"gps", "odometer", "odo", "mileage", "totaldistance", "latitude", "longitude"});
  return std::any_of(table.columns.begin(), table.columns.end(), [](const RawColumn& column) {
    return firstIn(wordsOf(column.channel.name, true), words) != nullptr;
  });
}

/// "speed" beside "motor_speed" is a vehicle's.
void setVehiclesSpeedAside(const RawTable& table, std::vector<Choice>& choices) {
  static constexpr auto motors = std::to_array<std::string_view>({"motor", "mot", "rotor"});
  const auto isMotors = [&table](size_t c) {
    return firstIn(wordsOf(table.columns[c].channel.name, true), motors) != nullptr;
  };
  bool motor = false;
  for (size_t c = 0; c < choices.size(); ++c)
    motor = motor || (choices[c].name.to == "velocity_rad_per_s" && isMotors(c));
  if (!motor || !isOfVehicle(table)) return;
  for (size_t c = 0; c < choices.size(); ++c) {
    const ColumnName& name = choices[c].name;
    const bool plain = name.to == "velocity_rad_per_s" && name.unit.empty() && !isMotors(c);
    if (plain && !choices[c].byMap && !choices[c].byTool)
      setAside(choices[c], message("is a vehicle's speed, beside a motor's"));
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
    if (linear && !choice.byMap) setAside(choice, message("is a linear speed, beside a motor that turns"));
  }
}

/// "travel_mm" beside an encoder and a duty of either side is how far a vehicle went.
void setVehiclesWayAside(const RawTable& table, std::vector<Choice>& choices) {
  const auto turnsAt = [&](const char* side) {
    return std::any_of(choices.begin(), choices.end(), [side](const Choice& one) {
      return one.name.group == side && (one.name.to == "angle_rad" || one.name.to == "velocity_rad_per_s");
    });
  };
  if (!turnsAt("left") || !turnsAt("right")) return;
  for (size_t c = 0; c < choices.size(); ++c) {
    const ColumnName& name = choices[c].name;
    const bool linear = name.to == "position_m" || name.to == "velocity_m_per_s";
    const auto words = wordsOf(table.columns[c].channel.name, true);
    if (linear && name.group.empty() && !choices[c].byMap && firstIn(words, jointWords) == nullptr)
      setAside(choices[c], message("is a vehicle's, beside the wheels of either side"));
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
      setAside(choices[c], letterOf(c) == 's' ? message("is a vehicle's steering, beside a motor that turns")
                                              : message("is a place in space, beside a motor that turns"));
  }
}

/// "x_position" beside "y_position" and a heading is where a vehicle stands.
void setPlanesAside(const RawTable& table, std::vector<Choice>& choices) {
  static constexpr auto heads = std::to_array<std::string_view>({"heading", "yaw", "orientation"});
  std::set<Words> names;
  bool heading = false;
  for (const RawColumn& column : table.columns) {
    names.insert(wordsOf(column.channel.name, true));
    heading = heading || firstIn(wordsOf(column.channel.name, true), heads) != nullptr;
  }
  if (!heading) return;
  for (size_t c = 0; c < choices.size(); ++c) {
    Words other = wordsOf(table.columns[c].channel.name, true);
    const auto letter =
        std::find_if(other.begin(), other.end(), [](const std::string& word) { return word == "x" || word == "y"; });
    const bool moves = isAngle(choices[c].name.to) || choices[c].name.to == "position_m" ||
                       isSpeed(choices[c].name.to) || choices[c].name.to == "velocity_m_per_s";
    if (letter == other.end() || !moves || choices[c].byMap || choices[c].byTool) continue;
    *letter = *letter == "x" ? "y" : "x";
    if (names.contains(other)) setAside(choices[c], message("is a place in a plane, beside a heading"));
  }
}

/// Beside x and y an "omega" is how a vehicle turns, and a "theta" where it heads, where a unit tells the motor's or a
/// wheel's speed.
void setTurningAside(const RawTable& table, std::vector<Choice>& choices) {
  bool placed = false;
  const bool motors = std::any_of(choices.begin(), choices.end(), [](const Choice& one) {
    return one.name.to == "velocity_rad_per_s" && !one.name.unit.empty();
  });
  const bool wheels = std::any_of(table.columns.begin(), table.columns.end(), [](const RawColumn& column) {
    const NameParts parts = partsOfName(column.channel.name, column.unit);
    const bool side = parts.group == "left" || parts.group == "right";
    return side && parts.unit != nullptr && parts.unit->kind == UnitKind::linearVelocity;  // "v_l (ips)"
  });
  const bool sides = std::any_of(choices.begin(), choices.end(), [](const Choice& one) {
    return one.name.to == "velocity_rad_per_s" && (one.name.group == "left" || one.name.group == "right");
  });
  if ((!motors && !wheels && !sides) || !hasCoordinate(table, "x", placed) || !hasCoordinate(table, "y", placed))
    return;
  for (size_t c = 0; c < choices.size(); ++c) {
    const ColumnName& name = choices[c].name;
    const bool turns = name.to == "velocity_rad_per_s" || name.to == "angle_rad";
    const auto words = wordsOf(table.columns[c].channel.name, true);
    const bool ofMotor = firstIn(words, jointWords) != nullptr || firstIn(words, drivenWords) != nullptr;
    const bool turned = words[0] == "rot" || words[0] == "rotation";
    const bool heads = name.group.empty() && name.to == "angle_rad" && (turned || (placed && words[0] == "theta"));
    const bool ofSide = name.group == "left" || name.group == "right";
    if (turns && !ofSide && (name.unit.empty() || heads) && !ofMotor && !choices[c].byMap && !choices[c].byTool)
      setAside(choices[c], message("is how a vehicle turns, beside its place and a motor's speed"));
  }
}

/// An "angle" beside a gyro and an acceleration is how far a robot or a vehicle leans, where an encoder or a speed of
/// rotation tells the motor's motion.
void setTiltAside(const RawTable& table, std::vector<Choice>& choices) {
  bool gyro = false, acceleration = false, motors = false, axes = false;
  const auto countsAsMotors = [&](size_t c) {
    const std::string& name = table.columns[c].channel.name;
    const auto words = wordsOf(name, true);
    const bool encoder =
        std::any_of(words.begin(), words.end(), [](const auto& one) { return one.starts_with("enc"); });
    const bool turns = choices[c].name.to == "velocity_rad_per_s" && !choices[c].name.unit.empty();
    return (encoder && choices[c].name.to == "angle_rad") || turns || choices[c].name.needs == UnitNeeds::countsPerRev;
  };
  for (size_t c = 0; c < choices.size(); ++c) {
    for (const std::string& word : wordsOf(table.columns[c].channel.name, true)) {
      gyro = gyro || word.starts_with("gyr");
      acceleration = acceleration || word.starts_with("acc");
    }
    axes = axes || (isTurnInSpace(table.columns[c].channel.name) && !choices[c].name.understood());
    motors = motors || countsAsMotors(c);
  }
  if (gyro && axes) {  // "angleX" beside "gyroY"
    for (size_t c = 0; c < choices.size(); ++c) {
      if (choices[c].name.to == "angle_rad" && !choices[c].byMap && isTurnInSpace(table.columns[c].channel.name))
        setAside(choices[c], message("is how far something leans, as a gyro beside it says"));
    }
  }
  if (!gyro || !acceleration || !motors) return;
  for (size_t c = 0; c < choices.size(); ++c) {
    const bool motorsOwn = firstIn(wordsOf(table.columns[c].channel.name, true), jointWords) != nullptr;
    if (choices[c].name.to == "angle_rad" && !choices[c].byMap && !countsAsMotors(c) && !motorsOwn)
      setAside(choices[c], message("is how far something leans, as gyro and acceleration beside it say"));
  }
}

/// "pendulum_angle" beside "arm_angle" hangs on what the motor moves.
void setHangingAside(const RawTable& table, std::vector<Choice>& choices) {
  static constexpr auto hanging = std::to_array<std::string_view>({"pendulum", "pend", "pole"});
  const auto hangs = [&table](size_t c) {
    return firstIn(wordsOf(table.columns[c].channel.name, true), hanging) != nullptr;
  };
  const auto moves = [&choices](size_t c) {
    const std::string& to = choices[c].name.to;
    return to == "angle_rad" || to == "velocity_rad_per_s";
  };
  size_t driven = choices.size();
  for (size_t c = choices.size(); c-- > 0;) {
    if (moves(c) && !hangs(c)) driven = c;
  }
  if (driven == choices.size()) return;
  for (size_t c = 0; c < choices.size(); ++c) {
    if (moves(c) && hangs(c) && !choices[c].byMap && !choices[c].byTool)
      setAside(choices[c], message("hangs on what a motor moves, beside {}", table.columns[driven].channel.name));
  }
}

/// "q_x" beside "q_w", "q_y" and "q_z" is a quaternion's, "w_x" beside "w_y" and "w_z" a body's in space.
void setVectorsAside(const RawTable& table, std::vector<Choice>& choices) {
  std::set<std::string> names;
  for (const RawColumn& column : table.columns) names.insert(column.channel.name);
  static constexpr auto stems =
      std::to_array<std::string_view>({"q", "quat", "quaternion", "orientation", "w", "omega", "angvel", "v", "vel"});
  for (size_t c = 0; c < choices.size(); ++c) {
    const std::string& name = table.columns[c].channel.name;
    const bool moves = choices[c].name.to == "angle_rad" || choices[c].name.to == "velocity_rad_per_s";
    if (!moves || choices[c].byMap || choices[c].byTool || name.size() < 2) continue;
    const std::string stem = name.substr(0, name.size() - 1);
    const Words words = wordsOf(stem, false);
    const auto has = [&](char letter) { return names.contains(stem + letter); };
    const bool quaternion = has('w') && has('x') && has('y') && has('z');
    const bool vector = has('x') && has('y') && has('z');
    const bool letter = std::string_view("wxyz").find(name.back()) != std::string_view::npos;
    if (letter && words.size() == 1 && isIn(stems, words[0]) && (quaternion || (vector && name.back() != 'w')))
      setAside(choices[c], quaternion ? message("is a quaternion's") : message("is one direction's in space"));
  }
}

/// Beside the position and the speed of a wheel or a cart, an angle that says nothing of whose it is leans, heads or
/// hangs: "theta" beside "wheel_pos" and "wheel_vel".
void preferWheelsAndCarts(const RawTable& table, std::vector<Choice>& choices) {
  static constexpr auto carts = std::to_array<std::string_view>({"cart", "carriage", "trolley"});
  static constexpr auto wheels = std::to_array<std::string_view>({"wheel", "flywheel", "cart", "carriage", "trolley"});
  const auto wordsAt = [&table](size_t c) { return wordsOf(table.columns[c].channel.name, true); };
  const auto is = [&choices](size_t c, const char* to) {
    return choices[c].name.to == to && !choices[c].byMap && !choices[c].byTool;
  };
  size_t position = choices.size(), speed = choices.size();
  for (size_t c = choices.size(); c-- > 0;) {
    if (firstIn(wordsAt(c), wheels) == nullptr) continue;
    if (is(c, "angle_rad")) position = c;
    if (is(c, "velocity_rad_per_s")) speed = c;
  }
  if (std::max(position, speed) == choices.size()) return;
  const std::string whose = *firstIn(wordsAt(position), wheels);
  if (!isIn(wordsAt(speed), whose)) return;
  bool others = false;
  for (size_t c = 0; c < choices.size(); ++c) {
    const Words words = wordsAt(c);
    const bool owned = firstIn(words, wheels) != nullptr || firstIn(words, jointWords) != nullptr ||
                       choices[c].name.qualified || choices[c].name.unit == "rpm" || !choices[c].name.group.empty() ||
                       std::any_of(words.begin(), words.end(), [](const auto& one) { return one.starts_with("enc"); });
    if ((!is(c, "angle_rad") && !is(c, "velocity_rad_per_s")) || owned) continue;
    setAside(choices[c], message("is how something leans, heads or hangs, beside {}, which a motor drives",
                                 table.columns[position].channel.name));
    others = true;
  }
  if (!others || !isIn(carts, whose)) return;
  for (const size_t c : {position, speed}) {
    if (choices[c].name.unit.empty()) choices[c].name.to = c == position ? "position_m" : "velocity_m_per_s";
  }
}

}  // namespace breakaway
