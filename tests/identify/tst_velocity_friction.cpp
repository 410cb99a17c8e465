#include <QTest>
#include <array>
#include <cmath>
#include <numbers>

#include "base/random.h"
#include "experiment/angle_cells.h"
#include "identify/run_spectrum.h"
#include "identify/velocity_friction.h"

using namespace breakaway;

class TestVelocityFriction : public QObject {
  Q_OBJECT
 private slots:
  void harmonicsOfBoth_areFoundThroughTheRipple();
  void noiseAlone_leavesFlatFriction();
  void stribeckSpeed_isLeftOut();
  void brokenOffRuns_countAsOneWithWhatWentOn();
  void oneSpeedOnly_isReportedAsUnobservable();
  void coggingThatTheRotorHides_isTakenFromTheBreakaways();
  void placeWhereTheRotorSticks_isNoMovingFriction();
  void coggingThatSlowsTheRotor_isNoFriction_data();
  void coggingThatSlowsTheRotor_isNoFriction();
};

namespace {

constexpr double turn = 2.0 * std::numbers::pi, Kt = 0.07, J = 6e-5;

double coulomb(double angle) {
  return 0.017 * (1.0 + 0.15 * std::cos(angle - 0.4));
}
double viscous(double angle) {
  return 2e-5 * (1.0 + 0.2 * std::cos(2.0 * angle - 1.0));
}

/// A run as the sweep makes it: constant current, so that all variation of friction turns into ripple of the speed.
VelocityRun runAt(double speed, double excess_Nm, double noise_A, bool varied, unsigned seed) {
  VelocityRun run;
  run.target_rad_per_s = speed;
  run.turns = 100;
  run.halfSpan_s = 2e-4;
  run.bins.resize(360);
  run.blocks.assign(8, {12, speed, speed, 0.0, 0.0, run.bins});
  Noise noise(seed);
  const double sign = speed > 0.0 ? 1.0 : -1.0, size = std::abs(speed);
  const double mean = 0.017 + 2e-5 * size + excess_Nm;
  for (size_t k = 0; k < 360; ++k) {
    const double angle = (static_cast<double>(k) + 0.5) * turn / 360.0;
    // J·d(½ω²)/dθ = mean − τ(θ) in the way's direction, integrated by its harmonics.
    double halfSquare = 0.5 * size * size;
    if (varied)
      halfSquare -= sign * (0.017 * 0.15 * std::sin(angle - 0.4) + 2e-5 * size * 0.1 * std::sin(2.0 * angle - 1.0)) / J;
    const double velocity = sign * std::sqrt(2.0 * halfSquare);
    for (size_t n = 0; n < 160; ++n) {
      const double current = sign * mean / Kt + noise_A * noise.normal();
      const double shown = velocity + 0.2 * noise.normal();
      run.bins[k].add(current, shown);
      run.blocks[n / 20].bins[k].add(current, shown);
    }
  }
  return run;
}

VelocityFrictionOptions options() {
  VelocityFrictionOptions result;
  result.torqueConstant_Nm_per_A = Kt;
  result.inertia_kg_m2 = J;
  result.evenBins = true;
  return result;
}

std::vector<VelocityRun> runs(bool varied, double slowExcess_Nm, unsigned seed = 1) {
  std::vector<VelocityRun> all;
  for (const double speed : {20.0, 40.0, 80.0, 140.0, 200.0}) {
    for (const double sign : {1.0, -1.0})
      all.push_back(runAt(sign * speed, speed < 30.0 ? slowExcess_Nm : 0.0, 0.017, varied, seed++));
  }
  return all;
}

}  // namespace

/// The worst of 180 bins, on average over ten draws of the noise: what one draw shows is chance.
void TestVelocityFriction::harmonicsOfBoth_areFoundThroughTheRipple() {
  constexpr int draws = 10;
  std::array<double, 2> coulombError{}, viscousError{};
  for (unsigned draw = 0; draw < draws; ++draw) {
    const auto friction = fitMovingFriction(runs(true, 0.0, 1 + 100 * draw), options());
    QVERIFY(friction.ok());
    for (size_t way = 0; way < 2; ++way) {
      double worstCoulomb = 0.0, worstViscous = 0.0;
      for (size_t k = 0; k < 180; ++k) {
        const double angle = (static_cast<double>(k) + 0.5) * turn / 180.0;
        worstCoulomb = std::max(worstCoulomb, std::abs((*friction)[way].coulomb_Nm[k].value - coulomb(angle)) / 0.017);
        worstViscous =
            std::max(worstViscous, std::abs((*friction)[way].viscous_Nm_s_per_rad[k].value - viscous(angle)) / 2e-5);
      }
      coulombError[way] += worstCoulomb / draws;
      viscousError[way] += worstViscous / draws;
      QCOMPARE((*friction)[way].leftOut, size_t{0});
    }
  }
  for (size_t way = 0; way < 2; ++way) {
    QVERIFY2(coulombError[way] < 0.02, qPrintable(QString::number(coulombError[way])));
    QVERIFY2(viscousError[way] < 0.12, qPrintable(QString::number(viscousError[way])));
  }
}

void TestVelocityFriction::noiseAlone_leavesFlatFriction() {
  const auto friction = fitMovingFriction(runs(false, 0.0), options());
  QVERIFY(friction.ok());
  const auto& bins = (*friction)[1].coulomb_Nm;
  double low = 1.0, high = 0.0;
  for (const Estimate& bin : bins) low = std::min(low, bin.value), high = std::max(high, bin.value);
  QVERIFY2(high - low < 2e-4, qPrintable(QString::number(high - low)));
  QVERIFY(std::abs((*friction)[1].coulombMean_Nm.value - 0.017) < 1e-4);
}

void TestVelocityFriction::stribeckSpeed_isLeftOut() {
  const auto friction = fitMovingFriction(runs(false, 0.002), options());
  QVERIFY(friction.ok());
  QCOMPARE((*friction)[0].leftOut, size_t{1});
  QVERIFY(std::abs((*friction)[0].coulombMean_Nm.value - 0.017) < 1e-4);
}

/// The first `blocks` of a run, or the others, which another start went on with.
static VelocityRun partOf(const VelocityRun& run, size_t blocks, bool first) {
  VelocityRun part = run;
  const auto at = part.blocks.begin() + static_cast<std::ptrdiff_t>(blocks);
  part.blocks.erase(first ? at : part.blocks.begin(), first ? part.blocks.end() : at);
  part.brokenOff = first;
  part.turns = 0;
  part.bins.assign(run.bins.size(), {});
  for (const RunBlock& block : part.blocks) {
    part.turns += block.turns;
    for (size_t k = 0; k < part.bins.size(); ++k) part.bins[k].add(block.bins[k]);
  }
  return part;
}

void TestVelocityFriction::brokenOffRuns_countAsOneWithWhatWentOn() {
  const auto whole = runs(true, 0.002);
  const auto expected = fitMovingFriction(whole, options());
  QVERIFY(expected.ok());
  for (const size_t blocks : {1, 4, 7}) {
    std::vector<VelocityRun> parts;
    for (size_t k = 0; k < whole.size(); ++k) {
      const bool isBroken = k % 3 == 0;
      if (isBroken) parts.push_back(partOf(whole[k], blocks, true));
      parts.push_back(isBroken ? partOf(whole[k], blocks, false) : whole[k]);
    }
    const auto found = fitMovingFriction(parts, options());
    QVERIFY(found.ok());
    for (size_t way = 0; way < 2; ++way) {
      const MovingFriction &one = (*found)[way], &other = (*expected)[way];
      QCOMPARE(one.leftOut, other.leftOut);
      const auto near = [](const Estimate& a, const Estimate& b) {
        return std::abs(a.value - b.value) < 0.3 * b.standardError && a.standardError > 0.8 * b.standardError &&
               a.standardError < 1.25 * b.standardError;
      };
      QVERIFY2(near(one.coulombMean_Nm, other.coulombMean_Nm), qPrintable(QString::number(blocks)));
      QVERIFY2(near(one.viscousMean_Nm_s_per_rad, other.viscousMean_Nm_s_per_rad), qPrintable(QString::number(blocks)));
      for (size_t k = 0; k < one.coulomb_Nm.size(); ++k) QVERIFY(near(one.coulomb_Nm[k], other.coulomb_Nm[k]));
    }
  }
}

void TestVelocityFriction::oneSpeedOnly_isReportedAsUnobservable() {
  const auto friction =
      fitMovingFriction({runAt(20.0, 0.0, 0.0, false, 1), runAt(-20.0, 0.0, 0.0, false, 2)}, options());
  QVERIFY(!friction.ok());
  QVERIFY(friction.error().message().find("expected at least two") != std::string::npos);
}

/// Fast runs' speeds are differences over spans too long for order 30, so that only breakaways can have shown it.
void TestVelocityFriction::coggingThatTheRotorHides_isTakenFromTheBreakaways() {
  std::vector<VelocityRun> fast;
  for (const VelocityRun& run : runs(false, 0.0)) {
    if (std::abs(run.target_rad_per_s) < 100.0) continue;
    fast.push_back(run);
    fast.back().halfSpan_s = 5e-4;
  }
  for (const double order : {30.0, 60.0}) {  // a stepper's steps and a gear's teeth are as fine
    VelocityFrictionOptions still = options();
    const auto cogging = [order](size_t bin) {
      return 0.003 * std::cos(order * (static_cast<double>(bin) + 0.5) * turn / 180.0);
    };
    for (size_t k = 0; k < 180; ++k) {
      still.static_Nm[0].push_back(0.022 + cogging(k));
      still.static_Nm[1].push_back(0.021 - cogging(k));
    }
    const auto friction = fitMovingFriction(fast, still);
    QVERIFY(friction.ok());
    for (size_t way = 0; way < 2; ++way) {
      double worst = 0.0;
      for (size_t k = 0; k < 180; ++k) {
        const double truth = 0.017 + (way == 0 ? cogging(k) : -cogging(k));
        worst = std::max(worst, std::abs((*friction)[way].coulomb_Nm[k].value - truth));
      }
      QVERIFY2(worst < 4e-4, qPrintable(QString::number(worst)));
    }
  }
}

/// In the slowest runs it stands in two bins for twenty times as long as it takes to pass them, until static friction
/// is overcome: a peak with harmonics of all orders, that no faster run has.
void TestVelocityFriction::placeWhereTheRotorSticks_isNoMovingFriction() {
  auto all = runs(true, 0.0);
  for (VelocityRun& run : all) {
    if (std::abs(run.target_rad_per_s) > 30.0) continue;
    const double static_A = (run.target_rad_per_s > 0.0 ? 1.0 : -1.0) * 0.026 / Kt;
    for (const size_t bin : {100u, 101u}) {
      for (size_t n = 0; n < 3200; ++n) {
        run.bins[bin].add(static_A, 0.0);
        run.blocks[n / 400].bins[bin].add(static_A, 0.0);
      }
    }
  }
  const auto friction = fitMovingFriction(all, options());
  QVERIFY(friction.ok());
  for (const MovingFriction& way : *friction) {
    double worstCoulomb = 0.0, worstViscous = 0.0;
    for (size_t k = 0; k < way.coulomb_Nm.size(); ++k) {
      const double angle = (static_cast<double>(k) + 0.5) * turn / static_cast<double>(way.coulomb_Nm.size());
      worstCoulomb = std::max(worstCoulomb, std::abs(way.coulomb_Nm[k].value - coulomb(angle)));
      worstViscous = std::max(worstViscous, std::abs(way.viscous_Nm_s_per_rad[k].value - viscous(angle)));
    }
    QVERIFY2(worstCoulomb < 0.02 * 0.017 && worstViscous < 0.15 * 2e-5,
             qPrintable(QString("%1 and %2").arg(worstCoulomb / 0.017).arg(worstViscous / 2e-5)));
  }
}

void TestVelocityFriction::coggingThatSlowsTheRotor_isNoFriction_data() {
  QTest::addColumn<double>("order");
  QTest::addColumn<double>("counts");
  QTest::addColumn<double>("bins");
  QTest::addColumn<double>("amps");      // of the cogging
  QTest::addColumn<double>("atCounts");  // of the loop's answer to single counts
  QTest::addColumn<double>("uneven");    // part of a count by which every other one is too wide
  QTest::newRow("a stepper's detents, four bins each") << 50.0 << 1600.0 << 200.0 << 0.1 << 0.0 << 0.0;
  QTest::newRow("two bins each") << 100.0 << 1600.0 << 200.0 << 0.1 << 0.0 << 0.0;
  QTest::newRow("coarse encoder, to whose counts the loop answers") << 12.0 << 120.0 << 120.0 << 0.1 << 0.3 << 0.0;
  QTest::newRow("three counts in a bin, likewise") << 24.0 << 360.0 << 120.0 << 0.1 << 0.3 << 0.0;
  QTest::newRow("counts of unequal width, answered in the next") << 30.0 << 1000.0 << 250.0 << 0.1 << 0.2 << 0.15;
  QTest::newRow("the same, five in a bin") << 30.0 << 1000.0 << 200.0 << 0.1 << 0.2 << 0.15;
}

/// Where detents hold it back the rotor is slow and takes more current, for longer: on average over the time that is
/// 2 % of the friction more, over the angle nothing.
void TestVelocityFriction::coggingThatSlowsTheRotor_isNoFriction() {
  QFETCH(double, order);
  QFETCH(double, counts);
  QFETCH(double, bins);
  QFETCH(double, amps);
  QFETCH(double, atCounts);
  QFETCH(double, uneven);
  constexpr double speed = 3.5, friction_A = 1.0, tick_s = 2e-4, halfSpan_rad = 1.0 / 40.0;
  constexpr size_t turns = 6, span = 35;
  const double count_rad = turn / counts;
  for (const double way : {1.0, -1.0}) {
    std::vector<double> angles, currents;
    for (double angle = 0.0; angle < (turns + 0.1) * turn;) {
      const double inPairs = 0.5 * angle / count_rad, inPair = 2.0 * (inPairs - std::floor(inPairs));
      const bool narrow = inPair >= 1.0 + uneven;
      angles.push_back(way * count_rad * (2.0 * std::floor(inPairs) + (narrow ? 1.0 : 0.0)));
      // As a count comes the loop sees more speed than it wants, and takes current back; after a wide one, less.
      const double inCount = narrow ? (inPair - 1.0 - uneven) / (1.0 - uneven) : inPair / (1.0 + uneven);
      const double answer = atCounts * (inCount - 0.5) + 2.0 * uneven * (narrow ? 1.0 + uneven : uneven - 1.0);
      currents.push_back(way * (friction_A - amps * std::cos(order * angle) + answer));
      for (int step = 0; step < 10; ++step) angle += 0.1 * tick_s * speed * (1.0 + 0.4 * std::cos(order * angle));
    }
    const auto n = static_cast<size_t>(bins);
    const size_t perBin = cellsPerBin(counts, n, static_cast<double>(angles.size()));
    AngleCells cells(n, perBin);
    double overTime_A = 0.0, count = 0.0;
    for (size_t k = span; k + span < angles.size() && std::abs(angles[k]) < turns * turn; ++k) {
      const double place = angles[k] / turn, inBins = (place - std::floor(place)) * bins + 1e-6;
      cells.add(static_cast<size_t>(inBins) % n, inBins, currents[k],
                (angles[k + span] - angles[k - span]) / (2.0 * span * tick_s));
      overTime_A += way * currents[k], count += 1.0;
    }
    QVERIFY2(overTime_A / count > 1.015 * friction_A, qPrintable(QString::number(overTime_A / count)));
    VelocityRun run;
    run.target_rad_per_s = way * speed;
    run.turns = turns;
    run.halfSpan_s = halfSpan_rad / speed;
    run.bins = cells.bins(cells);
    VelocityFrictionOptions even = options();
    even.evenBins = std::fmod(counts, countsPerLine * bins) == 0.0;
    const double found_A = spectrumOf(std::span(&run, 1), even).torque_Nm[0].real() / Kt;
    QVERIFY2(std::abs(found_A / friction_A - 1.0) < 0.005, qPrintable(QString::number(found_A)));
  }
}

QTEST_APPLESS_MAIN(TestVelocityFriction)
#include "tst_velocity_friction.moc"
