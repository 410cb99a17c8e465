#include <QTest>
#include <cmath>

#include "control/board_watch.h"

using namespace breakaway;

class TestBoardWatch : public QObject {
  Q_OBJECT
 private slots:
  void hardMotion_isSilent();
  void hardStop_isNoJump();
  void bounce_isNoJump();
  void slip_isFoundWithItsSize_data();
  void slip_isFoundWithItsSize();
  void overCurrent_tripsAtOnce();
  void supplyDrop_tripsAfterAMoment();
  void standingAtTheLimit_isBlockedAfterItsTime();
  void creepingAtTheLimit_isNotBlocked();
  void fasterThanAsked_tripsSoon_data();
  void fasterThanAsked_tripsSoon();
  void slowingDown_isLeftAlone_data();
  void slowingDown_isLeftAlone();
  void coasting_isGivenTimeToSlowDown();
  void heat_tripsWhenTheWindingHasIt();
  void ripple_isNoContradiction_data();
  void ripple_isNoContradiction();
};

namespace {

using Watch = BoardWatch<double>;
constexpr double tick_s = 2e-4, count_rad = 6.283185307 / 14400.0, acceleration = 14000.0;

Watch::Limits limits() {
  Watch::Limits limits;
  limits.tick_s = tick_s;
  limits.count_rad = count_rad;
  limits.trip_A = 12.0;
  limits.supply_V = 24.0;
  limits.mostAcceleration_rad_per_s2 = acceleration;
  return limits;
}

Watch::Seen sound(double angle_rad = 0.0) {
  return {std::floor(angle_rad / count_rad) * count_rad, 1.0, 1.0, 7.0, 24.0, true};
}

}  // namespace

void TestBoardWatch::hardMotion_isSilent() {
  Watch watch(limits());
  double angle = 0.0, velocity = 0.0;
  for (int k = 0; k < 20000; ++k) {
    velocity += (k / 100 % 2 == 0 ? 1.0 : -1.0) * acceleration * tick_s;  // ± 280 rad/s in 20 ms
    angle += velocity * tick_s;
    QVERIFY(watch.step(sound(angle)) == Trip::none);
  }
}

void TestBoardWatch::hardStop_isNoJump() {
  Watch watch(limits());
  for (int k = 0; k < 2000; ++k) QVERIFY(watch.step(sound(std::min(k, 1000) * 300.0 * tick_s)) == Trip::none);
}

/// A stage of tons that its stop throws back again and again, each time somewhat slower: no current made it turn about.
void TestBoardWatch::bounce_isNoJump() {
  Watch::Limits heavy = limits();
  heavy.mostAcceleration_rad_per_s2 = 10.0;
  for (const double back : {0.3, 0.8, 1.0}) {
    for (const double start : {0.0, 3.31, 7.77}) {
      Watch watch(heavy);
      double angle = start, velocity = 300.0;
      int bounces = 0;
      for (int k = 0; k < 10000; ++k) {
        angle += velocity * tick_s;
        if (angle > 20.0 || angle < 0.0) {  // thrown back within the tick
          angle = angle > 20.0 ? 20.0 - back * (angle - 20.0) : -back * angle;
          velocity *= -back;
          ++bounces;
        }
        const QString place = QString("bounce %1, restitution %2, from %3").arg(bounces).arg(back).arg(start);
        QVERIFY2(watch.step(sound(angle)) == Trip::none, qPrintable(place));
      }
      QVERIFY(bounces > 1);
    }
  }
}

void TestBoardWatch::slip_isFoundWithItsSize_data() {
  QTest::addColumn<double>("counts");
  QTest::addColumn<double>("speed");
  for (const double counts : {10.0, -10.0, 200.0, -200.0, 1000.0, -1000.0}) {
    for (const double speed : {0.0, 5.0, -300.0}) QTest::addRow("%g at %g rad/s", counts, speed) << counts << speed;
  }
}

void TestBoardWatch::slip_isFoundWithItsSize() {
  QFETCH(double, counts);
  QFETCH(double, speed);
  const auto trips = [&](double slip) {
    Watch watch(limits());
    size_t found = 0;
    for (int k = 0; k < 2000; ++k) {
      const Trip trip = watch.step(sound(speed * k * tick_s + (k < 1000 ? 0.0 : slip * count_rad)));
      if (trip == Trip::encoderJump && std::abs(watch.jumped_rad() / count_rad - slip) < 2.0) ++found;
      if (trip != Trip::none && trip != Trip::encoderJump) return size_t{99};
    }
    return found;
  };
  // Against the motion a slip that only brings it to a stand could be a hard stop.
  const bool likeAStop = counts * speed < 0.0 && std::abs(counts) < std::abs(speed) * tick_s / count_rad;
  QCOMPARE(trips(counts), likeAStop ? size_t{0} : size_t{1});
  QCOMPARE(trips(std::copysign(1.0, counts)), size_t{0});
}

void TestBoardWatch::overCurrent_tripsAtOnce() {
  Watch watch(limits());
  QVERIFY(watch.step(sound()) == Trip::none);
  Watch::Seen seen = sound();
  seen.current_A = -12.5;
  QVERIFY(watch.step(seen) == Trip::overCurrent);
  seen.enabled = false;
  QVERIFY(watch.step(seen) == Trip::openSensor);
  seen.current_A = 11.5;
  QVERIFY(watch.step(seen) == Trip::none);
}

void TestBoardWatch::supplyDrop_tripsAfterAMoment() {
  Watch watch(limits());
  Watch::Seen seen = sound();
  seen.supply_V = 18.0;
  int ticks = 0;
  while (watch.step(seen) == Trip::none && ticks < 1000) ++ticks;
  QVERIFY2(ticks >= 24 && ticks <= 26, qPrintable(QString::number(ticks)));
  seen.supply_V = 19.5;
  for (int k = 0; k < 1000; ++k) QVERIFY(watch.step(seen) == Trip::none);
}

void TestBoardWatch::standingAtTheLimit_isBlockedAfterItsTime() {
  Watch watch(limits());
  Watch::Seen seen = sound();
  seen.wanted_A = -6.9;
  int ticks = 0;
  while (watch.step(seen) == Trip::none && ticks < 10000) ++ticks;
  QVERIFY2(ticks >= 4998 && ticks <= 5002, qPrintable(QString::number(ticks)));
  Watch below(limits());
  seen.wanted_A = -5.0;
  for (int k = 0; k < 10000; ++k) QVERIFY(below.step(seen) == Trip::none);
}

void TestBoardWatch::creepingAtTheLimit_isNotBlocked() {
  Watch watch(limits());
  for (int k = 0; k < 20000; ++k) {
    Watch::Seen seen = sound(0.05 * k * tick_s);
    seen.current_A = 6.9;
    QVERIFY(watch.step(seen) == Trip::none);
  }
}

namespace {

/// A motor of 1.2 ohm and 0.07 V s/rad that voltage, current and speed agree on.
struct Turning {
  Watch watch;
  double angle_rad = 0.0, current_A = 0.5;

  static Watch::Limits motorLimits() {
    Watch::Limits own = limits();
    own.resistance_ohm = 1.2;
    own.backEmf_V_s_per_rad = 0.07;
    own.mostVelocity_rad_per_s = 320.0;
    own.continuous_A = 4.0;
    return own;
  }
  Turning() : watch(motorLimits()) {}
  Trip tick(double velocity, bool follows, double asked, double ripple_V = 0.0, bool enabled = true) {
    angle_rad += velocity * tick_s;
    Watch::Seen seen = sound(angle_rad);
    seen.current_A = seen.wanted_A = current_A;
    seen.voltage_V = 1.2 * current_A + 0.07 * velocity + ripple_V;
    seen.velocity_rad_per_s = velocity;
    seen.enabled = enabled;
    seen.follows = follows;
    seen.asked_rad_per_s = asked;
    return watch.step(seen);
  }
};

}  // namespace

void TestBoardWatch::fasterThanAsked_tripsSoon_data() {
  QTest::addColumn<double>("asked");
  QTest::addColumn<double>("speed");
  QTest::newRow("stands by command") << 0.0 << 30.0;
  QTest::newRow("the other way") << 5.0 << -60.0;
  QTest::newRow("twice as fast") << 100.0 << 200.0;
  QTest::newRow("no limit asked for") << 1000.0 << 330.0;
}

/// A motor that comes to its wrong speed within 50 ms is stopped in less than 100 ms.
void TestBoardWatch::fasterThanAsked_tripsSoon() {
  QFETCH(double, asked);
  QFETCH(double, speed);
  Turning motor;
  for (int k = 0; k < 500; ++k) QVERIFY(motor.tick(0.0, true, asked) == Trip::none);
  Trip trip = Trip::none;
  for (int k = 0; k < 500 && trip == Trip::none; ++k) trip = motor.tick(speed * std::min(1.0, k / 250.0), true, asked);
  QVERIFY(trip == Trip::overSpeed);
}

/// With open windings between two speeds, as a zeroing has it; one that is driven on is too fast all the same.
void TestBoardWatch::coasting_isGivenTimeToSlowDown() {
  for (const double slowing : {20.0, 200.0, -2000.0}) {
    Turning motor;
    double speed = -250.0;
    for (int k = 0; k < 500; ++k) QVERIFY(motor.tick(speed, false, 0.0, 0.0, false) == Trip::none);
    Trip trip = Trip::none;
    for (int k = 0; k < 2500 && trip == Trip::none && speed > -310.0; ++k)
      trip = motor.tick(speed = std::min(0.0, speed + slowing * tick_s), true, 5.0);
    QCOMPARE(trip == Trip::overSpeed, slowing < 0.0);
  }
}

void TestBoardWatch::slowingDown_isLeftAlone_data() {
  QTest::addColumn<double>("slowing");
  for (const double slowing : {50.0, 500.0, 5000.0}) QTest::addRow("%.0f rad/s2", slowing) << slowing;
}

void TestBoardWatch::slowingDown_isLeftAlone() {
  QFETCH(double, slowing);
  Turning motor;
  for (int k = 0; k < 2000; ++k) QVERIFY(motor.tick(200.0, true, 200.0) == Trip::none);
  double speed = 200.0;
  for (int k = 0; k < 20; ++k) QVERIFY(motor.tick(speed += 3000.0 * tick_s, true, 2.0) == Trip::none);  // still rising
  for (; speed > 2.0; speed -= slowing * tick_s) QVERIFY(motor.tick(speed, true, 2.0) == Trip::none);
  // What was thrown about in current mode is caught by a speed.
  for (int k = 0; k < 2000; ++k) QVERIFY(motor.tick(300.0 * k / 2000.0, false, 0.0) == Trip::none);
  for (speed = 300.0; speed > 2.0; speed -= slowing * tick_s) QVERIFY(motor.tick(speed, true, 2.0) == Trip::none);
}

/// Twice the current that the winding bears for ever, for ln(4/3) of its 20 s.
void TestBoardWatch::heat_tripsWhenTheWindingHasIt() {
  Turning motor;
  motor.current_A = 4.0;
  for (int k = 0; k < 300000; ++k) QVERIFY(motor.tick(20.0, true, 20.0) == Trip::none);
  Turning hotter;
  hotter.current_A = 8.0;
  int ticks = 0;
  while (ticks < 100000 && hotter.tick(20.0, true, 20.0) == Trip::none) ++ticks;
  QVERIFY2(std::abs(ticks * tick_s - 20.0 * std::log(4.0 / 3.0)) < 0.2, qPrintable(QString::number(ticks * tick_s)));
}

void TestBoardWatch::ripple_isNoContradiction_data() {
  QTest::addColumn<int>("period");
  for (const int period : {2, 4, 8}) QTest::addRow("%d ticks", period) << period;
}

/// A voltage that goes to and fro by two thirds of the supply, too fast for current and speed.
void TestBoardWatch::ripple_isNoContradiction() {
  QFETCH(int, period);
  Turning motor;
  for (int k = 0; k < 5000; ++k) {
    const double ripple_V = k % period < period / 2 ? 16.0 : -16.0;
    QVERIFY2(motor.tick(60.0, true, 60.0, ripple_V) == Trip::none, qPrintable(QString::number(k)));
  }
}

QTEST_APPLESS_MAIN(TestBoardWatch)
#include "tst_board_watch.moc"
