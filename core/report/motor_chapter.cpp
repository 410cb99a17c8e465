#include "report/motor_chapter.h"

#include "base/marked_text.h"

namespace breakaway {

namespace {

/// Units and scales in which people read an axis' quantities.
struct AxisUnits {
  const char* constant;
  MessageText<0> constantName;
  const char* backEmf;
  MessageText<0> inertiaName;
  const char* inertia;
  double inertiaScale;
  const char* torque;
  double torqueScale;
  const char* viscous;
  double viscousScale;
  const char *speed, *gain, *positionGain;
  MessageText<0> body, other;
};

constexpr AxisUnits rotaryUnits{"Nm/A",
                                marked("torque constant"),
                                "V s/rad",
                                marked("inertia"),
                                "kg mm²",
                                1e6,
                                "mNm",
                                1e3,
                                "µNm s/rad",
                                1e6,
                                "rad/s",
                                " A s/rad",
                                " A/rad",
                                marked("the rotor"),
                                marked("by turning round")};
constexpr AxisUnits linearUnits{"N/A",
                                marked("force constant"),
                                "V s/m",
                                marked("mass"),
                                "kg",
                                1.0,
                                "N",
                                1.0,
                                "N s/m",
                                1.0,
                                "m/s",
                                " A s/m",
                                " A/m",
                                marked("the axis"),
                                marked("by strokes at several speeds")};

const AxisUnits& unitsOf(Axis axis) {
  return axis == Axis::rotary ? rotaryUnits : linearUnits;
}

Figure dutyFigure(const DutyCurve& curve) {
  Figure figure{message("What the bridge gives of its duty"), message("input duty / %"), message("output duty / %")};
  Curve measured;
  measured.label = message("measured");
  for (const DutyPoint& point : curve.points) {
    measured.x.push_back(100.0 * point.input);
    measured.y.push_back(100.0 * point.output.value);
    measured.low.push_back(100.0 * point.output.low95());
    measured.high.push_back(100.0 * point.output.high95());
  }
  figure.curves.push_back(std::move(measured));
  return figure;
}

}  // namespace

Message withInterval(const Estimate& estimate, double scale, const Message& unit) {
  if (estimate.standardError <= 0.0) return Message(numberText(estimate.value * scale) + " ") + unit;
  return message("{} {} ({} to {})", numberText(estimate.value * scale), unit, numberText(estimate.low95() * scale),
                 numberText(estimate.high95() * scale));
}

void motorChapter(HtmlReport& report, const Commission& done) {
  const AxisUnits& units = unitsOf(done.identity.axis);
  const IdentifiedMotor& motor = done.motor;
  report.heading(message("The motor"));
  report.facts(
      {{message(units.constantName), withInterval(motor.torqueConstant_Nm_per_A, 1.0, units.constant) + ", " +
                                         (motor.torqueConstantTrusted ? message("trusted from the bench")
                                                                      : message("tied to the back-EMF constant"))},
       {message("back-EMF constant"), withInterval(motor.backEmfConstant_V_s_per_rad, 1.0, units.backEmf)},
       {message("resistance"), withInterval(motor.resistance_ohm, 1.0, "Ω")},
       {message("inductance"), withInterval(motor.inductance_H, 1e3, "mH")},
       {message("bridge's dead zone"), withInterval(motor.deadZone_V, 1.0, "V")},
       {message(units.inertiaName), withInterval(motor.inertia_kg_m2, units.inertiaScale, units.inertia)},
       {message("by speeding up and slowing down"),
        withInterval(motor.rampInertia_kg_m2, units.inertiaScale, units.inertia)},
       {message(units.other), motor.reversalInertia_kg_m2.value > 0.0
                                  ? withInterval(motor.reversalInertia_kg_m2, units.inertiaScale, units.inertia)
                                  : message("not measured")},
       {message("current sensor's zero"), withInterval(done.sensorZero_A, 1e3, "mA")},
       {message("current sensor's noise"), message("{} mA rms", numberText(1e3 * done.noiseRms_A))}});
  report.paragraph(message("In brackets: 95 % intervals. {}", motor.gauge));
  if (!motor.dutyCurve.known()) return;
  report.figure(dutyFigure(motor.dutyCurve),
                message("Both as part of the supply; the band is the 95 % interval. Further out the bridge is taken to "
                        "give a volt more for each volt more: a common factor can't be seen, and would be part of R, L "
                        "and Ke."));
}

void useChapter(HtmlReport& report, const Commission& done) {
  const AxisUnits& units = unitsOf(done.identity.axis);
  const std::string speed = std::string(" ") + units.speed;
  report.heading(message("With the map on the board"));
  const Estimate& fall = done.map.stribeckVelocity_rad_per_s;
  std::vector<std::pair<Saying, Saying>> facts;
  if (done.compensatedRun) {
    const CompensatedRun& run = *done.compensatedRun;
    report.paragraph(
        message("The velocity controller took {} to and fro, a sine of {} and {}, without compensation and "
                "with the measured friction added by the board.",
                message(units.body), numberText(run.amplitude_rad_per_s) + speed, numberText(run.period_s) + " s"));
    facts = {{message("velocity error without"), message("{} rms", numberText(run.without_rad_per_s) + speed)},
             {message("velocity error with the map"), message("{} rms", numberText(run.with_rad_per_s) + speed)},
             {message("smaller by"), message("{} times", numberText(run.without_rad_per_s / run.with_rad_per_s))}};
  }
  facts.emplace_back(message("friction falls to Coulomb over"),
                     fall.value > 0.0 ? withInterval(fall, 1.0, units.speed) : message("not seen"));
  const ControllerSettings& left = done.settings;
  facts.emplace_back(message("controller"),
                     done.tunedForUse ? message("tuned to medium stiffness for the identified motor, left on the board")
                                      : message("left as it was for the measurements"));
  facts.emplace_back(message("velocity controller"), numberText(left.velocity_kp_A_s_per_rad) + units.gain);
  facts.emplace_back(message("position controller"),
                     message("{} and {}", numberText(left.position_kp_A_per_rad) + units.positionGain,
                             numberText(left.position_kd_A_s_per_rad) + units.gain));
  facts.emplace_back(message("observer's cutoff"), numberText(left.observer_cutoff_rad_per_s) + " rad/s");
  report.facts(facts);
}

void closingChapter(HtmlReport& report, const Commission& done, bool hasTruth) {
  if (!done.remarks.empty()) report.list({done.remarks.begin(), done.remarks.end()});
  if (!done.identity.simulated) return;
  report.paragraph(hasTruth ? message("The board is simulated. Its true map lies beside the measured one in truth.csv.")
                            : message("The board is simulated."));
}

Message motorInWords(const Commission& done) {
  const IdentifiedMotor& motor = done.motor;
  const AxisUnits& units = unitsOf(done.identity.axis);
  const Message constant = withInterval(motor.torqueConstant_Nm_per_A, 1.0, units.constant);
  return (done.linear() ? message("Force constant {}", constant) : message("Torque constant {}", constant)) +
         message(", resistance {}, inductance {}, {} {}, Coulomb friction {}, viscous friction {}.",
                 withInterval(motor.resistance_ohm, 1.0, "Ω"), withInterval(motor.inductance_H, 1e3, "mH"),
                 message(units.inertiaName), withInterval(motor.inertia_kg_m2, units.inertiaScale, units.inertia),
                 withInterval(motor.coulomb_Nm, units.torqueScale, units.torque),
                 withInterval(motor.viscous_Nm_s_per_rad, units.viscousScale, units.viscous));
}

}  // namespace breakaway
