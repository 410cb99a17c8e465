#include <QTest>
#include <cmath>

#include "control/board_watch.h"

using namespace breakaway;

class TestBoardWatch : public QObject {
  Q_OBJECT
 private slots:
  void hardMotion_isSilent();
  void hardStop_isNoJump();
  void slip_isFoundWithItsSize_data();
  void slip_isFoundWithItsSize();
  void overCurrent_tripsAtOnce();
  void supplyDrop_tripsAfterAMoment();
  void standingAtTheLimit_isBlockedAfterItsTime();
  void creepingAtTheLimit_isNotBlocked();
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

void TestBoardWatch::slip_isFoundWithItsSize_data() {
  QTest::addColumn<double>("counts");
  QTest::addColumn<double>("speed");
  for (const double counts : {10.0, -10.0, 1000.0, -1000.0}) {
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

QTEST_APPLESS_MAIN(TestBoardWatch)
#include "tst_board_watch.moc"
