#include <QTest>

#include "experiment/breakaway_tour.h"

using namespace breakaway;

/// The order of a breakaway sweep's steps, and what it makes of an interrupted one.
class TestBreakawayTour : public QObject {
  Q_OBJECT
 private slots:
  void places_comeOneWayAndBack_someTimes();
  void interrupted_goesOnWithWhatIsMissing();
  void farFromItsNeighbours_isAnOutlier();
};

void TestBreakawayTour::places_comeOneWayAndBack_someTimes() {
  BreakawayTour tour(3, 2, {});
  const size_t bins[] = {0, 1, 2, 2, 1, 0, 0, 1, 2, 2, 1, 0};
  for (size_t k = 0; k < 12; ++k) {
    QVERIFY(!tour.ended());
    QCOMPARE(tour.bin(), bins[k]);
    QCOMPARE(tour.way() == Way::ccw, k % 6 < 3);
    QCOMPARE(tour.pass(), k / 6);
    QCOMPARE(tour.oneWay(), k / 3);
    QCOMPARE(tour.progress(), static_cast<double>(k) / 12.0);
    tour.advance();
  }
  QVERIFY(tour.ended());
  QCOMPARE(tour.remaining_s(100.0, 1.0), 0.0);
}

void TestBreakawayTour::interrupted_goesOnWithWhatIsMissing() {
  std::vector<BreakawayEvent> earlier;
  for (const size_t bin : {0, 1}) {
    BreakawayEvent event;
    event.way = Way::ccw;
    event.bin = bin;
    earlier.push_back(event);
  }
  earlier.push_back(earlier.front());  // said twice
  BreakawayEvent other;
  other.way = Way::cw;
  other.bin = 2;
  earlier.push_back(other);
  other.bin = 9;  // no such bin
  earlier.push_back(other);
  BreakawayTour tour(3, 1, earlier);
  QCOMPARE(tour.events().size(), size_t(3));
  QCOMPARE(tour.bin(), size_t(2));
  QVERIFY(tour.way() == Way::ccw);
  tour.advance();  // past the way back's first place, which is done
  QCOMPARE(tour.bin(), size_t(1));
  QVERIFY(tour.way() == Way::cw);
  tour.advance();
  tour.advance();
  QVERIFY(tour.ended());
}

void TestBreakawayTour::farFromItsNeighbours_isAnOutlier() {
  BreakawayTour tour(8, 1, {});
  const double torques[] = {1.0, 9.0, 1.1, 0.9, 1.0, 1.4, 2.0, 1.0};  // by the sixth there are five before it
  for (const double torque : torques) {
    BreakawayEvent event;
    event.torque_Nm = torque;
    tour.take(event);
    tour.advance();
  }
  for (size_t k = 0; k < 8; ++k) QCOMPARE(tour.events()[k].outlier, k == 6);
  // The way back has neighbours of its own.
  BreakawayEvent back;
  back.torque_Nm = -1.0;
  tour.take(back);
  QVERIFY(!tour.events().back().outlier);
  QVERIFY(tour.events().back().way == Way::cw);
}

QTEST_APPLESS_MAIN(TestBreakawayTour)
#include "tst_breakaway_tour.moc"
