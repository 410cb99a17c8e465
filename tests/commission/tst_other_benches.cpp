// Benches unlike the presets: light rotors, much static friction, loads, a sensor without a sign of life.
#include <QTest>
#include <functional>
#include <nlohmann/json.hpp>

#include "commission/job.h"
#include "firmware_link/simulated_board.h"
#include "support/temporary.h"
#include "support/wired_rig.h"

using namespace breakaway;

class TestOtherBenches : public QObject {
  Q_OBJECT
 private slots:
  void lightRotor_isHomed();
  void slowSpeedThatSticksAndSlips_isLeftOut();
  void armAndStiction_areNoOverSpeed();
  void loadThatDrivesTheMotor_isNoReversedSensor();
  void axisPressedToItsEnd_isNoDeadEncoder();
  void deadSensorOfHeldRotor_isNoLeadOff();
  void stopThatCameInTheWay_isNamed();
};

namespace {

using Json = nlohmann::json;
using Change = std::function<void(Json&)>;

struct Outcome {
  Procedure::State state = Procedure::State::running;
  std::string words;
  Commission known;
};

/// A job for that much on a preset's rig that was changed.
Outcome jobOn(const std::string& preset, const Change& change, const Facts& wanted) {
  Json rig = Json::parse(test::wiredRig(preset, ""));
  change(rig);
  const test::TemporaryFolder folder;
  auto drive = openDrive("simulated:" + folder.write("other.rig.json", rig.dump()), 7);
  if (!drive) qFatal("%s", drive.error().message().c_str());
  CommissionOptions options;
  options.keepRecordings = false;
  options.sweeps = {36, 1, 2.0, 6, 0.0};
  Job job(options, wanted);
  std::vector<Sample> samples;
  job.begin(**drive);
  while (job.running()) {
    samples.clear();
    const auto lost = (*drive)->advance(0.25, samples);
    if (!lost) qFatal("%s", lost.error().message().c_str());
    job.take(**drive, 0.25, samples, *lost);
  }
  return {job.status().state, job.failure().message(), job.known()};
}

bool says(const Outcome& outcome, const char* words) {
  const bool found = outcome.words.find(words) != std::string::npos;
  if (!found) qWarning("%s", outcome.words.c_str());
  return found;
}

void scaleFriction(Json& rig, double by) {
  for (const char* curve : {"static_cw", "static_ccw", "coulomb_cw", "coulomb_ccw", "viscous_cw", "viscous_ccw"})
    rig["friction"][curve]["mean"] = by * rig["friction"][curve]["mean"].get<double>();
}

/// A coreless motor of 9 V and 38,000 rpm.
void coreless(Json& rig) {
  constexpr double Kt = 0.00224;
  rig["loop_rate_Hz"] = 4000;
  rig["motor"] = {{"torque_constant_Nm_per_A", Kt},
                  {"back_emf_constant_V_s_per_rad", Kt},
                  {"resistance_ohm", 3.04},
                  {"inductance_H", 5.8e-4},
                  {"inertia_kg_m2", 2.6e-8}};
  scaleFriction(rig, 0.0095);
  for (const char* curve : {"viscous_cw", "viscous_ccw"}) rig["friction"][curve]["mean"] = 1.4e-8;
  rig["friction"]["stribeck_velocity_rad_per_s"] = 12.0;
  rig["position_torque"]["harmonics_Nm"] = Json::array();
  rig["encoder"] = {{"counts_per_rev", 2048}, {"index_angle_rad", -1.5}};
  rig["current_sensor"] = {{"sensitivity_V_per_A", 1.5}, {"noise_rms_A", 6e-4}, {"adc_bits", 12}, {"adc_range_V", 5.0}};
  rig["bridge"] = {{"supply_V", 9.0}, {"dead_zone_duty", 0.018}, {"pwm_steps", 500}};
}

/// A gear motor's own 6 V motor, its friction falling fast, with 400 counts.
void gearMotor(Json& rig) {
  constexpr double Kt = 0.0082;
  rig["loop_rate_Hz"] = 4000;
  rig["motor"] = {{"torque_constant_Nm_per_A", Kt},
                  {"back_emf_constant_V_s_per_rad", Kt},
                  {"resistance_ohm", 9.7},
                  {"inductance_H", 0.0048},
                  {"inertia_kg_m2", 4e-8}};
  scaleFriction(rig, 0.056);
  for (const char* curve : {"static_cw", "static_ccw"})
    rig["friction"][curve]["mean"] = 1.6 * rig["friction"][curve]["mean"].get<double>();
  for (const char* curve : {"viscous_cw", "viscous_ccw"}) rig["friction"][curve]["mean"] = 4e-7;
  rig["friction"]["stribeck_velocity_rad_per_s"] = 3.4;
  rig["position_torque"]["harmonics_Nm"] = {{6, 1.2e-4, 0.7}};
  rig["encoder"] = {{"counts_per_rev", 400}, {"index_angle_rad", 3.8}};
  rig["current_sensor"] = {
      {"sensitivity_V_per_A", 3.7}, {"noise_rms_A", 0.002}, {"adc_bits", 16}, {"adc_range_V", 5.0}};
  rig["bridge"] = {{"supply_V", 6.0}, {"dead_zone_duty", 0.0075}, {"pwm_steps", 1000}};
}

/// A brushed 24 V motor whose static friction is 1.4 times the moving one.
void stiff(Json& rig) {
  constexpr double Kt = 0.044;
  rig["loop_rate_Hz"] = 8000;
  rig["motor"] = {{"torque_constant_Nm_per_A", Kt},
                  {"back_emf_constant_V_s_per_rad", Kt},
                  {"resistance_ohm", 0.63},
                  {"inductance_H", 5.6e-4},
                  {"inertia_kg_m2", 1.96e-5}};
  scaleFriction(rig, 6.0);
  for (const char* curve : {"viscous_cw", "viscous_ccw"}) rig["friction"][curve]["mean"] = 5e-5;
  rig["friction"]["stribeck_velocity_rad_per_s"] = 5.4;
  rig["encoder"] = {{"counts_per_rev", 400}, {"index_angle_rad", 1.6}};
  rig["current_sensor"] = {
      {"sensitivity_V_per_A", 0.058}, {"noise_rms_A", 0.03}, {"adc_bits", 14}, {"adc_range_V", 5.0}};
}

}  // namespace

/// At 0.8 rad/s it takes seconds until the loop's current has gone from what friction takes one way to the other.
void TestOtherBenches::lightRotor_isHomed() {
  const Outcome outcome = jobOn("servo", coreless, {Known::index});
  QVERIFY2(outcome.state == Procedure::State::finished, outcome.words.c_str());
  QVERIFY(outcome.known.indexAngle_rad.standardError > 0.0);
}

void TestOtherBenches::slowSpeedThatSticksAndSlips_isLeftOut() {
  const Outcome outcome = jobOn("servo", gearMotor, {Known::runs});
  QVERIFY2(outcome.state == Procedure::State::finished, outcome.words.c_str());
  const auto& remarks = outcome.known.remarks;
  const auto left = std::count_if(remarks.begin(), remarks.end(), [](const Message& one) {
    return std::string(one).find("sticks and slips") != std::string::npos;
  });
  QVERIFY(left > 0);
  QCOMPARE(outcome.known.runs.size(), static_cast<size_t>(12 - left));
}

void TestOtherBenches::armAndStiction_areNoOverSpeed() {
  const auto change = [](Json& rig) {
    stiff(rig);
    rig["wiring"] = {{{"fault", "pendulum_Nm"}, {"value", 0.063}}};
  };
  const Outcome outcome = jobOn("servo", change, {Known::index});
  QVERIFY2(outcome.state == Procedure::State::finished, outcome.words.c_str());
}

/// More than moving friction and less than static: cogging holds it until it is turned.
void TestOtherBenches::loadThatDrivesTheMotor_isNoReversedSensor() {
  const auto change = [](Json& rig) {
    rig["position_torque"]["harmonics_Nm"] = {{24, 0.008, 0.0}};
    rig["wiring"] = {{{"fault", "load_Nm"}, {"value", -0.0195}}};
  };
  const Outcome outcome = jobOn("servo", change, {Known::roughMotor});
  QVERIFY(outcome.state != Procedure::State::finished);
  QVERIFY(says(outcome, "a load"));
}

/// At the current limit the voltage grows no more, and the current neither.
void TestOtherBenches::axisPressedToItsEnd_isNoDeadEncoder() {
  const auto change = [](Json& rig) {
    rig["wiring"] = {{{"fault", "load_N"}, {"value", 20.0}, {"from_s", 20.0}}};
    rig["current_sensor"]["sensitivity_V_per_A"] = 1.4;
  };
  const Outcome outcome = jobOn("linear", change, {Known::roughMotor});
  QVERIFY(outcome.state != Procedure::State::finished);
  QVERIFY2(outcome.words.find("encoder's cable") == std::string::npos, outcome.words.c_str());
}

/// The board's watch sees no current at that voltage; that the reading never changes tells which.
void TestOtherBenches::deadSensorOfHeldRotor_isNoLeadOff() {
  const auto wired = [](const char* fault) {
    return [fault](Json& rig) {
      stiff(rig);
      scaleFriction(rig, 2.0);  // more voltage than the watch leaves unexplained
      rig["encoder"]["counts_per_rev"] = 14400;
      rig["wiring"] = {{{"fault", fault}}};
    };
  };
  QVERIFY(says(jobOn("servo", wired("current_sensor_dead"), {Known::wiring}), "the current sensor is dead: it reads"));
  QVERIFY(says(jobOn("servo", wired("lead_off"), {Known::wiring}), "a lead of the motor is off"));
}

/// It comes while the rotor turns round by constant current.
void TestOtherBenches::stopThatCameInTheWay_isNamed() {
  const auto change = [](Json& rig) { rig["wiring"] = {{{"fault", "stop_at_rad"}, {"value", 8.0}, {"from_s", 60.3}}}; };
  const Outcome outcome = jobOn("servo", change, {Known::index});
  QVERIFY(outcome.state != Procedure::State::finished);
  QVERIFY(says(outcome, "a stop, or a load, holds it the other way") || says(outcome, "something in its way"));
}

QTEST_APPLESS_MAIN(TestOtherBenches)
#include "tst_other_benches.moc"
