#include <QTest>
#include <cmath>

#include "base/random.h"
#include "identify/motor_identification.h"
#include "identify/reversal_inertia.h"
#include "identify/spin_disc.h"

using namespace breakaway;

class TestInertia : public QObject {
  Q_OBJECT
 private slots:
  void reversals_giveTheInertiaWhateverTheFriction();
  void discOffItsCentre_doesNotDrawTheInertiaLow();
  void discInItsCentre_isNotFound();
  void frictionOfFewTurns_isNoDisc();
  void discThatTheVoltageRefutes_isNone();
  void coarseEncoder_doesNotDrawTheInertiaLow();
  void armOnASlowJoint_isNoInertia_data();
  void armOnASlowJoint_isNoInertia();
  void rotorThatNeverMoved_isReported();
  void currentThatStaysLow_isCalledSaturated();
  void methodsThatDisagree_widenTheInterval();
  void methodsThatAgree_narrowIt();
  void untrustedGain_goesIntoEveryIntervalAndIsNamed();
  void trustedInertia_measuresTheGain();
  void addedInertia_measuresTheGain();
  void addedInertia_carriesItsTolerance();
  void addedInertiaThatDrowns_measuresNothingAndSaysSo();
};

namespace {

constexpr double Kt = 0.07, J = 6e-5;

/// A rotor with Coulomb and viscous friction to and fro under ±`amps`, turned round at 60 rad/s or another speed;
/// blocks of 2 ms.
std::vector<SpinBlock> toAndFro(double amps, double coulomb_Nm, double viscous, unsigned seed, double highest = 60.0,
                                double waves = 0.0) {
  Noise noise(seed);
  std::vector<SpinBlock> blocks;
  double speed = 0.0, angle = 0.0, way = 1.0;
  for (int k = 1; k < 4000; ++k) {
    const double from = angle;
    for (int step = 0; step < 20; ++step) {
      const double around = 1.0 + waves * (std::cos(3.0 * angle) + std::cos(4.0 * angle - 1.0) + std::cos(5.0 * angle));
      const double friction = around * (speed > 0.0 ? coulomb_Nm : -coulomb_Nm) + viscous * speed;
      speed += 1e-4 * (Kt * way * amps - friction) / J;
      angle += 1e-4 * speed;
    }
    blocks.push_back({2e-3 * k, 2e-3, angle + 1e-4 * noise.uniform(), way * amps + 0.005 * noise.normal(),
                      1.2 * way * amps + Kt * (angle - from) / 2e-3});
    if (way * speed > highest) way = -way;
  }
  return blocks;
}

/// As a disc shows it that is off its centre by `off_rad`.
std::vector<SpinBlock> shownBy(double off_rad, std::vector<SpinBlock> blocks) {
  for (SpinBlock& block : blocks) block.angle_rad += off_rad * std::cos(block.angle_rad - 1.0);
  return blocks;
}

/// Inertia by the change of speed over 0.1 s, as the momentum's balance regards it.
Estimate inertiaBy(const std::vector<SpinBlock>& blocks, double count_rad) {
  std::vector<SpinBlock> ramped = blocks;
  for (SpinBlock& block : ramped) block.voltage_V = 1.2 * block.current_A;
  WindingLine winding;
  winding.resistance_ohm = {1.2, 0.001};
  MotorIdentificationOptions options;
  options.trustedTorqueConstant_Nm_per_A = Kt;
  options.window_s = 0.02;
  options.count_rad = count_rad;
  const auto found = identifyMotor(ramped, winding, {1e-3, 1e-6}, options);
  return found ? found->inertia_kg_m2 : Estimate{};
}

double inertiaOf(const std::vector<SpinBlock>& blocks) {
  return inertiaBy(blocks, 0.0).value;
}

IdentifiedMotor motor() {
  IdentifiedMotor result;
  result.torqueConstant_Nm_per_A = {Kt, 1e-5};
  result.resistance_ohm = {1.2, 0.001};
  result.inductance_H = {1.1e-3, 1e-6};
  result.inertia_kg_m2 = result.rampInertia_kg_m2 = {J, 0.002 * J};
  result.coulomb_Nm = {0.017, 1e-5};
  return result;
}

}  // namespace

void TestInertia::reversals_giveTheInertiaWhateverTheFriction() {
  for (const double coulomb : {0.0, 0.005, 0.02}) {
    const auto inertia = reversalInertia(toAndFro(0.7, coulomb, 2e-5, 1), {Kt, 0.7});
    QVERIFY2(inertia.ok(), inertia.ok() ? "" : inertia.error().message().c_str());
    QVERIFY2(std::abs(inertia->value / J - 1.0) < 0.01, qPrintable(QString::number(inertia->value / J)));
    QVERIFY(inertia->standardError > 1e-5 * J && inertia->standardError < 0.01 * J);
  }
}

void TestInertia::discOffItsCentre_doesNotDrawTheInertiaLow() {
  const auto shown = shownBy(0.05, toAndFro(0.7, 0.01, 2e-5, 1, 200.0));
  const EncoderDisc disc = spinDisc(shown);
  QVERIFY2(std::abs(std::abs(disc.off_rad) - 0.05) < 0.01 * 0.05, qPrintable(QString::number(std::abs(disc.off_rad))));
  const double off = inertiaOf(shown) / J, freed = inertiaOf(freedOf(disc, shown)) / J;
  QVERIFY2(off < 0.98 && std::abs(freed - 1.0) < 0.005, qPrintable(QString("%1 %2").arg(off).arg(freed)));
}

void TestInertia::discInItsCentre_isNotFound() {
  QVERIFY(!spinDisc(toAndFro(0.7, 0.01, 2e-5, 1, 200.0)).known());
}

/// Somewhat more than a turn each way: waves of friction of the orders 3 to 5 would pass for the disc's.
void TestInertia::frictionOfFewTurns_isNoDisc() {
  QVERIFY(!spinDisc(toAndFro(0.7, 0.02, 2e-5, 1, 80.0, 0.1)).known());
}

/// Where the back-EMF swings as the angle does, the rotor itself swings: torque that the balance doesn't know, as a
/// stepper's detents in a turn or two, passes for a disc's.
void TestInertia::discThatTheVoltageRefutes_isNone() {
  auto blocks = shownBy(0.05, toAndFro(0.7, 0.01, 2e-5, 1, 200.0));
  QVERIFY(spinDisc(blocks).known());
  for (size_t k = 1; k < blocks.size(); ++k)
    blocks[k].voltage_V = 1.2 * blocks[k].current_A + Kt * (blocks[k].angle_rad - blocks[k - 1].angle_rad) / 2e-3;
  QVERIFY(!spinDisc(blocks).known());
}

void TestInertia::coarseEncoder_doesNotDrawTheInertiaLow() {
  constexpr double count_rad = 0.04;
  auto blocks = toAndFro(0.7, 0.01, 2e-5, 1, 200.0);
  for (SpinBlock& block : blocks) block.angle_rad = count_rad * std::floor(block.angle_rad / count_rad);
  const double plain = inertiaOf(blocks) / J;
  const Estimate freed = inertiaBy(blocks, count_rad);
  QVERIFY2(plain < 0.93, qPrintable(QString::number(plain)));
  QVERIFY2(std::abs(freed.value / J - 1.0) < 0.03, qPrintable(QString::number(freed.value / J)));
  QVERIFY(freed.low95() < J && J < freed.high95() && freed.standardError < 0.1 * J);
}

void TestInertia::armOnASlowJoint_isNoInertia_data() {
  QTest::addColumn<double>("arm_Nm");
  QTest::newRow("none") << 0.0;
  QTest::newRow("15 times what accelerates") << 6.5;
}

/// A geared joint by voltage up and down, a turn a second at most: what its arm weighs passed for six times the
/// inertia.
void TestInertia::armOnASlowJoint_isNoInertia() {
  QFETCH(double, arm_Nm);
  constexpr double R = 1.1, constant = 2.8, inertia = 0.0765, coulomb = 16.0, viscous = 0.3, leg_s = 1.5, step_s = 1e-4;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    Noise noise(seed);
    std::vector<SpinBlock> blocks;
    double speed = 0.0, angle = 0.3 * seed;
    for (int k = 1; k <= 2400; ++k) {
      double current = 0.0, voltage = 0.0;
      for (int step = 0; step < 100; ++step) {
        const double legs = (0.01 * k + step_s * step) / leg_s, phase = legs - 4.0 * std::floor(legs / 4.0);
        const double applied = 24.0 * (phase < 1.0 ? phase : phase < 3.0 ? 2.0 - phase : phase - 4.0);
        const double through = (applied - constant * speed) / R;
        const double acting = constant * through - arm_Nm * std::cos(angle) - viscous * speed;
        const double next = speed + step_s * (acting - std::copysign(coulomb, speed != 0.0 ? speed : acting)) / inertia;
        speed = speed * next < 0.0 || (speed == 0.0 && std::abs(acting) < coulomb) ? 0.0 : next;
        angle += step_s * speed;
        current += 0.01 * through;
        voltage += 0.01 * applied;
      }
      blocks.push_back({0.01 * k, 0.01, angle, current + 0.07 * noise.normal(), voltage});
    }
    WindingLine winding;
    winding.resistance_ohm = {R, 0.001};
    MotorIdentificationOptions options;
    options.trustedTorqueConstant_Nm_per_A = constant;
    const auto found = identifyMotor(blocks, winding, {1e-3, 1e-6}, options);
    QVERIFY2(found.ok(), found.ok() ? "" : found.error().message().c_str());
    const Estimate& J_found = found->inertia_kg_m2;
    QVERIFY2(std::abs(J_found.value / inertia - 1.0) < 0.15, qPrintable(QString::number(J_found.value)));
    QVERIFY(std::abs(J_found.value - inertia) < 4.0 * J_found.standardError);
  }
}

void TestInertia::rotorThatNeverMoved_isReported() {
  const auto inertia = reversalInertia(std::vector<SpinBlock>(500, {1.0, 0.002, 0.3, 0.1, 0.0}), {Kt, 0.1});
  QVERIFY(!inertia.ok());
  QVERIFY(inertia.error().message().find("saw the rotor turn round 0 times") != std::string::npos);
}

void TestInertia::currentThatStaysLow_isCalledSaturated() {
  const auto inertia = reversalInertia(toAndFro(0.7, 0.005, 2e-5, 2), {Kt, 1.2});
  QVERIFY(!inertia.ok());
  QVERIFY(inertia.error().message().find("saturated") != std::string::npos);
}

void TestInertia::methodsThatDisagree_widenTheInterval() {
  IdentifiedMotor one = motor();
  const double apart = joinInertia(one, {1.05 * J, 0.002 * J});
  QVERIFY(apart > 10.0);
  QVERIFY(one.inertia_kg_m2.low95() < J && one.inertia_kg_m2.high95() > 1.05 * J);
}

void TestInertia::methodsThatAgree_narrowIt() {
  IdentifiedMotor one = motor();
  QVERIFY(joinInertia(one, {1.001 * J, 0.002 * J}) < 1.0);
  QVERIFY(one.inertia_kg_m2.standardError < 0.0015 * J);
}

void TestInertia::untrustedGain_goesIntoEveryIntervalAndIsNamed() {
  IdentifiedMotor one = motor();
  setCurrentScale(one, {});
  QCOMPARE(one.inertia_kg_m2.value, J);
  QVERIFY(one.inertia_kg_m2.high95() > 1.0265 * J && one.inertia_kg_m2.high95() < 1.03 * J);
  QVERIFY(one.resistance_ohm.high95() > 1.0265 * 1.2 && one.coulomb_Nm.high95() > 1.0265 * 0.017);
  QCOMPARE(one.torqueConstant_Nm_per_A.standardError, 1e-5);
  QVERIFY(one.gauge.find("±2.7 %") != std::string::npos);
}

void TestInertia::trustedInertia_measuresTheGain() {
  IdentifiedMotor one = motor();
  // A sensor that shows 3 % too much makes the rotor seem 3 % heavier and its winding 3 % lighter.
  CurrentScaleOptions trusted;
  trusted.gainInterval = 0.027;
  trusted.trustedInertia_kg_m2 = J / 1.03;
  setCurrentScale(one, trusted);
  QVERIFY(std::abs(one.currentGain.value - 1.03) < 1e-12);
  QVERIFY(one.currentGain.standardError > 0.002 && one.currentGain.standardError < 0.0025);
  QVERIFY(std::abs(one.resistance_ohm.value - 1.2 * 1.03) < 1e-12);
  QVERIFY(std::abs(one.coulomb_Nm.value - 0.017 / 1.03) < 1e-12);
  QVERIFY(std::abs(one.torquePerShownAmpere_Nm() - Kt / 1.03) < 1e-12);
  QVERIFY(one.gauge.find("trusted inertia") != std::string::npos);
}

void TestInertia::addedInertia_measuresTheGain() {
  // The sensor shows 3 % too much; the other time a disc of 1.5 J was on the shaft.
  const double disc = 1.5 * J / 1.03;
  for (const double way : {1.0, -1.0}) {
    IdentifiedMotor one = motor();
    if (way > 0.0) one.inertia_kg_m2 = {J + 1.03 * disc, 0.002 * J};
    const AddedInertia added{{way > 0.0 ? J : J + 1.03 * disc, 0.002 * J}, {way * disc, 0.0}};
    setCurrentScale(one, {Axis::rotary, 0.027, {}, added});
    QVERIFY(std::abs(one.currentGain.value - 1.03) < 1e-9);
    QVERIFY(one.currentGain.standardError > 0.0015 && one.currentGain.standardError < 0.0025);
    const double truth = way > 0.0 ? J / 1.03 + disc : J / 1.03;
    QVERIFY(std::abs(one.inertia_kg_m2.value / truth - 1.0) < 1e-9);
    QVERIFY(std::abs(one.coulomb_Nm.value - 0.017 / 1.03) < 1e-12);
    QVERIFY(one.gauge.find("disc of known inertia") != std::string::npos);
  }
}

void TestInertia::addedInertia_carriesItsTolerance() {
  IdentifiedMotor sharp = motor(), rough = motor();
  setCurrentScale(sharp, {Axis::rotary, 0.027, {}, AddedInertia{{2.0 * J, 1e-5 * J}, {-J, 0.0}}});
  setCurrentScale(rough, {Axis::rotary, 0.027, {}, AddedInertia{{2.0 * J, 1e-5 * J}, {-J, 0.01 * J}}});
  QVERIFY(rough.currentGain.standardError > 0.0099 && sharp.currentGain.standardError < 0.003);
  QVERIFY(rough.inertia_kg_m2.standardError > 0.0099 * J && rough.coulomb_Nm.standardError > 0.0099 * 0.017);
}

void TestInertia::addedInertiaThatDrowns_measuresNothingAndSaysSo() {
  IdentifiedMotor one = motor();
  setCurrentScale(one, {Axis::rotary, 0.027, {}, AddedInertia{{1.005 * J, 0.002 * J}, {-0.005 * J, 0.0}}});
  QCOMPARE(one.currentGain.value, 1.0);
  QVERIFY(one.gauge.find("doesn't stand out") != std::string::npos && one.gauge.find("±2.7 %") != std::string::npos);
}

QTEST_APPLESS_MAIN(TestInertia)
#include "tst_inertia.moc"
