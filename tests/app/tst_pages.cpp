// What single pages show: Friction's circle in its room, Tune's two loops, Connect's presets in words.
#include <qcustomplot.h>

#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <cmath>

#include "app/desk.h"
#include "app/rendered_tree.h"
#include "app/spoken.h"
#include "firmware_link/presets.h"
#include "pages/tune_page.h"
#include "session/settings_edits.h"
#include "support/temporary.h"
#include "widgets/board_list.h"
#include "widgets/facts_table.h"
#include "widgets/file_chooser.h"
#include "widgets/live_plots.h"
#include "widgets/step_plot.h"

using namespace breakaway;
using namespace breakaway::test;

class TestPages : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void circleOfFriction_isAsLargeAsItsPlaceIsHigh_data();
  void circleOfFriction_isAsLargeAsItsPlaceIsHigh();
  void positionLoop_hasItsOwnGainsAndStep();
  void emptyCards_sayWhatFillsThem();
  void connected_leadsOnByAClick();
  void withoutABoard_eachAnswerIsTriedByAClick();
  void tune_keepsInSightWhatTheBoardHas();
  void identify_showsEachStep();
  void parameters_leaveEveryPageItsWidth_data();
  void parameters_leaveEveryPageItsWidth();
  void facts_takeAnotherLineWhereTheyHaveNoRoom();
  void cursors_tellTheirDifferenceWhole();
  void identify_keepsItsPlacesWhateverIsKnown();
  void questionForAFile_isAskedOnce();
  void presets_sayWhatTheyAre();
  void stepsOfTuning_areNamedWhole_data();
  void stepsOfTuning_areNamedWhole();
  void parameters_leaveTuneItsStepOnASmallScreen_data();
  void parameters_leaveTuneItsStepOnASmallScreen();
};

void TestPages::initTestCase() {
  if (qEnvironmentVariableIsEmpty("BREAKAWAY_RESOURCES"))
    qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

void TestPages::circleOfFriction_isAsLargeAsItsPlaceIsHigh_data() {
  QTest::addColumn<QSize>("size");
  QTest::addColumn<int>("square");
  QTest::addColumn<int>("circle");
  QTest::newRow("1280×720") << QSize(1280, 720) << 490 << 445;
  QTest::newRow("1280×800") << QSize(1280, 800) << 520 << 465;
  QTest::newRow("1366×768") << QSize(1366, 768) << 520 << 490;
  QTest::newRow("1920×1080") << QSize(1920, 1080) << 840 << 790;
}

void TestPages::circleOfFriction_isAsLargeAsItsPlaceIsHigh() {
  QFETCH(QSize, size);
  QFETCH(int, square);
  QFETCH(int, circle);
  Desk desk;
  desk.window.resize(size);
  desk.window.showPage("frictionPage");
  QTest::qWait(20);
  const auto* polar = named<QWidget>(desk.window, "polarPlot");
  const QSize place = polar->parentWidget()->size();
  QVERIFY2(std::min(place.width(), place.height()) >= square,
           qPrintable(QString("%1×%2").arg(place.width()).arg(place.height())));
  const auto* angular =
      qobject_cast<QCPPolarAxisAngular*>(polar->findChild<QCustomPlot*>()->plotLayout()->element(0, 0));
  QVERIFY2(2.0 * angular->radius() >= circle, qPrintable(QString::number(2.0 * angular->radius())));
  QVERIFY(named<QWidget>(desk.window, "twinPlot")->width() >= 170);
}

void TestPages::questionForAFile_isAskedOnce() {
  QWidget window;
  FileDialogs files;
  const FileQuestion question{"Export the friction map", "Map (*.csv)", "map.csv", true};
  for (int k = 0; k < 3; ++k) files.ask(&window, question, [](const QString&) {});
  QCOMPARE(window.findChildren<QFileDialog*>().size(), 1);
  files.ask(&window, {"Save the last recording", "Recording (*.csv)", "recording.csv", true}, [](const QString&) {});
  QCOMPARE(window.findChildren<QFileDialog*>().size(), 2);
}

void TestPages::emptyCards_sayWhatFillsThem() {
  Desk desk;
  desk.window.showPage("frictionPage");
  QTest::qWait(1);
  for (const char* hint : {"twinHint", "harmonicsHint"}) {
    const auto* words = named<QLabel>(desk.window, hint);
    QVERIFY(words->isVisible() && !words->text().isEmpty());
    QVERIFY2(words->heightForWidth(words->width()) <= words->height(), hint);
  }
  // Before there is a finding nothing is said of unticking one.
  desk.window.showPage("comparePage");
  QTest::qWait(1);
  QVERIFY(!named<QLabel>(desk.window, "tickedLine")->isVisible());
  QVERIFY(!named<QLabel>(desk.window, "verdictFigure")->isVisible());
  // What will be found stands there before it is known.
  QCOMPARE(named<FactsTable>(desk.window, "motorFacts")->value("Resistance"), QString("–"));
}

void TestPages::cursors_tellTheirDifferenceWhole() {
  Desk desk;
  desk.window.resize(1280, 720);
  QVERIFY(desk.connected());
  desk.window.showPage("handPage");
  desk.window.showLive(true);
  QTest::qWait(300);
  auto* plots = named<LivePlots>(desk.window, "livePlots");
  plots->setPaused(true);
  plots->showCursors(true);
  const auto* words = named<QLabel>(desk.window, "cursorDifference");
  QTRY_VERIFY(words->isVisible() && words->text().startsWith("Δt"));
  for (const QSize size : {QSize(1280, 720), QSize(1920, 1080)}) {
    desk.window.resize(size);
    QTest::qWait(30);
    const QStringList shorter = shortened(*words->parentWidget());
    QVERIFY2(shorter.isEmpty(), qPrintable(shorter.join("; ")));
    QVERIFY2(words->text().contains("A ") && words->text().contains("B "), qPrintable(words->text()));  // its tooltip
  }
}

void TestPages::identify_keepsItsPlacesWhateverIsKnown() {
  Desk desk;
  desk.window.resize(1280, 720);
  desk.window.showPage("identifyPage");
  QTest::qWait(20);
  const auto places = [&desk] {
    return std::pair(placeIn(named<QWidget>(desk.window, "motorTestsPlot"), desk.window),
                     placeIn(named<QWidget>(desk.window, "identifyFacts"), desk.window));
  };
  const auto before = places();
  named<FactsTable>(desk.window, "wiringFacts")
      ->show(std::vector<Fact>(5, {"Current sensor",
                                   "rises with the voltage, by 1 A for 1.2 V; its zero was off by "
                                   "51 mA, its noise is 17 mA rms",
                                   {}}));
  QTest::qWait(20);
  QCOMPARE(places(), before);
}

void TestPages::withoutABoard_eachAnswerIsTriedByAClick() {
  for (const char* name : {"Friction", "Tune", "Compare"}) {
    Desk desk;
    const auto* welcome = named<QWidget>(desk.window, "welcomeCard");
    const auto* identity = named<QWidget>(desk.window, "identityTable");
    QVERIFY(welcome->isVisible() && !identity->isVisible());
    const QStringList cut = clippedWhereSmall(desk.window);
    QVERIFY2(cut.isEmpty(), qPrintable(cut.join("; ")));
    press(desk.window, qPrintable(QString("try%1Button").arg(name)));
    const bool needsBoard = qstrcmp(name, "Compare") != 0;
    QTRY_COMPARE(desk.session.connection.connected(), needsBoard);
    QVERIFY(named<QWidget>(desk.window, qPrintable(QString(name).toLower() + "Page"))->isVisible());
    QVERIFY(!desk.session.connection.run().running());
    desk.window.showPage("connectPage");
    QCOMPARE(welcome->isVisible(), !needsBoard);
    QCOMPARE(identity->isVisible(), needsBoard);
  }
}

/// Another gain: the step that the board's own makes stays where it was, until the edit is taken back.
void TestPages::tune_keepsInSightWhatTheBoardHas() {
  Desk desk;
  QVERIFY(desk.connected());
  desk.window.showPage("tunePage");
  const auto* plot = named<StepPlot>(desk.window, "stepPlot");
  QTRY_VERIFY(!plot->foretold().time_s.empty());
  QVERIFY(plot->onBoard().time_s.empty());
  const auto before = plot->foretold().velocity_rad_per_s;
  named<QDoubleSpinBox>(desk.window, "kpBox")->setValue(0.1);
  QTRY_COMPARE(plot->onBoard().velocity_rad_per_s, before);
  QVERIFY(plot->foretold().velocity_rad_per_s != before);
  press(desk.window, "revertButton");
  QTRY_VERIFY(plot->onBoard().time_s.empty());
}

void TestPages::connected_leadsOnByAClick() {
  Desk desk;
  QVERIFY(desk.connected());
  desk.window.showPage("connectPage");
  auto* state = named<QLabel>(desk.window, "connectionState");
  QVERIFY2(state->text().contains("href='identifyPage'"), qPrintable(state->text()));
  emit state->linkActivated("frictionPage");
  QVERIFY(named<QWidget>(desk.window, "frictionPage")->isVisible());
  // One button at the head is to be pressed: before there is a board to connect, then to go on.
  desk.window.showPage("connectPage");
  const auto isPrimary = [&desk](const char* name) {
    return named<QPushButton>(desk.window, name)->property("role").toString() == "primary";
  };
  QVERIFY(isPrimary("goOnButton") && !isPrimary("connectButton"));
  press(desk.window, "goOnButton");
  QVERIFY(named<QWidget>(desk.window, "identifyPage")->isVisible());
  desk.window.showPage("connectPage");
  press(desk.window, "disconnectButton");
  QTRY_VERIFY(!desk.session.connection.connected());
  QVERIFY(!isPrimary("goOnButton") && isPrimary("connectButton"));
  QVERIFY(!named<QPushButton>(desk.window, "goOnButton")->isEnabled());
}

/// The identified motor's own tests, drawn one by one; what was done names what comes next.
void TestPages::identify_showsEachStep() {
  Desk desk;
  desk.window.resize(1280, 720);
  QVERIFY(desk.connected());
  desk.window.showPage("identifyPage");
  const auto chip = [&desk](const char* name) { return named<QPushButton>(desk.window, name); };
  QVERIFY(!chip("testsOfReversal")->isEnabled() && !chip("testsOfReversal")->toolTip().isEmpty());
  press(desk.window, "identifyButton");
  QVERIFY(QTest::qWaitFor(
      [&desk] { return desk.session.bench.known().knows(Known::motor) && !desk.session.connection.run().running(); },
      patience_ms));
  auto* plot = named<QWidget>(desk.window, "motorTestsPlot")->findChild<QCustomPlot*>();
  const auto titles = [plot] {
    QStringList found;
    for (int k = 0; k < plot->plotLayout()->elementCount(); ++k) {
      if (const auto* one = qobject_cast<QCPTextElement*>(plot->plotLayout()->elementAt(k))) found << one->text();
    }
    return found.join(" | ");
  };
  QVERIFY2(titles().contains("back-EMF"), qPrintable(titles()));
  for (const auto& [name, title] :
       {std::pair{"testsOfWinding", "mA"}, {"testsOfSpin", "back-EMF"}, {"testsOfReversal", "Current (A) over time"}}) {
    press(desk.window, name);
    QVERIFY2(chip(name)->isChecked() && titles().contains(title), qPrintable(titles()));
    QVERIFY(plot->graph(0)->dataCount() > 50 && plot->graph(2)->dataCount() > 50);
  }
  // The speed that inertia, friction and current foretell between reversals is the measured one.
  const auto measured = plot->graph(0)->data(), foretold = plot->graph(1)->data();
  double off = 0.0, size = 0.0;
  for (const auto& point : *foretold) {
    const auto at = measured->findBegin(point.key, false);
    if (at == measured->constEnd() || std::isnan(point.value) || std::isnan(at->value)) continue;
    off += (point.value - at->value) * (point.value - at->value);
    size += at->value * at->value;
  }
  QVERIFY2(size > 0.0 && std::sqrt(off / size) < 0.1, qPrintable(QString::number(std::sqrt(off / size))));
  auto* said = named<QLabel>(desk.window, "identifyRunActivity");
  QVERIFY2(said->text().contains("href='tunePage'"), qPrintable(said->text()));
  emit said->linkActivated("tunePage");
  QVERIFY(named<QWidget>(desk.window, "tunePage")->isVisible());
}

/// Beside the board's settings pages scroll downwards alone, and the settings' rows are as high as their names.
void TestPages::parameters_leaveEveryPageItsWidth_data() {
  QTest::addColumn<bool>("german");
  QTest::newRow("English") << false;
  QTest::newRow("German") << true;
}

void TestPages::parameters_leaveEveryPageItsWidth() {
  QFETCH(bool, german);
  const Spoken language(german ? Language::german : Language::english);
  Desk desk;
  desk.window.resize(1280, 720);
  QVERIFY(desk.connected());
  ControllerSettings other = desk.session.edits.accepted();
  other.velocity_ki_A_per_rad = 0.5;
  desk.session.edits.edit(other);  // while the table isn't seen
  desk.window.showParameters(true);
  QTest::qWait(30);
  const auto* table = named<QTableWidget>(desk.window, "parametersTable");
  for (int row = 0; row < table->rowCount(); ++row)
    QVERIFY2(table->rowHeight(row) < 48, qPrintable(QString("%1: %2").arg(row).arg(table->rowHeight(row))));
  const auto* room = named<QScrollArea>(desk.window, "pageRoom");
  for (const char* page : {"connectPage", "identifyPage", "tunePage", "homePage", "frictionPage", "comparePage",
                           "reportPage", "handPage", "runsPage"}) {
    desk.window.showPage(page);
    QTest::qWait(30);
    QVERIFY2(room->horizontalScrollBar()->maximum() == 0,
             qPrintable(QString("%1: %2").arg(page).arg(room->horizontalScrollBar()->maximum())));
    if (QString(page) == "homePage")
      QVERIFY(named<QWidget>(*named<QWidget>(desk.window, page), "rotorDial")->height() > 260);
    // Without them it is as it was, and the window no larger.
    desk.window.showParameters(false);
    QTest::qWait(30);
    QCOMPARE(desk.window.size(), QSize(1280, 720));
    desk.window.showParameters(true);
  }
}

void TestPages::facts_takeAnotherLineWhereTheyHaveNoRoom() {
  QWidget window;
  FactsTable table("facts", &window);
  table.setOneLine(16);
  table.show({{"Wander of the friction", "0.029 ± 0.115 µNm s/rad", {}}, {"Inertia", "7.82 g cm²", {}}});
  table.resize(270, table.sizeHint().height());
  window.resize(270, 200);
  window.show();
  table.resize(270, table.heightForWidth(270));
  QTest::qWait(20);
  for (const QLabel* label : table.findChildren<QLabel*>()) {
    const QRect wanted = label->fontMetrics().boundingRect(0, 0, label->width(), 0, Qt::TextWordWrap, label->text());
    QVERIFY2(wanted.width() <= label->width() && wanted.height() <= label->height(), qPrintable(label->text()));
  }
}

void TestPages::positionLoop_hasItsOwnGainsAndStep() {
  Desk desk;
  desk.window.resize(1280, 720);
  QVERIFY(desk.connected());
  desk.window.showPage("tunePage");
  const auto seen = [&desk](const char* name) { return named<QWidget>(desk.window, name)->isVisible(); };
  QVERIFY(seen("kpSlider") && seen("cutoffSlider") && !seen("positionKpSlider"));
  const auto* page = named<TunePage>(desk.window, "tunePage");
  QTRY_VERIFY(!page->preview().step.time_s.empty());
  const double velocityMargin_rad = page->preview().margins.phaseMargin_rad;
  press(desk.window, "positionLoopTab");
  QVERIFY(!seen("kpSlider") && seen("cutoffSlider") && seen("positionKpSlider"));
  QVERIFY(std::abs(page->preview().margins.phaseMargin_rad - velocityMargin_rad) > 1e-3);
  const StepPlot* plot = named<StepPlot>(desk.window, "stepPlot");
  QCOMPARE(plot->foretold().reference_rad_per_s.back(), 5.0);
  const double last_deg = plot->foretold().velocity_rad_per_s.back();
  QVERIFY2(std::abs(last_deg - 5.0) < 0.5, qPrintable(QString::number(last_deg)));
  const auto* measure = named<QPushButton>(desk.window, "measureStepButton");
  QVERIFY(measure->isEnabled() && measure->toolTip().contains("Holds the shaft"));
  auto* box = named<QDoubleSpinBox>(desk.window, "positionKpBox");
  box->setValue(0.5 * box->value());
  QCOMPARE(desk.session.edits.count(), size_t{1});
  const QStringList cut = clipped(desk.window), on = overlapping(desk.window);
  QVERIFY2(cut.isEmpty() && on.isEmpty(), qPrintable((cut + on).join("; ")));
  press(desk.window, "velocityLoopTab");
  QVERIFY(seen("kpSlider") && measure->isEnabled());
}

void TestPages::presets_sayWhatTheyAre() {
  Desk desk;
  const auto* boards = named<QListWidget>(desk.window, "boardList");
  for (const std::string& name : presetNames()) {
    const auto rows = boards->findItems(QString::fromStdString(name), Qt::MatchExactly);
    QCOMPARE(rows.size(), 1);
    const QString words = rows.front()->toolTip();
    QVERIFY2(words.contains(' ') && !words.startsWith("simulated:"), qPrintable(words));
    QVERIFY2(!rows.front()->data(BoardList::aboutRole).toString().isEmpty(), name.c_str());  // and beside its name
  }
}

void TestPages::stepsOfTuning_areNamedWhole_data() {
  QTest::addColumn<bool>("german");
  QTest::newRow("in English") << false;
  QTest::newRow("in German") << true;
}

/// As many as are ever drawn, in the room that they have at 1280 × 720.
void TestPages::stepsOfTuning_areNamedWhole() {
  QFETCH(bool, german);
  const Spoken language(german ? Language::german : Language::english);
  StepPlot plot;
  plot.resize(380, 300);
  const StepCurve curve{{-0.01, 0.0, 0.1}, {0.0, 0.0, 20.0}, {0.0, 20.0, 20.0}, {0.0, 0.0, 1.0}};
  StepResult step;
  step.curve = curve;
  plot.foretell(curve);
  plot.show(std::vector<StepResult>(12, step));
  plot.QWidget::show();
  QTest::qWait(20);
  const QStringList cut = crampedIn(*plot.findChild<QCustomPlot*>());
  QVERIFY2(cut.isEmpty(), qPrintable(cut.join("; ")));
}

void TestPages::parameters_leaveTuneItsStepOnASmallScreen_data() {
  stepsOfTuning_areNamedWhole_data();
}

void TestPages::parameters_leaveTuneItsStepOnASmallScreen() {
  QFETCH(bool, german);
  const Spoken language(german ? Language::german : Language::english);
  Desk desk;
  QVERIFY(desk.connected());
  const TemporaryFolder folder;
  const QString profile = QString::fromStdString(folder.path("bench 3.profile.json"));
  desk.answers.byTitle[german ? "Das Profil speichern" : "Save the profile"] = profile;
  press(desk.window, "saveProfileButton");
  QTRY_VERIFY(QFile::exists(profile));
  desk.window.resize(1280, 720);
  desk.window.showPage("tunePage");
  const auto* loops = named<QWidget>(desk.window, "bodePlot");
  QTRY_VERIFY(loops->isVisible());
  desk.window.showParameters(true);
  QTest::qWait(20);
  const auto* room = named<QScrollArea>(desk.window, "pageRoom");
  QVERIFY2(!room->horizontalScrollBar()->isVisible(), "the whole page is there");
  const QRect free(room->mapToGlobal(QPoint(0, 0)), room->viewport()->size());
  for (const char* whole : {"stepPlot", "stepTable", "phaseMarginChip", "noiseChip", "kpSlider", "applyButton"}) {
    const auto* one = named<QWidget>(desk.window, whole);
    QVERIFY2(one->isVisible() && free.contains(QRect(one->mapToGlobal(QPoint(0, 0)), one->size())), whole);
  }
  QVERIFY(named<QWidget>(desk.window, "stepPlot")->width() >= 280);
  QVERIFY(!loops->isVisible());
  const QStringList cut = clippedWhereSmall(desk.window);
  QVERIFY2(cut.isEmpty(), qPrintable(cut.join("; ")));
  // With edits and a profile open, whose names and values take the most room.
  ControllerSettings other = desk.session.edits.accepted();
  desk.session.edits.openProfile(profile);
  other.velocity_ki_A_per_rad = 0.5;
  other.observer_cutoff_rad_per_s *= 0.5;
  desk.session.edits.edit(other);
  QTRY_VERIFY(named<TunePage>(desk.window, "tunePage")->preview().figures.rise_s > 0.0);
  desk.window.resize(1280, 720);
  QTest::qWait(50);
  const QStringList shorter =
      shortened(*named<QWidget>(desk.window, "tunePage")) + shortened(*named<QWidget>(desk.window, "parametersDock"));
  QVERIFY2(shorter.isEmpty(), qPrintable(shorter.join("; ")));
  constexpr int names = 1;
  const QStringList cells = shortenedIn(*named<QTableWidget>(desk.window, "parametersTable"), names);
  QVERIFY2(cells.isEmpty(), qPrintable(cells.join("; ")));
  constexpr int board = 2, profiles = 5;
  for (int column = board; column <= profiles; ++column) {
    const QStringList wrapped = wrappedIn(*named<QTableWidget>(desk.window, "parametersTable"), column);
    QVERIFY2(wrapped.isEmpty(), qPrintable(wrapped.join("; ")));
  }
  desk.window.showParameters(false);
  QTRY_VERIFY(loops->isVisible());
  const QStringList alone = shortened(*named<QWidget>(desk.window, "tunePage"));
  QVERIFY2(alone.isEmpty(), qPrintable(alone.join("; ")));
}

JOURNEY_MAIN(TestPages)
#include "tst_pages.moc"
