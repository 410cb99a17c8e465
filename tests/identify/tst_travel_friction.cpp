// Friction over a travel from strokes that are known in all but their noise.
#include <QTest>
#include <cmath>
#include <numbers>

#include "base/random.h"
#include "experiment/travel_bins.h"
#include "identify/smooth_pair.h"
#include "identify/travel_friction.h"

using namespace breakaway;

class TestTravelFriction : public QObject {
  Q_OBJECT
 private slots:
  void smoothCurves_areFoundAndHeldByTheirIntervals();
  void levelCurves_areLeftLevel();
  void massAndFriction_areToldApart();
  void wavesOfFewBins_arentFlattened();
  void wavesFinerThanTwoBins_areHeldByTheIntervals();
  void forceConstantsDoubt_isInEveryBin();
  void twoSpeeds_areRefused();
  void coarseCounts_dontMakeFriction();
  void creepAndJumps_areNoSpeed_data();
  void creepAndJumps_areNoSpeed();
  void coggingThatTheCurrentFollows_standsAtItsPlace_data();
  void coggingThatTheCurrentFollows_standsAtItsPlace();
  void speedThatSwingsQuickly_isntFlattened();
};

namespace {

constexpr size_t places = 90;

double at(size_t k) {
  return static_cast<double>(k) / (places - 1);
}

double coulombAt(double x) {
  return 5.0 + 0.5 * std::cos(5.0 * x) + 0.2 * std::sin(40.0 * x);
}

double viscousAt(double x) {
  return 8.0 + 0.8 * std::sin(4.0 * x);
}

/// What strokes at these speeds over bins of 2 mm leave, of an axis of 1.8 kg that speeds up over its first third.
std::vector<TravelRun> strokesOf(const std::vector<double>& speeds, double noise_A, unsigned seed) {
  constexpr double Kf = 14.0, mass = 1.8, tick_s = 2e-4, width_m = 0.002;
  Noise noise(seed);
  std::vector<TravelRun> runs;
  for (const double speed : speeds) {
    TravelRun run;
    run.target_m_per_s = speed;
    run.halfSpan_s = 0.002;
    for (size_t w = 0; w < 2; ++w) {
      const double sign = w == 0 ? -1.0 : 1.0;
      for (size_t k = 0; k < places; ++k) {
        const bool speedsUp = k<places / 3, slowsDown = k> 2 * places / 3;
        const double a = speed * speed * (speedsUp ? 6.0 : slowsDown ? -6.0 : 0.0);
        const auto samples = static_cast<size_t>(20.0 * width_m / speed / tick_s);
        const auto n = static_cast<double>(samples);
        const double force = coulombAt(at(k)) + viscousAt(at(k)) * speed + mass * a;
        run.bins[w].push_back({samples, sign * n * (force / Kf + noise_A * noise.normal() / std::sqrt(n)),
                               sign * n * speed, sign * n * a});
      }
    }
    runs.push_back(run);
  }
  return runs;
}

TravelFrictionOptions optionsFor(double noise_A) {
  TravelFrictionOptions options;
  options.forceConstant_N_per_A = 14.0;
  options.mass_kg = 1.7;  // 6 % off
  options.noiseRms_A = noise_A;
  options.tick_s = 2e-4;
  options.count_m = 1e-6;
  options.bins = {0.0, 0.002 * places, places};
  return options;
}

}  // namespace

void TestTravelFriction::smoothCurves_areFoundAndHeldByTheirIntervals() {
  Noise noise(11);
  std::vector<double> place;
  std::vector<Eigen::Vector2d> pairs;
  std::vector<Eigen::Matrix2d> covariances;
  constexpr double error = 0.1;
  for (size_t k = 0; k < places; ++k) {
    place.push_back(at(k));
    pairs.emplace_back(coulombAt(at(k)) + error * noise.normal(), viscousAt(at(k)) + error * noise.normal());
    covariances.emplace_back(error * error * Eigen::Matrix2d::Identity());
  }
  const SmoothPair curves = smoothPair(place, pairs, covariances);
  double squares[2] = {0.0, 0.0}, held[2] = {0.0, 0.0};
  for (size_t k = 0; k < places; ++k) {
    const double off[2] = {curves.first[k].value - coulombAt(at(k)), curves.second[k].value - viscousAt(at(k))};
    const double doubt[2] = {curves.first[k].standardError, curves.second[k].standardError};
    for (size_t c = 0; c < 2; ++c) {
      squares[c] += off[c] * off[c] / places;
      held[c] += std::abs(off[c]) < 1.96 * doubt[c] ? 1.0 / places : 0.0;
    }
  }
  // The smoother curve gains more.
  QVERIFY2(std::sqrt(squares[0]) < 0.7 * error && std::sqrt(squares[1]) < 0.4 * error,
           qPrintable(QString("%1 %2").arg(std::sqrt(squares[0])).arg(std::sqrt(squares[1]))));
  QVERIFY2(held[0] > 0.85 && held[1] > 0.85, qPrintable(QString("%1 %2").arg(held[0]).arg(held[1])));
}

void TestTravelFriction::levelCurves_areLeftLevel() {
  Noise noise(12);
  std::vector<double> place;
  std::vector<Eigen::Vector2d> pairs;
  std::vector<Eigen::Matrix2d> covariances;
  for (size_t k = 0; k < places; ++k) {
    place.push_back(at(k));
    pairs.emplace_back(5.0 + 0.1 * noise.normal(), 8.0 + 0.5 * noise.normal());
    covariances.emplace_back(Eigen::Vector2d(0.01, 0.25).asDiagonal());
  }
  // One place was never crossed.
  pairs[40].setZero();
  covariances[40] = 1e12 * Eigen::Matrix2d::Identity();
  const SmoothPair curves = smoothPair(place, pairs, covariances);
  for (size_t k = 0; k < places; ++k) {
    QVERIFY(std::abs(curves.first[k].value - 5.0) < 0.06);
    QVERIFY(std::abs(curves.second[k].value - 8.0) < 0.3);
  }
  QVERIFY(curves.firstMean.standardError < 0.02 && curves.firstMean.standardError > 0.005);
}

void TestTravelFriction::massAndFriction_areToldApart() {
  const auto friction = fitTravelFriction(strokesOf({0.02, 0.1, 0.3, 0.8}, 0.017, 3), optionsFor(0.017));
  QVERIFY2(friction.ok(), friction ? "" : friction.error().message().c_str());
  QVERIFY2(std::abs(friction->mass_kg.value - 1.8) < 3.0 * friction->mass_kg.standardError + 1e-12,
           qPrintable(QString::number(friction->mass_kg.value)));
  QVERIFY(friction->mass_kg.standardError < 0.01 * 1.8);
  for (size_t w = 0; w < 2; ++w) {
    double squares[2] = {0.0, 0.0};
    for (size_t k = 0; k < places; ++k) {
      squares[0] += std::pow(friction->moving[w].coulomb_Nm[k].value / coulombAt(at(k)) - 1.0, 2) / places;
      squares[1] += std::pow(friction->moving[w].viscous_Nm_s_per_rad[k].value / viscousAt(at(k)) - 1.0, 2) / places;
    }
    QVERIFY(std::sqrt(squares[0]) < 0.004 && std::sqrt(squares[1]) < 0.01);
    QVERIFY(std::abs(friction->moving[w].coulombMean_Nm.value - 5.0) < 0.3);
  }
}

/// A wave of four bins, whose means over the bins are a tenth flatter than it is.
void TestTravelFriction::wavesOfFewBins_arentFlattened() {
  constexpr double perBin = std::numbers::pi / 2.0;
  const double flattened = std::sin(0.5 * perBin) / (0.5 * perBin);
  auto strokes = strokesOf({0.02, 0.1, 0.3, 0.8}, 1e-4, 5);
  for (TravelRun& run : strokes) {
    for (size_t w = 0; w < 2; ++w) {
      for (size_t k = 0; k < places; ++k) {
        TravelBinSums& sum = run.bins[w][k];
        const double sign = w == 0 ? -1.0 : 1.0, wave_N = std::cos(perBin * static_cast<double>(k) + 0.5);
        sum.current_A += sign * static_cast<double>(sum.samples) * flattened * wave_N / 14.0;
      }
    }
  }
  const auto friction = fitTravelFriction(strokes, optionsFor(1e-4));
  QVERIFY2(friction.ok(), friction ? "" : friction.error().message().c_str());
  for (const MovingFriction& way : friction->moving) {
    double found = 0.0;
    for (size_t k = 8; k + 10 < places; ++k) {
      const double wave = std::cos(perBin * static_cast<double>(k) + 0.5);
      found += 2.0 * wave * (way.coulomb_Nm[k].value - coulombAt(at(k))) / 72.0;
    }
    QVERIFY2(std::abs(found - 1.0) < 0.04, qPrintable(QString::number(found)));
  }
}

/// Of less than two bins, as a linear motor's magnets are to a coarse map: what its means hide, its intervals hold.
void TestTravelFriction::wavesFinerThanTwoBins_areHeldByTheIntervals() {
  constexpr double perBin = 20.0 / 18.0 * std::numbers::pi, noise_A = 2e-3;
  const double flattened = std::sin(0.5 * perBin) / (0.5 * perBin);
  auto strokes = strokesOf({0.02, 0.1, 0.3, 0.8}, noise_A, 6);
  const auto waveAt = [](size_t k) { return 0.8 * std::cos(perBin * static_cast<double>(k) + 0.5); };
  for (TravelRun& run : strokes) {
    for (size_t w = 0; w < 2; ++w) {
      for (size_t k = 0; k < places; ++k) {
        TravelBinSums& sum = run.bins[w][k];
        const double sign = w == 0 ? -1.0 : 1.0;
        sum.current_A += sign * static_cast<double>(sum.samples) * flattened * waveAt(k) / 14.0;
      }
    }
  }
  const auto friction = fitTravelFriction(strokes, optionsFor(noise_A));
  QVERIFY2(friction.ok(), friction ? "" : friction.error().message().c_str());
  for (const MovingFriction& way : friction->moving) {
    double held = 0.0;
    for (size_t k = 4; k + 4 < places; ++k) {
      const Estimate& one = way.coulomb_Nm[k];
      held +=
          std::abs(one.value - coulombAt(at(k)) - waveAt(k)) < 1.96 * one.standardError ? 1.0 / (places - 8.0) : 0.0;
    }
    QVERIFY2(held > 0.85, qPrintable(QString::number(held)));
  }
}

void TestTravelFriction::forceConstantsDoubt_isInEveryBin() {
  TravelFrictionOptions options = optionsFor(1e-4);
  options.scaleError = 0.01;
  const auto friction = fitTravelFriction(strokesOf({0.02, 0.1, 0.3, 0.8}, 1e-4, 5), options);
  QVERIFY2(friction.ok(), friction ? "" : friction.error().message().c_str());
  for (const Estimate& one : friction->moving[1].coulomb_Nm) QVERIFY(one.standardError >= 0.0099 * one.value);
}

void TestTravelFriction::twoSpeeds_areRefused() {
  const auto friction = fitTravelFriction(strokesOf({0.1, 0.3}, 0.017, 3), optionsFor(0.017));
  QVERIFY(!friction);
  QVERIFY(friction.error().message().find("crossed no bin at three speeds") != std::string::npos);
  // A third one that went nowhere steadily.
  auto strokes = strokesOf({0.01, 0.1, 0.3}, 0.017, 3);
  for (auto& way : strokes[0].bins) way.assign(places, {});
  const auto unsteady = fitTravelFriction(strokes, optionsFor(0.017));
  QVERIFY(!unsteady && unsteady.error().message().find("sticks and slips") != std::string::npos);
}

/// Speeds at bins' ends that a coarse encoder tells by a tenth of themselves: what one bin gains of acceleration its
/// neighbour loses, and the slope over the speeds is none the worse.
void TestTravelFriction::coarseCounts_dontMakeFriction() {
  constexpr double mass = 1.8, count_m = 5e-5;
  TravelFrictionOptions options = optionsFor(0.017);
  options.mass_kg = mass;
  options.count_m = count_m;
  double worst = 0.0, held = 0.0;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    auto strokes = strokesOf({0.05, 0.1, 0.2, 0.35, 0.5}, 0.017, seed);
    Noise noise(100 + seed);
    for (TravelRun& run : strokes) {
      const double speedError = count_m / std::sqrt(6.0) / (2.0 * run.halfSpan_s);
      for (auto& way : run.bins) {
        for (size_t pass = 0; pass < 20; ++pass) {
          double before = speedError * noise.normal();
          for (TravelBinSums& sum : way) {
            const double after = speedError * noise.normal();
            sum.acceleration_m_per_s2 += (after - before) / options.tick_s;
            before = after;
          }
        }
      }
    }
    const auto friction = fitTravelFriction(strokes, options);
    QVERIFY2(friction.ok(), friction ? "" : friction.error().message().c_str());
    for (const MovingFriction& way : friction->moving) {
      double off = 0.0;
      for (size_t k = 0; k < places; ++k) {
        const Estimate& one = way.viscous_Nm_s_per_rad[k];
        off += (one.value / viscousAt(at(k)) - 1.0) / places;
        held += std::abs(one.value - viscousAt(at(k))) < 1.96 * one.standardError ? 1.0 / (8.0 * places) : 0.0;
      }
      worst = std::max(worst, std::abs(off));
    }
  }
  QVERIFY2(worst < 0.01, qPrintable(QString::number(worst)));
  QVERIFY2(held > 0.85, qPrintable(QString::number(held)));
}

void TestTravelFriction::creepAndJumps_areNoSpeed_data() {
  QTest::addColumn<double>("jump_m_per_s");
  QTest::addColumn<bool>("counts");
  QTest::newRow("steady, with noise") << 0.0 << true;
  QTest::newRow("a tenth to and fro") << 0.001 << true;
  QTest::newRow("creeps and jumps") << 0.03 << false;
}

/// A stroke at 10 mm/s whose speed rises for a fifth of each count by so much, and is less in between; friction's slope
/// over the place is no swing.
void TestTravelFriction::creepAndJumps_areNoSpeed() {
  QFETCH(double, jump_m_per_s);
  QFETCH(bool, counts);
  constexpr double speed = 0.01, perAmpere = 5.0, noise_A = 0.02, tick_s = 2e-4;
  constexpr size_t period = 75, quick = 15;  // ticks
  Noise noise(4);
  StrokeTrace trace;
  trace.tick_s = tick_s;
  double at_m = 0.0, before = speed;
  for (size_t k = 0; at_m < 0.03; ++k) {
    const bool jumps = k % period < quick;
    const double now = speed + (jumps ? jump_m_per_s : -jump_m_per_s * quick / (period - quick));
    at_m += now * tick_s;
    trace.position_m.push_back(std::floor(at_m / 1.5e-4) * 1.5e-4);
    trace.current_A.push_back(0.4 + 20.0 * at_m + (now - before) / tick_s / perAmpere + noise_A * noise.normal());
    before = now;
  }
  std::array<std::vector<TravelBinSums>, 2> sums;
  addStroke(trace, {0.003, 0.027, 8}, 0.005, {perAmpere, noise_A}, sums);
  for (const TravelBinSums& sum : sums[1]) QCOMPARE(sum.samples > 0, counts);
  TravelRun run;
  run.bins = {sums[1], sums[1]};
  QCOMPARE(tellsOfFriction(run), counts);
}

void TestTravelFriction::coggingThatTheCurrentFollows_standsAtItsPlace_data() {
  QTest::addColumn<double>("windingTime_s");
  QTest::newRow("there at once") << 0.0;
  QTest::newRow("within a tick") << 1e-4;
  QTest::newRow("long") << 4e-3;
}

/// At a constant speed the current makes up for cogging, in steps of the tick's voltage: the bins show the same force
/// at each speed, where half a tick's shift would be 2 % of it.
void TestTravelFriction::coggingThatTheCurrentFollows_standsAtItsPlace() {
  QFETCH(double, windingTime_s);
  constexpr double tick_s = 1.25e-4, period_m = 5.8e-3, speed = 0.3;
  const double wave = 2.0 * std::numbers::pi / period_m;
  const auto meanOver = [&](double from_m, double to_m) {
    return (std::cos(wave * from_m) - std::cos(wave * to_m)) / (wave * (to_m - from_m));
  };
  StrokeTrace trace;
  trace.tick_s = tick_s;
  trace.windingTime_s = windingTime_s;
  // Between two ticks a current flows whose mean is what is asked for there.
  const double q = windingTime_s > 0.0 ? std::exp(-tick_s / windingTime_s) : 0.0;
  const double lasting = windingTime_s > 0.0 ? windingTime_s / tick_s * (1.0 - q) : 0.0;
  double current_A = 0.0;
  for (size_t k = 0; static_cast<double>(k) * tick_s * speed < 0.03; ++k) {
    const double at_m = static_cast<double>(k) * tick_s * speed;
    trace.position_m.push_back(at_m);
    trace.current_A.push_back(current_A);
    const double wanted_A = meanOver(at_m, at_m + tick_s * speed);
    const double end_A = windingTime_s > 10.0 * tick_s
                             ? std::sin(wave * (at_m + tick_s * speed))
                             : current_A + (wanted_A - current_A) * (1.0 - q) / std::max(1e-9, 1.0 - lasting);
    current_A = end_A;
  }
  std::array<std::vector<TravelBinSums>, 2> sums;
  // Bins that end where ticks do.
  const double first_m = 100.0 * tick_s * speed - 1e-9;
  const TravelBins bins{first_m, first_m + 24.0 * 24.0 * tick_s * speed, 24};
  addStroke(trace, bins, 0.001, {}, sums);
  for (size_t k = 0; k < bins.count; ++k) {
    const double mean_A = sums[1][k].current_A / static_cast<double>(sums[1][k].samples);
    const double from_m = bins.centre_m(k) - 0.5 * bins.width_m(),
                 off_A = mean_A - meanOver(from_m, from_m + bins.width_m());
    QVERIFY2(std::abs(off_A) < 0.002, qPrintable(QString("%1: %2 off").arg(k).arg(off_A)));
  }
}

/// Cogging that nothing makes up for swings the speed, within ± 1 ms by a good part of its wave: that is no friction.
void TestTravelFriction::speedThatSwingsQuickly_isntFlattened() {
  constexpr double tick_s = 1.25e-4, period_m = 5.8e-3, speed = 0.7, swing = 0.02;
  const double wave = 2.0 * std::numbers::pi / period_m;
  const TravelBins bins{0.005, 0.05, 150};
  StrokeTrace trace;
  trace.tick_s = tick_s;
  trace.reachesFar = reachesFar(0.001, speed, bins);
  QVERIFY(trace.reachesFar && !reachesFar(0.001, 0.07, bins));
  double at_m = 0.0;
  for (size_t k = 0; at_m < 0.057; ++k) {
    trace.position_m.push_back(at_m);
    trace.current_A.push_back(0.0);
    for (int part = 0; part < 8; ++part) at_m += tick_s / 8.0 * (speed + swing * std::sin(wave * at_m));
  }
  std::array<std::vector<TravelBinSums>, 2> sums;
  addStroke(trace, bins, 0.001, {}, sums);
  double shown = 0.0, is = 0.0;
  for (size_t k = 0; k < bins.count; ++k) {
    const TravelBinSums& sum = sums[1][k];
    QVERIFY(sum.samples > 0);
    const double truth = speed * swing * wave * std::cos(wave * bins.centre_m(k));
    shown += truth * sum.acceleration_m_per_s2 / static_cast<double>(sum.samples);
    is += truth * truth;
  }
  QVERIFY2(std::abs(shown / is - 1.0) < 0.05, qPrintable(QString::number(shown / is)));
}

QTEST_APPLESS_MAIN(TestTravelFriction)
#include "tst_travel_friction.moc"
