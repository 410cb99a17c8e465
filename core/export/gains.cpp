#include "export/gains.h"

#include <fmt/core.h>
#include <numbers>

#include "base/made.h"
#include "base/numbers.h"
#include "export/comment.h"

namespace breakaway {

namespace {

constexpr double degree_rad = std::numbers::pi / 180.0;
constexpr double rpmPerSpeed = 60.0 / turn_rad;  ///< rpm per rad/s

/// Lines of one language, with what they say of themselves.
class Lines {
 public:
  Lines(std::string mark, std::string assign, std::string end)
      : mark_(std::move(mark)), assign_(std::move(assign)), end_(std::move(end)) {}

  void say(const std::string& text) { text_ += mark_ + (text.empty() ? "" : " " + text) + "\n"; }
  void set(const std::string& name, double value, const std::string& meaning) {
    set(name, fmt::format("{:.6g}", value), meaning);
  }
  void set(const std::string& name, const std::string& value, const std::string& meaning) {
    text_ += name + assign_ + value + end_ + (meaning.empty() ? "" : "  " + mark_ + " " + meaning) + "\n";
  }
  void gap() { text_ += "\n"; }
  const std::string& text() const { return text_; }

 private:
  std::string mark_, assign_, end_, text_;
};

const char* const observed =
    "Lost: the disturbance observer, which the board doesn't have. Its share of the feedback is in the gains all the "
    "same, so that loads are answered as tuned; a step of the reference is answered harder than tuned: ramp it.";
const char* const cascade =
    "Lost: the position loop as tuned. The board's is a cascade, for which the tuned margins don't hold; its gain here "
    "is kp/kd of the tuned one.";

void sayHead(Lines& lines, const TunedGains& gains, const std::string& tuning, const std::vector<std::string>& notes) {
  lines.say("Gains of " + (gains.name.empty() ? "a rig" : commentable(gains.name)) + ", from " + commentable(tuning) +
            ", by " + thisRun().by + ".");
  for (const std::string& note : notes) lines.say(note);
  lines.say(fmt::format(
      "Tuned: kp {:.6g} A s/rad, observer's cutoff g {:.6g} rad/s, for J {:.6g} kg m2 and Kt {:.6g} Nm/A.",
      gains.velocityKp_A_s_per_rad, gains.cutoff_rad_per_s, gains.inertia_kg_m2, gains.torqueConstant_Nm_per_A));
  lines.gap();
}

std::string pFormula(const TunedGains& gains) {
  return gains.cutoff_rad_per_s > 0.0 ? "kp + g J/Kt" : "kp";
}
std::string iFormula(const TunedGains& gains) {
  return gains.cutoff_rad_per_s > 0.0 ? "ki + g kp" : "ki";
}

std::string simpleFoc(const TunedGains& gains, const std::string& tuning, const std::vector<std::string>& notes) {
  Lines lines("//", " = ", ";");
  sayHead(lines, gains, tuning, notes);
  lines.say("Velocity, torque by current: the output is A (docs.simplefoc.com, velocity loop and library units).");
  const SameFeedback velocity = velocityFeedback(gains);
  lines.set("motor.torque_controller", "TorqueControlType::foc_current", "");
  lines.set("motor.PID_velocity.P", velocity.p, "A/(rad/s), " + pFormula(gains));
  lines.set("motor.PID_velocity.I", velocity.i, "A/rad, " + iFormula(gains));
  lines.set("motor.PID_velocity.D", velocity.d, "A s/(rad/s), kd");
  if (gains.currentLimit_A > 0.0) lines.set("motor.current_limit", gains.currentLimit_A, "A");
  lines.set("motor.LPF_velocity.Tf", 1.0 / gains.speedFilter_rad_per_s, "s, 1 over the speed observer's bandwidth");
  lines.set("motor.P_angle.P", gains.positionKp_A_per_rad / gains.positionKd_A_s_per_rad,
            "(rad/s)/rad, kp/kd of the position loop");
  if (!gains.resistance_ohm) return lines.text();
  lines.gap();
  if (gains.inductance_H) {
    lines.say("Current: its zero on the winding's pole, bandwidth w.");
    for (const char* of : {"q", "d"}) {
      lines.set(fmt::format("motor.PID_current_{}.P", of), gains.currentBandwidth_rad_per_s * *gains.inductance_H,
                "V/A, w L");
      lines.set(fmt::format("motor.PID_current_{}.I", of), gains.currentBandwidth_rad_per_s * *gains.resistance_ohm,
                "V/(A s), w R");
    }
    lines.gap();
  }
  lines.say("Torque by voltage instead, without motor.phase_resistance: the output is V, R times as much. Back-EMF is");
  lines.say("not made up for and damps in addition.");
  lines.say(fmt::format("motor.PID_velocity.P = {:.6g};  V/(rad/s)", velocity.p * *gains.resistance_ohm));
  lines.say(fmt::format("motor.PID_velocity.I = {:.6g};  V/rad", velocity.i * *gains.resistance_ohm));
  return lines.text();
}

std::string oDrive(const TunedGains& gains, const std::string& tuning, const std::vector<std::string>& notes) {
  Lines lines("#", " = ", "");
  sayHead(lines, gains, tuning, notes);
  lines.say(
      "Lines for odrivetool. Speeds are turns per second, outputs Nm (docs.odriverobotics.com, control structure).");
  const SameFeedback velocity = velocityFeedback(gains);
  const double torquePerTurn = gains.torqueConstant_Nm_per_A * turn_rad;
  const std::string of = "odrv0.axis0.controller.config.";
  lines.set(of + "vel_gain", velocity.p * torquePerTurn, "Nm/(turn/s), 2 pi Kt (" + pFormula(gains) + ")");
  lines.set(of + "vel_integrator_gain", velocity.i * torquePerTurn, "Nm/turn, 2 pi Kt (" + iFormula(gains) + ")");
  lines.set(of + "pos_gain", gains.positionKp_A_per_rad / gains.positionKd_A_s_per_rad,
            "(turn/s)/turn, kp/kd of the position loop");
  lines.gap();
  lines.say(
      "Firmware 0.6; in 0.5 the motor's fields are under odrv0.axis0.motor.config, the current's limit current_lim.");
  lines.set("odrv0.axis0.config.motor.torque_constant", gains.torqueConstant_Nm_per_A, "Nm/A");
  if (gains.currentLimit_A > 0.0) lines.set("odrv0.axis0.config.motor.current_soft_max", gains.currentLimit_A, "A");
  lines.set("odrv0.axis0.config.motor.current_control_bandwidth", gains.currentBandwidth_rad_per_s, "rad/s");
  lines.set("odrv0.axis0.config.encoder_bandwidth", gains.speedFilter_rad_per_s, "rad/s, of the speed's observer");
  return lines.text();
}

Result<std::string> vesc(const TunedGains& gains, const std::string& tuning, const std::vector<std::string>& notes,
                         std::optional<double> polePairs) {
  if (!polePairs)
    return Error{"--pole-pairs", "is missing, expected those of the motor: a VESC counts electrical turns"};
  if (gains.currentLimit_A <= 0.0)
    return Error{tuning + ", field controller.current_limit_A",
                 "is 0, expected the limit of which a VESC's outputs are parts; tune with --current-limit-A"};
  Lines lines("#", " = ", "");
  sayHead(lines, gains, tuning, notes);
  lines.say(
      "Parameters of the motor's configuration. A PID's output is a part of l_current_max; speeds are electrical");
  lines.say("rpm, and 1/20 of the error counts (vedderb/bldc, motor/foc_math.c, foc_run_pid_control_speed).");
  const SameFeedback velocity = velocityFeedback(gains), position = positionFeedback(gains);
  const double most = gains.currentLimit_A, perErpm = 20.0 / (most * rpmPerSpeed * *polePairs);
  lines.set("l_current_max", most, "A");
  lines.set("si_motor_poles", 2.0 * *polePairs, "twice the pole pairs");
  lines.set("s_pid_kp", velocity.p * perErpm, "20 (" + pFormula(gains) + ") / (l_current_max pole pairs 60/(2 pi))");
  lines.set("s_pid_ki", velocity.i * perErpm, "per s, 20 (" + iFormula(gains) + ") / (the same)");
  lines.set("s_pid_kd", velocity.d * perErpm, "s, 20 kd / (the same)");
  lines.say("Where the speed asked for is below s_pid_min_erpm, 900 as delivered, a VESC lets go of the motor.");
  lines.gap();
  lines.say(
      "Position: errors are degrees (the same file, foc_run_pid_control_pos), of the motor's turn: p_pid_ang_div 1.");
  const double perDegree = degree_rad / most;
  lines.set("p_pid_kp", position.p * perDegree, "per degree, (kp + g kd) pi/180 / l_current_max");
  lines.set("p_pid_ki", position.i * perDegree, "per degree s, (ki + g kp) pi/180 / l_current_max");
  lines.set("p_pid_kd", position.d * perDegree, "s/degree, (kd + g J/Kt) pi/180 / l_current_max");
  lines.set("p_pid_kd_proc", 0.0, "s/degree; as delivered it is 0.00035, and adds to p_pid_kd");
  lines.set("p_pid_gain_dec_angle", 0.0, "degrees; gains fall within it");
  lines.set("p_pid_ang_div", 1.0, "");
  if (!gains.resistance_ohm || !gains.inductance_H) return lines.text();
  lines.gap();
  lines.say(
      "Current: its zero on the winding's pole, bandwidth w; R and L as the tuning's bench file has them, of a phase.");
  lines.set("foc_current_kp", gains.currentBandwidth_rad_per_s * *gains.inductance_H, "V/A, w L");
  lines.set("foc_current_ki", gains.currentBandwidth_rad_per_s * *gains.resistance_ohm, "V/(A s), w R");
  return lines.text();
}

}  // namespace

SameFeedback velocityFeedback(const TunedGains& gains) {
  const double g = gains.cutoff_rad_per_s, added = g * gains.inertia_kg_m2 / gains.torqueConstant_Nm_per_A;
  return {gains.velocityKp_A_s_per_rad + added, gains.velocityKi_A_per_rad + g * gains.velocityKp_A_s_per_rad,
          gains.velocityKd_A_s2_per_rad};
}

SameFeedback positionFeedback(const TunedGains& gains) {
  const double g = gains.cutoff_rad_per_s, added = g * gains.inertia_kg_m2 / gains.torqueConstant_Nm_per_A;
  return {gains.positionKp_A_per_rad + g * gains.positionKd_A_s_per_rad,
          gains.positionKi_A_per_rad_s + g * gains.positionKp_A_per_rad, gains.positionKd_A_s_per_rad + added};
}

const std::vector<std::string>& gainForms() {
  static const std::vector<std::string> forms{"simplefoc", "odrive", "vesc"};
  return forms;
}

Result<GainsExport> exportGains(const TunedGains& gains, const std::string& form, const std::string& tuning,
                                std::optional<double> polePairs) {
  GainsExport out;
  if (gains.cutoff_rad_per_s > 0.0) out.notes.emplace_back(observed);
  if (form != "vesc") out.notes.emplace_back(cascade);
  if (form == "vesc") {
    auto text = vesc(gains, tuning, out.notes, polePairs);
    if (!text) return text.error();
    out.text = std::move(*text);
  } else {
    out.text = form == "odrive" ? oDrive(gains, tuning, out.notes) : simpleFoc(gains, tuning, out.notes);
  }
  return out;
}

}  // namespace breakaway
