// Tuning from an uncertain motor: what it promises holds at every corner, and in the controller's own code.
#include <QTest>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "stability/auto_tuning.h"
#include "stability/simulated_loop.h"
#include "support/sanitized.h"

using namespace breakaway;
using namespace breakaway::test;

class TestAutoTuning : public QObject {
  Q_OBJECT
 private slots:
  void margins_holdAtEveryCorner_data();
  void margins_holdAtEveryCorner();
  void worstCorner_holdsInSimulation_data();
  void worstCorner_holdsInSimulation();
  void insideOfTheCorners_nothingIsWorse();
  void stiffer_isFasterAndBarer();
  void moreDoubt_makesTheLoopSlower();
  void coarseEncoder_isHeldByItsNoise();
  void intervalToZero_isRefused();
  void names_goBothWays();
};

namespace {

constexpr double inertia_kg_m2 = 6e-5, torqueConstant_Nm_per_A = 0.07;

/// Each computed once, since several tests look at the same one.
const Result<Tuning>& tuned(Stiffness stiffness, double tick_s, double inertiaError = 0.03,
                            double countsPerRev = 14400.0) {
  static std::map<std::tuple<Stiffness, double, double, double>, Result<Tuning>> known;
  const auto key = std::tuple(stiffness, tick_s, inertiaError, countsPerRev);
  if (const auto found = known.find(key); found != known.end()) return found->second;
  AutoTuningOptions options;
  options.stiffness = stiffness;
  options.noise = {roundingRms_rad(2.0 * std::numbers::pi / countsPerRev), 0.018};
  return known
      .emplace(key, autoTune(servoLoop(1.0, tick_s, 1), {inertia_kg_m2, inertiaError * inertia_kg_m2},
                             {torqueConstant_Nm_per_A, 0.0135 * torqueConstant_Nm_per_A}, options))
      .first->second;
}

ServoLoop withMotor(const Tuning& tuning, double tick_s, double J, double Kt, ServoMode mode) {
  ServoLoop loop = servoLoop(1.0, tick_s, 1);
  loop.settings = tuning.settings;
  loop.motor.inertia_kg_m2 = J;
  loop.motor.torqueConstant_Nm_per_A = Kt;
  loop.mode = mode;
  return loop;
}

void addTicks() {
  QTest::addColumn<int>("stiffness");
  QTest::addColumn<double>("tick_s");
  for (const Stiffness one : {Stiffness::soft, Stiffness::medium, Stiffness::stiff}) {
    for (const double tick_s : {2e-4, 1e-3})
      QTest::newRow(qPrintable(QString("%1, T %2 ms").arg(nameOf(one).data()).arg(1e3 * tick_s)))
          << static_cast<int>(one) << tick_s;
    if (sanitized) return;  // another stiffness runs no other code
  }
}

/// The largest excursion in the last tenth of two seconds after a step, per step; and the overshoot.
struct StepEnd {
  double left = 0.0, overshoot = 0.0;
};
StepEnd stepEnd(const ServoLoop& loop) {
  SimulatedLoop simulated(loop);
  simulated.ask(1.0);
  StepEnd end;
  const int ticks = static_cast<int>(4.0 / loop.board.tick_s);
  for (int k = 0; k < ticks; ++k) {
    simulated.step();
    const double value = loop.mode == ServoMode::position ? simulated.angle_rad() : simulated.velocity_rad_per_s();
    end.overshoot = std::max(end.overshoot, value - 1.0);
    if (k > 9 * ticks / 10) end.left = std::max(end.left, std::abs(value - 1.0));
  }
  return end;
}

}  // namespace

void TestAutoTuning::margins_holdAtEveryCorner_data() {
  addTicks();
}

void TestAutoTuning::margins_holdAtEveryCorner() {
  QFETCH(int, stiffness);
  QFETCH(double, tick_s);
  const auto& tuning = tuned(static_cast<Stiffness>(stiffness), tick_s);
  QVERIFY2(tuning.ok(), tuning.ok() ? "" : tuning.error().message().c_str());
  QCOMPARE(tuning->corners.size(), size_t{4});
  double worst = 0.0;
  for (const TuningCorner& corner : tuning->corners) {
    for (const LoopMargins& found : {corner.velocity, corner.position}) {
      QVERIFY(found.stable);
      QVERIFY(found.gainMargin >= tuning->wanted.gainMargin);
      QVERIFY(found.phaseMargin_rad >= tuning->wanted.phaseMargin_rad);
      QVERIFY(found.peakSensitivity <= tuning->wanted.peakSensitivity);
    }
    worst = std::max(worst, corner.velocity.peakSensitivity);
  }
  QCOMPARE(tuning->worstVelocity.peakSensitivity, worst);
  QVERIFY(tuning->nominal.velocity.peakSensitivity < worst);
  // Nothing is given away either: one of the bounds is met.
  QVERIFY(worst > 0.995 * tuning->wanted.peakSensitivity ||
          tuning->worstVelocity.gainMargin < 1.01 * tuning->wanted.gainMargin ||
          tuning->worstVelocity.phaseMargin_rad < 1.01 * tuning->wanted.phaseMargin_rad);
}

void TestAutoTuning::worstCorner_holdsInSimulation_data() {
  addTicks();
}

void TestAutoTuning::worstCorner_holdsInSimulation() {
  QFETCH(int, stiffness);
  QFETCH(double, tick_s);
  const auto& tuning = tuned(static_cast<Stiffness>(stiffness), tick_s);
  QVERIFY(tuning.ok());
  for (const TuningCorner& corner : tuning->corners) {
    for (const ServoMode mode : {ServoMode::velocity, ServoMode::position}) {
      const ServoLoop loop = withMotor(*tuning, tick_s, corner.inertia_kg_m2, corner.torqueConstant_Nm_per_A, mode);
      const StepEnd end = stepEnd(loop);
      QVERIFY2(end.left < 0.01, qPrintable(QString::number(end.left)));
      QVERIFY2(end.overshoot < 0.6, qPrintable(QString::number(end.overshoot)));
      QVERIFY(!grows(loop, tuning->wanted.gainMargin));
      QVERIFY(grows(loop, 2.5 * tuning->wanted.gainMargin));
    }
  }
}

void TestAutoTuning::insideOfTheCorners_nothingIsWorse() {
  const auto& tuning = tuned(Stiffness::medium, 2e-4, 0.05);
  QVERIFY(tuning.ok());
  const unsigned seed = 5;
  qInfo("seed %u", seed);
  Noise noise(seed);
  const auto inside = [&noise](double value, double error) {
    return value * (1.0 + 1.96 * error * (2.0 * noise.uniform() - 1.0));
  };
  for (int k = 0; k < 200; ++k) {
    const auto found = margins(withMotor(*tuning, 2e-4, inside(inertia_kg_m2, 0.05),
                                         inside(torqueConstant_Nm_per_A, 0.0135), ServoMode::velocity));
    QVERIFY(found.stable);
    QVERIFY(found.peakSensitivity <= tuning->worstVelocity.peakSensitivity * (1.0 + 1e-6));
    QVERIFY(found.gainMargin >= tuning->worstVelocity.gainMargin * (1.0 - 1e-6));
    QVERIFY(found.phaseMargin_rad >= tuning->worstVelocity.phaseMargin_rad * (1.0 - 1e-6));
  }
}

void TestAutoTuning::stiffer_isFasterAndBarer() {
  const auto &soft = tuned(Stiffness::soft, 2e-4), &medium = tuned(Stiffness::medium, 2e-4),
             &stiff = tuned(Stiffness::stiff, 2e-4);
  QVERIFY(soft && medium && stiff);
  QVERIFY(medium->velocityBandwidth_rad_per_s > 1.2 * soft->velocityBandwidth_rad_per_s);
  QVERIFY(stiff->velocityBandwidth_rad_per_s > 1.2 * medium->velocityBandwidth_rad_per_s);
  QVERIFY(stiff->velocityBandwidth_rad_per_s < 10.0 * soft->velocityBandwidth_rad_per_s);
  QVERIFY(stiff->noise.estimate_Nm > medium->noise.estimate_Nm && medium->noise.estimate_Nm > soft->noise.estimate_Nm);
  QVERIFY(stiff->positionBandwidth_rad_per_s > medium->positionBandwidth_rad_per_s);
}

void TestAutoTuning::moreDoubt_makesTheLoopSlower() {
  double last = HUGE_VAL;
  for (const double error : {0.0, 0.02, 0.05, 0.1, 0.2}) {
    const auto& tuning = tuned(Stiffness::medium, 2e-4, error);
    QVERIFY(tuning.ok());
    QVERIFY(tuning->velocityBandwidth_rad_per_s < last);
    last = tuning->velocityBandwidth_rad_per_s;
  }
  QVERIFY(last > 5.0);
}

void TestAutoTuning::coarseEncoder_isHeldByItsNoise() {
  const auto &fine = tuned(Stiffness::medium, 2e-4), &coarse = tuned(Stiffness::medium, 2e-4, 0.03, 100.0);
  QVERIFY(fine && coarse);
  QCOMPARE(fine->heldBy, std::string("peak of the sensitivity"));
  QCOMPARE(coarse->heldBy, std::string("noise of the current"));
  QVERIFY(coarse->velocityBandwidth_rad_per_s < 0.9 * fine->velocityBandwidth_rad_per_s);
  QVERIFY(coarse->noise.currentReference_A <= 0.02 * coarse->settings.current_limit_A);
  QVERIFY(coarse->noise.currentReference_A > 0.98 * 0.02 * coarse->settings.current_limit_A);
}

void TestAutoTuning::intervalToZero_isRefused() {
  const auto& refused = tuned(Stiffness::medium, 2e-4, 0.6);
  QVERIFY(!refused.ok());
  QCOMPARE(refused.error().place, std::string("inertia_kg_m2"));
}

void TestAutoTuning::names_goBothWays() {
  for (const Stiffness one : {Stiffness::soft, Stiffness::medium, Stiffness::stiff})
    QCOMPARE(stiffnessNamed(nameOf(one)), std::optional(one));
  QVERIFY(!stiffnessNamed("brutal"));
}

QTEST_APPLESS_MAIN(TestAutoTuning)
#include "tst_auto_tuning.moc"
