#include <QTest>
#include <cmath>

#include "experiment/compensation.h"
#include "experiment/course.h"

using namespace breakaway;

class TestCourse : public QObject {
  Q_OBJECT
 private slots:
  void course_zeroesHoldsAndRuns();
  void course_keepsEveryTickOfItsOwnTimeOnly();
  void courseWithoutCommand_failsAtOnce();
  void stoppedCourse_keepsWhatItHas();
  void compensation_averagesEachWay();
  void coulombAlone_leavesViscousOut();
  void wholeMap_isTakenBinByBin();
  void largeMap_isGroupedIntoWhatTheBoardHolds();
  void noCompensation_hasNoBins();
};

namespace {

constexpr double tick_s = 1e-3;

CourseOptions pulse() {
  CourseOptions options;
  options.zeroing_s = 0.2;
  options.before = {Command::Mode::velocity, 7.0, 0.0, false};
  options.before_s = 0.5;
  options.duration_s = 0.3;
  options.command = [](double time_s, const Sample& start) {
    return Command{Command::Mode::current, time_s + start.angle_rad, 0.0, false};
  };
  return options;
}

/// A rotor that turns at 7 rad/s whatever it is told.
Sample sampleAt(int k) {
  Sample sample;
  sample.time_s = 5.0 + k * tick_s;
  sample.angle_rad = 7.0 * sample.time_s;
  return sample;
}

FrictionMap wavyMap(size_t bins) {
  FrictionMap map;
  map.bins.resize(bins);
  for (size_t k = 0; k < bins; ++k) {
    for (size_t way = 0; way < 2; ++way) {
      map.bins[k].way[way].coulomb_Nm.value =
          0.01 + 0.001 * static_cast<double>(k % 4) + 0.002 * static_cast<double>(way);
      map.bins[k].way[way].viscous_Nm_s_per_rad.value = 2e-5 + 1e-6 * static_cast<double>(k % 4);
    }
  }
  return map;
}

}  // namespace

void TestCourse::course_zeroesHoldsAndRuns() {
  Course course(pulse());
  int zeroed = 0, held = 0, driven = 0, k = 0;
  for (; course.state() == Procedure::State::running && k < 5000; ++k) {
    const Command command = course.step(sampleAt(k));
    zeroed += command.zeroCurrentSensor && command.mode == Command::Mode::off ? 1 : 0;
    held += command.mode == Command::Mode::velocity && command.target == 7.0 ? 1 : 0;
    driven += command.mode == Command::Mode::current ? 1 : 0;
  }
  QCOMPARE(course.state(), Procedure::State::finished);
  QVERIFY(std::abs(zeroed - 180) <= 2);
  QVERIFY(std::abs(held - 500) <= 2);
  QVERIFY(std::abs(driven - 300) <= 2);
  QVERIFY(std::abs(course.velocityBefore_rad_per_s() - 7.0) < 1e-9);
  QCOMPARE(course.step(sampleAt(k)).mode, Command::Mode::off);
}

void TestCourse::course_keepsEveryTickOfItsOwnTimeOnly() {
  Course course(pulse());
  for (int k = 0; course.state() == Procedure::State::running && k < 5000; ++k) course.step(sampleAt(k));
  QCOMPARE(course.samples().size(), size_t{301});
  QCOMPARE(course.samples().front().time_s, 0.0);
  QVERIFY(std::abs(course.samples().back().time_s - 0.3) < 1e-9);
}

void TestCourse::courseWithoutCommand_failsAtOnce() {
  Course course({});
  QCOMPARE(course.state(), Procedure::State::failed);
  QVERIFY(!course.status().failure.empty());
}

void TestCourse::stoppedCourse_keepsWhatItHas() {
  Course course(pulse());
  for (int k = 0; k < 800; ++k) course.step(sampleAt(k));
  course.stop("STOP was pressed");
  QCOMPARE(course.state(), Procedure::State::stopped);
  QCOMPARE(course.status().failure, std::string("STOP was pressed"));
  QVERIFY(course.samples().size() > 90 && course.samples().size() < 110);
}

void TestCourse::compensation_averagesEachWay() {
  const auto friction = compensationOf(wavyMap(180), CompensatedFriction::coulombAndViscous, 0.4);
  QCOMPARE(friction.coulomb_Nm[0].size(), size_t{1});
  QVERIFY(std::abs(friction.coulomb_Nm[0][0] - 0.0115) < 1e-12);
  QVERIFY(std::abs(friction.coulomb_Nm[1][0] - 0.0135) < 1e-12);
  QVERIFY(std::abs(friction.viscous_Nm_s_per_rad[1][0] - 2.15e-5) < 1e-15);
  QCOMPARE(friction.indexAngle_rad, 0.4);
}

void TestCourse::coulombAlone_leavesViscousOut() {
  const auto friction = compensationOf(wavyMap(180), CompensatedFriction::coulomb, 0.0);
  QVERIFY(std::abs(friction.coulomb_Nm[0][0] - 0.0115) < 1e-12);
  QCOMPARE(friction.viscous_Nm_s_per_rad[0], std::vector<double>{0.0});
}

void TestCourse::wholeMap_isTakenBinByBin() {
  const auto friction = compensationOf(wavyMap(180), CompensatedFriction::map, 0.0);
  QCOMPARE(friction.coulomb_Nm[1].size(), size_t{180});
  QCOMPARE(friction.coulomb_Nm[1][7], 0.01 + 0.001 * 3.0 + 0.002);
}

void TestCourse::largeMap_isGroupedIntoWhatTheBoardHolds() {
  const auto friction = compensationOf(wavyMap(720), CompensatedFriction::map, 0.0, 256);
  QCOMPARE(friction.coulomb_Nm[0].size(), size_t{240});
  double sum = 0.0;
  for (const double one : friction.coulomb_Nm[0]) sum += one / 240.0;
  QVERIFY(std::abs(sum - 0.0115) < 1e-12);
}

void TestCourse::noCompensation_hasNoBins() {
  QVERIFY(compensationOf(wavyMap(36), CompensatedFriction::none, 0.0).coulomb_Nm[0].empty());
  QVERIFY(compensationOf({}, CompensatedFriction::map, 0.0).coulomb_Nm[0].empty());
}

QTEST_APPLESS_MAIN(TestCourse)
#include "tst_course.moc"
