// The technician's way through the window on a simulated linear axis: connect, feel for the ends, home, both sweeps,
// export, and the map against the truth.
#include <QDoubleSpinBox>
#include <QImage>
#include <QListWidget>
#include <QSvgRenderer>
#include <cmath>
#include <utility>

#include "app/desk.h"
#include "base/atomic_file.h"
#include "firmware_link/simulated_truth.h"
#include "friction/map_export.h"
#include "support/linear_rig.h"
#include "support/temporary.h"
#include "widgets/travel_plot.h"
#include "widgets/travel_strip.h"

using namespace breakaway;
using namespace breakaway::test;

class TestLinearJourney : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void connectHomeSweepExport_mapHoldsTheTruth();
  void tunePage_tunesTheAxisAndStepsWithinItsTravel();
  void stop_endsEveryMotion_data();
  void stop_endsEveryMotion();
  void stoppedSweep_goesOnAfterReconnectingAndHomingAnew();
  void anotherBoard_forgetsWhatWasMeasured();
  void axisWithoutIndex_countsFromItsLowerEnd();
};

namespace {

constexpr int placesOfTravel = 24;
constexpr size_t breakaways = 96;   // at each place, each way, two passes
constexpr double axisPace = 120.0;  ///< board seconds per wall second
const std::string uri = "simulated:linear";

/// At the board list's linear preset.
struct LinearDesk : Desk {
  LinearDesk() : Desk(axisPace) {}
  bool connected() {
    auto* list = named<QListWidget>(window, "boardList");
    const auto found = list->findItems("linear", Qt::MatchExactly);
    if (found.isEmpty()) return false;
    window.showPage("connectPage");
    list->setCurrentItem(found.front());
    return Desk::connected();
  }
  void sweepVelocity() {
    window.showPage("frictionPage");
    named<QSpinBox>(window, "bins")->setValue(placesOfTravel);
    named<QSpinBox>(window, "speedCount")->setValue(6);
    named<QDoubleSpinBox>(window, "speedDuration")->setValue(6.0);
    press(window, "velocitySweepButton");
  }
  bool sweptVelocity() {
    sweepVelocity();
    return QTest::qWaitFor(
        [this] { return session.bench.known().knows(Known::runs) && !session.connection.run().running(); },
        patience_ms);
  }
  bool beginsWith(const char* button, const QString& step) {
    auto* found = named<QWidget>(window, button);
    return found->isEnabled() && found->toolTip().contains("First: ") && found->toolTip().contains(step);
  }
  bool waits(const char* button, const QString& reason) {
    auto* found = named<QWidget>(window, button);
    return !found->isEnabled() && found->toolTip().contains(reason);
  }
};

/// RMS error in parts of the mean, the worse way's.
double errorOf(const FrictionMap& map, const FrictionMap& truth, Estimate WayBin::*curve) {
  double worst = 0.0;
  for (size_t w = 0; w < 2; ++w) {
    double squares = 0.0, sum = 0.0;
    for (size_t k = 0; k < map.bins.size(); ++k) {
      const double right = (truth.bins[k].way[w].*curve).value;
      squares += std::pow((map.bins[k].way[w].*curve).value - right, 2);
      sum += right;
    }
    worst = std::max(worst, std::sqrt(squares * static_cast<double>(map.bins.size())) / sum);
  }
  return worst;
}

}  // namespace

void TestLinearJourney::initTestCase() {
  if (qEnvironmentVariableIsEmpty("BREAKAWAY_RESOURCES"))
    qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

void TestLinearJourney::connectHomeSweepExport_mapHoldsTheTruth() {
  LinearDesk desk;
  QVERIFY(desk.connected());
  QVERIFY(!desk.session.connection.powered() && !desk.session.connection.run().running());
  QVERIFY(desk.waits("turnButton", "ends of the travel are not known"));
  QVERIFY(desk.waits("saveProfileButton", "linear axis"));
  desk.window.showPage("frictionPage");
  QVERIFY(desk.beginsWith("velocitySweepButton", "homing"));
  QVERIFY(desk.beginsWith("breakawaySweepButton", "homing, velocity sweep"));

  QVERIFY(desk.homed());
  QVERIFY(named<QWidget>(*named<QWidget>(desk.window, "homePage"), "travelStrip")->isVisible());
  const Commission& known = desk.session.bench.known();
  QVERIFY(desk.session.bench.axisIsHomed());
  QVERIFY(std::abs(known.counted.high_m - known.counted.low_m - 0.4) < 5e-4);
  QVERIFY(std::abs(known.indexAngle_rad.value - (0.21 - 0.13)) < 2e-5);
  QVERIFY(std::abs(known.motor.inertia_kg_m2.value / 1.8 - 1.0) < 0.02);
  QVERIFY(named<QLabel>(desk.window, "homingRunActivity")->text().contains("Done"));

  desk.window.showPage("frictionPage");
  QVERIFY(!desk.beginsWith("velocitySweepButton", "homing"));
  QVERIFY(desk.beginsWith("breakawaySweepButton", "velocity sweep"));
  QVERIFY(named<QDoubleSpinBox>(desk.window, "highestSpeed")->suffix() == " m/s");
  QVERIFY(desk.sweptVelocity());
  const double coulomb_N = desk.session.bench.known().coulombAverage_Nm()->value;
  QVERIFY2(coulomb_N > 0.97 * 4.95 && coulomb_N < 1.03 * 4.95, qPrintable(QString::number(coulomb_N)));
  auto* plot = named<TravelPlot>(desk.window, "travelPlot");
  QVERIFY(plot->isVisible());
  QCOMPARE(plot->curves().size(), size_t{2});  // Coulomb friction both ways, before there is a breakaway
  QVERIFY(plot->readingAt(plot->pixelOf(plot->curves()[0].points[3])).contains("(95 %)"));

  named<QSpinBox>(desk.window, "bins")->setValue(placesOfTravel + 1);
  QVERIFY(desk.beginsWith("breakawaySweepButton", "velocity sweep"));  // strokes were taken apart into other places
  named<QSpinBox>(desk.window, "bins")->setValue(placesOfTravel);
  QVERIFY(!desk.beginsWith("breakawaySweepButton", "velocity sweep"));
  desk.sweep(placesOfTravel, 2);
  QVERIFY2(desk.mapGrows(), "the map did not grow while the sweep ran");
  press(desk.window, "viewTurns");
  QCOMPARE(plot->curves().size(), size_t{4});
  const QString reading = plot->readingAt(plot->pixelOf(plot->curves()[0].points[3]));
  QVERIFY2(reading.contains(" mm: ") && reading.contains(" N"), qPrintable(reading));

  QTemporaryDir folder;
  for (const auto& [format, name] :
       {std::pair{"csv", "map.csv"}, std::pair{"json", "map.json"}, std::pair{"mat", "map.mat"},
        std::pair{"c-header", "map.h"}, std::pair{"png", "map.png"}, std::pair{"svg", "map.svg"},
        std::pair{"breakaways", "breakaways.csv"}})
    QVERIFY2(desk.exported(format, folder.filePath(name)), format);
  const auto csv = readFile(folder.filePath("map.csv").toStdString());
  QVERIFY(csv && csv->starts_with("position_m,"));
  const auto events = readFile(folder.filePath("breakaways.csv").toStdString());
  QVERIFY(events && events->starts_with("position_m,way,pass,"));
  QCOMPARE(QImage(folder.filePath("map.png")).width(), 2000);
  QVERIFY(QSvgRenderer(folder.filePath("map.svg")).isValid());
  desk.answers.byTitle["Write the friction report"] = folder.filePath("friction.html");
  desk.window.showPage("reportPage");
  press(desk.window, "writeFrictionReportButton");
  QTRY_VERIFY(QFile::exists(folder.filePath("friction.html")));
  const auto report = readFile(folder.filePath("friction.html").toStdString());
  QVERIFY(report && report->find("over the travel") != std::string::npos && report->find("mNm") == std::string::npos);

  const auto map = readMap(folder.filePath("map.json").toStdString());
  QVERIFY2(map.ok(), map.ok() ? "" : map.error().message().c_str());
  QVERIFY(map->axis == Axis::linear);
  QCOMPARE(map->bins.size(), size_t{placesOfTravel});
  const auto truth = trueMap(uri, *map);
  QVERIFY(truth.ok());
  const double breakaway = errorOf(*map, *truth, &WayBin::static_Nm),
               coulomb = errorOf(*map, *truth, &WayBin::coulomb_Nm),
               viscous = errorOf(*map, *truth, &WayBin::viscous_Nm_s_per_rad);
  qInfo("errors: breakaway %.2f %%, Coulomb %.2f %%, viscous %.2f %%", 1e2 * breakaway, 1e2 * coulomb, 1e2 * viscous);
  QVERIFY(breakaway > 0.0 && breakaway < 0.03);
  QVERIFY(coulomb > 0.0 && coulomb < 0.03);
  QVERIFY(viscous > 0.0 && viscous < 0.08);
}

void TestLinearJourney::tunePage_tunesTheAxisAndStepsWithinItsTravel() {
  LinearDesk desk;
  QVERIFY(desk.connected());
  desk.window.showPage("tunePage");
  QVERIFY(desk.waits("measureStepButton", "Home first"));
  QVERIFY(desk.homed());
  desk.window.showPage("tunePage");
  const ControllerSettings before = desk.session.connection.settings();
  press(desk.window, "tuneMediumButton");
  QVERIFY(QTest::qWaitFor([&] { return named<QWidget>(desk.window, "applyButton")->isEnabled(); }, patience_ms));
  press(desk.window, "applyButton");
  QVERIFY(QTest::qWaitFor([&] { return desk.session.connection.settings() != before; }, patience_ms));
  const double bandwidth = desk.session.connection.settings().velocity_kp_A_s_per_rad * 14.0 / 1.8;
  QVERIFY2(bandwidth > 20.0 && bandwidth < 200.0, qPrintable(QString::number(bandwidth)));
  auto* height = named<QDoubleSpinBox>(desk.window, "stepHeight");
  QVERIFY(height->suffix() == " m/s" && height->maximum() < 1.0);
  height->setValue(height->maximum());
  press(desk.window, "measureStepButton");
  QVERIFY(QTest::qWaitFor([&] { return desk.session.bench.steps().size() == 1; }, patience_ms));
  const StepFigures& figures = desk.session.bench.steps().front().figures;
  QVERIFY2(figures.rise_s > 0.005 && figures.rise_s < 0.3, qPrintable(QString::number(figures.rise_s)));
  QVERIFY(QTest::qWaitFor([&] { return !desk.session.connection.powered(); }, patience_ms));
  QTest::qWait(100);  // it coasts
  const double stands_m = desk.session.live.history().newest()->angle_rad;
  const Travel travel = desk.session.bench.known().counted;
  QVERIFY2(stands_m > travel.middle_m() && stands_m < travel.last_m() + 0.5 * travel.margin_m,
           qPrintable(QString::number(stands_m)));
}

void TestLinearJourney::stop_endsEveryMotion_data() {
  QTest::addColumn<QString>("activity");
  const std::pair<const char*, const char*> rows[] = {{"ends", "end"},
                                                      {"winding test", "raising the voltage"},
                                                      {"strokes by voltage", "by voltage"},
                                                      {"index", "index"},
                                                      {"velocity sweep", ""},
                                                      {"to and fro", "to and fro slowly"}};
  size_t row = 0;
  for (const auto& [motion, activity] : rows) {
    if (alsoRun(row++, 2)) QTest::newRow(motion) << activity;
  }
}

void TestLinearJourney::stop_endsEveryMotion() {
  QFETCH(QString, activity);
  LinearDesk desk;
  QVERIFY(desk.connected());
  const QString row = QTest::currentDataTag();
  const bool onKnownAxis = row == "velocity sweep" || row == "to and fro" || row == "index";
  if (onKnownAxis) QVERIFY(desk.homed());
  desk.session.connection.setPace(unhurried);
  if (row == "velocity sweep" || row == "to and fro") {
    if (row == "velocity sweep") {
      desk.sweepVelocity();
    } else {
      desk.window.showPage("connectPage");
      press(desk.window, "turnButton");
    }
  } else {
    desk.window.showPage("homePage");
    press(desk.window, "homeButton");
  }
  QVERIFY(QTest::qWaitFor(
      [&] {
        const auto& run = desk.session.connection.run();
        return run.running() && desk.session.connection.powered() &&
               QString::fromStdString(run.status.activity).contains(activity);
      },
      patience_ms));
  press(desk.window, "stopButton");
  QVERIFY(QTest::qWaitFor([&] { return !desk.session.connection.run().running(); }, patience_ms));
  QCOMPARE(desk.session.connection.run().status.state, Procedure::State::stopped);
  QVERIFY(QTest::qWaitFor([&] { return !desk.session.connection.powered(); }, patience_ms));
  QVERIFY(desk.session.connection.obstacle().isEmpty());
}

void TestLinearJourney::stoppedSweep_goesOnAfterReconnectingAndHomingAnew() {
  LinearDesk desk;
  QVERIFY(desk.connected());
  QVERIFY(desk.homed());
  QVERIFY(desk.sweptVelocity());
  desk.session.connection.setPace(unhurried);
  desk.sweep(placesOfTravel, 2);
  QVERIFY(QTest::qWaitFor([&] { return desk.session.bench.known().breakaways.size() >= 6; }, patience_ms));
  press(desk.window, "stopButton");
  QVERIFY(QTest::qWaitFor([&] { return desk.session.connection.run().status.state == Procedure::State::stopped; },
                          patience_ms));
  const std::vector<BreakawayEvent> before = desk.session.bench.known().breakaways;
  QVERIFY(before.size() < breakaways);
  desk.window.showPage("connectPage");
  press(desk.window, "disconnectButton");
  desk.session.connection.setPace(axisPace);
  QVERIFY(desk.connected());
  QVERIFY(desk.homed());
  desk.sweep(placesOfTravel, 2);
  QVERIFY(QTest::qWaitFor([&] { return desk.session.bench.known().knows(Known::map); }, patience_ms));
  const auto& events = desk.session.bench.known().breakaways;
  QCOMPARE(events.size() + desk.session.bench.known().missed, breakaways);
  for (size_t k = 0; k < before.size(); ++k) QCOMPARE(events[k].torque_Nm, before[k].torque_Nm);
}

void TestLinearJourney::anotherBoard_forgetsWhatWasMeasured() {
  LinearDesk desk;
  QVERIFY(desk.connected());
  QVERIFY(desk.homed());
  QVERIFY(desk.session.bench.known().knows(Known::motor));
  desk.session.connection.open("simulated:servo");
  QVERIFY(desk.session.connection.connected());
  QVERIFY(!desk.session.bench.known().knows(Known::motor) && !desk.session.bench.known().travel);
  desk.window.showPage("homePage");
  QVERIFY(named<QWidget>(*named<QWidget>(desk.window, "homePage"), "rotorDial")->isVisible());
}

void TestLinearJourney::axisWithoutIndex_countsFromItsLowerEnd() {
  LinearAxis axis;
  axis.length_m = 0.12;
  axis.hasIndex = false;
  const TemporaryFolder folder;
  LinearDesk desk;
  desk.session.connection.open(
      QString::fromStdString("simulated:" + folder.write("axis.rig.json", linearRigText(axis, 7))));
  QVERIFY(desk.session.connection.connected());
  desk.window.showPage("homePage");
  QVERIFY(named<QLabel>(desk.window, "homingPlan")->text().contains("no index"));
  QVERIFY(desk.homed());
  const Commission& known = desk.session.bench.known();
  QVERIFY(std::abs(known.indexAngle_rad.value - known.counted.low_m) < 1e-9);
  desk.window.showPage("frictionPage");
  QVERIFY(named<QWidget>(desk.window, "velocitySweepButton")->isEnabled());
}

JOURNEY_MAIN(TestLinearJourney)
#include "tst_linear_journey.moc"
