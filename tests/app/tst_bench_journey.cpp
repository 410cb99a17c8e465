// The technician's way through the window on the simulated board: connect, tune, home, sweep, export.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QImage>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QSvgRenderer>
#include <QTableWidget>

#include "app/desk.h"
#include "app/rendered_tree.h"
#include "app/technician.h"
#include "base/atomic_file.h"
#include "friction/map_export.h"
#include "pages/tune_page.h"
#include "widgets/figure_chip.h"
#include "widgets/polar_plot.h"
#include "widgets/rail.h"

using namespace breakaway;
using namespace breakaway::test;

class TestBenchJourney : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void connectHomeSweepExport();
  void wiringCheck_saysWhatBelongsTogether();
  void stopDuringSweep_keepsWhatWasMeasured_data();
  void stopDuringSweep_keepsWhatWasMeasured();
  void stoppedSweep_goesOnWhereItEnded();
  void slider_changesTheBoardAndTheStep();
  void positionStep_isMeasuredAsItWasForetold();
  void measuredImprovement_wasForetold();
  void clicks_areAsTheManualCounts();
  void stiffnessButton_tunesAndSaysItsMargins();
  void everyControl_hasAName();
  void disabledControls_sayWhy();
};

void TestBenchJourney::initTestCase() {
  if (qEnvironmentVariableIsEmpty("BREAKAWAY_RESOURCES"))
    qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

void TestBenchJourney::connectHomeSweepExport() {
  Desk desk;
  QCOMPARE(named<QListWidget>(desk.window, "boardList")->currentItem()->text(), QString("servo"));
  QVERIFY(desk.connected());
  QVERIFY(named<QWidget>(desk.window, "simulatedLabel")->isVisible());
  QVERIFY(named<QLabel>(desk.window, "deviceLabel")->text().contains("servo"));
  QVERIFY(desk.homed());
  QVERIFY(named<QLabel>(desk.window, "homingRunActivity")->text().contains("Done"));

  desk.window.showPage("frictionPage");
  named<QDoubleSpinBox>(desk.window, "highestSpeed")->setValue(120.0);
  named<QSpinBox>(desk.window, "speedCount")->setValue(3);
  named<QDoubleSpinBox>(desk.window, "speedDuration")->setValue(4.0);
  press(desk.window, "velocitySweepButton");
  QVERIFY(QTest::qWaitFor([&] { return desk.session.bench.known().knows(Known::runs); }, patience_ms));
  // The preset's friction: Coulomb 17 mNm both ways, viscous 20 µNm s/rad.
  const double coulomb_Nm = desk.session.bench.known().coulombAverage_Nm()->value;
  const double viscous = desk.session.bench.known().viscousAverage_Nm_s_per_rad()->value;
  QVERIFY2(coulomb_Nm > 0.95 * 0.017 && coulomb_Nm < 1.05 * 0.017, qPrintable(QString::number(coulomb_Nm)));
  QVERIFY2(viscous > 0.8 * 2e-5 && viscous < 1.2 * 2e-5, qPrintable(QString::number(viscous)));

  const auto* button = named<QWidget>(desk.window, "exportMapButton");
  const QRect before = placeIn(button, desk.window);
  desk.sweep(12, 2);
  auto* plot = named<PolarPlot>(desk.window, "polarPlot");
  QVERIFY2(desk.mapGrows(), "the map did not grow while the sweep ran");
  QCOMPARE(placeIn(button, desk.window), before);  // what a sweep finds moves nothing
  QCOMPARE(plot->curves().size(), size_t{4});
  QVERIFY(plot->readingAt(plot->pixelOf(plot->curves()[0].points[3])).contains("mNm"));
  for (const char* page : {"frictionPage", "identifyPage"}) {
    desk.window.showPage(page);
    const QStringList cut = clippedWhereSmall(desk.window);
    QVERIFY2(cut.isEmpty(), qPrintable(QString(page) + ": " + cut.join("; ")));
  }
  desk.window.showPage("frictionPage");
  desk.window.resize(1280, 720);
  QTest::qWait(50);
  // What the page is for needs no scrolling.
  const auto* scrolls = named<QScrollArea>(desk.window, "frictionPageSettings");
  const QRect seen = placeIn(scrolls->viewport(), desk.window);
  QVERIFY(seen.contains(placeIn(button, desk.window)));

  QTemporaryDir folder;
  QVERIFY(desk.exported("csv", folder.filePath("map.csv")));
  QVERIFY(desk.exported("json", folder.filePath("map.json")));
  QVERIFY(desk.exported("c-header", folder.filePath("map.h")));
  QVERIFY(desk.exported("png", folder.filePath("map.png")));
  QVERIFY(desk.exported("svg", folder.filePath("map.svg")));
  const auto map = readMap(folder.filePath("map.json").toStdString());
  QVERIFY2(map.ok(), map.ok() ? "" : map.error().message().c_str());
  QCOMPARE(map->bins.size(), size_t{12});
  QCOMPARE(QImage(folder.filePath("map.png")).width(), 1600);
  QVERIFY(QImage(folder.filePath("map.png")).text("made").contains("\"run\""));
  QVERIFY(QSvgRenderer(folder.filePath("map.svg")).isValid());
  QFile svg(folder.filePath("map.svg"));
  QVERIFY(svg.open(QIODevice::ReadOnly) && svg.readAll().contains("<metadata>{\"at\""));
  desk.answers.byTitle["Write the friction report"] = folder.filePath("friction.html");
  desk.window.showPage("reportPage");
  press(desk.window, "writeFrictionReportButton");
  QTRY_VERIFY(QFile(folder.filePath("friction.html")).size() > 5000);
  const auto csv = readFile(folder.filePath("map.csv").toStdString());
  QVERIFY(csv && csv->starts_with("angle_rad,"));
}

void TestBenchJourney::wiringCheck_saysWhatBelongsTogether() {
  Desk desk;
  QVERIFY(desk.connected());
  desk.window.showPage("identifyPage");
  press(desk.window, "wiringButton");
  QVERIFY(QTest::qWaitFor([&] { return desk.session.bench.known().knows(Known::wiring); }, patience_ms));
  QVERIFY(named<QLabel>(desk.window, "identifyRunActivity")->text().contains("Done"));
  QStringList shown;
  for (const QLabel* label : named<QWidget>(desk.window, "wiringFacts")->findChildren<QLabel*>())
    shown << label->text();
  QVERIFY2(shown.filter("count the same way").size() == 1, qPrintable(shown.join(" | ")));
  // What is begun is what comes next, and not what follows it.
  const auto* rail = named<Rail>(desk.window, "steps");
  const auto words = [rail](int row) { return rail->item(row)->data(Qt::AccessibleDescriptionRole).toString(); };
  QCOMPARE(words(1), QString("2 of 7 passed"));
  QCOMPARE(words(2), QString());
}

void TestBenchJourney::stopDuringSweep_keepsWhatWasMeasured_data() {
  QTest::addColumn<int>("key");
  QTest::newRow("button") << 0;
  QTest::newRow("Esc") << static_cast<int>(Qt::Key_Escape);
  QTest::newRow("Space") << static_cast<int>(Qt::Key_Space);
}

void TestBenchJourney::stopDuringSweep_keepsWhatWasMeasured() {
  QFETCH(int, key);
  Desk desk;
  QVERIFY(desk.connected());
  QVERIFY(desk.homed());
  desk.quickSpeeds();
  desk.sweep(48, 2);
  QVERIFY(QTest::qWaitFor([&] { return desk.session.bench.known().knows(Known::runs); }, patience_ms));
  desk.session.connection.setPace(unhurried);
  QVERIFY(QTest::qWaitFor([&] { return desk.session.bench.known().breakaways.size() >= 5; }, patience_ms));
  if (key == 0) {
    press(desk.window, "stopButton");
  } else {
    QTest::keyClick(named<QWidget>(desk.window, "viewTurns"), static_cast<Qt::Key>(key));
  }
  QVERIFY(QTest::qWaitFor([&] { return desk.session.connection.run().status.state == Procedure::State::stopped; },
                          patience_ms));
  QVERIFY(QTest::qWaitFor([&] { return !desk.session.connection.powered(); }, patience_ms));
  QVERIFY(desk.session.bench.known().breakaways.size() >= 5);
  QVERIFY(!desk.session.bench.known().knows(Known::map));
  QVERIFY(!named<PolarPlot>(desk.window, "polarPlot")->curves().empty());
  QVERIFY(named<QLabel>(desk.window, "frictionRunActivity")->text().contains("What was measured is kept"));
  QTemporaryDir folder;
  QVERIFY(desk.exported("breakaways", folder.filePath("breakaways.csv")));
  auto* format = named<QComboBox>(desk.window, "exportFormat");
  format->setCurrentIndex(format->findData("csv"));
  QVERIFY(!named<QWidget>(desk.window, "exportMapButton")->isEnabled());
  QVERIFY(named<QWidget>(desk.window, "exportMapButton")->toolTip().contains("no map yet"));
  // What goes on and what begins are two buttons: neither changes its meaning under the pointer.
  QVERIFY(named<QWidget>(desk.window, "continueSweepButton")->isEnabled());
  QVERIFY(!named<QWidget>(desk.window, "breakawaySweepButton")->isEnabled());
  named<QSpinBox>(desk.window, "bins")->setValue(36);
  QVERIFY(!named<QWidget>(desk.window, "continueSweepButton")->isEnabled());
  QVERIFY(named<QWidget>(desk.window, "breakawaySweepButton")->isEnabled());
}

void TestBenchJourney::stoppedSweep_goesOnWhereItEnded() {
  Desk desk;
  QVERIFY(desk.connected());
  QVERIFY(desk.homed());
  desk.quickSpeeds();
  desk.sweep(48, 2);
  QVERIFY(QTest::qWaitFor([&] { return desk.session.bench.known().knows(Known::runs); }, patience_ms));
  desk.session.connection.setPace(unhurried);
  QVERIFY(QTest::qWaitFor([&] { return desk.session.bench.known().breakaways.size() >= 7; }, patience_ms));
  press(desk.window, "stopButton");
  QVERIFY(QTest::qWaitFor([&] { return desk.session.connection.run().status.state == Procedure::State::stopped; },
                          patience_ms));
  const std::vector<BreakawayEvent> before = desk.session.bench.known().breakaways;
  QVERIFY(before.size() < 180);
  desk.session.connection.setPace(hurried);
  desk.sweep(48, 2);
  QVERIFY(QTest::qWaitFor([&] { return desk.session.bench.known().knows(Known::map); }, patience_ms));
  const auto& events = desk.session.bench.known().breakaways;
  QVERIFY(events.size() + desk.session.bench.known().missed == 192);
  for (size_t k = 0; k < before.size(); ++k) QCOMPARE(events[k].torque_Nm, before[k].torque_Nm);
  QTRY_VERIFY(named<QWidget>(desk.window, "breakawaySweepButton")->isEnabled());
  QVERIFY(!named<QWidget>(desk.window, "continueSweepButton")->isEnabled());  // a second click begins nothing
}

void TestBenchJourney::slider_changesTheBoardAndTheStep() {
  Desk desk;
  QVERIFY(desk.connected());
  desk.window.showPage("tunePage");
  const auto measure = [&](size_t count) {
    press(desk.window, "measureStepButton");
    return QTest::qWaitFor([&] { return desk.session.bench.steps().size() == count; }, patience_ms);
  };
  QVERIFY(measure(1));
  const auto* page = named<TunePage>(desk.window, "tunePage");
  const double kp = desk.session.connection.settings().velocity_kp_A_s_per_rad;
  const double foretoldBefore_s = page->preview().figures.rise_s;
  auto* slider = named<QSlider>(desk.window, "kpSlider");
  slider->setValue(slider->value() - 200);  // a fifth of the way: a quarter of the gain
  QVERIFY(QTest::qWaitFor([&] { return page->preview().figures.rise_s > 1.5 * foretoldBefore_s; }, patience_ms));
  QTest::qWait(100);
  QCOMPARE(desk.session.connection.settings().velocity_kp_A_s_per_rad, kp);  // nothing is sent before Apply
  QCOMPARE(named<QPushButton>(desk.window, "applyButton")->text(), QString("Apply 1 edit"));
  press(desk.window, "undoButton");
  QVERIFY(!named<QWidget>(desk.window, "applyButton")->isEnabled());
  press(desk.window, "redoButton");
  press(desk.window, "applyButton");
  QVERIFY(QTest::qWaitFor([&] { return desk.session.connection.settings().velocity_kp_A_s_per_rad < 0.5 * kp; },
                          patience_ms));
  QVERIFY(measure(2));
  const auto& steps = desk.session.bench.steps();
  QVERIFY2(steps[1].figures.rise_s > 1.5 * steps[0].figures.rise_s, "a quarter of the gain must rise more slowly");
  QCOMPARE(named<QTableWidget>(desk.window, "stepTable")->rowCount(), 3);  // what is foretold, and both
  const QStringList cut = clippedWhereSmall(desk.window);
  QVERIFY2(cut.isEmpty(), qPrintable(cut.join("; ")));
}

void TestBenchJourney::positionStep_isMeasuredAsItWasForetold() {
  Desk desk;
  QVERIFY(desk.connected());
  desk.window.showPage("tunePage");
  const auto* page = named<TunePage>(desk.window, "tunePage");
  press(desk.window, "positionLoopTab");
  QVERIFY(QTest::qWaitFor([&] { return page->preview().figures.rise_s > 0.0; }, patience_ms));
  const double foretold_s = page->preview().figures.rise_s;
  press(desk.window, "measureStepButton");
  const auto& steps = desk.session.bench.steps();
  QVERIFY(QTest::qWaitFor([&] { return !steps.empty(); }, patience_ms));
  QCOMPARE(steps[0].kind, RunKind::positionStep);
  QVERIFY2(steps[0].figures.rise_s > 0.8 * foretold_s && steps[0].figures.rise_s < 1.2 * foretold_s,
           qPrintable(QString("foretold %1 s, measured %2 s").arg(foretold_s).arg(steps[0].figures.rise_s)));
  const auto* table = named<QTableWidget>(desk.window, "stepTable");
  QCOMPARE(table->rowCount(), 2);  // what is foretold, and it
  press(desk.window, "velocityLoopTab");
  QCOMPARE(table->rowCount(), 1);  // it is no step of speed
}

void TestBenchJourney::measuredImprovement_wasForetold() {
  Desk desk;
  QVERIFY(desk.connected());
  desk.window.showPage("identifyPage");
  press(desk.window, "identifyButton");
  QVERIFY(QTest::qWaitFor(
      [&] { return desk.session.bench.known().knows(Known::motor) && !desk.session.connection.run().running(); },
      patience_ms));
  desk.window.showPage("tunePage");
  const auto* page = named<TunePage>(desk.window, "tunePage");
  const auto measure = [&](size_t count) {
    press(desk.window, "measureStepButton");
    return QTest::qWaitFor([&] { return desk.session.bench.steps().size() == count; }, patience_ms);
  };
  const auto tuned = [&](const char* button) {
    press(desk.window, button);
    auto* apply = named<QPushButton>(desk.window, "applyButton");
    if (!QTest::qWaitFor([&] { return apply->isEnabled(); }, patience_ms)) return false;
    QTest::qWait(100);
    press(desk.window, "applyButton");
    return QTest::qWaitFor([&] { return !apply->isEnabled(); }, patience_ms);
  };
  QVERIFY(tuned("tuneSoftButton"));
  QTest::qWait(100);
  const double foretoldSoft_s = page->preview().figures.rise_s;
  QVERIFY(measure(1));
  QVERIFY(tuned("tuneMediumButton"));
  QTest::qWait(100);
  const double foretoldMedium_s = page->preview().figures.rise_s;
  QVERIFY(measure(2));
  const auto& steps = desk.session.bench.steps();
  const double foretold = foretoldMedium_s / foretoldSoft_s,
               measured = steps[1].figures.rise_s / steps[0].figures.rise_s;
  qInfo("rise: soft %.2f ms (foretold %.2f), medium %.2f ms (foretold %.2f)", 1e3 * steps[0].figures.rise_s,
        1e3 * foretoldSoft_s, 1e3 * steps[1].figures.rise_s, 1e3 * foretoldMedium_s);
  QVERIFY(measured < 0.9);
  QVERIFY2(foretold > 0.8 * measured && foretold < 1.2 * measured,
           qPrintable(QString("foretold %1, measured %2").arg(foretold).arg(measured)));
  QVERIFY(foretoldMedium_s > 0.8 * steps[1].figures.rise_s && foretoldMedium_s < 1.2 * steps[1].figures.rise_s);
}

void TestBenchJourney::clicks_areAsTheManualCounts() {
  if (sanitized)
    QSKIP("the whole sweep takes minutes under sanitizers; what is clicked is tested by the other journeys");
  const auto until = [](Desk& desk, const std::function<bool()>& so) {
    return QTest::qWaitFor([&] { return so() && !desk.session.connection.run().running(); }, patience_ms);
  };
  const auto boardTime_s = [](const Desk& desk) { return desk.session.live.history().newest()->time_s; };
  {
    Desk desk;
    Technician hand{desk.window};
    hand.click("connectButton");
    hand.goTo("Home");
    hand.click("homeButton");
    QVERIFY(until(desk, [&] { return desk.session.bench.index_rad().has_value(); }));
    hand.goTo("Friction");
    hand.click("breakawaySweepButton");
    QVERIFY(until(desk, [&] { return desk.session.bench.known().knows(Known::map); }));
    const QTemporaryDir folder;
    desk.answers.byTitle["Export the friction map"] = folder.filePath("map.csv");
    hand.click("exportMapButton");
    QVERIFY(QFile(folder.filePath("map.csv")).size() > 0);
    qInfo("map: %d clicks, %.0f s", hand.clicks, boardTime_s(desk));
    QCOMPARE(hand.clicks, clicksSaid("an exported friction map"));
  }
  Desk desk;
  Technician hand{desk.window};
  hand.click("connectButton");
  hand.goTo("Identify");
  hand.click("identifyButton");
  QVERIFY(until(desk, [&] { return desk.session.bench.known().knows(Known::motor); }));
  hand.goTo("Tune");
  const ControllerSettings before = desk.session.connection.settings();
  hand.click("tuneMediumButton");
  auto* apply = named<QPushButton>(desk.window, "applyButton");
  QVERIFY(until(desk, [&] { return apply->isEnabled(); }));
  QTest::qWait(100);
  hand.click("applyButton");
  QVERIFY(until(desk, [&] { return desk.session.connection.settings() != before; }));
  hand.click("measureStepButton");
  QVERIFY(until(desk, [&] { return desk.session.bench.steps().size() == 1; }));
  qInfo("loop: %d clicks, %.0f s", hand.clicks, boardTime_s(desk));
  QCOMPARE(hand.clicks, clicksSaid("a tuned loop, and its step measured"));
}

void TestBenchJourney::stiffnessButton_tunesAndSaysItsMargins() {
  Desk desk;
  desk.window.showPage("tunePage");
  auto* button = named<QWidget>(desk.window, "tuneStiffButton");
  QVERIFY(!button->isEnabled() && button->toolTip() == "No board is connected");
  desk.window.showPage("connectPage");
  QVERIFY(desk.connected());
  desk.window.showPage("tunePage");
  const auto* phase = named<FigureChip>(desk.window, "phaseMarginChip");
  const auto* page = named<TunePage>(desk.window, "tunePage");
  double last_rad_per_s = 0.0;
  for (const char* name : {"tuneSoftButton", "tuneMediumButton", "tuneStiffButton"}) {
    const ControllerSettings before = desk.session.connection.settings();
    press(desk.window, name);
    auto* apply = named<QPushButton>(desk.window, "applyButton");
    QVERIFY(QTest::qWaitFor([&] { return apply->isEnabled() && button->isEnabled(); }, patience_ms));
    QCOMPARE(desk.session.connection.settings(), before);
    press(desk.window, "applyButton");
    QVERIFY(QTest::qWaitFor([&] { return desk.session.connection.settings() != before; }, patience_ms));
    QVERIFY(desk.session.connection.settings().observer_cutoff_rad_per_s > last_rad_per_s);
    last_rad_per_s = desk.session.connection.settings().observer_cutoff_rad_per_s;
    QTest::qWait(100);
    const double margin_deg = page->preview().margins.phaseMargin_rad * 180.0 / M_PI;
    QCOMPARE(phase->value(), QString("%1°").arg(margin_deg, 0, 'f', 1));
    QCOMPARE(phase->tone(), QString(margin_deg >= 45.0 ? "good" : margin_deg >= 30.0 ? "warning" : "trouble"));
  }
}

void TestBenchJourney::everyControl_hasAName() {
  Desk desk;
  QStringList nameless;
  for (const auto* widget : desk.window.findChildren<QWidget*>()) {
    const bool control = qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QComboBox*>(widget) ||
                         qobject_cast<const QAbstractSpinBox*>(widget) || qobject_cast<const QSlider*>(widget);
    if (!control || widget->objectName().startsWith("qt_") || widget->inherits("QTableCornerButton")) continue;
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    const bool spoken = !widget->accessibleName().isEmpty() || (button && !button->text().isEmpty());
    if (widget->objectName().isEmpty() || !spoken)
      nameless << widget->metaObject()->className() + QString(" ") + widget->objectName();
    if (widget->focusPolicy() == Qt::NoFocus) nameless << widget->objectName() + " cannot be reached by the keyboard";
  }
  QVERIFY2(nameless.isEmpty(), qPrintable(nameless.join(", ")));
}

void TestBenchJourney::disabledControls_sayWhy() {
  Desk desk;
  QStringList silent;
  for (const auto* widget : desk.window.findChildren<QAbstractButton*>()) {
    if (widget->inherits("QTableCornerButton") || widget->objectName().startsWith("qt_")) continue;
    if (!widget->isEnabled() && widget->toolTip().isEmpty()) silent << widget->objectName();
  }
  QVERIFY2(silent.isEmpty(), qPrintable(silent.join(", ")));
}

JOURNEY_MAIN(TestBenchJourney)
#include "tst_bench_journey.moc"
