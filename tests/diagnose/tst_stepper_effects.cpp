#include <QTest>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "support/known_servo.h"
#include "support/within.h"

using namespace breakaway;
using namespace breakaway::test;

/// Each kind of effect against what its formula says in closed form, or against an integration of its own.
class TestStepperEffects : public QObject {
  Q_OBJECT
 private slots:
  void deadTime_losesItsVoltageWithTheCurrentsSign();
  void voltageThatHelps_isNotLost();
  void currentDrive_losesNoVoltage();
  void supplySag_actsAsAResistanceTimesTheDutySquared();
  void supplyGivesBack_noSagWhileBraking();
  void windingHeating_raisesTheResistanceWithItsTimeConstant();
  void elasticFriction_givesLikeASpringAtSmallMotion();
  void elasticFriction_closesItsLoop();
  void elasticFriction_slidesLikeARigidOneInTheEnd();
  void compliance_hasItsAntiresonanceAndResonance_data();
  void compliance_hasItsAntiresonanceAndResonance();
  void frictionOnTheLoadsSide_slidesAndHoldsThere_data();
  void frictionOnTheLoadsSide_slidesAndHoldsThere();
  void backlash_movesAloneWithinTheGap();
  void endStop_throwsBackWithoutLoss();
  void waves_areAveragedOverTheWayOfAStep();
  void fastCogging_pushesNoWayEvenAtOneWavePerRow();
};

namespace {

constexpr double row_s = 1e-3;

/// A rotor that never breaks away: the winding alone.
Physics heldRotor() {
  Physics p = voltageDriven();
  p.coulomb = 100.0;
  return p;
}

/// The current after a constant voltage for some time, A.
double heldCurrent(const std::vector<CompiledTerm>& terms, double volts, double seconds, double supply_V = 0.0) {
  Stepper stepper(heldRotor(), terms);
  stepper.setSupply(supply_V);
  MotionState state;
  for (long k = 0; k < std::lround(seconds / row_s); ++k)
    stepper.advance(state, volts, row_s, static_cast<double>(k) * row_s);
  return state.current;
}

/// Runs `drive` (Nm, a function of time) for some seconds in rows of 1 ms and calls `look(time, state)` after each.
template <typename Drive, typename Look>
void runAlong(Stepper& stepper, MotionState& state, double seconds, Drive drive, Look look) {
  for (long k = 0; k < std::lround(seconds / row_s); ++k) {
    const double t = static_cast<double>(k) * row_s;
    stepper.advance(state, drive(t), row_s, t);
    look(t + row_s, state);
  }
}

}  // namespace

void TestStepperEffects::waves_areAveragedOverTheWayOfAStep() {
  const MotionState state;
  for (const char* name : {"cogging", "imbalance", "position_dependent_friction"}) {
    const Stepper stepper(torqueDriven(), {compiled(name, {0.002, 0.7, 11.0})});
    const auto resistance = [&](double position, double span) {
      const auto forces = stepper.forcesAt(state, position, 20.0, 1.0, 0.01, 0.0, span);
      return forces.load + forces.friction;
    };
    for (const double span : {0.02, 0.3, 0.9}) {
      constexpr int parts = 2000;
      double mean = 0.0;
      for (int k = 0; k < parts; ++k) mean += resistance(1.0 + span * ((k + 0.5) / parts - 0.5), 0.0) / parts;
      COMPARE_WITHIN(resistance(1.0, span) - torqueDriven().coulomb, mean - torqueDriven().coulomb, 1e-4);
    }
  }
}

void TestStepperEffects::fastCogging_pushesNoWayEvenAtOneWavePerRow() {
  Physics p = torqueDriven();
  p.viscous = p.coulomb = 0.0;
  constexpr double order = 24.0, speed = 2.0 * std::numbers::pi / (order * row_s);
  Stepper stepper(p, {compiled("cogging", {0.002, 0.4, order})});
  MotionState state;
  state.velocity = speed;
  state.way = 1.0;
  runAlong(
      stepper, state, 0.5, [](double) { return 0.0; }, [](double, const MotionState&) {});
  // Looked at once per row it would be one and the same torque, and change the speed by 17 rad/s.
  QVERIFY(std::abs(state.velocity - speed) < 0.2);
}

void TestStepperEffects::deadTime_losesItsVoltageWithTheCurrentsSign() {
  const Physics p = heldRotor();
  const std::vector<CompiledTerm> terms{compiled("dead_time", {0.5, 0.05})};
  for (const double way : {1.0, -1.0}) {
    COMPARE_WITHIN(heldCurrent(terms, way * 3.0, 0.05), way * 2.5 / p.resistance, 2e-4);
    // Where the current is small, so is the loss: R i + V tanh(i/i₀) = u.
    const double i = way * 0.03, u = p.resistance * i + 0.5 * std::tanh(i / 0.05);
    COMPARE_WITHIN(heldCurrent(terms, u, 0.05), i, 1e-4);
  }
  QVERIFY(std::abs(heldCurrent(terms, 0.0, 0.05)) < 1e-12);
}

void TestStepperEffects::voltageThatHelps_isNotLost() {
  // A back-EMF that changes around the turn, at one speed and place: i = (u − Ke ω (1 + A cos(N θ − φ)))/R, on either
  // side of no current.
  Physics p = voltageDriven();
  p.inductance = 0.0;
  p.inertia = 1e3;  // so that neither changes
  constexpr double speed = 40.0, share = 0.25;
  for (const double wave : {1.0, -1.0}) {
    for (const double volts : {-0.2, -0.02, 0.02, 0.2}) {
      const double u = p.backEmf * speed + volts;
      Stepper stepper(p, {compiled("torque_ripple", {share * wave, 0.0, 1e-3})});
      MotionState state{0.0, speed, 0.0};
      stepper.advance(state, u, row_s, 0.0);
      const double expected = (volts - share * wave * p.backEmf * speed) / p.resistance;
      COMPARE_WITHIN(state.current, expected, 1e-3 * std::abs(expected));
    }
  }
}

void TestStepperEffects::currentDrive_losesNoVoltage() {
  Stepper with(torqueDriven(), {compiled("dead_time", {0.5, 0.05})}), without(torqueDriven(), {});
  MotionState a, b;
  QVERIFY(!with.losesVoltage());
  for (int k = 0; k < 50; ++k) {
    with.advance(a, 0.03, row_s, row_s * k);
    without.advance(b, 0.03, row_s, row_s * k);
  }
  COMPARE_WITHIN(a.position, b.position, 1e-12);
  QVERIFY(b.position > 0.1);
}

void TestStepperEffects::supplySag_actsAsAResistanceTimesTheDutySquared() {
  const Physics p = heldRotor();
  const std::vector<CompiledTerm> terms{compiled("supply_sag", {0.8, 24.0})};
  const auto current = [&p](double u, double supply) { return u / (p.resistance + 0.8 * std::pow(u / supply, 2)); };
  for (const double u : {6.0, -6.0, 18.0}) {
    COMPARE_WITHIN(heldCurrent(terms, u, 0.05), current(u, 24.0), 2e-4 * std::abs(u));
    COMPARE_WITHIN(heldCurrent(terms, u, 0.05, 36.0), current(u, 36.0), 2e-4 * std::abs(u));  // the recorded supply
  }
  QVERIFY(current(18.0, 24.0) < 0.8 * 18.0 / p.resistance);
}

void TestStepperEffects::supplyGivesBack_noSagWhileBraking() {
  const Physics p = voltageDriven();
  Stepper sagging(p, {compiled("supply_sag", {0.8, 24.0})}), stiff(p, {});
  MotionState a{0.0, 300.0, -5.0}, b = a;  // the back-EMF of 21 V drives current against 6 V
  for (int k = 0; k < 10; ++k) {
    sagging.advance(a, 6.0, row_s, row_s * k);
    stiff.advance(b, 6.0, row_s, row_s * k);
  }
  QVERIFY(b.current < -1.0);
  COMPARE_WITHIN(a.current, b.current, 1e-9);
  COMPARE_WITHIN(a.velocity, b.velocity, 1e-7);
}

void TestStepperEffects::windingHeating_raisesTheResistanceWithItsTimeConstant() {
  const double R = heldRotor().resistance, c = 0.12, T = 0.5, u = 1.2;
  // The winding's own equations, L i' = u − (R + c Θ) i and T Θ' = i² (1 + c Θ/R) − Θ, in steps of 10 µs.
  double i = 0.0, theta = 0.0, largest = 0.0;
  long done = 0;
  for (const double seconds : {0.1, 0.5, 1.0, 4.0}) {
    for (; done < std::lround(seconds / 1e-5); ++done) {
      i += 1e-5 / heldRotor().inductance * (u - (R + c * theta) * i);
      theta += 1e-5 / T * (i * i * (1.0 + c * theta / R) - theta);
    }
    const double rise = u / heldCurrent({compiled("winding_heating", {c, T})}, u, seconds) - R;
    VERIFY_WITHIN(rise, c * theta, 0.01);
    largest = std::max(largest, rise);
  }
  QVERIFY(largest > 0.09 && largest < 0.13);
}

void TestStepperEffects::elasticFriction_givesLikeASpringAtSmallMotion() {
  const Physics p = torqueDriven();
  const double K = 20.0;
  Stepper stepper(p, {compiled("presliding", {K, 0.35})});
  MotionState state;
  runAlong(
      stepper, state, 2.0, [&](double t) { return 0.2 * p.coulomb * t / 2.0; }, [](double, const auto&) {});
  // Dahl on a monotonous path: u = F (1 − exp(−K x/F)).
  VERIFY_WITHIN(state.position, -p.coulomb / K * std::log(0.8), 0.02);
}

void TestStepperEffects::elasticFriction_closesItsLoop() {
  Physics p = torqueDriven();
  p.viscous = 2e-2;  // so that the corners of the drive don't ring
  const double K = 20.0, period = 2.0, peak = 0.6 * p.coulomb;
  Stepper stepper(p, {compiled("presliding", {K, 0.35})});
  MotionState state;
  const auto triangle = [&](double t) {
    const double phase = t / period - std::floor(t / period);
    return peak * (phase < 0.25 ? 4.0 * phase : phase < 0.75 ? 2.0 - 4.0 * phase : 4.0 * phase - 4.0);
  };
  std::vector<double> top, bottom;
  double area = 0.0, last = 0.0;
  runAlong(stepper, state, 4.0 * period, triangle, [&](double t, const MotionState& now) {
    const double phase = t / period - std::floor(t / period);
    if (std::abs(phase - 0.25) < 0.4 * row_s / period) top.push_back(now.position);
    if (std::abs(phase - 0.75) < 0.4 * row_s / period) bottom.push_back(now.position);
    if (t > 3.0 * period) area += triangle(t - 0.5 * row_s) * (now.position - last);
    last = now.position;
  });
  QCOMPARE(top.size(), size_t(4));
  QCOMPARE(bottom.size(), size_t(4));
  const double F = p.coulomb, width = F / K * std::log(1.6 / 0.4);
  VERIFY_WITHIN(top[3] - bottom[3], width, 0.02);
  COMPARE_WITHIN(top[3], top[2], 0.01 * width);
  COMPARE_WITHIN(bottom[3], bottom[2], 0.01 * width);
  // ∮u dx = 2 ∫ u dx over one branch, u = F ζ, dx = F/K dζ/(1 − ζ) from −0.6 to 0.6: F²/K (ln 4 − 1.2) twice.
  VERIFY_WITHIN(area, 2.0 * F * F / K * (std::log(4.0) - 1.2), 0.05);
}

void TestStepperEffects::elasticFriction_slidesLikeARigidOneInTheEnd() {
  const Physics p = torqueDriven();
  Stepper elastic(p, {compiled("presliding", {20.0, 0.35})}), rigid(p, {});
  MotionState a, b;
  const auto twice = [&](double) { return 2.0 * p.coulomb; };
  runAlong(elastic, a, 0.2, twice, [](double, const auto&) {});
  runAlong(rigid, b, 0.2, twice, [](double, const auto&) {});
  QVERIFY(b.velocity > 20.0);
  // Until the friction is whole it gives way for some F/K of travel: that is work of about F · F/K, once.
  VERIFY_WITHIN(a.velocity, b.velocity, 0.01);
  QVERIFY(a.velocity > b.velocity);
}

void TestStepperEffects::compliance_hasItsAntiresonanceAndResonance_data() {
  QTest::addColumn<double>("frequency");  // of ω_a
  for (const double frequency : {0.5, 0.9, 1.0, 1.1, 1.41, 2.0})
    QTest::newRow(qPrintable(QString::number(frequency))) << frequency;
}

void TestStepperEffects::compliance_hasItsAntiresonanceAndResonance() {
  QFETCH(double, frequency);
  const double wa = 60.0, zeta = 0.05, share = 0.5, w = frequency * wa;
  Physics p = torqueDriven();
  p.coulomb = 0.0;
  p.viscous = 1e-3;
  Stepper stepper(p, {compiled("compliance", {share * p.inertia, wa, zeta, 0.0})});
  MotionState state;
  const double settled = 3.0, turns = 20.0, seconds = settled + turns * 2.0 * std::numbers::pi / w;
  std::complex<double> sum = 0.0;
  double count = 0.0;
  runAlong(
      stepper, state, seconds, [&](double t) { return 0.01 * std::sin(w * (t + 0.5 * row_s)); },
      [&](double t, const MotionState& now) {
        if (t < settled) return;
        sum += now.velocity * std::polar(1.0, -w * t);
        count += 1.0;
      });
  const double got = 2.0 * std::abs(sum) / count;
  const std::complex<double> s(0.0, w), spring = 2.0 * zeta * wa * s + wa * wa;
  const std::complex<double> mechanical =
      (1.0 - share) * p.inertia * s + p.viscous + share * p.inertia * s * spring / (s * s + spring);
  VERIFY_WITHIN(got, 0.01 / std::abs(mechanical), 0.04);
}

void TestStepperEffects::frictionOnTheLoadsSide_slidesAndHoldsThere_data() {
  QTest::addColumn<double>("size");  // of the drive, in parts of all friction
  QTest::newRow("it rests at times") << 1.6;
  QTest::newRow("it slides") << 6.0;
}

void TestStepperEffects::frictionOnTheLoadsSide_slidesAndHoldsThere() {
  QFETCH(double, size);
  const double wa = 90.0, zeta = 0.06;
  const Physics p = torqueDriven();
  const double load = 0.4 * p.inertia, held = 0.5 * p.coulomb;
  const auto drive = [&](double t) { return size * p.coulomb * (std::sin(9.0 * t) + 0.4 * std::sin(47.0 * t + 1.0)); };
  // Both sides with Coulomb friction, each stopped when it would turn round: explicit, in steps of 2 µs.
  struct Side {
    double inertia, coulomb, position = 0.0, velocity = 0.0;
    void advance(double torque, double h) {
      if (velocity == 0.0 && std::abs(torque) <= coulomb) return;
      const double way = velocity != 0.0 ? velocity : torque;
      const double after = velocity + h * (torque - std::copysign(coulomb, way)) / inertia;
      velocity = velocity * after < 0.0 ? 0.0 : after;
      position += h * velocity;
    }
  };
  Side motor{p.inertia - load, p.coulomb - held}, hanging{load, held};
  Stepper stepper(p, {compiled("compliance", {load, wa, zeta, held})});
  MotionState state;
  double furthest = 0.0, worst = 0.0, rested = 0.0;
  runAlong(stepper, state, 2.0, drive, [&](double t, const MotionState& now) {
    constexpr double h = 2e-6;
    for (int k = 0; k < std::lround(row_s / h); ++k) {
      const double pull = load * (wa * wa * (motor.position - hanging.position) +
                                  2.0 * zeta * wa * (motor.velocity - hanging.velocity));
      motor.advance(drive(t - row_s) - pull - p.viscous * motor.velocity, h);
      hanging.advance(pull, h);
    }
    if (hanging.velocity == 0.0) rested += row_s;
    furthest = std::max(furthest, std::abs(motor.position));
    worst = std::max(worst, std::abs(motor.position - now.position));
  });
  QVERIFY(furthest > 0.05);
  QVERIFY2(worst < 0.02 * furthest, qPrintable(QString("%1 of %2").arg(worst).arg(furthest)));
  QVERIFY((rested > 0.2) == (size < 2.0));
}

void TestStepperEffects::backlash_movesAloneWithinTheGap() {
  Physics p = torqueDriven();
  p.coulomb = p.viscous = 0.0;
  const double share = 0.5, gap = 0.2, drive = 6e-3;
  Stepper stepper(p, {compiled("backlash", {share * p.inertia, gap, share * p.inertia * 300.0 * 300.0, 0.3})});
  MotionState state;
  double inGap = 0.0;
  runAlong(
      stepper, state, 0.4, [=](double) { return drive; },
      [&](double t, const MotionState& now) {
        if (now.position < 0.45 * gap) inGap = now.velocity / t;
      });
  VERIFY_WITHIN(inGap, drive / ((1.0 - share) * p.inertia), 0.01);
  // In the end both turn together, and no impulse was lost.
  VERIFY_WITHIN(state.velocity, drive * 0.4 / p.inertia, 0.02);
}

void TestStepperEffects::endStop_throwsBackWithoutLoss() {
  Physics p = torqueDriven();
  p.coulomb = p.viscous = 0.0;
  for (const double side : {1.0, -1.0}) {
    const double K = 2.0, start = 0.1 * side, speed = 5.0 * side;
    Stepper stepper(p, {compiled("end_stop", {K, start, side, 0.0})});
    MotionState state{0.0, speed, 0.0};
    double furthest = 0.0;
    runAlong(
        stepper, state, 0.06, [](double) { return 0.0; },
        [&](double, const MotionState& now) { furthest = std::max(furthest, side * now.position); });
    VERIFY_WITHIN(furthest - 0.1, std::abs(speed) * std::sqrt(p.inertia / K), 0.02);
    VERIFY_WITHIN(state.velocity, -speed, 0.02);
  }
}

QTEST_APPLESS_MAIN(TestStepperEffects)
#include "tst_stepper_effects.moc"
