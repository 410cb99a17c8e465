#include <QTest>
#include <cmath>

#include "diagnose/effects/all.h"
#include "diagnose/fit/parameter_vector.h"
#include "diagnose/fit/preparation.h"
#include "support/known_servo.h"
#include "support/recorded_rig.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

class TestParameterVector : public QObject {
  Q_OBJECT
 private slots:
  void inductance_staysWithinItsLimits();
  void heldValues_areNotFree();
  void bias_staysATrifle_andLeavesAConstantLoadToItsEffect();
  void limits_reachFromTheBenchToWhatTheCurrentShows();
  void shapeThatMayBeAny_leavesTheSizeKnown();
};

namespace {

Eigen::Index indexOf(const ParameterVector& parameters, const std::string& name) {
  for (Eigen::Index k = 0; k < parameters.size(); ++k) {
    if (parameters.name(k) == name) return k;
  }
  return -1;
}

}  // namespace

/// An exponent between 0.5 and 3, which data don't tell and the size hangs together with: the size is as uncertain as
/// these exponents leave it, and not as any number would.
void TestParameterVector::shapeThatMayBeAny_leavesTheSizeKnown() {
  Model model = servoModel(DriveInput::torque);
  model.effects.push_back(frictionNearStandstill(8e-3, 5.0, Axis::rotary));
  const ParameterVector parameters(model, {}, 0.05, 50.0, true);
  const Eigen::Index size = indexOf(parameters, "excess_Nm"), exponent = indexOf(parameters, "exponent");
  QVERIFY(size >= 0 && exponent >= 0);
  // One unit of the exponent's logarithm goes with a fifth of the size, and it is uncertain by five.
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(parameters.size(), parameters.size());
  covariance(exponent, exponent) = 25.0;
  covariance(size, exponent) = covariance(exponent, size) = 5.0;
  covariance(size, size) = 1.0 + 1e-4;
  const Model known = parameters.withIntervals(parameters.start(), covariance, 1.96);
  const Parameter& excess = known.effects[0].parameters[0];
  QVERIFY(excess.low95 > 0.7 * excess.value && excess.low95 < 0.9 * excess.value);
  const Parameter& p = known.effects[0].parameters[2];
  QVERIFY(p.low95 >= 0.5 - 1e-9 && p.high95 <= 3.0 + 1e-9 && p.high95 - p.low95 > 1.5);
}

/// Wherever the start lies between them, so that fits that follow each other don't walk away.
void TestParameterVector::inductance_staysWithinItsLimits() {
  Freedom freedom;
  freedom.leastInductance_H = 1e-3;
  freedom.mostInductance_H = 2e-3;
  for (const double start : {1.1e-3, 1.9e-3}) {
    Model model = servoModel(DriveInput::voltage);
    for (Parameter& one : model.base) {
      if (one.name == "inductance_H") one.value = start;
    }
    const ParameterVector parameters(model, freedom, 0.05, 50.0);
    const Eigen::Index inductance = indexOf(parameters, "inductance_H"), inertia = indexOf(parameters, "inertia_kg_m2");
    QVERIFY(inductance >= 0 && inertia >= 0);
    QVERIFY(std::abs(parameters.lower(inductance) - std::log(1e-3)) < 1e-9);
    QVERIFY(std::abs(parameters.upper(inductance) - std::log(2e-3)) < 1e-9);
    QVERIFY(parameters.upper(inertia) - parameters.lower(inertia) > 10.0);
  }
}

void TestParameterVector::heldValues_areNotFree() {
  Freedom freedom;
  freedom.held = {"inductance_H", "inertia_kg_m2"};
  const ParameterVector parameters(servoModel(DriveInput::voltage), freedom, 0.05, 50.0);
  QCOMPARE(indexOf(parameters, "inductance_H"), Eigen::Index(-1));
  QCOMPARE(indexOf(parameters, "inertia_kg_m2"), Eigen::Index(-1));
  QVERIFY(indexOf(parameters, "coulomb_Nm") >= 0);
}

void TestParameterVector::bias_staysATrifle_andLeavesAConstantLoadToItsEffect() {
  Freedom freedom;
  freedom.mostBias = 2e-4;
  Model model = servoModel(DriveInput::current);
  model.base.push_back({biasName(model.axis), 1e-4, 1e-4, 1e-4});
  const ParameterVector alone(model, freedom, 0.05, 50.0);
  const Eigen::Index bias = indexOf(alone, "bias_Nm");
  QVERIFY(bias >= 0);
  QCOMPARE(alone.start()[bias], 0.5);
  QCOMPARE(alone.lower(bias), -1.0);
  QCOMPARE(alone.upper(bias), 1.0);
  model.effects.push_back(effectTerm(*findEffect("constant_load"), {3e-3}));
  const ParameterVector beside(model, freedom, 0.05, 50.0);
  QCOMPARE(indexOf(beside, "bias_Nm"), Eigen::Index(-1));
  QCOMPARE(beside.at(beside.start()).baseValue("bias_Nm").value_or(1.0), 0.0);
}

void TestParameterVector::limits_reachFromTheBenchToWhatTheCurrentShows() {
  auto rig = recordRig({.seconds = 12.0, .currentOffset_A = 1e-6});
  rig.bench.motor.inductance_H = 0.011;  // ten times what it is: fits begin from what the current shows
  const auto prepared = prepare(rig.bench, {rig.recording}, {}, 0.5);
  VERIFY_OK(prepared);
  QVERIFY(*prepared->starts.front().baseValue("inductance_H") < 0.0022);
  QVERIFY(prepared->freedom.leastInductance_H < 0.0011);
  QVERIFY(prepared->freedom.mostInductance_H > 0.011);
}

QTEST_APPLESS_MAIN(TestParameterVector)
#include "tst_parameter_vector.moc"
