#include "export/program_texts.h"

#include <initializer_list>

#include "base/exact_text.h"
#include "export/portable/program.h"

namespace breakaway {

namespace {

class Texts {
 public:
  explicit Texts(const WrittenModel& of) : of_(of) {}

  std::string all() const {
    std::string text = forceText() + publicText();
    if (of_.motion.changing) text += historyText();
    if (of_.motion.losesVoltage) text += lostText();
    return text + stepText() + (of_.motion.electrical ? coastText() : "");
  }

 private:
  bool rotary() const { return of_.axis == Axis::rotary; }
  std::string placeName() const { return breakaway::placeName(of_.axis); }
  std::string speedName() const { return breakaway::speedName(of_.axis); }
  std::string forceUnit() const { return rotary() ? "Nm" : "N"; }
  std::string forceName() const { return rotary() ? "torque_Nm" : "force_N"; }
  std::string driveName() const { return rotary() ? "drive_Nm" : "drive_N"; }

  /// All terms of one kind, one after the other onto `sum`.
  std::string sum(const char* name, std::initializer_list<std::string Written::*> kinds) const {
    std::string text;
    for (const Written& one : of_.terms) {
      for (const auto kind : kinds) {
        if (!(one.*kind).empty()) text += std::string(name) + " = " + name + " + " + one.*kind + ";";
      }
    }
    return text;
  }

  /// What the terms in `text` ask for beside the arguments.
  std::string situation(const std::string& text, bool ofState) const {
    std::string out;
    if (mentions(text, "known_load"))
      out += of_.gravity ? "known_load = gravity * sin(position - down_angle);" : "known_load = 0;";
    if (mentions(text, "current")) out += "current = drive / torque_constant;";
    if (ofState && mentions(text, "rest_s")) out += "rest_s = s.rest_s;";
    return out;
  }

  std::string forceText() const {
    std::string load = "load = 0;";
    if (of_.gravity) load = "load = gravity * sin(position - down_angle);";
    load += sum("load", {&Written::load, &Written::drag});
    const std::string friction = "full = coulomb;" + sum("full", {&Written::friction}) + "full = max(full, 0);";
    const std::string arguments = "(s, position, velocity, direction, drive, time_s, span)";
    return "/// What opposes growing position whatever the direction.\nfunction load_torque" + arguments +
           " -> load {" + situation(load, true) + load + "}\n" +
           "/// What opposes motion, and holds at standstill.\nfunction friction_limit" + arguments + " -> full {" +
           situation(friction, true) + friction + "}\n";
  }

  std::string lostText() const {
    const std::string lost = sum("lost", {&Written::voltage});
    std::string text =
        "/// What is lost before the windings at a current.\nfunction voltage_lost(s, drive_input, supply_V, position, "
        "velocity, current, time_s) -> lost {";
    if (mentions(lost, "direction")) text += "direction = way_of(velocity);";
    if (mentions(lost, "drive")) text += "drive = torque_constant * current;";
    if (mentions(lost, "span")) text += "span = 0;";
    return text + lost + "}\n";
  }

  std::string historyText() const {
    std::string remember;
    for (const Written& one : of_.terms) remember += one.remember;
    std::string text =
        "/// Rests, direction and what effects remember, after a step.\nfunction keep_history(&s, was_at, was_fast, "
        "drive_input, dt_s, time_s) {"
        "way = way_of(s.velocity);"
        "if (way != 0 && way != s.way) { if (was_fast != 0) { s.rest_s = 0; } s.way = way; }"
        "if (way == 0) { if (was_fast != 0) { s.rest_s = 0; } else { s.rest_s = s.rest_s + dt_s; } }";
    const bool asksDrive = mentions(remember, "drive") || mentions(remember, "current") || of_.motion.elastic;
    if (asksDrive)
      text += std::string("drive = torque_constant * ") + (of_.motion.electrical ? "s.current" : "drive_input") + ";";
    if (of_.motion.elastic)
      text +=
          "full = friction_limit(s, s.position, s.velocity, way, drive, time_s, 0);"
          "s.slip = slip_after(s.slip, s.position - was_at, full);";
    for (const char* name : {"position", "velocity", "acceleration"}) {
      if (mentions(remember, name)) text += std::string(name) + " = s." + name + ";";
    }
    return text + situation(remember, true) + remember + "}\n";
  }

  /// What people call beside the step.
  std::string publicText() const {
    return frictionText() + restingLoadText() + readingText() + (of_.motion.electrical ? currentReadingText() : "");
  }

  /// A body of inner names with those of the arguments that people see.
  std::string shownBody(const std::string& body) const {
    return renamed(body, {{"position", placeName()},
                          {"velocity", speedName()},
                          {"drive", driveName()},
                          {"time_s", "running_s"},
                          {"span", "0"}});
  }

  std::string frictionText() const {
    const std::string growing = rotary() ? "angle" : "position", result = forceName();
    const std::string terms = sum("full", {&Written::friction}), drags = sum(result.c_str(), {&Written::drag});
    return "/// Friction in " + forceUnit() + " from " + growing +
           ", speed, load and temperature: positive where it opposes growing " + growing + ".\n/// " + driveName() +
           " is what the motor gives, and with it what bearings and gear carry; at standstill the result is the most\n"
           "/// that friction holds against it. The model knows temperature by running_s alone, the time since it was\n"
           "/// cold; rest_s is how long the last standstill lasted.\nshown function friction(" +
           placeName() + ", " + speedName() + ", " + driveName() + ", running_s, rest_s) -> " + result + " {" +
           shownBody("direction = way_of(velocity); if (direction == 0) { direction = way_of(drive); }" +
                     situation(terms + drags, false) + "full = coulomb;" + terms + "full = max(full, 0);" + result +
                     " = viscous * velocity + direction * full;" + drags) +
           "}\n";
  }

  std::string restingLoadText() const {
    const std::string growing = rotary() ? "angle" : "position", result = forceName();
    std::string loads = of_.gravity ? result + " = gravity * sin(position - down_angle);" : "";
    for (const Written& one : of_.terms) {
      if (!one.load.empty() && one.memory.empty()) loads += result + " = " + result + " + " + one.load + ";";
    }
    return "/// What else opposes growing " + growing + " in " + forceUnit() +
           ", whatever the direction: gravity, magnets, stops.\nshown function load(" + placeName() + ", " +
           speedName() + ", " + driveName() + ", running_s) -> " + result + " {" + result + " = 0;" +
           shownBody((mentions(loads, "direction") ? "direction = way_of(velocity);" : "") + situation(loads, false) +
                     loads) +
           "}\n";
  }

  std::string readingText() const {
    std::string text = "/// What the encoder shows.\nshown function reading(s) -> " + placeName() + " {" + placeName() +
                       " = s.position;";
    for (const Written& one : of_.terms) {
      if (!one.shown.empty()) text += placeName() + " = " + renamed(one.shown, {{"position", placeName()}}) + ";";
    }
    if (of_.rounds) text += placeName() + " = " + placeName() + " - 0.5 * encoder_count;";
    return text + "}\n";
  }

  std::string currentReadingText() const {
    std::string text =
        "/// What the current's sensor shows.\nshown function current_reading(s) -> current_A {"
        "current_A = s.current;";
    for (const Written& one : of_.terms) {
      if (!one.sensed.empty()) text += "current_A = " + renamed(one.sensed, {{"current", "current_A"}}) + ";";
    }
    return text + "}\n";
  }

  std::string inputName() const {
    Bench names;
    names.axis = of_.axis;
    names.input = of_.input;
    if (of_.byReference) names.servo = ServoLaw{};
    return names.inputChannel();
  }

  std::string stepText() const {
    const bool supply = of_.motion.electrical, duty = of_.input == DriveInput::duty;
    const std::string speed = rotary() ? "velocity_reference_rad_per_s" : "velocity_reference_m_per_s";
    std::string text = "/// The whole model, dt_s on, while " + inputName() + " is held" +
                       (supply ? "; supply_V is the bridge's" : "") + ".\n";
    if (of_.byReference) text += "/// Without a reference of speed give 0.\n";
    text += "shown function step(&s, " + inputName() + (of_.byReference ? ", " + speed : "") +
            (supply ? ", supply_V" : "") + ", dt_s) {";
    if (!supply) text += "supply_V = 0;";
    if (of_.byReference) {
      text += "note_reference(&s, " + inputName() + ", " + speed +
              ");"
              "stable = law_kd * " +
              exactText(of_.torquePerInput) +
              " * dt_s / (0.25 * inertia);"
              "times = clamp(ceil(max(dt_s / law_step_s, stable) - 0.000001), 1, 1000); h = dt_s / times; k = 0;"
              "while (k < times) {"
              "seen_s = s.time_s + 0.5 * h - law_late_s; place = s.position; fast = s.velocity;"
              "if (seen_s < s.time_s) { (place, fast) = motion_at(s, seen_s); note_motion(&s); }"
              "(wanted, wanted_fast) = reference_mean(s, s.time_s - law_delay_s, s.time_s + h - law_delay_s);"
              "drive_input = law_kp * (wanted - place) - law_kd * (fast - wanted_fast);"
              "if (law_limit > 0) { drive_input = clamp(drive_input, -law_limit, law_limit); }";
      if (duty) text += "drive_input = clamp(drive_input, -1, 1) * supply_V;";
      return text + "advance(&s, drive_input, supply_V, h); k = k + 1; } }\n";
    }
    text += "drive_input = " + inputName() + (duty ? " * supply_V;" : ";");
    for (const Written& one : of_.terms) {
      text += one.input;
      if (!one.delay.empty() && !of_.inPieces)
        text += "note_input(&s, drive_input); drive_input = input_mean(s, s.time_s - " + one.delay +
                ", s.time_s + dt_s - " + one.delay + ");";
    }
    if (of_.inPieces)
      return text + "note_input(&s, drive_input); advance_late(&s, " + of_.delay + ", supply_V, dt_s); }\n";
    return text + "advance(&s, drive_input, supply_V, dt_s); }\n";
  }

  std::string coastText() const {
    const std::string noted = of_.delay.empty() ? "" : "note_input(&s, 0);";
    return "/// The whole model, dt_s on, with open windings: no current flows.\nshown function coast(&s, dt_s) {" +
           noted + "advance_open(&s, dt_s); }\n";
  }

  const WrittenModel& of_;
};

}  // namespace

bool mentions(const std::string& text, const std::string& name) {
  return renamed(text, {{name, ""}}) != text;
}

std::string placeName(Axis axis) {
  return axis == Axis::rotary ? "angle_rad" : "position_m";
}

std::string speedName(Axis axis) {
  return axis == Axis::rotary ? "velocity_rad_per_s" : "velocity_m_per_s";
}

std::string functionTexts(const WrittenModel& of) {
  return Texts(of).all();
}

}  // namespace breakaway
