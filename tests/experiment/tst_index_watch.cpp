#include <QTest>
#include <cmath>
#include <numbers>

#include "experiment/index_watch.h"

using namespace breakaway;

class TestIndexWatch : public QObject {
  Q_OBJECT
 private slots:
  void soundIndex_isSilentAtAnySpeedAndWay_data();
  void soundIndex_isSilentAtAnySpeedAndWay();
  void lostCounts_areFoundAtTheNextIndex_data();
  void lostCounts_areFoundAtTheNextIndex();
  void missingIndex_isFoundWhereItShouldCome();
  void rotorAroundTheIndex_isSilent();
  void withoutTolerance_watchesNothing();
};

namespace {

constexpr double turn = 2.0 * std::numbers::pi, index_rad = 1.3, tick_s = 1e-3;

/// Turns at `speed` for `turns`; from half the time on the angle is shown `slip_rad` further. The first words.
std::string watched(double speed, double turns, double slip_rad, bool hasIndex, double tolerance_rad = 0.01) {
  IndexWatch watch(index_rad + 4.0 * turn, tolerance_rad);
  double before = 0.3;
  const int ticks = static_cast<int>(turns * turn / std::abs(speed) / tick_s);
  for (int k = 0; k < ticks; ++k) {
    const double angle = 0.3 + speed * k * tick_s;
    Sample sample;
    sample.angle_rad = angle + (2 * k > ticks ? slip_rad : 0.0);
    sample.index = hasIndex && std::floor((angle - index_rad) / turn) != std::floor((before - index_rad) / turn);
    before = angle;
    if (std::string words = watch.step(sample); !words.empty()) return words;
  }
  return {};
}

}  // namespace

void TestIndexWatch::soundIndex_isSilentAtAnySpeedAndWay_data() {
  QTest::addColumn<double>("speed");
  for (const double speed : {0.5, -0.5, 20.0, -20.0, 400.0, -400.0}) QTest::addRow("%g rad/s", speed) << speed;
}

void TestIndexWatch::soundIndex_isSilentAtAnySpeedAndWay() {
  QFETCH(double, speed);
  QCOMPARE(watched(speed, 6.0, 0.0, true), std::string());
}

void TestIndexWatch::lostCounts_areFoundAtTheNextIndex_data() {
  soundIndex_isSilentAtAnySpeedAndWay_data();
}

void TestIndexWatch::lostCounts_areFoundAtTheNextIndex() {
  QFETCH(double, speed);
  const double slip_rad = 0.02 + 1.5 * std::abs(speed) * tick_s;
  const std::string words = watched(speed, 6.0, slip_rad, true);
  QVERIFY2(words.starts_with("the index"), words.c_str());
  QCOMPARE(watched(speed, 6.0, 0.005, true), std::string());
}

void TestIndexWatch::missingIndex_isFoundWhereItShouldCome() {
  QVERIFY(watched(20.0, 1.0, 0.0, false).starts_with("the index did not come"));
  QVERIFY(watched(-20.0, 1.0, 0.0, false).starts_with("the index did not come"));
  QCOMPARE(watched(20.0, 0.1, 0.0, false), std::string());
}

void TestIndexWatch::rotorAroundTheIndex_isSilent() {
  IndexWatch watch(index_rad, 0.01);
  double before = 0.0;
  for (int k = 0; k < 20000; ++k) {
    const double angle = index_rad + 0.05 * std::sin(1e-2 * k) + 0.003 * std::sin(0.37 * k);
    Sample sample;
    sample.angle_rad = angle;
    sample.index = k > 0 && (angle < index_rad) != (before < index_rad);
    before = angle;
    QCOMPARE(watch.step(sample), std::string());
  }
}

void TestIndexWatch::withoutTolerance_watchesNothing() {
  QCOMPARE(watched(20.0, 6.0, 1.0, true, 0.0), std::string());
}

QTEST_APPLESS_MAIN(TestIndexWatch)
#include "tst_index_watch.moc"
