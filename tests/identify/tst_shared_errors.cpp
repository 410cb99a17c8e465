// What all of a run's turns share, and their scatter doesn't show: an encoder off its centre, an inertia that is off, a
// converter's steps.
#include <QTest>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

#include "base/random.h"
#include "experiment/velocity_sweep.h"
#include "identify/encoder_swing.h"
#include "identify/velocity_friction.h"

using namespace breakaway;

class TestSharedErrors : public QObject {
  Q_OBJECT
 private slots:
  void discOffItsCentre_isFoundAndTakenOff();
  void discInItsCentre_isNotFound();
  void discFurtherOffThanAny_isSaidAndNotTakenOff();
  void waveOfASlowRunAlone_isNoDisc();
  void evenSpeed_isTakenAsEvenOverAnySpan();
  void currentBetweenSamples_isWhereTheWindingTookIt();
  void whatIsOffAboutALargeWave_isInTheInterval();
  void inertiaThatIsOff_isNoViscousFriction();
  void whatDiffersFromSpeedToSpeed_isInTheInterval();
  void breakaways_standWhereTheRotorStood();
  void samplesOfWholeCounts_lieBesideTheirBinsMiddles();
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

/// What a central difference of the disc's angles makes of an even speed.
double shownOver(double velocity, double angle_rad, double halfSpan_s, const EncoderDisc& disc) {
  const double half = velocity * halfSpan_s;
  const auto shown = [&disc](double angle) { return angle + (disc.off_rad * std::polar(1.0, angle)).real(); };
  return (shown(angle_rad + half) - shown(angle_rad - half)) / (2.0 * halfSpan_s);
}

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
      const double shown = shownOver(velocity, at.angle_rad, run.halfSpan_s, disc) + 0.05 * noise.normal();
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
  const EncoderDisc found = fitDisc(runs(steady), options());
  QVERIFY(!found.known() && found.unsettled_rad == 0.0);
}

void TestSharedErrors::discFurtherOffThanAny_isSaidAndNotTakenOff() {
  const EncoderDisc truth{std::polar(0.45, 1.0), 0.0};
  const EncoderDisc found = fitDisc(runs(heldBy(truth), truth), options());
  QVERIFY(!found.known());
  QVERIFY2(found.unsettled_rad > 0.3, qPrintable(QString::number(found.unsettled_rad)));
}

/// Friction that still falls at the slowest speed of one way, once per turn: with a straight line through the others it
/// looks like what grows with the square of the speed, and no disc settles.
void TestSharedErrors::waveOfASlowRunAlone_isNoDisc() {
  for (const double part : {0.05, 0.1, 0.2, 0.4}) {
    for (const double slow : {20.0, -20.0}) {
      const auto fallsOnce = [part, slow](double angle, double speed) {
        return Place{angle, 1.0, 0.0, speed == slow ? 0.017 * part * std::cos(angle) : 0.0};
      };
      const EncoderDisc disc = fitDisc(runs(fallsOnce), options());
      QVERIFY2(std::abs(disc.off_rad) < 0.005,
               qPrintable(QString("%1 at %2: %3").arg(part).arg(slow).arg(std::abs(disc.off_rad))));
    }
  }
}

void TestSharedErrors::evenSpeed_isTakenAsEvenOverAnySpan() {
  const EncoderDisc disc{std::polar(0.05, 0.3), 0.0};
  for (const double halfSpan_s : {1e-5, 1e-3, 5e-3}) {
    for (const double speed : {100.0, -100.0}) {
      for (double angle = 0.0; angle < turn; angle += 0.5) {
        const double shown = shownOver(speed, angle, halfSpan_s, disc);
        QVERIFY(std::abs(disc.speedOf(shown, angle, halfSpan_s) / speed - 1.0) < 1e-6);
      }
    }
  }
}

/// Of a wave of 40 samples per turn, against its integral along the winding's exponentials from one to the next.
void TestSharedErrors::currentBetweenSamples_isWhereTheWindingTookIt() {
  constexpr size_t samples = 40;
  constexpr double speed = 100.0, step = turn / samples, tick_s = step / speed;
  const auto sampled = [](double angle) { return 0.3 * std::cos(angle - 0.2); };
  for (const double windingTime_s : {1e-6, 0.5 * tick_s, 100.0 * tick_s}) {
    for (const double sign : {1.0, -1.0}) {
      VelocityRun run;
      run.target_rad_per_s = sign * speed;
      run.turns = 1;
      run.halfSpan_s = tick_s;
      run.bins.resize(samples);
      Complex truth = 0.0;
      constexpr int parts = 2000;
      for (size_t n = 0; n < samples; ++n) {
        const double angle = (static_cast<double>(n) + 0.5) * step, next = sampled(angle + sign * step);
        run.bins[n].add(sampled(angle), sign * speed);
        const double rise = -std::expm1(-tick_s / windingTime_s);
        for (int k = 0; k < parts; ++k) {
          const double part = (k + 0.5) / parts;
          const double gone = -std::expm1(-part * tick_s / windingTime_s) / rise;
          const double current = sampled(angle) + (next - sampled(angle)) * gone;
          truth += sign * Kt * current * std::polar(2.0 / (samples * parts), -(angle + sign * part * step));
        }
      }
      VelocityFrictionOptions given = options();
      given.tick_s = tick_s;
      given.windingTime_s = windingTime_s;
      const Complex found = spectrumOf({&run, 1}, given).torque_Nm[1];
      // Each bin's mean stands for its middle: the harmonic is taken as that of means over the bins.
      const double half = 0.5 * step;
      QVERIFY2(std::abs(found * std::sin(half) / half - truth) < 1e-3 * std::abs(truth),
               qPrintable(QString("%1 %2").arg(std::abs(found / truth)).arg(std::arg(found / truth))));
    }
  }
}

/// Of waves that are off by a part of 1e-3 in each run, at orders where they are a hundred times friction.
void TestSharedErrors::whatIsOffAboutALargeWave_isInTheInterval() {
  const EncoderDisc disc{std::polar(0.04, 1.0), 0.0};
  const Complex C(2e-4, -1e-4), slope(1e-6, 2e-6);
  size_t narrow = 0, wide = 0;
  constexpr size_t trials = 200;
  for (unsigned seed = 1; seed <= trials; ++seed) {
    Noise noise(seed);
    std::array<WayRuns, 2> ways;
    for (const Way way : {Way::cw, Way::ccw}) {
      for (const double speed : speeds) {
        RunSpectrum run;
        run.speed_rad_per_s = speed;
        const Complex wave = J * disc.off_rad * speed * speed;
        const Complex off(1e-3 * noise.normal(), 1e-3 * noise.normal());
        const Complex chance(1e-5 * noise.normal(), 1e-5 * noise.normal());
        run.torque_Nm = {0.017, C + slope * speed + off * wave + chance};
        run.acceleration_rad_per_s2 = {0.0, wave / J * std::min(1.0, 100.0 / speed)};
        run.ripple_rad_per_s = {0.0, 0.0};
        run.variance_Nm2 = {1e-12, 1e-10};
        ways[static_cast<size_t>(way)].spectra.push_back(run);
      }
      ways[static_cast<size_t>(way)].fall.assign(std::size(speeds), 0.0);
      ways[static_cast<size_t>(way)].widened_Nm2 = ways[static_cast<size_t>(way)].fall;
    }
    const auto holds = [&slope](const std::array<WayRuns, 2>& of) {
      const FrictionLine line = swingOf(of)->lines[1];
      return std::abs(line.viscous.real() - slope.real()) < normal95 * std::sqrt(line.viscousVariance);
    };
    narrow += holds(ways) ? 1 : 0;
    widenBySwing(ways, J, disc);
    wide += holds(ways) ? 1 : 0;
  }
  QVERIFY2(narrow < trials / 2, qPrintable(QString::number(narrow)));
  QVERIFY2(wide > 0.88 * trials && wide < trials, qPrintable(QString::number(wide)));
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

/// Against the mean place of the counts that fall into each bin.
void TestSharedErrors::samplesOfWholeCounts_lieBesideTheirBinsMiddles() {
  for (const size_t bins : {100u, 50u}) {
    constexpr size_t counts = 100;
    const double count = turn / counts;
    for (const double index : {7.0 * count, 7.25 * count, -3.5 * count}) {
      std::vector<double> sums(bins), numbers(bins);
      for (int n = 0; n < static_cast<int>(counts); ++n) {
        double place = (n * count - index) / turn;
        place -= std::floor(place + 1e-9);
        const auto bin = static_cast<size_t>(place * static_cast<double>(bins) + 1e-6) % bins;
        sums[bin] += place * turn - (static_cast<double>(bin) + 0.5) * turn / static_cast<double>(bins);
        numbers[bin] += 1.0;
      }
      for (size_t k = 0; k < bins; ++k)
        QVERIFY(std::abs(sums[k] / numbers[k] - beyondBins_rad(counts, bins, index)) < 1e-3 * count);
    }
  }
  QCOMPARE(beyondBins_rad(100.0, 60, 0.1), 0.0);
}

QTEST_APPLESS_MAIN(TestSharedErrors)
#include "tst_shared_errors.moc"
