#include <QTest>
#include <cmath>

#include "diagnose/simulate/stepper.h"
#include "support/known_servo.h"
#include "support/within.h"

using namespace breakaway;
using namespace breakaway::test;

class TestStepper : public QObject {
  Q_OBJECT
 private slots:
  void belowCoulombFriction_standsExactlyStill();
  void aboveCoulombFriction_breaksAwayBothWays();
  void reversal_happensAtTheClosedFormsTime();
  void reversalWithoutDamping_followsTheParabolas();
  void stopsForGood_whereTheDriveCannotReverse();
  void oneLongStep_isTenShortOnes();
  void withInductance_followsAFineRungeKutta();
  void standingRotorsCurrent_risesWithLOverR();
  void openWindings_coastWithoutCurrent();
  void effects_convergeWithSecondOrder();
};

namespace {

/// Classical Runge–Kutta of fourth order over one piece of motion in one direction; `h` s per step.
struct RungeKutta {
  Physics p;
  double u, direction;
  MotionState rate(const MotionState& s) const {
    return {s.velocity, (p.torqueConstant * s.current - p.viscous * s.velocity - direction * p.coulomb) / p.inertia,
            (u - p.resistance * s.current - p.backEmf * s.velocity) / p.inductance};
  }
  static MotionState along(const MotionState& s, const MotionState& d, double h) {
    return {s.position + h * d.position, s.velocity + h * d.velocity, s.current + h * d.current};
  }
  MotionState step(const MotionState& s, double h) const {
    const MotionState a = rate(s), b = rate(along(s, a, 0.5 * h)), c = rate(along(s, b, 0.5 * h)),
                      d = rate(along(s, c, h));
    const MotionState sum{a.position + 2 * b.position + 2 * c.position + d.position,
                          a.velocity + 2 * b.velocity + 2 * c.velocity + d.velocity,
                          a.current + 2 * b.current + 2 * c.current + d.current};
    return along(s, sum, h / 6.0);
  }
};

/// Stick and slip in steps of 1 µs: a step that would reverse is cut where the axis stands, and what stands waits for
/// the torque.
MotionState fineMotion(const Physics& p, MotionState s, double u, double seconds) {
  const double longest = 1e-6;
  for (double left = seconds; left > 1e-12;) {
    const double h = std::min(left, longest);
    left -= h;
    const double torque = p.torqueConstant * s.current;
    if (s.velocity == 0.0 && std::abs(torque) <= p.coulomb) {
      const double final = u / p.resistance;
      s.current = final + (s.current - final) * std::exp(-p.resistance / p.inductance * h);
      continue;
    }
    const double direction = s.velocity != 0.0 ? std::copysign(1.0, s.velocity) : std::copysign(1.0, torque);
    const RungeKutta motion{p, u, direction};
    MotionState next = motion.step(s, h);
    if (s.velocity * next.velocity < 0.0) {
      double low = 0.0, high = h;
      for (int halving = 0; halving < 50; ++halving) {
        const double middle = 0.5 * (low + high);
        (motion.step(s, middle).velocity * s.velocity > 0.0 ? low : high) = middle;
      }
      next = motion.step(s, low);
      next.velocity = 0.0;
      left += h - low;
    }
    s = next;
  }
  return s;
}

}  // namespace

void TestStepper::belowCoulombFriction_standsExactlyStill() {
  Stepper stepper(torqueDriven(), {});
  MotionState state{0.123, 0.0, 0.0};
  for (int k = 0; k < 5000; ++k) {
    stepper.advance(state, 0.0119999 * std::sin(0.01 * k), 1e-3, 1e-3 * k);
    QCOMPARE(state.position, 0.123);
    QCOMPARE(state.velocity, 0.0);
  }
}

void TestStepper::aboveCoulombFriction_breaksAwayBothWays() {
  const Physics p = torqueDriven();
  for (const double way : {1.0, -1.0}) {
    Stepper stepper(p, {});
    MotionState state;
    const double u = way * 1.01 * p.coulomb, tau = p.inertia / p.viscous, end = way * 0.01 * p.coulomb / p.viscous;
    stepper.advance(state, u, 0.05, 0.0);
    COMPARE_WITHIN(state.velocity, end * (1.0 - std::exp(-0.05 / tau)), 1e-14);
    COMPARE_WITHIN(state.position, end * (0.05 - tau * (1.0 - std::exp(-0.05 / tau))), 1e-14);
  }
}

void TestStepper::reversal_happensAtTheClosedFormsTime() {
  const Physics p = torqueDriven();
  const double tau = p.inertia / p.viscous, v0 = 5.0, u = -0.03;
  const double slowing = (u - p.coulomb) / p.viscous, back = (u + p.coulomb) / p.viscous;  // speeds it tends to
  const double stop = tau * std::log(1.0 - v0 / slowing), dt = 0.02, rest = dt - stop;
  QVERIFY(stop > 0.004 && stop < 0.01);
  const double turned = slowing * stop + (v0 - slowing) * tau * (1.0 - std::exp(-stop / tau));
  Stepper stepper(p, {});
  MotionState state{0.0, v0, 0.0};
  stepper.advance(state, u, dt, 0.0);
  COMPARE_WITHIN(state.velocity, back * (1.0 - std::exp(-rest / tau)), 1e-12);
  COMPARE_WITHIN(state.position, turned + back * (rest - tau * (1.0 - std::exp(-rest / tau))), 1e-13);

  MotionState before{0.0, v0, 0.0}, after{0.0, v0, 0.0};
  stepper.advance(before, u, stop * (1.0 - 1e-9), 0.0);
  stepper.advance(after, u, stop * (1.0 + 1e-9), 0.0);
  QVERIFY(before.velocity > 0.0 && before.velocity < 1e-5);
  QVERIFY(after.velocity < 0.0 && after.velocity > -1e-5);
}

void TestStepper::reversalWithoutDamping_followsTheParabolas() {
  Physics p = torqueDriven();
  p.viscous = 0.0;
  const double slowing = (-0.03 - p.coulomb) / p.inertia, back = (-0.03 + p.coulomb) / p.inertia;
  const double stop = -2.0 / slowing, rest = 0.01 - stop;
  QVERIFY(rest > 0.002);
  Stepper stepper(p, {});
  MotionState state{0.0, 2.0, 0.0};
  stepper.advance(state, -0.03, 0.01, 0.0);
  COMPARE_WITHIN(state.velocity, back * rest, 1e-12);
  COMPARE_WITHIN(state.position, 2.0 * stop + 0.5 * slowing * stop * stop + 0.5 * back * rest * rest, 1e-14);
}

void TestStepper::stopsForGood_whereTheDriveCannotReverse() {
  const Physics p = torqueDriven();
  Stepper stepper(p, {});
  MotionState state{0.0, 2.0, 0.0};
  stepper.advance(state, -0.011, 0.1, 0.0);
  QCOMPARE(state.velocity, 0.0);
  const double tau = p.inertia / p.viscous, slowing = (-0.011 - p.coulomb) / p.viscous;
  const double stop = tau * std::log(1.0 - 2.0 / slowing);
  COMPARE_WITHIN(state.position, slowing * stop + (2.0 - slowing) * tau * (1.0 - std::exp(-stop / tau)), 1e-13);
  const double stands = state.position;
  stepper.advance(state, 0.0119, 0.1, 0.1);
  QCOMPARE(state.position, stands);
}

void TestStepper::oneLongStep_isTenShortOnes() {
  Stepper stepper(torqueDriven(), {});
  MotionState whole, parts;
  int stops = 0;
  for (int k = 0; k < 400; ++k) {
    const double u = 0.012 * (1.6 * std::sin(0.145 * k) + 0.5 * std::sin(0.023 * k));
    stepper.advance(whole, u, 1e-2, 1e-2 * k);
    for (int part = 0; part < 10; ++part) stepper.advance(parts, u, 1e-3, 1e-2 * k + 1e-3 * part);
    COMPARE_WITHIN(whole.position, parts.position, 1e-12 * std::max(1.0, std::abs(parts.position)));
    COMPARE_WITHIN(whole.velocity, parts.velocity, 1e-12 * std::max(1.0, std::abs(parts.velocity)) * 10.0);
    stops += whole.velocity == 0.0;
  }
  QVERIFY(stops > 20 && stops < 380);
}

void TestStepper::withInductance_followsAFineRungeKutta() {
  const Physics p = voltageDriven();
  // From rest through breakaway, on in motion, through a reversal, and to a stop.
  const double volts[]{0.6, 0.6, -1.5, -1.5, 0.1, 0.1};
  Stepper stepper(p, {});
  MotionState exact, fine;
  double largest = 0.0;
  bool went[2]{};
  for (const double u : volts) {
    for (int row = 0; row < 10; ++row) {
      stepper.advance(exact, u, 1e-3, 0.0);
      fine = fineMotion(p, fine, u, 1e-3);
      COMPARE_WITHIN(exact.position, fine.position, 1e-7);
      COMPARE_WITHIN(exact.velocity, fine.velocity, 1e-5);
      COMPARE_WITHIN(exact.current, fine.current, 1e-6);
      largest = std::max(largest, std::abs(fine.velocity));
      went[0] = went[0] || fine.velocity > 1.0;
      went[1] = went[1] || fine.velocity < -1.0;
    }
  }
  QVERIFY(went[0] && went[1]);
  QVERIFY(largest > 2.0 && largest < 30.0);
}

void TestStepper::standingRotorsCurrent_risesWithLOverR() {
  const Physics p = voltageDriven();
  Stepper stepper(p, {});
  MotionState state;
  const double u = 0.9 * p.coulomb / p.torqueConstant * p.resistance;
  stepper.advance(state, u, 1e-3, 0.0);
  COMPARE_WITHIN(state.current, u / p.resistance * (1.0 - std::exp(-1e-3 * p.resistance / p.inductance)), 1e-14);
  QCOMPARE(state.position, 0.0);
  QCOMPARE(state.velocity, 0.0);
}

void TestStepper::openWindings_coastWithoutCurrent() {
  const Physics p = voltageDriven();
  Stepper stepper(p, {}), coasting(torqueDriven(), {});
  MotionState state{0.0, 10.0, 0.8}, free{0.0, 10.0, 0.0};
  for (int row = 0; row < 5; ++row) {
    stepper.advance(state, 24.0, 1e-3, 0.0, false);
    coasting.advance(free, 0.0, 1e-3, 0.0);
    QCOMPARE(state.current, 0.0);
    COMPARE_WITHIN(state.position, free.position, 1e-15);
    COMPARE_WITHIN(state.velocity, free.velocity, 1e-14);
  }
  QVERIFY(state.velocity > 8.0 && state.velocity < 9.5);
}

void TestStepper::effects_convergeWithSecondOrder() {
  const std::vector<CompiledTerm> terms{compiled("cogging", {0.002, 0.4, 12.0}),
                                        compiled("stribeck", {0.004, 1.5, 2.0})};
  const auto end = [&terms](double step) {
    Stepper stepper(torqueDriven(), terms);
    MotionState state;
    for (long k = 0, steps = std::lround(0.1 / step); k < steps; ++k) {
      stepper.advance(state, 0.025, step, static_cast<double>(k) * step);
    }
    return state.position;
  };
  const double truth = end(1e-6), coarse = std::abs(end(2e-3) - truth), half = std::abs(end(1e-3) - truth),
               quarter = std::abs(end(5e-4) - truth);
  QVERIFY2(coarse < 1e-2 && quarter > 1e-9, qPrintable(QString("%1 %2 %3").arg(coarse).arg(half).arg(quarter)));
  const double order = std::log2(half / quarter);
  QVERIFY2(order > 1.6 && order < 2.6,
           qPrintable(QString("order %1, errors %2 %3 %4").arg(order).arg(coarse).arg(half).arg(quarter)));
}

QTEST_APPLESS_MAIN(TestStepper)
#include "tst_stepper.moc"
