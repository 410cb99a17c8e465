// What is read off a map's curves: orders of the turn, of the turns of a way together.
#include <QTest>
#include <cmath>
#include <limits>
#include <numbers>

#include "diagnose/verdict/where.h"
#include "widgets/evidence_plot.h"
#include "widgets/map_harmonics.h"

using namespace breakaway;

class TestMapCurves : public QObject {
  Q_OBJECT
 private slots:
  void order_hasItsAmplitude();
  void orders_ofAnUnfinishedTurnAreNotTold();
  void fewAngles_showFewerOrders();
  void turns_areTakenTogether();
  void evidence_isJoinedOnlyBetweenNeighbours();
};

namespace {

/// 20 and a wave of order 3, its amplitude 2, with an offset.
MapCurve turn(int colour, double offset, size_t count = 60) {
  MapCurve curve;
  curve.colour = colour;
  curve.closed = true;
  for (size_t k = 0; k < count; ++k) {
    const double at = 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(count);
    curve.points.push_back({at, 20.0 + offset + 2.0 * std::cos(3.0 * at + 0.4)});
  }
  return curve;
}

}  // namespace

/// Cells of a speed: some next to each other, one far away, one without data.
void TestMapCurves::evidence_isJoinedOnlyBetweenNeighbours() {
  const double none = std::numeric_limits<double>::quiet_NaN();
  ResidualMap map;
  map.centre = {-37.0, -15.0, -12.0, -8.0, -5.0, 6.0, 9.0, 12.0};
  map.mean = {0.1, 0.1, 0.2, none, 0.1, 0.1, 0.1, 0.1};
  const bool joined[] = {false, true, false, false, false, true, true, false};
  for (size_t k = 0; k < map.centre.size(); ++k) QCOMPARE(leadsOn(map, k), joined[k]);
}

void TestMapCurves::order_hasItsAmplitude() {
  const std::vector<double> amplitudes = harmonicsOf(turn(0, 0.0), 12);
  QCOMPARE(amplitudes.size(), size_t{12});
  for (size_t k = 0; k < amplitudes.size(); ++k)
    QVERIFY2(std::abs(amplitudes[k] - (k == 2 ? 2.0 : 0.0)) < 1e-9, qPrintable(QString::number(amplitudes[k])));
}

void TestMapCurves::orders_ofAnUnfinishedTurnAreNotTold() {
  MapCurve half = turn(0, 0.0);
  half.closed = false;
  QVERIFY(harmonicsOf(half, 12).empty());
  QVERIFY(harmonicsOf(turn(0, 0.0, 20), 12).empty());  // fewer than two points an order
}

void TestMapCurves::fewAngles_showFewerOrders() {
  QCOMPARE(ordersShownBy(turn(0, 0.0), 12).size(), size_t{12});
  const std::vector<double> few = ordersShownBy(turn(0, 0.0, 24), 12);
  QCOMPARE(few.size(), size_t{11});
  QVERIFY2(std::abs(few[2] - 2.0) < 1e-9, qPrintable(QString::number(few[2])));
  QVERIFY(ordersShownBy(turn(0, 0.0, 1), 12).empty() && ordersShownBy(MapCurve{}, 12).empty());
}

void TestMapCurves::turns_areTakenTogether() {
  MapCurve unfinished = turn(1, 3.0, 30);
  unfinished.closed = false;
  const auto means = meansByColour({turn(0, -1.0), turn(0, 1.0), turn(1, 0.0), unfinished});
  QCOMPARE(means.size(), size_t{2});
  QCOMPARE(means[0].colour, 0);
  QCOMPARE(means[1].colour, 1);
  QCOMPARE(means[0].points[7].value, turn(0, 0.0).points[7].value);
  QCOMPARE(means[1].points[7].value, turn(1, 0.0).points[7].value);
}

QTEST_APPLESS_MAIN(TestMapCurves)
#include "tst_map_curves.moc"
