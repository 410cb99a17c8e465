#include <QTest>
#include <cmath>
#include <numbers>

#include "base/numbers.h"
#include "base/random.h"
#include "identify/finest_noise.h"
#include "identify/map_estimation.h"

using namespace breakaway;

class TestMapEstimation : public QObject {
  Q_OBJECT
 private slots:
  void everyBin_isFilledAndNearTheTruth();
  void missingBreakaways_areInterpolated();
  void stretchWithoutBreakaways_isBridged();
  void slotsFinerThanTheBinsMiddlesShow_areFollowed();
  void wavesFinerThanBinsShow_areInCoulombsDoubt();
  void standardError_matchesTheScatter();
  void intervalsHoldTheTruth_data();
  void intervalsHoldTheTruth();
  void noiseOfACurve_isToldBesideItsHarmonics();
  void angleInDoubt_widensWhereTheMapIsSteep();
  void outlier_isMarkedAndKept();
  void weakCurrents_areCalibratedTogether();
  void unrelatedTurns_dontCorrelate();
  void noBreakaways_areReported();
};

namespace {

constexpr double turn = 2.0 * std::numbers::pi, Kt = 0.07;

double truth(double angle) {
  return 0.021 * (1.0 + 0.2 * std::cos(angle));
}

MapOptions options() {
  MapOptions result;
  result.bins = 90;
  result.torqueConstant_Nm_per_A = Kt;
  return result;
}

/// Ramps of 1000 samples over the last 30 % of the breakaway's current.
std::vector<BreakawayEvent> events(double scatter, double noise_A, double size, unsigned seed, size_t turns = 2) {
  Noise noise(seed);
  std::vector<BreakawayEvent> all;
  for (size_t t = 0; t < turns; ++t) {
    for (const Way way : {Way::ccw, Way::cw}) {
      for (size_t bin = 0; bin < 90; ++bin) {
        BreakawayEvent event;
        event.way = way;
        event.turn = t;
        event.bin = bin;
        event.angle_rad = (static_cast<double>(bin) + 0.2 + 0.6 * noise.uniform()) * turn / 90.0;
        event.commanded_A = size * truth(event.angle_rad) / Kt * (1.0 + scatter * noise.normal());
        event.commandedMean_A = 0.85 * event.commanded_A;
        event.commandedVariance_A2 = std::pow(0.3 * event.commanded_A, 2) / 12.0;
        event.samples = 1000;
        event.measuredMean_A = event.commandedMean_A + noise_A / std::sqrt(1000.0) * noise.normal();
        event.covariance_A2 =
            event.commandedVariance_A2 + noise_A * std::sqrt(event.commandedVariance_A2 / 1000.0) * noise.normal();
        event.current_A = event.measuredMean_A + event.commanded_A - event.commandedMean_A;
        all.push_back(event);
      }
    }
  }
  return all;
}

double rmsError(const FrictionMap& map, double size) {
  double squares = 0.0;
  for (const MapBin& bin : map.bins) squares += std::pow(bin.way[1].static_Nm.value - size * truth(bin.angle_rad), 2);
  return std::sqrt(squares / static_cast<double>(map.bins.size())) / (size * 0.021);
}

}  // namespace

void TestMapEstimation::everyBin_isFilledAndNearTheTruth() {
  const auto map = estimateMap(events(0.01, 0.0, 1.0, 1), nullptr, options());
  QVERIFY(map.ok());
  QCOMPARE(map->bins.size(), size_t{90});
  const double error = rmsError(*map, 1.0);
  QVERIFY2(error > 0.002 && error < 0.01, qPrintable(QString::number(error)));
  QVERIFY(map->repeatability[1].correlation > 0.98);
  for (const MapBin& bin : map->bins) QCOMPARE(bin.way[0].samples, size_t{2});
}

void TestMapEstimation::missingBreakaways_areInterpolated() {
  auto all = events(0.0, 0.0, 1.0, 2);
  std::erase_if(all, [](const BreakawayEvent& event) { return event.bin % 5 == 0; });
  const auto map = estimateMap(all, nullptr, options());
  QVERIFY(map.ok());
  QCOMPARE(map->bins[10].way[1].samples, size_t{0});
  QVERIFY(rmsError(*map, 1.0) < 0.002);
}

/// A twentieth to a sixth of the turn where no rotor could be held: the harmonics of least squares swung down to zero
/// in it, and said that they knew.
void TestMapEstimation::stretchWithoutBreakaways_isBridged() {
  for (const size_t wide : {4u, 7u, 15u}) {
    size_t within = 0, bins = 0;
    for (unsigned seed = 1; seed <= 10; ++seed) {
      auto all = events(0.02, 0.0, 1.0, seed);
      std::erase_if(all, [&](const BreakawayEvent& event) { return event.bin >= 30 && event.bin < 30 + wide; });
      const auto map = estimateMap(all, nullptr, options());
      QVERIFY(map.ok());
      QVERIFY2(rmsError(*map, 1.0) < 0.03, qPrintable(QString::number(rmsError(*map, 1.0))));
      for (size_t bin = 30; bin < 30 + wide; ++bin) {
        const Estimate& one = map->bins[bin].way[1].static_Nm;
        within += std::abs(one.value - truth(map->bins[bin].angle_rad)) < normal95 * one.standardError ? 1 : 0;
        ++bins;
      }
    }
    const double share = static_cast<double>(within) / static_cast<double>(bins);
    QVERIFY2(share > 0.85, qPrintable(QString("%1 bins: %2").arg(wide).arg(share)));
  }
}

/// A gimbal motor's slots, 84 to the turn, and breakaways anywhere within 180 bins: straight lines between those had
/// cut a quarter off them.
void TestMapEstimation::slotsFinerThanTheBinsMiddlesShow_areFollowed() {
  const auto slotsAt = [](double angle) { return 0.006 * std::cos(84.0 * angle - 0.7); };
  auto all = events(0.01, 0.0, 1.0, 5, 4);
  for (BreakawayEvent& event : all) {
    const double more_A = (event.way == Way::cw ? 1.0 : -1.0) * slotsAt(event.angle_rad) / Kt;
    for (double* one : {&event.commanded_A, &event.commandedMean_A, &event.measuredMean_A, &event.current_A})
      *one += more_A;
  }
  const auto map = estimateMap(all, nullptr, options());
  QVERIFY(map.ok());
  double squares = 0.0;
  for (const MapBin& bin : map->bins) {
    const double off = bin.way[1].static_Nm.value - truth(bin.angle_rad) + slotsAt(bin.angle_rad);
    squares += off * off;
  }
  const double rms = std::sqrt(squares / static_cast<double>(map->bins.size())) / 0.021;
  QVERIFY2(rms < 0.02, qPrintable(QString::number(rms)));
}

/// A ripple of 43 periods over 90 bins is no part of what moving friction shows, and moving friction has it all the
/// same.
void TestMapEstimation::wavesFinerThanBinsShow_areInCoulombsDoubt() {
  constexpr double amplitude = 0.0015, known = 1e-5;
  std::array<MovingFriction, 2> moving;
  for (MovingFriction& way : moving) {
    way.coulomb_Nm.assign(90, Estimate{0.015, known});
    way.viscous_Nm_s_per_rad.assign(90, Estimate{1e-5, 1e-7});
  }
  for (unsigned seed = 1; seed <= 10; ++seed) {
    for (const bool rippled : {false, true}) {
      auto all = events(0.015, 0.0, 1.0, seed);
      for (BreakawayEvent& event : all) {
        const double more_A =
            rippled ? signOf(event.way) * amplitude * std::cos(43.0 * event.angle_rad + 0.4) / Kt : 0.0;
        for (double* one : {&event.commanded_A, &event.commandedMean_A, &event.measuredMean_A, &event.current_A})
          *one += more_A;
      }
      const auto map = estimateMap(all, &moving, options());
      QVERIFY(map.ok());
      for (const WayBin& way : map->bins[17].way) {
        const double doubt = way.coulomb_Nm.standardError / (rippled ? amplitude / std::sqrt(2.0) : known);
        QVERIFY2(doubt > 0.8 && doubt < 1.3, qPrintable(QString("seed %1: %2").arg(seed).arg(doubt)));
      }
    }
  }
}

void TestMapEstimation::standardError_matchesTheScatter() {
  const auto map = estimateMap(events(0.02, 0.0, 1.0, 3), nullptr, options());
  QVERIFY(map.ok());
  const double relative = map->bins[0].way[1].static_Nm.standardError / 0.021;
  QVERIFY2(relative > 0.007 && relative < 0.018, qPrintable(QString::number(relative)));
}

/// Breakaways that all stood 0.02 rad beyond where they are taken to have stood.
void TestMapEstimation::angleInDoubt_widensWhereTheMapIsSteep() {
  auto all = events(0.0, 0.0, 1.0, 3);
  for (BreakawayEvent& event : all) event.angle_rad -= std::min(0.02, event.angle_rad);
  MapOptions doubtful = options();
  doubtful.angleError_rad = 0.02;
  const auto sure = estimateMap(all, nullptr, options()), wide = estimateMap(all, nullptr, doubtful);
  QVERIFY(sure.ok() && wide.ok());
  const auto off = [](const FrictionMap& map, size_t bin) {
    const Estimate& one = map.bins[bin].way[1].static_Nm;
    return std::abs(one.value - truth(map.bins[bin].angle_rad)) / one.standardError;
  };
  constexpr size_t steep = 22, top = 45;
  QVERIFY2(off(*sure, steep) > 2.0, qPrintable(QString::number(off(*sure, steep))));
  QVERIFY2(off(*wide, steep) < 1.2 && off(*wide, steep) > 0.5, qPrintable(QString::number(off(*wide, steep))));
  const auto error = [](const FrictionMap& map, size_t bin) { return map.bins[bin].way[1].static_Nm.standardError; };
  QVERIFY(error(*wide, steep) > 2.0 * error(*sure, steep));
  QVERIFY(error(*wide, top) < 0.2 * error(*wide, steep) + error(*sure, top));
}

void TestMapEstimation::intervalsHoldTheTruth_data() {
  QTest::addColumn<size_t>("turns");
  for (const size_t turns : {1u, 2u, 4u}) QTest::addRow("%zu turns", turns) << turns;
}

void TestMapEstimation::intervalsHoldTheTruth() {
  QFETCH(size_t, turns);
  size_t within = 0, bins = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    MapOptions wanted = options();
    wanted.turns = turns;
    const auto map = estimateMap(events(0.02, 0.0, 1.0, seed, turns), nullptr, wanted);
    QVERIFY(map.ok());
    for (const MapBin& bin : map->bins) {
      const Estimate& one = bin.way[1].static_Nm;
      within += std::abs(one.value - truth(bin.angle_rad)) < normal95 * one.standardError ? 1 : 0;
      ++bins;
    }
  }
  const double share = static_cast<double>(within) / static_cast<double>(bins);
  QVERIFY2(share > 0.9 && share < 0.985, qPrintable(QString::number(share)));
}

void TestMapEstimation::noiseOfACurve_isToldBesideItsHarmonics() {
  for (const bool around : {true, false}) {
    double ratios = 0.0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
      Noise noise(seed);
      std::vector<double> values;
      for (size_t k = 0; k < 90; ++k) {
        const double angle = (static_cast<double>(k) + 0.5) / 90.0 * (around ? turn : 0.4 * turn);
        values.push_back(std::cos(angle) + 0.3 * std::sin(24.0 * angle) + 0.02 * noise.normal());
      }
      ratios += finestNoise(values, around) / 0.02 / 20.0;
    }
    QVERIFY2(ratios > 0.85 && ratios < 1.25, qPrintable(QString::number(ratios)));
  }
  QCOMPARE(finestNoise({1.0, 2.0}, true), 0.0);
}

void TestMapEstimation::outlier_isMarkedAndKept() {
  auto all = events(0.005, 0.0, 1.0, 4);
  for (BreakawayEvent& event : all) {
    if (event.bin == 40 && event.turn == 0 && event.way == Way::ccw) {
      event.commanded_A *= 1.6;
      event.outlier = true;
    }
  }
  const auto map = estimateMap(all, nullptr, options());
  QVERIFY(map.ok());
  QVERIFY(map->bins[40].way[1].outlier);
  QVERIFY(!map->bins[70].way[1].outlier);
  QVERIFY(map->bins[40].way[1].static_Nm.value > 1.2 * truth(map->bins[40].angle_rad));
}

void TestMapEstimation::weakCurrents_areCalibratedTogether() {
  // Friction of 9 mA under 17 mA of noise.
  MapOptions together = options(), alone = options();
  together.noiseRms_A = 0.017;
  const double size = 0.03;
  const auto good = estimateMap(events(0.01, 0.017, size, 5), nullptr, together);
  const auto bad = estimateMap(events(0.01, 0.017, size, 5), nullptr, alone);
  QVERIFY(good.ok() && bad.ok());
  QVERIFY2(rmsError(*good, size) < 0.02, qPrintable(QString::number(rmsError(*good, size))));
  QVERIFY(rmsError(*bad, size) > 0.03);
}

void TestMapEstimation::unrelatedTurns_dontCorrelate() {
  auto all = events(0.0, 0.0, 1.0, 6);
  Noise noise(9);
  for (BreakawayEvent& event : all) {
    event.commanded_A = 0.3 * (1.0 + 0.1 * noise.normal());
    event.measuredMean_A = event.commandedMean_A;
  }
  const auto map = estimateMap(all, nullptr, options());
  QVERIFY(map.ok());
  QVERIFY(std::abs(map->repeatability[0].correlation) < 0.4);
}

void TestMapEstimation::noBreakaways_areReported() {
  QVERIFY(!estimateMap({}, nullptr, options()).ok());
}

QTEST_APPLESS_MAIN(TestMapEstimation)
#include "tst_map_estimation.moc"
