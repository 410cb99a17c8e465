// Speed observer and current loop as they are chosen: what the choice keeps, and that the noise it counts is the noise
// of the controller's own code.
#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/random.h"
#include "control/tuning.h"
#include "stability/inner_loops.h"
#include "stability/simulated_loop.h"

using namespace breakaway;
using namespace breakaway::test;

class TestInnerLoops : public QObject {
  Q_OBJECT
 private slots:
  void observer_yieldsLittleWithinTheNoise();
  void coarseEncoder_getsASlowerObserver();
  void fasterThanTheBest_isHeldByNoiseAndYieldsMore();
  void currentLoop_keepsItsMarginsInAWarmWinding();
  void currentLoop_isAsFastAsItMay();
  void noisySensor_slowsTheCurrentLoop();
  void currentNoise_isThatOfTheController();
  void given_isTaken();
  void withoutLimitOrSupply_theObserverIsTheBoards();
};

namespace {

constexpr double tick_s = 2e-4, inertia_kg_m2 = 6e-5, torqueConstant_Nm_per_A = 0.07;
constexpr double degree = std::numbers::pi / 180.0;

ServoLoop motorLoop() {
  ServoLoop loop = servoLoop(1.0, tick_s, 1);
  loop.settings.current_limit_A = 4.0;
  return loop;
}

/// Few rows, for those who look at none of them.
const InnerLoopOptions few{.rows = 2};

InnerLoops chosen(const ServoLoop& loop, double countsPerRev, const InnerLoopOptions& inner,
                  double currentNoise_A = 0.018) {
  AutoTuningOptions options;
  options.noise = {roundingRms_rad(2.0 * std::numbers::pi / countsPerRev), currentNoise_A};
  auto found = chooseInnerLoops(loop, {inertia_kg_m2, 0.025 * inertia_kg_m2},
                                {torqueConstant_Nm_per_A, 0.0135 * torqueConstant_Nm_per_A}, options, inner);
  if (!found) qFatal("%s", found.error().message().c_str());
  return std::move(*found);
}

const InnerLoops& fine() {
  static const InnerLoops found = chosen(motorLoop(), 14400.0, {});
  return found;
}

const InnerLoops& coarse() {
  static const InnerLoops found = chosen(motorLoop(), 1024.0, {});
  return found;
}

const SpeedObserverRow& rowAt(const InnerLoops& loops, double bandwidth) {
  return *std::find_if(loops.observerRows.begin(), loops.observerRows.end(), [bandwidth](const SpeedObserverRow& row) {
    return std::abs(row.bandwidth_rad_per_s - bandwidth) < 1e-6 * bandwidth;
  });
}

/// Rms of the current in the winding, by the controller's own code around a winding whose shaft is held.
double simulatedCurrentNoise(const ServoLoop& loop, double bandwidth_rad_per_s, double noise_A) {
  CurrentController<double> controller;
  auto settings = loop.board.current;
  settings.bandwidth_rad_per_s = bandwidth_rad_per_s;
  controller.configure(settings, tick_s);
  const double decay = std::exp(-loop.motor.resistance_ohm * tick_s / loop.motor.inductance_H);
  Random random(7);
  double current = 0.0, acting = 0.0, sum = 0.0;
  constexpr int ticks = 100000;
  for (int k = 0; k < ticks; ++k) {
    const double voltage = controller.step(0.0, current + noise_A * random.normal(), 0.0, 1e9);
    current = decay * current + (1.0 - decay) / loop.motor.resistance_ohm * acting;
    acting = voltage;  // a tick of delay
    sum += current * current;
  }
  return std::sqrt(sum / ticks);
}

}  // namespace

void TestInnerLoops::observer_yieldsLittleWithinTheNoise() {
  const InnerLoops& found = fine();
  QVERIFY(found.observer.source == BandwidthSource::chosen);
  const SpeedObserverRow& row = rowAt(found, found.observer.bandwidth_rad_per_s);
  const SpeedObserverRow& board = rowAt(found, boardVelocityBandwidth_rad_per_s(tick_s));
  QVERIFY(row.noise.currentReference_A <= 1.001 * 0.02 * 4.0);
  QVERIFY2(row.yielding_rad_per_s_per_Nm < 0.6 * board.yielding_rad_per_s_per_Nm,
           qPrintable(
               QString("%1, the boards' %2").arg(row.yielding_rad_per_s_per_Nm).arg(board.yielding_rad_per_s_per_Nm)));
  double least = HUGE_VAL;
  for (const SpeedObserverRow& other : found.observerRows) {
    if (other.loopBandwidth_rad_per_s > 0.0) least = std::min(least, other.yielding_rad_per_s_per_Nm);
  }
  QVERIFY(row.yielding_rad_per_s_per_Nm <= 1.1 * least);
  for (const SpeedObserverRow& other : found.observerRows) {
    const bool slower = other.loopBandwidth_rad_per_s > 0.0 && other.bandwidth_rad_per_s < row.bandwidth_rad_per_s;
    QVERIFY(!slower || other.yielding_rad_per_s_per_Nm > 1.1 * least);
  }
}

void TestInnerLoops::coarseEncoder_getsASlowerObserver() {
  const double ratio = coarse().observer.bandwidth_rad_per_s / fine().observer.bandwidth_rad_per_s;
  QVERIFY2(ratio < 0.6 && ratio > 0.02, qPrintable(QString::number(ratio)));
  // The encoder has nothing to do with the current loop.
  QCOMPARE(coarse().current.bandwidth_rad_per_s, fine().current.bandwidth_rad_per_s);
}

void TestInnerLoops::fasterThanTheBest_isHeldByNoiseAndYieldsMore() {
  const auto& rows = coarse().observerRows;
  const SpeedObserverRow& last = rows.back();
  QCOMPARE(last.heldBy, std::string("noise of the current"));
  QVERIFY(last.yielding_rad_per_s_per_Nm >
          2.0 * rowAt(coarse(), coarse().observer.bandwidth_rad_per_s).yielding_rad_per_s_per_Nm);
}

void TestInnerLoops::currentLoop_keepsItsMarginsInAWarmWinding() {
  ServoLoop loop = motorLoop();
  loop.board.current.bandwidth_rad_per_s = fine().current.bandwidth_rad_per_s;
  for (const double ofL : {0.8, 1.0, 1.2}) {
    for (const double ofR : {1.0, 1.24}) {
      ServoLoop other = loop;
      other.motor.inductance_H *= ofL;
      other.motor.resistance_ohm *= ofR;
      const LoopMargins kept = margins(closedCurrentLoop(other), openCurrentLoop(other));
      QVERIFY(kept.stable && kept.peakSensitivity <= 1.6001 && kept.gainMargin >= 2.999);
      QVERIFY(kept.phaseMargin_rad >= 44.99 * degree);
    }
  }
}

void TestInnerLoops::currentLoop_isAsFastAsItMay() {
  // The zero cancels the winding's pole, so that w·T/(z·(z − 1)) is left: its peak of the sensitivity is 1.6 at
  // w·T = 0.36 (by scanning the circle), and an inductance that is a fifth less takes a fifth of that.
  const double perTick = fine().current.bandwidth_rad_per_s * tick_s;
  QVERIFY2(perTick > 0.25 && perTick < 0.36, qPrintable(QString::number(perTick)));
  QVERIFY(fine().current.heldBy == "peak of the sensitivity" || fine().current.heldBy == "gain margin");
  ServoLoop prompt = motorLoop();
  prompt.delay_ticks = 0;
  QVERIFY(chosen(prompt, 14400.0, few).current.bandwidth_rad_per_s > 1.3 * fine().current.bandwidth_rad_per_s);
}

void TestInnerLoops::noisySensor_slowsTheCurrentLoop() {
  const InnerLoops noisy = chosen(motorLoop(), 14400.0, few, 0.3);
  QVERIFY(noisy.current.bandwidth_rad_per_s < 0.8 * fine().current.bandwidth_rad_per_s);
  QCOMPARE(noisy.current.heldBy, std::string("noise of the current"));
}

void TestInnerLoops::currentNoise_isThatOfTheController() {
  for (const CurrentLoopRow& row : fine().currentRows) {
    if (!std::isfinite(row.current_A) || row.bandwidth_rad_per_s > 0.4 / tick_s) continue;
    const double simulated_A = simulatedCurrentNoise(motorLoop(), row.bandwidth_rad_per_s, 0.018);
    QVERIFY2(
        std::abs(simulated_A / row.current_A - 1.0) < 0.05,
        qPrintable(QString("%1 rad/s: %2 for %3").arg(row.bandwidth_rad_per_s).arg(simulated_A).arg(row.current_A)));
  }
}

void TestInnerLoops::given_isTaken() {
  InnerLoopOptions inner = few;
  inner.observer_rad_per_s = 777.0;
  inner.current_rad_per_s = 555.0;
  const InnerLoops found = chosen(motorLoop(), 14400.0, inner);
  QVERIFY(found.observer.source == BandwidthSource::given && found.current.source == BandwidthSource::given);
  QCOMPARE(found.observer.bandwidth_rad_per_s, 777.0);
  QCOMPARE(found.current.bandwidth_rad_per_s, 555.0);
  inner = few;
  inner.asBoards = true;
  const InnerLoops boards = chosen(motorLoop(), 14400.0, inner);
  QCOMPARE(boards.observer.bandwidth_rad_per_s, boardVelocityBandwidth_rad_per_s(tick_s));
  QCOMPARE(boards.current.bandwidth_rad_per_s, boardCurrentBandwidth_rad_per_s(tick_s));
}

void TestInnerLoops::withoutLimitOrSupply_theObserverIsTheBoards() {
  ServoLoop loop = motorLoop();
  loop.settings.current_limit_A = 0.0;
  QVERIFY(chosen(loop, 14400.0, few).observer.source == BandwidthSource::board);
  InnerLoopOptions inner = few;
  inner.supply_V = 24.0;  // then U/R is the limit
  QVERIFY(chosen(loop, 14400.0, inner).observer.source == BandwidthSource::chosen);
}

QTEST_APPLESS_MAIN(TestInnerLoops)
#include "tst_inner_loops.moc"
