#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/random.h"
#include "experiment/breakaway_sweep.h"
#include "experiment/current_zeroing.h"
#include "experiment/homing.h"
#include "experiment/position_step.h"
#include "experiment/reversal_test.h"
#include "experiment/slow_turns.h"
#include "experiment/velocity_step.h"
#include "experiment/velocity_sweep.h"
#include "experiment/wiring_check.h"
#include "firmware_link/simulated_board.h"

using namespace breakaway;

class TestProcedures : public QObject {
  Q_OBJECT
 private slots:
  void slowTurns_giveFrictionBetweenStandingAndMoving();
  void slowTurnsThatTakeTooLong_areLeftOut();
  void zeroing_findsTheSensorsOffset();
  void zeroing_takesNoiseForNoise();
  void homing_findsTheIndexToACount();
  void homing_findsItAgainFromElsewhere();
  void homingWithoutIndex_saysSo();
  void homingOnADiscOfOtherCounts_namesThem_data();
  void homingOnADiscOfOtherCounts_namesThem();
  void homingWithAFalseIndex_doesntTakeItForOtherCounts();
  void homingOfAHeldRotor_saysSo();
  void homingThatCreeps_timesOut();
  void homing_countsEdgesTowardsGrowingAngleOnly();
  void velocityStep_isFastAndReachesItsSpeed();
  void positionStep_goesToItsPlace_data();
  void positionStep_goesToItsPlace();
  void positionStepOfAHeldShaft_saysSo();
  void velocitySweep_runsWholeTurnsBothWays();
  void unreachableSpeed_isReported();
  void speedLostWhileMeasuring_isReportedWithItsPlace();
  void breakawaySweep_logsTheAngleReallyReached();
  void placesThatSeemFree_dontEndASweepThatCanGoOn();
  void stoppedSweep_keepsWhatItMeasured();
  void sweepWithoutResistance_failsAtOnce();
  void aRotorThatSticksWhereFrictionIsHigh_isNotHeld();
  void whatFallsBackFromStandstill_isToldFromWhatCoasts();
};

namespace {

std::unique_ptr<Drive> servo() {
  qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
  auto drive = openDrive("simulated:servo", 3);
  if (!drive) qFatal("%s", drive.error().message().c_str());
  return std::move(*drive);
}

void run(Drive& drive, const std::shared_ptr<Procedure>& procedure, double most_s) {
  std::vector<Sample> samples;
  drive.start(procedure);
  for (double time = 0.0; time < most_s && procedure->state() == Procedure::State::running; time += 0.05) {
    samples.clear();
    if (!drive.advance(0.05, samples)) qFatal("no samples");
  }
}

double indexErrorInCounts(double found_rad) {
  const double count = 2.0 * std::numbers::pi / 14400.0, turn = 2.0 * std::numbers::pi;
  return std::remainder(found_rad - 1.234, turn) / count;
}

BreakawaySweepOptions quickSweep() {
  BreakawaySweepOptions options;
  options.bins = 12;
  options.turns = 1;
  options.indexAngle_rad = 1.234;
  options.torqueConstant_Nm_per_A = options.backEmfConstant_V_s_per_rad = 0.07;
  options.resistance_ohm = 1.2;
  options.deadZone_V = 0.24;
  options.inertia_kg_m2 = 6e-5;
  options.countsPerRev = 14400;
  return options;
}

}  // namespace

void TestProcedures::zeroing_findsTheSensorsOffset() {
  auto drive = servo();
  const auto zeroing = std::make_shared<CurrentZeroing>();
  run(*drive, zeroing, 5.0);
  QCOMPARE(zeroing->state(), Procedure::State::finished);
  QVERIFY(std::abs(zeroing->zero_A().value - 0.05) < 0.003);
  QVERIFY(zeroing->noiseRms_A() > 0.015 && zeroing->noiseRms_A() < 0.02);
}

/// Two halves' means differ by chance by more than a quiet sensor's zero may move; what moves beyond that is named.
void TestProcedures::zeroing_takesNoiseForNoise() {
  int moved = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    for (const double drift_A : {0.0, 0.2}) {
      Noise noise(seed);
      CurrentZeroing zeroing;
      Sample sample;
      for (int k = 0; zeroing.state() == Procedure::State::running && k < 8000; ++k) {
        sample.time_s = k / 5000.0;
        sample.current_A = 0.7 * noise.normal() + (sample.time_s > 0.55 ? drift_A : 0.0);
        zeroing.step(sample);
      }
      if (drift_A > 0.0) moved += zeroing.status().failure.find("zero moved") != std::string::npos ? 1 : 0;
      if (drift_A == 0.0) QCOMPARE(zeroing.state(), Procedure::State::finished);
    }
  }
  QCOMPARE(moved, 40);
}

void TestProcedures::homing_findsTheIndexToACount() {
  auto drive = servo();
  const auto homing = std::make_shared<Homing>();
  run(*drive, homing, 60.0);
  QCOMPARE(homing->state(), Procedure::State::finished);
  QCOMPARE(homing->passes(), size_t{3});
  QVERIFY2(std::abs(indexErrorInCounts(homing->indexAngle_rad().value)) < 1.5,
           qPrintable(QString::number(indexErrorInCounts(homing->indexAngle_rad().value))));
}

void TestProcedures::homing_findsItAgainFromElsewhere() {
  auto drive = servo();
  std::vector<Sample> samples;
  drive->command({Command::Mode::position, 3.5, 0.0, false});
  QVERIFY(drive->advance(3.0, samples).ok());
  const auto homing = std::make_shared<Homing>();
  run(*drive, homing, 60.0);
  QCOMPARE(homing->state(), Procedure::State::finished);
  QVERIFY(std::abs(indexErrorInCounts(homing->indexAngle_rad().value)) < 1.5);
  QVERIFY(homing->indexAngle_rad().value > 3.5);
}

void TestProcedures::homingWithoutIndex_saysSo() {
  Homing homing;
  Sample sample;
  for (int k = 0; k < 100000 && homing.state() == Procedure::State::running; ++k) {
    sample.time_s = k * 1e-3;
    sample.angle_rad = 3e-3 * k;
    homing.step(sample);
  }
  QCOMPARE(homing.state(), Procedure::State::failed);
  QVERIFY(homing.status().failure.find("no index within 1.5 turns") != std::string::npos);
  QCOMPARE(homing.step(sample), Command{});
}

void TestProcedures::homingOnADiscOfOtherCounts_namesThem_data() {
  QTest::addColumn<double>("shownTurns");
  QTest::addColumn<QString>("words");
  QTest::newRow("a quarter more") << 1.25 << "a turn has 5120 counts, not 4096";
  QTest::newRow("a fifth less") << 0.8 << "a turn has 3277 counts, not 4096";
  QTest::newRow("the other channel only") << 0.5 << "a turn has 2048 counts, not 4096";
}

/// The index comes once in a true turn, which the board takes for so many.
void TestProcedures::homingOnADiscOfOtherCounts_namesThem() {
  QFETCH(double, shownTurns);
  QFETCH(QString, words);
  const double turn = 2.0 * std::numbers::pi, count = turn / 4096.0;
  HomingOptions options;
  options.countsPerRev = 4096.0;
  options.timeout_s = 300.0;
  Homing homing(options);
  Sample sample;
  double before = 0.0;
  for (int k = 0; k < 300000 && homing.state() == Procedure::State::running; ++k) {
    sample.time_s = k * 1e-3;
    sample.velocity_rad_per_s = 1.0;
    sample.angle_rad = count * std::floor(1e-3 * k / count);
    const auto passes = [&](double angle) { return std::floor((angle - 1.0) / (shownTurns * turn)); };
    sample.index = passes(sample.angle_rad) != passes(before);
    before = sample.angle_rad;
    homing.step(sample);
  }
  QCOMPARE(homing.state(), Procedure::State::failed);
  QVERIFY2(homing.status().failure.find(words.toStdString()) != std::string::npos, homing.status().failure.c_str());
}

/// What comes in between once, and not as far again, is no disc's index.
void TestProcedures::homingWithAFalseIndex_doesntTakeItForOtherCounts() {
  const double turn = 2.0 * std::numbers::pi;
  HomingOptions options;
  options.countsPerRev = 4096.0;
  Homing homing(options);
  Sample sample;
  double before = 0.0;
  for (int k = 0; k < 100000 && homing.state() == Procedure::State::running; ++k) {
    sample.time_s = k * 1e-3;
    sample.velocity_rad_per_s = 3.0;
    sample.angle_rad = 3e-3 * k;
    const auto passed = [&](double place) {
      return std::floor((sample.angle_rad - place) / turn) != std::floor((before - place) / turn);
    };
    sample.index = passed(1.0) || passed(1.0 + 0.8 * turn);
    before = sample.angle_rad;
    homing.step(sample);
  }
  QCOMPARE(homing.state(), Procedure::State::failed);
  QVERIFY2(homing.status().failure.find("seen twice within a turn") != std::string::npos,
           homing.status().failure.c_str());
}

void TestProcedures::homingOfAHeldRotor_saysSo() {
  Homing homing;
  Sample sample;
  for (int k = 0; k < 10000 && homing.state() == Procedure::State::running; ++k) {
    sample.time_s = k * 1e-3;
    homing.step(sample);
  }
  QCOMPARE(homing.state(), Procedure::State::failed);
  QVERIFY(homing.status().failure.find("does not move") != std::string::npos);
}

void TestProcedures::homingThatCreeps_timesOut() {
  HomingOptions options;
  options.timeout_s = 20.0;
  Homing homing(options);
  Sample sample;
  for (int k = 0; k < 100000 && homing.state() == Procedure::State::running; ++k) {
    sample.time_s = k * 1e-3;
    sample.angle_rad = 0.1 * sample.time_s;
    homing.step(sample);
  }
  QCOMPARE(homing.state(), Procedure::State::failed);
  QVERIFY(homing.status().failure.find("not done after 20 s") != std::string::npos);
  QVERIFY(sample.time_s > 19.9 && sample.time_s < 20.1);
}

/// Obeys at once, and shows an index that is `width_rad` wide: its edges differ by the way of passing.
void TestProcedures::homing_countsEdgesTowardsGrowingAngleOnly() {
  const double edge_rad = 2.0, width_rad = 0.01, turn = 2.0 * std::numbers::pi;
  Homing homing;
  Sample sample;
  size_t backwards = 0;
  for (int k = 0; k < 100000 && homing.state() == Procedure::State::running; ++k) {
    const double before_rad = sample.angle_rad;
    const Command command = homing.step(sample);
    QVERIFY(command.mode != Command::Mode::position);
    sample.time_s = k * 1e-3;
    sample.angle_rad += 1e-3 * command.target;
    const double seen_rad = command.target > 0.0 ? edge_rad : edge_rad - width_rad;
    sample.index = std::floor((sample.angle_rad - seen_rad) / turn) != std::floor((before_rad - seen_rad) / turn);
    if (sample.index && command.target < 0.0) ++backwards;
  }
  QCOMPARE(homing.state(), Procedure::State::finished);
  QVERIFY(backwards >= 3);
  QVERIFY(std::abs(std::remainder(homing.indexAngle_rad().value - edge_rad, turn)) < 1e-3);
}

void TestProcedures::velocityStep_isFastAndReachesItsSpeed() {
  auto drive = servo();
  run(*drive, std::make_shared<CurrentZeroing>(), 5.0);
  const auto step = std::make_shared<VelocityStep>();
  run(*drive, step, 5.0);
  const StepFigures figures = step->figures();
  QVERIFY2(figures.rise_s > 0.005 && figures.rise_s < 0.12, qPrintable(QString::number(figures.rise_s)));
  QVERIFY(figures.overshoot < 0.3);
  QVERIFY(figures.peakCurrent_A > 0.3 && figures.peakCurrent_A < 8.0);
  QVERIFY(std::abs(step->curve().velocity_rad_per_s.back() - 20.0) < 1.0);
}

void TestProcedures::positionStep_goesToItsPlace_data() {
  QTest::addColumn<double>("by_rad");
  QTest::newRow("forwards") << 0.4;
  QTest::newRow("backwards") << -0.4;
}

void TestProcedures::positionStep_goesToItsPlace() {
  QFETCH(double, by_rad);
  auto drive = servo();
  run(*drive, std::make_shared<CurrentZeroing>(), 5.0);
  run(*drive, std::make_shared<VelocityStep>(), 5.0);  // so that it doesn't begin at 0
  PositionStepOptions options;
  options.by_rad = by_rad;
  const auto step = std::make_shared<PositionStep>(options);
  run(*drive, step, 5.0);
  QVERIFY2(step->state() == Procedure::State::finished, step->status().failure.c_str());
  const StepCurve& curve = step->curve();
  QVERIFY(curve.time_s.front() < -0.05 && std::abs(curve.velocity_rad_per_s.front()) < 0.02);
  QVERIFY2(std::abs(curve.velocity_rad_per_s.back() / by_rad - 1.0) < 0.05,
           qPrintable(QString::number(curve.velocity_rad_per_s.back())));
  const StepFigures figures = step->figures();
  QVERIFY2(figures.rise_s > 0.005 && figures.rise_s < 0.3, qPrintable(QString::number(figures.rise_s)));
  QVERIFY(figures.overshoot < 0.3 && figures.peakCurrent_A > 0.05 && figures.peakCurrent_A < 8.0);
}

void TestProcedures::positionStepOfAHeldShaft_saysSo() {
  PositionStepOptions options;
  options.by_rad = 0.1;
  PositionStep step(options);
  Sample sample;
  sample.angle_rad = 3.0;
  double farthest_rad = 0.0;
  for (int k = 0; k < 3000 && step.state() == Procedure::State::running; ++k) {
    sample.time_s = k * 1e-3;
    sample.current_A = 1e-3 * (k % 7);
    const Command command = step.step(sample);
    if (command.mode == Command::Mode::position) farthest_rad = std::max(farthest_rad, command.target);
  }
  QVERIFY(std::abs(farthest_rad - 3.1) < 1e-12);
  QCOMPARE(step.state(), Procedure::State::failed);
  QVERIFY(step.status().failure.find("does not follow a step of 5.73°") != std::string::npos);
}

void TestProcedures::velocitySweep_runsWholeTurnsBothWays() {
  auto drive = servo();
  VelocitySweepOptions options;
  options.speeds_rad_per_s = {20.0, 40.0};
  options.run_s = 2.0;
  const auto sweep = std::make_shared<VelocitySweep>(options);
  run(*drive, sweep, 60.0);
  QCOMPARE(sweep->state(), Procedure::State::finished);
  QCOMPARE(sweep->runs().size(), size_t{4});
  for (const VelocityRun& one : sweep->runs()) {
    const double turns = std::abs(one.target_rad_per_s) * one.duration_s / (2.0 * std::numbers::pi);
    QVERIFY(std::abs(turns - static_cast<double>(one.turns)) < 0.1);
    for (const AngleBinSums& bin : one.bins) QVERIFY(bin.samples > 0);
  }
  QCOMPARE(sweep->runs()[1].way(), Way::cw);
}

void TestProcedures::unreachableSpeed_isReported() {
  auto drive = servo();
  VelocitySweepOptions options;
  options.speeds_rad_per_s = {1000.0};
  const auto sweep = std::make_shared<VelocitySweep>(options);
  run(*drive, sweep, 60.0);
  // The board stops it before the supply leaves nothing to brake with.
  QCOMPARE(sweep->state(), Procedure::State::stopped);
  QVERIFY(sweep->status().failure.find("over-speed") != std::string::npos);
}

/// On a board that doesn't watch for itself.
void TestProcedures::speedLostWhileMeasuring_isReportedWithItsPlace() {
  VelocitySweepOptions options;
  options.speeds_rad_per_s = {10.0};
  options.zeroing_s = 0.0;
  VelocitySweep sweep(options);
  Sample sample;
  Command command;
  for (int k = 0; k < 60000 && sweep.state() == Procedure::State::running; ++k) {
    sample.time_s = k * 1e-3;
    sample.velocity_rad_per_s = sample.time_s < 5.0 ? command.target : 0.0;
    sample.angle_rad += 1e-3 * sample.velocity_rad_per_s;
    command = sweep.step(sample);
  }
  QCOMPARE(sweep.state(), Procedure::State::failed);
  QVERIFY2(sample.time_s > 5.9 && sample.time_s < 6.3, qPrintable(QString::number(sample.time_s)));
  const auto at = static_cast<int>(std::fmod(sample.angle_rad, 2.0 * std::numbers::pi) * 180.0 / std::numbers::pi);
  const std::string words = "the speed 10.0 rad/s was lost at " + std::to_string(at) + "°";
  QVERIFY2(sweep.status().failure.starts_with(words), sweep.status().failure.c_str());
}

void TestProcedures::breakawaySweep_logsTheAngleReallyReached() {
  auto drive = servo();
  const auto sweep = std::make_shared<BreakawaySweep>(quickSweep());
  run(*drive, sweep, 120.0);
  QCOMPARE(sweep->state(), Procedure::State::finished);
  QCOMPARE(sweep->events().size() + sweep->missed(), size_t{24});
  QVERIFY(sweep->missed() <= 1);
  for (const BreakawayEvent& event : sweep->events()) {
    const double wanted = (static_cast<double>(event.bin) + 0.5) * 2.0 * std::numbers::pi / 12.0;
    QVERIFY(std::abs(std::remainder(event.angle_rad - wanted, 2.0 * std::numbers::pi)) < 0.15);
    QVERIFY2(event.torque_Nm > 0.012 && event.torque_Nm < 0.032, qPrintable(QString::number(event.torque_Nm)));
  }
}

/// Of a slow run in strong cogging, say: a third of the turn seems to take a twelfth of what it takes.
void TestProcedures::placesThatSeemFree_dontEndASweepThatCanGoOn() {
  auto drive = servo();
  BreakawaySweepOptions options = quickSweep();
  for (auto& way : options.moving_A) {
    way.assign(36, 0.24);
    std::fill(way.begin() + 12, way.begin() + 24, 0.02);
  }
  const auto sweep = std::make_shared<BreakawaySweep>(options);
  run(*drive, sweep, 300.0);
  QVERIFY2(sweep->state() == Procedure::State::finished, sweep->status().failure.c_str());
  QVERIFY(sweep->missed() <= 1);
}

void TestProcedures::stoppedSweep_keepsWhatItMeasured() {
  auto drive = servo();
  const auto sweep = std::make_shared<BreakawaySweep>(quickSweep());
  run(*drive, sweep, 8.0);
  drive->stop("pressed");
  const size_t measured = sweep->events().size();
  QVERIFY(measured >= 2);
  QCOMPARE(sweep->state(), Procedure::State::stopped);
  QCOMPARE(sweep->status().failure, std::string("pressed"));
  std::vector<Sample> samples;
  QVERIFY(drive->advance(1.0, samples).ok());
  QVERIFY(!samples.back().enabled);
  QCOMPARE(samples.back().voltage_V, 0.0);
  QCOMPARE(sweep->events().size(), measured);
}

void TestProcedures::sweepWithoutResistance_failsAtOnce() {
  BreakawaySweepOptions options = quickSweep();
  options.resistance_ohm = 0.0;
  const BreakawaySweep sweep(options);
  QCOMPARE(sweep.state(), Procedure::State::failed);
  QVERIFY(sweep.status().failure.find("resistance") != std::string::npos);
}

void TestProcedures::slowTurns_giveFrictionBetweenStandingAndMoving() {
  auto drive = servo();
  SlowTurnsOptions options;
  options.speeds_rad_per_s = {4.0, 1.0};
  const auto slow = std::make_shared<SlowTurns>(options);
  run(*drive, slow, 60.0);
  QCOMPARE(slow->state(), Procedure::State::finished);
  QCOMPARE(slow->turns().size(), size_t{4});
  const auto torque = [&slow](size_t k) { return 0.07 * std::abs(slow->turns()[k].current_A); };
  QVERIFY(std::abs(slow->turns()[0].velocity_rad_per_s - 4.0) < 0.1);
  QVERIFY(std::abs(slow->turns()[3].velocity_rad_per_s + 1.0) < 0.1);
  // The rig's means: Coulomb 16.75 mNm, static 21.55 mNm, falling over 1.5 rad/s.
  for (const size_t k : {size_t{0}, size_t{1}})
    QVERIFY2(std::abs(torque(k) / 0.01684 - 1.0) < 0.03, qPrintable(QString::number(torque(k))));
  for (const size_t k : {size_t{2}, size_t{3}})
    QVERIFY2(std::abs(torque(k) / 0.01984 - 1.0) < 0.04, qPrintable(QString::number(torque(k))));
}

void TestProcedures::slowTurnsThatTakeTooLong_areLeftOut() {
  auto drive = servo();
  SlowTurnsOptions options;
  options.speeds_rad_per_s = {20.0};
  options.patience = 0.5;
  const auto slow = std::make_shared<SlowTurns>(options);
  run(*drive, slow, 60.0);
  QCOMPARE(slow->state(), Procedure::State::finished);
  QVERIFY(slow->turns().empty());
}

/// What hardly breaks it loose at one place needn't do so at all others; twice as much does.
void TestProcedures::aRotorThatSticksWhereFrictionIsHigh_isNotHeld() {
  for (const bool held : {false, true}) {
    ReversalTestOptions options;
    options.current_A = 8.5;
    options.breakaway_A = held ? 4.2 : 6.7;
    options.highest_rad_per_s = 50.0;
    ReversalTest test(options);
    Sample sample;
    for (int k = 0; test.state() != Procedure::State::failed && k < 10000; ++k) {
      sample.time_s = 1e-3 * k;
      static_cast<void>(test.step(sample));
    }
    QVERIFY(test.state() == Procedure::State::failed);
    QCOMPARE(test.stood(), held);
    const std::string words = test.status().failure.c_str();
    QVERIFY2(words.find(held ? "something in its way" : "6.7 A") != std::string::npos, words.c_str());
  }
}

/// A rotor that a current held up against an arm, and one that turned when the job ended.
void TestProcedures::whatFallsBackFromStandstill_isToldFromWhatCoasts() {
  for (const bool coasts : {false, true}) {
    WiringCheckOptions options;
    options.coast_s = 1.0;
    options.count_rad = 1e-3;
    WiringCheck check(options);
    Sample sample;
    sample.supply_V = 24.0;
    for (int k = 0; k < 1500; ++k) {
      const double t = sample.time_s = 1e-3 * k, end = std::min(t, 0.2);
      sample.angle_rad = coasts ? 10.0 * end * (1.0 - 2.5 * end) : 0.5 + 0.5 * std::cos(std::numbers::pi * end / 0.2);
      sample.velocity_rad_per_s = coasts && t < 0.2 ? 10.0 - 50.0 * t : 0.0;
      static_cast<void>(check.step(sample));
    }
    QVERIFY2(std::abs(check.fell_rad() + (coasts ? 0.0 : 1.0)) < 1e-6, qPrintable(QString::number(check.fell_rad())));
  }
}

QTEST_APPLESS_MAIN(TestProcedures)
#include "tst_procedures.moc"
