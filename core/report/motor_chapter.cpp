#include "report/motor_chapter.h"

#include <cctype>

namespace breakaway {

namespace {

/// Units and scales in which people read an axis' quantities.
struct AxisUnits {
  const char *constant, *constantName, *backEmf;
  const char* inertiaName;
  const char* inertia;
  double inertiaScale;
  const char* torque;
  double torqueScale;
  const char* viscous;
  double viscousScale;
  const char *speed, *gain, *positionGain, *body, *other;
};

constexpr AxisUnits rotaryUnits{
    "Nm/A",  "torque constant", "V s/rad", "inertia",   "kg mm²",          1e6, "mNm", 1e3, "µNm s/rad", 1e6,
    "rad/s", " A s/rad",        " A/rad",  "the rotor", "by turning round"};
constexpr AxisUnits linearUnits{"N/A",
                                "force constant",
                                "V s/m",
                                "mass",
                                "kg",
                                1.0,
                                "N",
                                1.0,
                                "N s/m",
                                1.0,
                                "m/s",
                                " A s/m",
                                " A/m",
                                "the axis",
                                "by strokes at several speeds"};

const AxisUnits& unitsOf(Axis axis) {
  return axis == Axis::rotary ? rotaryUnits : linearUnits;
}

Figure dutyFigure(const DutyCurve& curve) {
  Figure figure{"What the bridge gives of its duty", "input duty / %", "output duty / %"};
  Curve measured;
  measured.label = "measured";
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

std::string withInterval(const Estimate& estimate, double scale, const std::string& unit) {
  if (estimate.standardError <= 0.0) return numberText(estimate.value * scale) + " " + unit;
  return numberText(estimate.value * scale) + " " + unit + " (" + numberText(estimate.low95() * scale) + " to " +
         numberText(estimate.high95() * scale) + ")";
}

void motorChapter(HtmlReport& report, const Commission& done) {
  const AxisUnits& units = unitsOf(done.identity.axis);
  const IdentifiedMotor& motor = done.motor;
  report.heading("The motor");
  report.facts(
      {{std::string(units.constantName),
        withInterval(motor.torqueConstant_Nm_per_A, 1.0, units.constant) +
            (motor.torqueConstantTrusted ? ", trusted from the bench" : ", tied to the back-EMF constant")},
       {"back-EMF constant", withInterval(motor.backEmfConstant_V_s_per_rad, 1.0, units.backEmf)},
       {"resistance", withInterval(motor.resistance_ohm, 1.0, "Ω")},
       {"inductance", withInterval(motor.inductance_H, 1e3, "mH")},
       {"bridge's dead zone", withInterval(motor.deadZone_V, 1.0, "V")},
       {units.inertiaName, withInterval(motor.inertia_kg_m2, units.inertiaScale, units.inertia)},
       {"by speeding up and slowing down", withInterval(motor.rampInertia_kg_m2, units.inertiaScale, units.inertia)},
       {units.other, motor.reversalInertia_kg_m2.value > 0.0
                         ? withInterval(motor.reversalInertia_kg_m2, units.inertiaScale, units.inertia)
                         : std::string("not measured")},
       {"current sensor's zero", withInterval(done.sensorZero_A, 1e3, "mA")},
       {"current sensor's noise", numberText(1e3 * done.noiseRms_A) + " mA rms"}});
  report.paragraph("In brackets: 95 % intervals. " + motor.gauge);
  if (!motor.dutyCurve.known()) return;
  report.figure(
      dutyFigure(motor.dutyCurve),
      "Both as part of the supply; the band is the 95 % interval. Further out the bridge is taken to give a volt more "
      "for each volt more: a common factor can't be seen, and would be part of R, L and Ke.");
}

void useChapter(HtmlReport& report, const Commission& done) {
  const AxisUnits& units = unitsOf(done.identity.axis);
  const std::string speed = std::string(" ") + units.speed;
  report.heading("With the map on the board");
  const Estimate& fall = done.map.stribeckVelocity_rad_per_s;
  std::vector<std::pair<std::string, std::string>> facts;
  if (done.compensatedRun) {
    const CompensatedRun& run = *done.compensatedRun;
    report.paragraph(std::string("The velocity controller took ") + units.body + " to and fro, a sine of " +
                     numberText(run.amplitude_rad_per_s) + speed + " and " + numberText(run.period_s) +
                     " s, without compensation and with the measured friction added by the board.");
    facts = {{"velocity error without", numberText(run.without_rad_per_s) + speed + " rms"},
             {"velocity error with the map", numberText(run.with_rad_per_s) + speed + " rms"},
             {"smaller by", numberText(run.without_rad_per_s / run.with_rad_per_s) + " times"}};
  }
  facts.emplace_back("friction falls to Coulomb over",
                     fall.value > 0.0 ? withInterval(fall, 1.0, units.speed) : std::string("not seen"));
  const ControllerSettings& left = done.settings;
  facts.emplace_back("controller", done.tunedForUse
                                       ? "tuned to medium stiffness for the identified motor, left on the board"
                                       : "left as it was for the measurements");
  facts.emplace_back("velocity controller", numberText(left.velocity_kp_A_s_per_rad) + units.gain);
  facts.emplace_back("position controller", numberText(left.position_kp_A_per_rad) + units.positionGain + " and " +
                                                numberText(left.position_kd_A_s_per_rad) + units.gain);
  facts.emplace_back("observer's cutoff", numberText(left.observer_cutoff_rad_per_s) + " rad/s");
  report.facts(facts);
}

void closingChapter(HtmlReport& report, const Commission& done, bool hasTruth) {
  if (!done.remarks.empty()) report.list({done.remarks.begin(), done.remarks.end()});
  if (!done.identity.simulated) return;
  report.paragraph(std::string("The board is simulated.") +
                   (hasTruth ? " Its true map lies beside the measured one in truth.csv." : ""));
}

std::string motorInWords(const Commission& done) {
  const IdentifiedMotor& motor = done.motor;
  const AxisUnits& units = unitsOf(done.identity.axis);
  std::string name = units.constantName;
  name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name + " " + withInterval(motor.torqueConstant_Nm_per_A, 1.0, units.constant) + ", resistance " +
         withInterval(motor.resistance_ohm, 1.0, "Ω") + ", inductance " + withInterval(motor.inductance_H, 1e3, "mH") +
         ", " + units.inertiaName + " " + withInterval(motor.inertia_kg_m2, units.inertiaScale, units.inertia) +
         ", Coulomb friction " + withInterval(motor.coulomb_Nm, units.torqueScale, units.torque) +
         ", viscous friction " + withInterval(motor.viscous_Nm_s_per_rad, units.viscousScale, units.viscous) + ".";
}

}  // namespace breakaway
