#include <QTest>
#include <cmath>
#include <memory>

#include "base/random.h"
#include "control/friction_compensator.h"
#include "control/friction_table.h"
#include "control/servo_controller.h"
#include "control/tuning.h"
#include "observer/reaction_torque_observer.h"

using namespace breakaway;

class TestFrictionCompensator : public QObject {
  Q_OBJECT
 private slots:
  void methodsAAndB_giveTheSameTorque();
  void methodsThatDisagree_wouldBeFound();
  void filterOfB_hasTheExactPole();
  void table_isLinearBetweenItsBins();
  void table_takesPositionTorqueOutOfBothWays();
  void oneBin_isTheSameAllAround();
  void slowSpeeds_blendTheWays();
  void noBins_giveNothing();
  void fromRest_staticFrictionIsGivenTheWayThatIsMeant();
  void staticFriction_fallsToCoulombOverTheStribeckSpeed();
  void withoutIntent_aSlowRotorGetsNoStaticFriction();
  void smallCommandedCurrents_giveTheirShareAlone();
  void servo_addsTheTablesCurrent();
  void servoWithoutTable_addsNothing();
  void reactionObserver_leavesTheLoadThatIsNotFriction();
  void reactionObserver_takesTheInertiaMismatchOut();
};

namespace {

constexpr double tick_s = 2e-4;
const DisturbanceObserver<double>::Settings nominal{200.0, 6e-5, 0.07};

/// Largest difference of methods A and B over a rotor's random motion, part of the largest torque, when the cutoff of B
/// is off by `part`.
double worstDifference(double part) {
  DifferenceCompensator<double> a;
  FilteredCompensator<double> b;
  a.configure(nominal, tick_s);
  b.configure((1.0 + part) * nominal.cutoff_rad_per_s, tick_s);
  a.reset(0.0);
  Noise noise(5);
  double velocity = 0.0, worst = 0.0, largest = 0.0;
  for (int k = 0; k < 20000; ++k) {
    const double current = 2.0 * noise.normal();
    velocity += 0.5 * noise.normal() - 1e-3 * velocity;
    const double friction = dryAndViscous(0.017, 2e-5, velocity);
    const double fromA = a.step(current, velocity, friction), fromB = b.step(friction);
    worst = std::max(worst, std::abs(fromA - fromB));
    largest = std::max(largest, std::abs(fromB));
  }
  return worst / largest;
}

/// What the board gives by a table, at an angle instead of a place.
template <typename Scalar>
class Given {
 public:
  explicit Given(const FrictionTable<Scalar>& table) { given_->take(table); }
  Scalar torque_Nm(Scalar angle, Scalar velocity, Scalar intent = 0) const {
    return given_->torque_Nm(given_->placeOf(turnOf(angle)), velocity, intent);
  }
  Scalar movingTorque_Nm(Scalar angle, Scalar target, Scalar velocity) const {
    return given_->movingTorque_Nm(given_->placeOf(turnOf(angle)), target, velocity);
  }

 private:
  std::unique_ptr<FrictionFeedForward<Scalar>> given_ = std::make_unique<FrictionFeedForward<Scalar>>();
};

std::unique_ptr<FrictionTable<double>> waves() {
  auto table = std::make_unique<FrictionTable<double>>();
  table->bins = 90;
  table->index_rad = 0.7;
  for (int k = 0; k < 90; ++k) {
    const double angle = (k + 0.5) * 2.0 * M_PI / 90.0;
    table->coulomb_Nm[0][k] = 0.017 + 0.003 * std::cos(angle) + 0.001 * std::cos(3.0 * angle);
    table->coulomb_Nm[1][k] = 0.016 + 0.003 * std::cos(angle) - 0.001 * std::cos(3.0 * angle);
    table->viscous_Nm_s_per_rad[0][k] = table->viscous_Nm_s_per_rad[1][k] = 2e-5;
  }
  return table;
}

}  // namespace

void TestFrictionCompensator::methodsAAndB_giveTheSameTorque() {
  const double difference = worstDifference(0.0);
  QVERIFY2(difference < 1e-12, qPrintable(QString::number(difference)));
}

void TestFrictionCompensator::methodsThatDisagree_wouldBeFound() {
  QVERIFY(worstDifference(0.01) > 1e-3);
}

void TestFrictionCompensator::filterOfB_hasTheExactPole() {
  FilteredCompensator<double> b;
  b.configure(200.0, tick_s);
  double torque = 0.0;
  for (int k = 0; k < 30; ++k) torque = b.step(0.017);
  QVERIFY(std::abs(torque / (0.017 * (1.0 - std::exp(-200.0 * 30 * tick_s))) - 1.0) < 1e-10);
  b.configure(0.0, tick_s);
  QCOMPARE(b.step(0.01), 0.01);
}

void TestFrictionCompensator::table_isLinearBetweenItsBins() {
  const Given given(*waves());
  double worst = 0.0;
  for (double angle = -30.0; angle < 30.0; angle += 0.0137) {
    const double true_Nm = 0.016 + 0.003 * std::cos(angle - 0.7) - 0.001 * std::cos(3.0 * (angle - 0.7)) + 2e-5 * 10.0;
    worst = std::max(worst, std::abs(given.torque_Nm(angle, 10.0) - true_Nm));
  }
  QVERIFY2(worst < 1e-5 && worst > 1e-7, qPrintable(QString::number(worst)));
}

void TestFrictionCompensator::table_takesPositionTorqueOutOfBothWays() {
  const Given given(*waves());
  const double angle = 0.7 + 1.3, still = given.torque_Nm(angle, 0.0);
  QVERIFY(std::abs(still - 0.5 * (0.016 - 0.017 - 0.002 * std::cos(3.9))) < 1e-5);
  QVERIFY(std::abs(0.5 * (given.torque_Nm(angle, 5.0) + given.torque_Nm(angle, -5.0)) - still) < 1e-12);
}

void TestFrictionCompensator::oneBin_isTheSameAllAround() {
  auto table = std::make_unique<FrictionTable<float>>();
  table->bins = 1;
  table->coulomb_Nm[0][0] = 0.017f;
  table->coulomb_Nm[1][0] = 0.016f;
  const Given given(*table);
  for (const float angle : {-100.0f, -0.1f, 0.0f, 3.0f, 1000.0f}) {
    QCOMPARE(given.torque_Nm(angle, 2.0f), 0.016f);
    QCOMPARE(given.torque_Nm(angle, -2.0f), -0.017f);
  }
}

void TestFrictionCompensator::slowSpeeds_blendTheWays() {
  auto table = std::make_unique<FrictionTable<double>>();
  table->bins = 1;
  table->blend_rad_per_s = 0.5;
  table->coulomb_Nm[0][0] = table->coulomb_Nm[1][0] = 0.017;
  const Given given(*table);
  QCOMPARE(given.torque_Nm(0.0, 0.25), 0.0085);
  QCOMPARE(given.torque_Nm(0.0, -0.25), -0.0085);
  QCOMPARE(given.torque_Nm(0.0, 0.5), 0.017);
  QCOMPARE(given.torque_Nm(0.0, 0.0), 0.0);
}

void TestFrictionCompensator::noBins_giveNothing() {
  const Given given(FrictionTable<double>{});
  QCOMPARE(given.torque_Nm(1.0, 5.0), 0.0);
}

static std::unique_ptr<FrictionTable<double>> sticking() {
  auto table = std::make_unique<FrictionTable<double>>();
  table->bins = 1;
  table->blend_rad_per_s = 0.5;
  table->stribeck_rad_per_s = 1.5;
  table->coulomb_Nm[0][0] = table->coulomb_Nm[1][0] = 0.017;
  table->static_Nm[0][0] = 0.023;
  table->static_Nm[1][0] = 0.021;
  return table;
}

void TestFrictionCompensator::fromRest_staticFrictionIsGivenTheWayThatIsMeant() {
  const Given given(*sticking());
  QVERIFY(std::abs(given.torque_Nm(0.0, 0.0, 1.0) - 0.021) < 1e-12);
  QVERIFY(std::abs(given.torque_Nm(0.0, 0.0, -1.0) + 0.023) < 1e-12);
  QVERIFY(std::abs(given.movingTorque_Nm(0.0, 5.0, 0.0) - 0.021) < 1e-12);
  QVERIFY(std::abs(given.movingTorque_Nm(0.0, -5.0, 0.0) + 0.023) < 1e-12);
  QVERIFY(std::abs(given.movingTorque_Nm(0.0, 5.0, 5.0) - 0.017) < 1e-12);
}

void TestFrictionCompensator::staticFriction_fallsToCoulombOverTheStribeckSpeed() {
  const Given given(*sticking());
  double worst = 0.0;
  for (double speed = 0.5; speed < 10.0; speed += 0.01) {
    const double x = speed / 1.5, true_Nm = 0.017 + 0.004 * std::exp(-x * x);
    worst = std::max(worst, std::abs(given.torque_Nm(0.0, speed, 1.0) - true_Nm) / 0.004);
  }
  QVERIFY2(worst < 0.08 && worst > 0.01, qPrintable(QString::number(worst)));
}

void TestFrictionCompensator::withoutIntent_aSlowRotorGetsNoStaticFriction() {
  const Given given(*sticking());
  QCOMPARE(given.torque_Nm(0.0, 0.0), 0.0);
  for (const double speed : {-1.0, -0.2, 0.3, 0.6, 2.0})
    QVERIFY(std::abs(given.torque_Nm(0.0, speed)) <= 0.017 + 1e-12);
  // Nor one that still turns the other way.
  QVERIFY(std::abs(given.torque_Nm(0.0, -0.8, 1.0) + 0.017) < 1e-12);
}

void TestFrictionCompensator::smallCommandedCurrents_giveTheirShareAlone() {
  ServoController<double> controller({tick_s, 2.0 * M_PI / 14400.0, {1.2, 0.0011, 0.07, 300.0}, 400.0});
  controller.configure({tuneMotion(6e-5, 0.07, 60.0, 40.0), 0.0, 6e-5, 0.07, 5.0});
  controller.compensate(*sticking(), 0.0);
  const auto givenTo = [&controller](double current) {
    controller.command({ServoMode::current, current, 0.0, false});
    double given = 0.0;  // once the speed has settled on the middle of the count
    for (int k = 0; k < 2000; ++k) given = controller.step(0.0, 0.0, 24.0).current_reference_A - current;
    return given;
  };
  const double full_A = 0.1 * 0.017 / 0.07;
  QVERIFY(std::abs(givenTo(0.0)) < 1e-9);
  QVERIFY(std::abs(givenTo(full_A) - 0.021 / 0.07) < 1e-9);
  QVERIFY(std::abs(givenTo(3.0 * full_A) - 0.021 / 0.07) < 1e-9);
  const double half_A = givenTo(0.5 * full_A);
  QVERIFY2(half_A > 0.0 && half_A < 0.6 * 0.021 / 0.07, qPrintable(QString::number(half_A)));
}

static double currentWith(const FrictionTable<double>& table) {
  ServoController<double> controller({tick_s, 2.0 * M_PI / 14400.0, {1.2, 0.0011, 0.07, 300.0}, 400.0});
  controller.configure({tuneMotion(6e-5, 0.07, 60.0, 40.0), 0.0, 6e-5, 0.07, 5.0});
  controller.compensate(table, 0.0);
  controller.command({ServoMode::velocity, 3.0, 0.0, false});
  double reference = 0.0;
  for (int k = 0; k < 2000; ++k) reference = controller.step(3.0 * k * tick_s, 0.0, 24.0).current_reference_A;
  return reference;
}

void TestFrictionCompensator::servo_addsTheTablesCurrent() {
  auto table = std::make_unique<FrictionTable<double>>();
  table->bins = 1;
  table->coulomb_Nm[0][0] = table->coulomb_Nm[1][0] = 0.014;
  table->viscous_Nm_s_per_rad[0][0] = table->viscous_Nm_s_per_rad[1][0] = 7e-4;
  const double added = currentWith(*table) - currentWith({});
  QVERIFY2(std::abs(added - (0.014 + 7e-4 * 3.0) / 0.07) < 1e-9, qPrintable(QString::number(added)));
}

void TestFrictionCompensator::servoWithoutTable_addsNothing() {
  QVERIFY(std::abs(currentWith({})) < 0.01);
}

/// RTOB's steady estimate for a rotor that is driven at a constant acceleration against friction and a load.
static double steadyReaction(double load_Nm, double friction_Nm, double inertia_kg_m2, double mismatch_kg_m2) {
  ReactionTorqueObserver<double> observer;
  observer.configure({nominal, mismatch_kg_m2, 0.0}, tick_s);
  observer.reset(0.0);
  const double acceleration = 300.0;
  const double current = (inertia_kg_m2 * acceleration + friction_Nm + load_Nm) / nominal.torqueConstant_Nm_per_A;
  double estimate = 0.0;
  for (int k = 1; k < 1000; ++k) estimate = observer.step(current, acceleration * k * tick_s, friction_Nm);
  return estimate;
}

void TestFrictionCompensator::reactionObserver_leavesTheLoadThatIsNotFriction() {
  // A ramp of speed is held over ticks: the estimate carries J·a·gT/2 of that.
  const double held = 6e-5 * 300.0 * 200.0 * tick_s * 0.5;
  QVERIFY(std::abs(steadyReaction(0.005, 0.017, 6e-5, 0.0) - 0.005) < 1.1 * held);
  QVERIFY(std::abs(steadyReaction(0.0, 0.017, 6e-5, 0.0)) < 1.1 * held);
}

void TestFrictionCompensator::reactionObserver_takesTheInertiaMismatchOut() {
  const double right = steadyReaction(0.0, 0.0, 8e-5, 2e-5), wrong = steadyReaction(0.0, 0.0, 8e-5, 0.0);
  QVERIFY(std::abs(wrong - 2e-5 * 300.0) < 0.001);
  QVERIFY(std::abs(right) < 0.1 * wrong);
}

QTEST_APPLESS_MAIN(TestFrictionCompensator)
#include "tst_friction_compensator.moc"
