// What all of a run's turns share, and their scatter doesn't show: an encoder off its centre, an inertia that is off, a
// converter's steps.
#include <QTest>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

#include "base/random.h"
#include "identify/velocity_friction.h"

using namespace breakaway;

class TestSharedErrors : public QObject {
  Q_OBJECT
 private slots:
  void discOffItsCentre_isFoundAndTakenOff();
  void discInItsCentre_isNotFound();
  void inertiaThatIsOff_isNoViscousFriction();
  void whatDiffersFromSpeedToSpeed_isInTheInterval();
  void breakaways_standWhereTheRotorStood();
};

namespace {

using Complex = std::complex<double>;
constexpr double turn = 2.0 * std::numbers::pi, Kt = 0.07, J = 6e-5, B = 2e-5;
constexpr double speeds[] = {20.0, 40.0, 80.0, 140.0, 200.0, 300.0};

double coulomb(double angle) {
  return 0.017 * (1.0 + 0.15 * std::cos(2.0 * angle - 0.4));
}

/// At a bin's middle: the rotor's speed over the mean one and how it changes with the angle, and a torque towards
/// growing angle beside friction and inertia.
struct Place {
  double angle_rad, speed, slope, torque_Nm;
};
using PlaceAt = std::function<Place(double shown_rad, double speed)>;

VelocityRun runAt(double target, const PlaceAt& placeAt, const EncoderDisc& disc, unsigned seed) {
  VelocityRun run;
  run.target_rad_per_s = target;
  run.turns = 96;
  run.halfSpan_s = 2e-4;
  run.bins.resize(360);
  run.blocks.assign(8, {12, target, target, 0.0, 0.0, run.bins});
  Noise noise(seed);
  for (size_t k = 0; k < 360; ++k) {
    const Place at = placeAt((static_cast<double>(k) + 0.5) * turn / 360.0, target);
    const double velocity = target * at.speed, acceleration = target * target * at.speed * at.slope;
    const double friction = std::copysign(coulomb(at.angle_rad) + B * std::abs(velocity), target);
    const double current = (friction + J * acceleration - at.torque_Nm) / Kt;
    for (size_t n = 0; n < 160; ++n) {
      const double shown_A = current + 0.017 * noise.normal();
      const double shown = velocity / disc.gainAt(at.angle_rad) + 0.05 * noise.normal();
      run.bins[k].add(shown_A, shown);
      run.blocks[n / 20].bins[k].add(shown_A, shown);
    }
  }
  return run;
}

std::vector<VelocityRun> runs(const PlaceAt& placeAt, const EncoderDisc& disc = {}) {
  std::vector<VelocityRun> all;
  unsigned seed = 1;
  for (const double speed : speeds) {
    for (const double sign : {1.0, -1.0}) all.push_back(runAt(sign * speed, placeAt, disc, seed++));
  }
  return all;
}

VelocityFrictionOptions options(double inertia = J, double inertiaError = 0.0) {
  VelocityFrictionOptions result;
  result.torqueConstant_Nm_per_A = Kt;
  result.inertia_kg_m2 = inertia;
  result.inertiaError_kg_m2 = inertiaError;
  return result;
}

Place steady(double angle, double) {
  return {angle, 1.0, 0.0, 0.0};
}

/// A controller that holds what the encoder shows.
PlaceAt heldBy(const EncoderDisc& disc) {
  return [disc](double shown, double) {
    const double angle = disc.angleOf(shown), gain = disc.gainAt(angle);
    return Place{angle, gain, gain * gain * (disc.off_rad * std::polar(1.0, angle)).real(), 0.0};
  };
}

struct Worst {
  double coulomb = 0.0, viscous = 0.0;
};

Worst worstOf(const std::array<MovingFriction, 2>& friction) {
  Worst worst;
  for (const MovingFriction& way : friction) {
    for (size_t k = 0; k < way.coulomb_Nm.size(); ++k) {
      const double angle = (static_cast<double>(k) + 0.5) * turn / static_cast<double>(way.coulomb_Nm.size());
      worst.coulomb = std::max(worst.coulomb, std::abs(way.coulomb_Nm[k].value - coulomb(angle)) / 0.017);
      worst.viscous = std::max(worst.viscous, std::abs(way.viscous_Nm_s_per_rad[k].value - B) / B);
    }
  }
  return worst;
}

}  // namespace

void TestSharedErrors::discOffItsCentre_isFoundAndTakenOff() {
  const EncoderDisc truth{std::polar(0.04, 1.0), 0.0};
  const auto measured = runs(heldBy(truth), truth);
  VelocityFrictionOptions given = options();
  const auto bent = fitMovingFriction(measured, given);
  given.disc = fitDisc(measured, given);
  QVERIFY(given.disc.known());
  QVERIFY2(std::abs(given.disc.off_rad - truth.off_rad) < 0.01 * 0.04,
           qPrintable(QString("%1 %2").arg(given.disc.off_rad.real()).arg(given.disc.off_rad.imag())));
  const auto friction = fitMovingFriction(measured, given);
  QVERIFY(bent && friction);
  const Worst before = worstOf(*bent), after = worstOf(*friction);
  QVERIFY2(after.coulomb < 0.02 && after.viscous < 0.1,
           qPrintable(QString("%1 %2").arg(after.coulomb).arg(after.viscous)));
  QVERIFY2(before.viscous > 3.0 * after.viscous, qPrintable(QString::number(before.viscous)));
}

void TestSharedErrors::discInItsCentre_isNotFound() {
  QVERIFY(!fitDisc(runs(steady), options()).known());
}

/// An arm, whose torque a controller of 100 rad/s holds the better, the slower it turns: an inertia of 5 % too little
/// takes the rest for viscous friction of order 1.
void TestSharedErrors::inertiaThatIsOff_isNoViscousFriction() {
  const PlaceAt arm = [](double angle, double speed) {
    const double size = std::abs(speed), swing = 0.004 / J / (size * std::hypot(size, 100.0));
    return Place{angle, 1.0 + swing * std::cos(angle), -swing * std::sin(angle), 0.004 * std::sin(angle)};
  };
  VelocityFrictionOptions asGiven = options(0.95 * J), fitted = options(0.95 * J, 0.03 * J);
  const auto measured = runs(arm);
  const auto off = fitMovingFriction(measured, asGiven), right = fitMovingFriction(measured, fitted);
  QVERIFY(off && right);
  const auto worstViscous = [](const std::array<MovingFriction, 2>& friction) { return worstOf(friction).viscous; };
  QVERIFY2(worstViscous(*right) < 0.15, qPrintable(QString::number(worstViscous(*right))));
  QVERIFY2(worstViscous(*off) > 2.0 * worstViscous(*right), qPrintable(QString::number(worstViscous(*off))));
}

/// A wave that is another at each speed, as steps of a converter leave it: each run repeats it exactly.
void TestSharedErrors::whatDiffersFromSpeedToSpeed_isInTheInterval() {
  const PlaceAt stepped = [](double angle, double speed) {
    return Place{angle, 1.0, 0.0, 1e-3 * std::cos(2.0 * angle + 40.0 * speed)};
  };
  const auto clean = fitMovingFriction(runs(steady), options()), friction = fitMovingFriction(runs(stepped), options());
  QVERIFY(clean && friction);
  size_t inside = 0;
  for (size_t w = 0; w < 2; ++w) {
    for (size_t k = 0; k < 180; ++k) {
      const Estimate& one = (*friction)[w].coulomb_Nm[k];
      const double angle = (static_cast<double>(k) + 0.5) * turn / 180.0;
      inside += std::abs(one.value - coulomb(angle)) < normal95 * one.standardError ? 1 : 0;
    }
    const double wide = (*friction)[w].coulomb_Nm[0].standardError, narrow = (*clean)[w].coulomb_Nm[0].standardError;
    QVERIFY2(wide > 3.0 * narrow && wide < 0.002, qPrintable(QString("%1 %2").arg(wide).arg(narrow)));
  }
  QVERIFY2(inside >= 320, qPrintable(QString::number(inside)));
}

void TestSharedErrors::breakaways_standWhereTheRotorStood() {
  const EncoderDisc disc{std::polar(0.05, -0.7), 0.0};
  std::vector<BreakawayEvent> events(3);
  const double angles[] = {0.1, 3.0, 6.2};
  for (size_t k = 0; k < 3; ++k)
    events[k].angle_rad = angles[k] + (disc.off_rad * std::polar(1.0, angles[k])).real() - disc.off_rad.real();
  placeBy(disc, events);
  for (size_t k = 0; k < 3; ++k) QVERIFY(std::abs(events[k].angle_rad - angles[k]) < 1e-9);
}

QTEST_APPLESS_MAIN(TestSharedErrors)
#include "tst_shared_errors.moc"
