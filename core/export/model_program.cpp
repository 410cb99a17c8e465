#include "export/model_program.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <map>

#include "base/exact_text.h"
#include "diagnose/effects/catalogue.h"
#include "diagnose/simulate/physics.h"
#include "diagnose/simulate/servo_drive.h"
#include "diagnose/simulate/stepper.h"
#include "export/motion_text.h"
#include "export/past_text.h"
#include "export/program_texts.h"

namespace breakaway {

namespace {

using Names = std::vector<std::pair<std::string, std::string>>;

constexpr double usualStep_s = 1e-4;  ///< shortest row for which the whole of a delay is remembered
constexpr size_t leastKept = 64, mostKept = 4096;
constexpr double shortestServo_s = 1e-3, longestServo_s = 2.5e-3;  // steps of a servo's law, as in servo_drive.cpp

size_t keptOver(double delay_s) {
  return std::clamp(static_cast<size_t>(std::ceil(delay_s / usualStep_s)) + 2, leastKept, mostKept);
}

std::string intervalText(const Parameter& one) {
  if (one.low95 == one.high95) return "held";
  return "95 %: " + exactText(one.low95) + " to " + exactText(one.high95);
}

class Composer {
 public:
  Composer(const Model& model, std::vector<LeftOut>& leftOut)
      : model_(model), stepper_(physicsOf(model), *termsOf(model)), servo_(ServoDrive::of(model)), leftOut_(leftOut) {}

  Program whole() {
    addBase();
    addState();
    addEffects();
    addServo();
    const MotionKind kind = kindOfMotion();
    if (kind.changing) addConstant("longest_step_s", stepper_.longestStep_s(), "a longer step is divided");
    std::string text = motionText(kind) + functionTexts({.axis = model_.axis,
                                                         .input = model_.input,
                                                         .byReference = servo_.has_value(),
                                                         .motion = kind,
                                                         .gravity = physics().gravity != 0.0,
                                                         .rounds = model_.count > 0.0,
                                                         .torquePerInput = physics().torquePerInput(),
                                                         .terms = terms_,
                                                         .delay = delay_,
                                                         .inPieces = inPieces()});
    if (servo_)
      text += servoText(kept_);
    else if (!delay_.empty())
      text += delayText(kept_);
    auto functions = functionsIn(renamed(text, names_));
    for (Function& one : functionsIn(ownFunctions_)) functions.push_back(std::move(one));
    program_.functions = needed(functions);
    return std::move(program_);
  }

 private:
  bool rotary() const { return model_.axis == Axis::rotary; }
  const Physics& physics() const { return stepper_.physics(); }
  std::string on(const char* rotorsName) const { return nameOn(model_.axis, rotorsName); }
  MotionKind kindOfMotion() const {
    MotionKind kind;
    kind.electrical = physics().electrical;
    kind.inductive = kind.electrical && physics().inductance > 0.0;
    kind.elastic = stepper_.elastic();
    kind.changing = stepper_.stateDependent();
    kind.losesVoltage = losesVoltage_;
    return kind;
  }

  /// `inner` is what the texts call it.
  void addConstant(const std::string& inner, double value, const std::string& comment, std::string outer = {}) {
    if (outer.empty()) outer = inner;
    program_.constants.push_back({outer, value, comment});
    if (outer != inner) names_.emplace_back(inner, outer);
  }

  void addBaseConstant(const char* inner, double value, const std::string& outer) {
    const auto it = std::find_if(model_.base.begin(), model_.base.end(),
                                 [&outer](const Parameter& one) { return one.name == outer; });
    std::string comment = it == model_.base.end() ? "as the model takes it" : intervalText(*it);
    if (it != model_.base.end() && it->value != value)
      comment = "of the fitted " + exactText(it->value) + ", " +
                (value > it->value ? "with the pendulum's" : "without what moves apart from it");
    addConstant(inner, value, comment, outer);
  }

  void addBase() {
    const MotorNames& names = motorNames(model_.axis);
    const Physics& p = physics();
    addBaseConstant("inertia", p.inertia, names.inertia);
    addBaseConstant("viscous", p.viscous, names.viscous);
    addBaseConstant("coulomb", p.coulomb, names.coulomb);
    if (model_.input == DriveInput::torque)
      names_.emplace_back("torque_constant", "1");
    else
      addBaseConstant("torque_constant", p.torqueConstant, names.torqueConstant);
    if (p.electrical) {
      addBaseConstant("back_emf", p.backEmf, names.backEmfConstant);
      addBaseConstant("resistance", p.resistance, names.resistance);
      addBaseConstant("inductance", p.inductance, names.inductance);
    }
    if (p.gravity != 0.0) {
      addConstant("gravity", p.gravity, "of the pendulum, held out level", on("gravity_Nm"));
      addBaseConstant("down_angle", p.downAngle, "down_angle_rad");
    }
    if (model_.count > 0.0)
      addConstant("encoder_count", model_.count, "of the encoder", rotary() ? "encoder_count_rad" : "encoder_count_m");
    if (stepper_.elastic()) {
      addConstant("slip_stiffness", stepper_.slipStiffness(), "with which friction builds up",
                  rotary() ? "slip_stiffness_Nm_per_rad" : "slip_stiffness_N_per_m");
      addConstant("slip_damping", stepper_.slipDamping(), "while it builds up", on("slip_damping_Nm_s_per_rad"));
    }
  }

  void addField(const std::string& inner, const std::string& outer, const std::string& comment = {}, size_t size = 0) {
    program_.state.push_back({outer, 0.0, comment, size});
    if (inner != outer) names_.emplace_back("." + inner, "." + outer);
  }

  void addState() {
    addField("position", placeName(model_.axis), "the true one, without what the encoder makes of it");
    addField("velocity", speedName(model_.axis));
    addField("acceleration", rotary() ? "acceleration_rad_per_s2" : "acceleration_m_per_s2", "of the last step");
    if (physics().electrical) addField("current", "current_A");
    addField("time_s", "time_s", "since the begin, when it was cold");
    if (!stepper_.stateDependent()) return;
    addField("rest_s", "rest_s", "how long the last standstill lasted, or lasts by now");
    addField("way", "way", "of the last motion, -1 or 1");
    if (stepper_.elastic()) addField("slip", "slip", "friction that has built up, as a part of all");
  }

  /// Whether anything of it acts in this model.
  bool acts(const Effect& effect, const Written& one) const {
    const bool electrical = physics().electrical;
    return !one.load.empty() || !one.drag.empty() || !one.friction.empty() || !one.shown.empty() ||
           (!one.voltage.empty() && electrical) || (!one.sensed.empty() && electrical) || effect.elastic() != nullptr ||
           (effect.input(model_.input) != nullptr && !servo_);
  }

  void addEffects() {
    std::map<std::string, int> count, seen;
    for (const EffectTerm& term : model_.effects) ++count[term.effect];
    for (const EffectTerm& term : model_.effects) {
      const Effect& effect = *findEffect(term.effect);
      const std::vector<double> p = valuesOf(term);
      Written one = effect.written(p, model_.axis);
      const std::string prefix =
          term.effect + (count[term.effect] > 1 ? "_" + std::to_string(++seen[term.effect]) : "") + "_";
      if (one.lacking.empty() && !acts(effect, one)) one.lacking = "it has no part in what moves this model";
      if (!one.lacking.empty()) {
        leftOut_.push_back({inWords(term), one.lacking});
        continue;
      }
      addEffect(term, effect, std::move(one), prefix);
    }
  }

  void addEffect(const EffectTerm& term, const Effect& effect, Written one, const std::string& prefix) {
    Names own;
    for (size_t k = 0; k < term.parameters.size(); ++k) {
      const Parameter& parameter = term.parameters[k];
      program_.constants.push_back({prefix + parameter.name, parameter.value, intervalText(parameter)});
      own.emplace_back("p" + std::to_string(k), prefix + parameter.name);
    }
    for (size_t k = 0; k < one.memory.size(); ++k) {
      program_.state.push_back({prefix + one.memory[k]});
      own.emplace_back("m" + std::to_string(k), "s." + prefix + one.memory[k]);
    }
    for (std::string* text : {&one.load, &one.drag, &one.friction, &one.voltage, &one.remember, &one.input, &one.delay,
                              &one.shown, &one.sensed})
      *text = renamed(*text, own);
    if (effect.input(model_.input) == nullptr || servo_) one.input = one.delay = {};
    if (!physics().electrical) one.voltage = {};
    losesVoltage_ = losesVoltage_ || !one.voltage.empty();
    if (!one.input.empty() || !one.delay.empty()) ++inputs_;
    if (!one.delay.empty()) {
      delay_ = one.delay;
      kept_ = keptOver(term.parameters[0].value);
      addField("past_count", "past_count", "commands that are remembered");
      addField("past_time_s", "past_time_s", "when they came", kept_);
      addField("past_input", "past_input", "what they were", kept_);
    }
    if (ownFunctions_.find(one.functions) == std::string::npos) ownFunctions_ += one.functions;
    terms_.push_back(std::move(one));
  }

  void addServo() {
    if (!servo_) return;
    const ServoNames& names = servoNames(model_.input, model_.axis);
    const auto add = [this](const char* inner, const std::string& outer) {
      addBaseConstant(inner, model_.baseValue(outer).value_or(0.0), outer);
    };
    add("law_kp", names.kp);
    add("law_kd", names.kd);
    add("law_limit", names.limit);
    const double delay_s = model_.baseValue(servoDelayName).value_or(0.0);
    if (delay_s < 0.0)
      leftOut_.push_back({fmt::format("the law's delay ({} {:.4g})", servoDelayName, delay_s),
                          "it would answer before it is asked; here it answers at once"});
    addBaseConstant("law_delay_s", std::max(delay_s, 0.0), servoDelayName);
    addConstant("law_late_s", servo_->late_s(), "how late the law answers to motion, with half of its hold");
    addConstant("law_step_s", std::clamp(2.0 * servo_->late_s(), shortestServo_s, longestServo_s),
                "in which the law is reckoned, at least");
    kept_ = keptOver(servo_->late_s());
    addField("asked_count", "asked_count", "references that are remembered");
    addField("asked_time_s", "asked_time_s", "when they came", kept_);
    addField("asked_place", "asked_place", "where to", kept_);
    addField("asked_speed", "asked_speed", "how fast", kept_);
    addField("been_count", "been_count", "motion that is remembered");
    addField("been_time_s", "been_time_s", "when", kept_);
    addField("been_place", "been_place", "where", kept_);
    addField("been_speed", "been_speed", "how fast", kept_);
  }

  /// A late input of a winding alone acts in pieces, as in the simulator; else means over the step will do.
  bool inPieces() const {
    return !delay_.empty() && inputs_ == 1 && physics().electrical && physics().inductance > 0.0;
  }

  const Model& model_;
  Stepper stepper_;
  std::optional<ServoDrive> servo_;
  std::vector<LeftOut>& leftOut_;
  Program program_;
  Names names_;
  std::vector<Written> terms_;
  std::string ownFunctions_, delay_;
  size_t kept_ = leastKept;
  int inputs_ = 0;
  bool losesVoltage_ = false;
};

}  // namespace

std::string inWords(const EffectTerm& term) {
  std::string text;
  for (const Parameter& one : term.parameters)
    text += (text.empty() ? "" : ", ") + one.name + " " + fmt::format("{:.4g}", one.value);
  return term.effect + " (" + text + ")";
}

Program programOf(const Model& model, std::vector<LeftOut>& leftOut) {
  return Composer(model, leftOut).whole();
}

}  // namespace breakaway
