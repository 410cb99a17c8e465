#include <QTest>
#include <cmath>

#include "base/random.h"
#include "identify/zero_track.h"

using namespace breakaway;

class TestZeroTrack : public QObject {
  Q_OBJECT
 private slots:
  void smoothDrift_isKnownBetterThanFromOneZeroing();
  void jump_isFollowedByLinesBetweenNeighbours();
  void noReading_isZero();
  void runsAndBreakaways_areCountedFromTheTrack();
};

namespace {

constexpr double noise_A = 0.017;
constexpr size_t samples = 2000;

/// Thirteen zeroings, one every 20 s, of a zero that is `zeroAt` of time.
template <typename Zero>
std::vector<ZeroReading> readings(Zero zeroAt, unsigned seed) {
  Noise noise(seed);
  std::vector<ZeroReading> all;
  for (int k = 0; k < 13; ++k) {
    const double time_s = 20.0 * k;
    all.push_back(
        {time_s, zeroAt(time_s) + noise_A / std::sqrt(static_cast<double>(samples)) * noise.normal(), samples});
  }
  return all;
}

}  // namespace

void TestZeroTrack::smoothDrift_isKnownBetterThanFromOneZeroing() {
  const auto drift = [](double time_s) { return 0.002 + 1e-5 * time_s; };
  const double single_A = noise_A / std::sqrt(static_cast<double>(samples));
  double squares = 0.0;
  int better = 0;  // in some of many, chance makes a straight drift look like none
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const Estimate zero = ZeroTrack(readings(drift, seed), noise_A).at(130.0);
    squares += std::pow((zero.value - drift(130.0)) / zero.standardError, 2) / 50.0;
    better += zero.standardError < 0.5 * single_A && zero.standardError > 0.2 * single_A ? 1 : 0;
  }
  QVERIFY2(better >= 45, qPrintable(QString::number(better)));
  QVERIFY2(squares > 0.5 && squares < 1.8, qPrintable(QString::number(squares)));
}

void TestZeroTrack::jump_isFollowedByLinesBetweenNeighbours() {
  const auto jump = [](double time_s) { return time_s > 125.0 ? 0.03 : 0.0; };
  const ZeroTrack track(readings(jump, 3), noise_A);
  QVERIFY(std::abs(track.at(60.0).value) < 0.0015);
  QVERIFY(std::abs(track.at(200.0).value - 0.03) < 0.0015);
}

void TestZeroTrack::noReading_isZero() {
  QCOMPARE(ZeroTrack({}, noise_A).at(5.0), Estimate{});
}

void TestZeroTrack::runsAndBreakaways_areCountedFromTheTrack() {
  const ZeroTrack track({{0.0, 0.0, samples}, {10.0, 0.01, samples}, {20.0, 0.02, samples}}, 0.0001);
  VelocityRun run;
  run.middle_s = 10.0;
  run.zero_A = 0.004;
  run.bins.resize(1);
  run.bins[0].add(0.5, 3.0);
  run.bins[0].add(0.7, 3.0);
  std::vector<VelocityRun> runs{run};
  countFrom(track, runs);
  QVERIFY(std::abs(runs[0].bins[0].current_A - 2.0 * (0.6 - 0.006)) < 1e-9);
  QVERIFY(std::abs(runs[0].bins[0].currentSquared_A2 - (std::pow(0.494, 2) + std::pow(0.694, 2))) < 1e-9);
  BreakawayEvent event;
  event.way = Way::cw;
  event.time_s = 10.0;
  event.measuredMean_A = 0.3;
  std::vector<BreakawayEvent> events{event};
  countFrom(track, events);
  QVERIFY(std::abs(events[0].measuredMean_A - 0.31) < 1e-9);
}

QTEST_APPLESS_MAIN(TestZeroTrack)
#include "tst_zero_track.moc"
