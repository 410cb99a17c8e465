// What the window measured is there afterwards: when the link is lost, when the window is closed, when a job is done.
#include <qcustomplot.h>

#include <QMessageBox>
#include <QPushButton>
#include <QTableWidget>
#include <algorithm>

#include "app/cut_drive.h"
#include "app/desk.h"
#include "app/rendered_tree.h"
#include "app/small_drive.h"
#include "base/atomic_file.h"
#include "firmware_link/transport/open_board.h"
#include "recording/block_file.h"
#include "recording/csv.h"
#include "support/temporary.h"
#include "widgets/closing.h"
#include "widgets/rail.h"

using namespace breakaway;
using namespace breakaway::test;

class TestKept : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void linkLostWhileRecording_leavesPlotsAndRecording();
  void linkLostInASweep_leavesItsBreakaways_data();
  void linkLostInASweep_leavesItsBreakaways();
  void message_hidesNothingAndIsWhole();
  void messageThatIsClicked_isShownWholeInTheLog();
  void doubleClick_doesNotPressWhatTheButtonHasBecome();
  void windowClosedWhileRecording_leavesTheRecording();
  void closing_asksOnlyWhileTheMotorTurns();
  void finishedMap_isInTheProject_andBackAfterAnotherBoard();
  void resultWithoutATemporaryFolder_isKept();
  void sizeOfTheWindow_isKept();
  void settingsOfSweepsAndPlots_areKept();
  void folderThatCannotBeMade_isSaid();
};

namespace {

/// The window on a small drive, with a project of its own.
struct SmallDesk {
  explicit SmallDesk(const QString& project) : session({1.0, 0.005, 600.0}), window(session, answers) {
    session.project.open(project);
    window.show();
    press(window, "liveButton");
    session.connection.adopt(std::make_unique<SmallDrive>(witness), "small");
  }
  bool turning() {
    session.bench.turnSlowly();
    return QTest::qWaitFor([this] { return witness->powered && session.connection.powered(); }, 5000);
  }
  bool recordsFor(double duration_s) {
    press(window, "recordButton");
    return QTest::qWaitFor([this, duration_s] { return session.connection.link().recorded_s > duration_s; }, 10000);
  }

  std::shared_ptr<DriveWitness> witness = std::make_shared<DriveWitness>();
  Answers answers;
  Session session;
  MainWindow window;
};

/// What a project holds when it is opened afterwards, as a command would.
std::vector<ProjectRun> runsIn(const QString& folder, std::vector<Message>* said = nullptr) {
  const auto project = Project::open(folder.toStdString());
  if (!project) qFatal("%s", project.error().message().c_str());
  if (said != nullptr) *said = project->said();
  std::vector<ProjectRun> whole;
  const auto listed = project->index().list({});
  for (const ProjectRun& run : listed.value()) whole.push_back(project->index().find(run.id).value());
  return whole;
}

size_t rowsOf(const QString& project, const ProjectRun& run) {
  const auto recording = readBlocks(project.toStdString() + "/" + run.folder + "/" + recordingFile);
  if (!recording) qFatal("%s", recording.error().message().c_str());
  return recording->rows();
}

}  // namespace

void TestKept::initTestCase() {
  if (qEnvironmentVariableIsEmpty("BREAKAWAY_RESOURCES"))
    qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

void TestKept::linkLostWhileRecording_leavesPlotsAndRecording() {
  const QTemporaryDir place;
  const QString project = place.filePath("p"), csv = place.filePath("r.csv");
  SmallDesk desk(project);
  auto* mark = named<QWidget>(desk.window, "livePlot")->findChild<QCPItemText*>("linkLost");
  QVERIFY(mark != nullptr && !mark->visible());
  QVERIFY(!named<QAbstractButton>(desk.window, "saveRecordingButton")->isEnabled());
  QVERIFY(desk.recordsFor(0.3));
  desk.witness->cableCut = true;
  QTRY_VERIFY(!desk.session.connection.connected() && !desk.session.live.recording());
  QVERIFY(mark->visible());
  const auto newest = desk.session.live.history().newest();
  QVERIFY(newest.has_value());
  QCOMPARE(mark->position->coords().x(), newest->time_s);
  auto* graph = named<QCustomPlot>(desk.window, "livePlot")->graph(0);
  QVERIFY2(graph->dataCount() > 0, "the picture stays");
  QVERIFY(named<QAbstractButton>(desk.window, "exportVisibleButton")->isEnabled());
  desk.answers.byTitle["Save the last recording"] = csv;
  press(desk.window, "saveRecordingButton");
  QTRY_VERIFY(QFile::exists(csv));
  const auto saved = readCsv(csv.toStdString());
  VERIFY_OK(saved);
  QVERIFY(saved->rows() > 250);
  QTRY_VERIFY(runsIn(project).front().state == RunState::cut);
  const auto runs = runsIn(project);
  QCOMPARE(runs.size(), size_t{1});
  QCOMPARE(rowsOf(project, runs.front()), saved->rows());
  QVERIFY2(runs.front().verdict.find("the link was lost") != std::string::npos, runs.front().verdict.c_str());
  // A stale number would be taken for the motor's.
  const auto* strip = named<QWidget>(desk.window, "liveStrip");
  const auto numbers = [strip] {
    QStringList values;
    for (const QLabel* label : strip->findChildren<QLabel*>())
      if (!label->accessibleName().isEmpty()) values << label->text();
    return values;
  };
  QTRY_COMPARE(numbers(), QStringList(4, "–"));
  desk.window.showPage("handPage");
  const auto large = [&desk] {
    int none = 0;
    for (const QLabel* label : named<QWidget>(desk.window, "handPage")->findChildren<QLabel*>())
      none += label->text() == "–" ? 1 : 0;
    return none;
  };
  QTRY_COMPARE(large(), 4);
  // The same board again goes on, with a gap; its clock begins anew.
  const int before = graph->dataCount();
  desk.witness->cableCut = false;
  desk.session.connection.adopt(std::make_unique<SmallDrive>(desk.witness), "small");
  QTRY_VERIFY(graph->dataCount() > before + 20);
  QVERIFY2(mark->visible(), "where the link was lost is still to be seen");
  QTRY_VERIFY(!numbers().contains("–"));
  int gaps = 0;
  for (auto point = graph->data()->constBegin(); point != graph->data()->constEnd(); ++point)
    gaps += std::isnan(point->value) ? 1 : 0;
  QCOMPARE(gaps, 1);
  QVERIFY(desk.session.live.stretch(desk.session.live.history(), 0.0, 1e9).ok());
  // Another one begins anew.
  desk.session.connection.open("simulated");
  QVERIFY(!mark->visible());
  QVERIFY(!desk.session.live.lost_s());
}

void TestKept::linkLostInASweep_leavesItsBreakaways_data() {
  QTest::addColumn<QString>("uri");
  QTest::addColumn<double>("pace");
  QTest::newRow("rotor") << "simulated:servo" << hurried;
  QTest::newRow("linear axis") << "simulated:linear" << 2.0 * hurried;
}

/// A journey of seconds: it needs a motor that is known and a sweep that is under way.
void TestKept::linkLostInASweep_leavesItsBreakaways() {
  QFETCH(QString, uri);
  QFETCH(double, pace);
  constexpr int angles = 72;  // many, or a busy machine sees the sweep only when it is over
  const QTemporaryDir place;
  Desk desk(pace);
  desk.session.project.open(place.filePath("p"));
  auto board = openBoard({uri.toStdString()});
  VERIFY_OK(board);
  const auto cut = std::make_shared<std::atomic<bool>>(false);
  desk.session.connection.adopt(std::make_unique<CutDrive>(std::move(*board), cut), uri);
  desk.window.showLive(true);
  QVERIFY(desk.homed());
  const Commission& known = desk.session.bench.known();
  desk.quickSpeeds();
  desk.sweep(angles, 1);
  QVERIFY(QTest::qWaitFor([&] { return known.knows(Known::runs); }, patience_ms));
  desk.session.connection.setPace(unhurried);
  QVERIFY(QTest::qWaitFor([&] { return known.breakaways.size() >= 4; }, patience_ms));
  *cut = true;
  QTRY_VERIFY(!desk.session.connection.connected() && !desk.session.connection.run().running());
  const std::vector<BreakawayEvent> before = known.breakaways;
  QVERIFY(before.size() >= 4 && before.size() < size_t{2} * angles && !known.knows(Known::map));
  const QString said = named<QLabel>(desk.window, "frictionRunActivity")->text();
  QVERIFY2(said.contains("What was measured is kept"), qPrintable(said));
  const auto& lines = desk.session.messages.lines();
  QVERIFY(std::any_of(lines.begin(), lines.end(),
                      [](const Messages::Line& line) { return line.text.contains("What ran had come to "); }));
  const auto* mark = named<QWidget>(desk.window, "livePlot")->findChild<QCPItemText*>("linkLost");
  QVERIFY2(mark->visible(), "the moment of loss");
  QTRY_COMPARE(QDir(place.filePath("p/unfinished")).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size(), 1);
  // The board is back: it homes anew, and the sweep goes on with what there is.
  desk.session.connection.setPace(pace);
  desk.session.connection.open(uri);
  QVERIFY(desk.homed());
  desk.sweep(angles, 1);
  QVERIFY(QTest::qWaitFor([&] { return known.breakaways.size() > before.size(); }, patience_ms));
  press(desk.window, "stopButton");
  for (size_t k = 0; k < before.size(); ++k) QCOMPARE(known.breakaways[k].torque_Nm, before[k].torque_Nm);
}

void TestKept::message_hidesNothingAndIsWhole() {
  const QTemporaryDir place;
  SmallDesk desk(place.filePath("p"));
  desk.window.resize(1280, 720);
  desk.session.messages.warn(
      "Recorded 1234567 samples, then the disk has no room for more than 64 MB; what was "
      "recorded is kept");
  const auto* toast = named<QWidget>(desk.window, "toast");
  const auto* words = named<QLabel>(desk.window, "messageLine");
  QTest::qWait(20);
  QVERIFY(words->heightForWidth(words->width()) <= words->height());
  QVERIFY(toast->toolTip().contains(words->text()));
  for (const char* page : {"frictionPage", "comparePage", "tunePage", "handPage"}) {
    for (const bool live : {false, true}) {
      desk.window.showPage(page);
      desk.window.showLive(live);
      QTest::qWait(20);
      const QRect covered(toast->mapToGlobal(QPoint(0, 0)), toast->size());
      const auto* rail = named<Rail>(desk.window, "steps");
      QVERIFY(covered.top() >= rail->mapToGlobal(QPoint(0, rail->rowsHeight_px())).y());
      for (const QWidget* one : desk.window.findChildren<QWidget*>()) {
        const auto* text = qobject_cast<const QLabel*>(one);
        const bool says = text != nullptr && text != words && !text->text().isEmpty();
        if (!one->isVisible() || (!says && !isControl(one) && qobject_cast<const QCustomPlot*>(one) == nullptr))
          continue;
        const QRect drawn(one->mapToGlobal(QPoint(0, 0)), one->size());
        QVERIFY2(!drawn.intersects(covered), qPrintable(QString(page) + ": " + one->objectName()));
      }
    }
  }
}

void TestKept::messageThatIsClicked_isShownWholeInTheLog() {
  const QTemporaryDir place;
  SmallDesk desk(place.filePath("p"));
  desk.window.resize(1280, 720);
  const QString said = QString("The board says at length what was wrong with it. ").repeated(8);
  desk.session.messages.warn(said);
  for (int k = 0; k < 20; ++k) desk.session.messages.say(QString("line %1").arg(k));
  auto* filter = named<QPushButton>(desk.window, "logTroubleOnly");
  desk.session.messages.warn(said + "Again.");
  QTest::qWait(20);
  QTest::mouseClick(named<QWidget>(desk.window, "toast"), Qt::LeftButton);
  const auto* table = named<QTableWidget>(desk.window, "logTable");
  QTRY_VERIFY(table->isVisible());
  QCOMPARE(table->currentRow(), 0);
  QCOMPARE(table->item(0, 1)->text(), said + "Again.");
  QVERIFY2(table->rowHeight(0) > 1.5 * table->rowHeight(1), "the line is there whole");
  filter->setChecked(true);
  desk.session.messages.say("the last one");  // that the filter hides
  QTest::qWait(20);
  QTest::mouseClick(named<QWidget>(desk.window, "toast"), Qt::LeftButton);
  QCOMPARE(table->item(table->currentRow(), 1)->text(), QString("the last one"));
}

void TestKept::doubleClick_doesNotPressWhatTheButtonHasBecome() {
  const QTemporaryDir place;
  SmallDesk desk(place.filePath("p"));
  auto* record = named<QAbstractButton>(desk.window, "recordButton");
  QTest::mouseClick(record, Qt::LeftButton);
  QTest::mouseDClick(record, Qt::LeftButton);  // its second press comes to a button that says Finish
  QTest::mouseRelease(record, Qt::LeftButton);
  QTest::qWait(50);
  QVERIFY(desk.session.live.recording());
  QTest::mouseClick(record, Qt::LeftButton);
  QTRY_VERIFY(!desk.session.live.recording());
}

void TestKept::windowClosedWhileRecording_leavesTheRecording() {
  const QTemporaryDir place;
  const QString project = place.filePath("p");
  {
    SmallDesk desk(project);
    QVERIFY(desk.recordsFor(0.2));
    QVERIFY(desk.window.close());
  }
  std::vector<Message> said;
  const auto runs = runsIn(project, &said);
  QVERIFY2(said.empty(), "it was ended in order, nothing had to be mended");
  QCOMPARE(runs.size(), size_t{1});
  QVERIFY2(runs[0].verdict.find("ended by: the window was closed") != std::string::npos, runs[0].verdict.c_str());
  QVERIFY(rowsOf(project, runs[0]) > 150);
}

void TestKept::closing_asksOnlyWhileTheMotorTurns() {
  const QTemporaryDir place;
  SmallDesk desk(place.filePath("p"));
  QVERIFY(desk.turning());
  QVERIFY(!desk.window.close());
  QVERIFY(!desk.window.close());  // asks once
  QCOMPARE(desk.window.findChildren<QMessageBox*>("closeQuestion").size(), 1);
  QVERIFY(desk.witness->powered);
  auto* question = desk.window.findChild<QMessageBox*>("closeQuestion");
  question->reject();
  QTRY_VERIFY(desk.window.findChild<QMessageBox*>("closeQuestion") == nullptr);
  QVERIFY(desk.window.isVisible() && desk.witness->powered);
  QVERIFY(!desk.window.close());
  QTest::mouseClick(named<QPushButton>(desk.window, "stopAndCloseButton"), Qt::LeftButton);
  QTRY_VERIFY(!desk.window.isVisible());
  QVERIFY(!desk.witness->powered);
  SmallDesk still(place.filePath("p"));
  QVERIFY2(still.window.close(), "a motor that stands is no question");
}

void TestKept::finishedMap_isInTheProject_andBackAfterAnotherBoard() {
  const QTemporaryDir place;
  const QString project = place.filePath("p");
  Desk desk;
  desk.session.project.open(project);
  QVERIFY(desk.connected());
  QVERIFY(desk.homed());
  desk.quickSpeeds();
  desk.sweep(36, 1);
  QVERIFY(QTest::qWaitFor([&] { return desk.session.bench.known().knows(Known::map); }, patience_ms));
  QTRY_VERIFY_WITH_TIMEOUT(!runsIn(project).empty() && runsIn(project).front().kind == "commission", 30000);
  const ProjectRun run = runsIn(project).front();
  QVERIFY(run.value("static_average_Nm") != nullptr && run.value("coulomb_average_Nm") != nullptr);
  QVERIFY(run.file("map") != nullptr && run.file("report") != nullptr && run.file("bench") != nullptr);
  QVERIFY2(run.device.find("servo") != std::string::npos, run.device.c_str());

  const auto& known = desk.session.bench.known();
  const std::vector<BreakawayEvent> measured = known.breakaways;
  desk.session.connection.open("simulated:uneven");
  QTRY_VERIFY_WITH_TIMEOUT(desk.session.connection.connected(), 10000);
  QVERIFY(!known.knows(Known::map) && known.breakaways.empty());
  const auto& lines = desk.session.messages.lines();
  QVERIFY(std::any_of(lines.begin(), lines.end(),
                      [](const Messages::Line& one) { return one.text.startsWith("This is another board"); }));
  QCOMPARE(runsIn(project).size(), size_t{1});
  desk.session.connection.open("simulated:servo");
  QTRY_VERIFY_WITH_TIMEOUT(desk.session.connection.connected(), 10000);
  QVERIFY(known.knows(Known::map) && known.breakaways.size() == measured.size());
  QCOMPARE(known.breakaways.back().torque_Nm, measured.back().torque_Nm);
}

void TestKept::resultWithoutATemporaryFolder_isKept() {
  const QTemporaryDir place;
  const QByteArray before = qgetenv("TMPDIR");
  Desk desk;
  desk.session.project.open(place.filePath("p"));
  QTRY_VERIFY(QFile::exists(place.filePath("p/project.json")));
  qputenv("TMPDIR", place.filePath("none").toUtf8());
  NewRun run;
  run.name = "kept";
  run.write = [](const std::string& into) { return writeFile(into + "/note.txt", "kept\n"); };
  bool kept = false;
  desk.session.project.put(run, [&kept] { kept = true; });
  const bool done = QTest::qWaitFor([&kept] { return kept; }, 10000);
  before.isEmpty() ? qunsetenv("TMPDIR") : qputenv("TMPDIR", before);
  QVERIFY(done);
  QCOMPARE(runsIn(place.filePath("p")).front().name, std::string("kept"));
}

void TestKept::sizeOfTheWindow_isKept() {
  Desk desk;
  desk.window.resize(1300, 720);
  QVERIFY(desk.window.close());
  Desk next;
  QVERIFY(restoreLayout(next.window));
  QCOMPARE(next.window.size(), QSize(1300, 720));
}

void TestKept::settingsOfSweepsAndPlots_areKept() {
  const auto live = [](Desk& desk) { return named<QAbstractButton>(desk.window, "liveButton"); };
  Desk desk;
  const bool open = live(desk)->isChecked();
  named<QSpinBox>(desk.window, "bins")->setValue(90);
  named<QDoubleSpinBox>(desk.window, "speedDuration")->setValue(12.5);
  named<QDoubleSpinBox>(desk.window, "highestSpeed")->setValue(50.0);  // one motor's
  named<QComboBox>(desk.window, "spanBox")->setCurrentIndex(3);
  press(desk.window, "liveButton");
  QVERIFY(desk.window.close());
  Desk next;
  restoreLayout(next.window);
  QCOMPARE(named<QSpinBox>(next.window, "bins")->value(), 90);
  QCOMPARE(named<QDoubleSpinBox>(next.window, "speedDuration")->value(), 12.5);
  QCOMPARE(named<QDoubleSpinBox>(next.window, "highestSpeed")->value(), 0.0);
  QCOMPARE(named<QComboBox>(next.window, "spanBox")->currentIndex(), 3);
  QCOMPARE(live(next)->isChecked(), !open);
}

void TestKept::folderThatCannotBeMade_isSaid() {
  const TemporaryFolder folder;
  const std::string file = folder.write("letter.txt", "dear");
  SmallDesk desk(QString::fromStdString(file));
  auto* line = named<QLabel>(desk.window, "messageLine");
  QTRY_VERIFY2(line->text().contains("Nothing can be kept: " + QString::fromStdString(file) + ": is a file"),
               qPrintable(line->text()));
  press(desk.window, "recordButton");
  QTRY_VERIFY2(line->text().contains("there is no project to keep it in"), qPrintable(line->text()));
  QVERIFY(!desk.session.live.recording());
}

JOURNEY_MAIN(TestKept)
#include "tst_kept.moc"
