// Compare through the window: open, diagnose, before and after, leave a finding out.
#include <qcustomplot.h>

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTableWidget>
#include <QTextBlock>
#include <QTextBrowser>
#include <QThread>
#include <cmath>

#include "app/rendered_tree.h"
#include "app/technician.h"
#include "app/window_support.h"
#include "base/atomic_file.h"
#include "house/program.h"
#include "session/language.h"
#include "support/real_recordings.h"
#include "support/sanitized.h"
#include "widgets/facts_table.h"
#include "widgets/log_panel.h"
#include "widgets/residual_plots.h"

using namespace breakaway;
using namespace breakaway::test;

class TestCompareJourney : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void example_isDiagnosed();
  void clicks_areAsTheManualCounts();
  void emps_isDiagnosed();
  void sealedTrial_isDiagnosedAndUnsealed();
  void nextExperiment_isRunOnTheBoardAndOpened();
  void slowTurns_areShownInTorque();
  void cancel_endsTheDiagnosis();
  void badRecording_isSaidInOneLine();
  void log_isShownAsUnderstoodAndCorrectedByAClick();
  void whatNoLogSays_isAskedForAndRemembered();
  void logOfSeveralMotors_isPartedByAClick();
  void advice_isTheWindows();
  void benchBesideARecording_isOpenedWithIt();

 private:
  const QTemporaryDir settings_;
};

namespace {

constexpr int patience_ms = 240'000;
constexpr double hurried = 30.0;  ///< board seconds per wall second

struct Desk {
  explicit Desk(double pace = 1.0) : session({pace, 0.005, 600.0}), window(session, answers) {
    window.show();
    window.showPage("comparePage");
  }
  bool opened(const QString& bench, const QString& recording) {
    answers.byTitle["Open a bench"] = bench;
    answers.byTitle["Open a recording"] = recording;
    press(window, "openBenchButton");
    press(window, "openRecordingButton");
    return ready();
  }
  bool ready() {
    return QTest::qWaitFor([this] { return session.comparison.bench() && session.comparison.recording(); },
                           patience_ms);
  }
  bool diagnosed() {
    press(window, "diagnoseButton");
    return QTest::qWaitFor(
        [this] {
          return !session.comparison.baseTrace().position.empty() && !session.comparison.shownTrace().position.empty();
        },
        patience_ms);
  }
  QString text(const char* name) { return named<QLabel>(window, name)->text(); }

  Answers answers;
  Session session;
  MainWindow window;
};

/// The first six seconds of a recording as a file of its own: under sanitizers, where a diagnosis takes ten times as
/// long, the journey is what is tested, not what it finds.
QString shortened(const QString& path, const QTemporaryDir& folder) {
  QFile in(path);
  if (!in.open(QIODevice::ReadOnly)) return path;
  QFile out(folder.filePath("short.csv"));
  if (!out.open(QIODevice::WriteOnly)) return path;
  for (int line = 0; line < 6000 && !in.atEnd(); ++line) out.write(in.readLine());
  return out.fileName();
}

int lowestPlot(QWidget& window, const char* name) {
  auto* plot = named<QWidget>(window, name)->findChild<QCustomPlot*>();
  plot->replot();
  int lowest = QWIDGETSIZE_MAX;
  for (const QCPAxisRect* rect : plot->axisRects()) lowest = std::min(lowest, rect->height());
  return lowest;
}

/// Each plot is high enough to be read, on the smallest screen one at a time.
void checkRoom(MainWindow& window) {
  const QSize before = window.size();
  const auto seen = [&window](const char* name) { return named<QWidget>(window, name)->isVisible(); };
  window.resize(1280, 720);
  press(window, "showEvidence");
  QTest::qWait(20);
  QVERIFY(seen("evidencePlot") && !seen("residualPlots"));
  QVERIFY2(lowestPlot(window, "evidencePlot") >= 240, qPrintable(QString::number(lowestPlot(window, "evidencePlot"))));
  press(window, "showMotion");
  QTest::qWait(20);
  QVERIFY(!seen("evidencePlot") && seen("residualPlots"));
  QVERIFY2(lowestPlot(window, "residualPlots") >= 110,
           qPrintable(QString::number(lowestPlot(window, "residualPlots"))));
  window.resize(1920, 1080);
  QTest::qWait(20);
  QVERIFY(seen("evidencePlot") && seen("residualPlots") && !seen("showEvidence"));
  QVERIFY2(lowestPlot(window, "residualPlots") >= 110,
           qPrintable(QString::number(lowestPlot(window, "residualPlots"))));
  window.resize(before);
}

/// Before and after stand on the page, the simulation that is drawn has the error that is claimed, and every place can
/// be shown.
void checkDiagnosis(Desk& desk) {
  const Diagnosis& diagnosis = *desk.session.comparison.diagnosis();
  if (!sanitized) {
    QVERIFY(!diagnosis.findings.empty());
    QVERIFY(diagnosis.fit.heldoutAfter < diagnosis.fit.heldoutBefore);
  }
  QVERIFY2(desk.text("verdictFigure").contains("→"), qPrintable(desk.text("verdictFigure")));
  QVERIFY(!named<FactsTable>(desk.window, "baseParameters")->value("Wander of the friction").isEmpty());
  if (!diagnosis.findings.empty())
    QVERIFY(QTest::qWaitFor([&] { return desk.session.comparison.evidence().has_value(); }, patience_ms));
  const double drawn = desk.session.comparison.shownRmse();
  QVERIFY2(sanitized || (drawn > 0.7 * diagnosis.fit.heldoutAfter && drawn < 1.4 * diagnosis.fit.heldoutAfter),
           qPrintable(QString::number(drawn)));
  auto* plots = named<ResidualPlots>(desk.window, "residualPlots");
  auto* axis = named<QComboBox>(desk.window, "residualAxis");
  for (const Place& place : diagnosis.where) {
    const int index = axis->findData(QString::fromStdString(place.axis));
    if (index < 0) continue;
    axis->setCurrentIndex(index);
    QVERIFY(plots->bands() > 0);
  }
  desk.window.showPage("comparePage");
  checkRoom(desk.window);
  const QStringList cut = clippedWhereSmall(desk.window);
  QVERIFY2(cut.isEmpty(), qPrintable(cut.join("; ")));
}

}  // namespace

void TestCompareJourney::initTestCase() {
  qputenv("XDG_CONFIG_HOME", settings_.path().toUtf8());
  if (qEnvironmentVariableIsEmpty("BREAKAWAY_RESOURCES"))
    qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

void TestCompareJourney::example_isDiagnosed() {
  Desk desk;
  QTemporaryDir folder;
  press(desk.window, "openExampleButton");
  QVERIFY(desk.ready());
  if (sanitized) {
    const QString example = qEnvironmentVariable("BREAKAWAY_RESOURCES") + "/examples/example";
    QVERIFY(desk.opened(example + ".bench.json", shortened(example + ".csv", folder)));
    QVERIFY(QTest::qWaitFor([&] { return desk.session.comparison.recording()->rows() < 10000; }, patience_ms));
  }
  QVERIFY(desk.diagnosed());
  checkDiagnosis(desk);
  desk.answers.byTitle["Write the comparison's report into a folder"] = folder.path();
  desk.window.showPage("reportPage");
  press(desk.window, "writeComparisonReportButton");
  QTRY_VERIFY_WITH_TIMEOUT(named<QWidget>(desk.window, "openReportButton")->isEnabled(), patience_ms);
  QVERIFY(QFile(folder.filePath("report.html")).size() > 5000);
  QVERIFY(QFile(folder.filePath("diagnosis.json")).size() > 500);
  // A picture after a list is none of its items.
  auto* preview = named<QTextBrowser>(desk.window, "reportPreview");
  press(desk.window, "reportOfComparison");
  QTRY_VERIFY_WITH_TIMEOUT(preview->toPlainText().contains("Where it shows"), patience_ms);
  size_t pictures = 0;
  for (QTextBlock block = preview->document()->begin(); block.isValid(); block = block.next()) {
    if (!block.text().contains(QChar::ObjectReplacementCharacter)) continue;
    QVERIFY2(block.textList() == nullptr, qPrintable(block.text()));
    ++pictures;
  }
  QVERIFY(pictures > 3);
  QCOMPARE(preview->horizontalScrollBar()->maximum(), 0);
  // In German all of it but what programs read, and where formulas come from.
  QTemporaryDir other;
  desk.answers.byTitle["Write the comparison's report into a folder"] = other.path();
  auto* language = named<QComboBox>(desk.window, "reportLanguage");
  language->setCurrentIndex(language->findData("de"));
  press(desk.window, "writeComparisonReportButton");
  QTRY_VERIFY_WITH_TIMEOUT(QFile(other.filePath("report.html")).size() > 5000, patience_ms);
  QString report = QString::fromStdString(*readFile(other.filePath("report.html").toStdString()));
  report.remove(QRegularExpression("<(style|details).*?</\\1>", QRegularExpression::DotMatchesEverythingOption))
      .replace(QRegularExpression("<[^>]*>"), " ");
  QVERIFY2(report.contains("Dem Modell fehlt: "), qPrintable(report.left(500)));
  static const QRegularExpression english(
      "\\b(the|of|and|is|to|from|with|by|before|after|held|window|model|error|speed|torque|time)\\b");
  const auto left = english.match(report);
  QVERIFY2(!left.hasMatch(),
           qPrintable(report.mid(std::max<qsizetype>(0, left.capturedStart() - 60), 120).simplified()));
  QVERIFY(readFile(other.filePath("diagnosis.json").toStdString())->find("Near standstill friction is") !=
          std::string::npos);
}

void TestCompareJourney::clicks_areAsTheManualCounts() {
  if (sanitized) QSKIP("a diagnosis takes ten times as long; its clicks are the same");
  const QString example = qEnvironmentVariable("BREAKAWAY_RESOURCES") + "/examples/example";
  Desk desk;
  desk.window.showPage("connectPage");
  Technician hand{desk.window};
  hand.goTo("Compare");
  desk.answers.byTitle["Open a bench"] = example + ".bench.json";
  hand.click("openBenchButton");
  desk.answers.byTitle["Open a recording"] = example + ".csv";
  hand.click("openRecordingButton");
  QVERIFY(desk.ready());
  hand.click("diagnoseButton");
  QVERIFY(QTest::qWaitFor([&] { return !desk.session.comparison.shownTrace().position.empty(); }, patience_ms));
  QCOMPARE(desk.session.comparison.diagnosis()->findings.front().effect, std::string("stribeck"));
  QCOMPARE(hand.clicks, clicksSaid("a cause named, and proved"));
}

void TestCompareJourney::emps_isDiagnosed() {
  NEEDS_REAL_RECORDINGS();
  const QString folder = QString::fromStdString(realRecordings()) + "/emps/";
  Desk desk;
  const QTemporaryDir temporary;
  const QString recording = folder + "DATA_EMPS.csv";
  QVERIFY(desk.opened(folder + "emps.bench.json", sanitized ? shortened(recording, temporary) : recording));
  QVERIFY(desk.diagnosed());
  checkDiagnosis(desk);
  if (desk.session.comparison.diagnosis()->findings.empty() && sanitized) return;
  const std::string first = desk.session.comparison.diagnosis()->findings.front().effect;
  const double with = desk.session.comparison.shownRmse();
  auto* box = named<QCheckBox>(desk.window, ("finding_" + first).c_str());
  box->setFocus();
  QTest::keyClick(box, Qt::Key_Return);
  QVERIFY(!desk.session.comparison.includes(first));
  QVERIFY(QTest::qWaitFor([&] { return desk.session.comparison.shownRmse() > 1.5 * with; }, patience_ms));
  QTest::keyClick(box, Qt::Key_Return);
  QVERIFY(QTest::qWaitFor([&] { return std::abs(desk.session.comparison.shownRmse() - with) < 1e-12; }, patience_ms));
}

/// The window sees files alone; what they conceal it says only when the answer is in, and as the command has it.
void TestCompareJourney::sealedTrial_isDiagnosedAndUnsealed() {
  Desk desk;
  TrialRun& trial = desk.session.trial;
  trial.setProgram(builtProgram("breakaway"));
  QVERIFY(named<QPushButton>(desk.window, "sealedTrialButton")->isEnabled());
  trial.conceal(34);
  QVERIFY(trial.preparing() && !trial.obstacle().isEmpty());
  QVERIFY(desk.ready());
  QVERIFY(trial.isOpen());
  auto* unseal = named<QPushButton>(desk.window, "unsealButton");
  QVERIFY2(!unseal->isEnabled() && unseal->toolTip().startsWith("Diagnose first"), qPrintable(unseal->toolTip()));
  QVERIFY(desk.diagnosed());
  press(desk.window, "unsealButton");
  QVERIFY(trial.truth());
  const QString said = named<QLabel>(desk.window, "trialWords")->text();
  QVERIFY(!unseal->isEnabled() && unseal->toolTip().startsWith("It is unsealed"));
  QVERIFY2(said.contains("Concealed was") || said.contains("Nothing was concealed"), qPrintable(said));
  QFile file(QFileInfo(QString::fromStdString(desk.session.comparison.recording()->name())).path() + "/trial.json");
  QVERIFY(file.open(QIODevice::ReadOnly));
  const QJsonObject command = QJsonDocument::fromJson(file.readAll()).object();
  QCOMPARE(trial.truth()->answer.isRight, command["right"].toBool());
  QCOMPARE(said.contains("The answer is right"), command["right"].toBool());
  QCOMPARE(desk.session.comparison.recordings().size(), size_t{2});
  // Another recording ends it.
  press(desk.window, "openExampleButton");
  QVERIFY(QTest::qWaitFor([&] { return !trial.isOpen(); }, patience_ms));
  QCOMPARE(desk.session.comparison.recordings().size(), size_t{1});
}

void TestCompareJourney::nextExperiment_isRunOnTheBoardAndOpened() {
  const QTemporaryDir place;
  Desk desk(hurried);
  desk.session.project.open(place.filePath("p"));
  auto* button = named<QPushButton>(desk.window, "runExperimentButton");
  QVERIFY2(!button->isEnabled() && button->toolTip().startsWith("Diagnose first"), qPrintable(button->toolTip()));
  press(desk.window, "openExampleButton");
  QVERIFY(desk.ready() && desk.diagnosed());
  QVERIFY2(!button->isEnabled() && button->toolTip().startsWith("Connect"), qPrintable(button->toolTip()));
  desk.session.connection.open("simulated:servo");
  QVERIFY(desk.session.connection.connected());
  QVERIFY2(button->isEnabled(), qPrintable(button->toolTip()));
  const double planned_s = durationOf(desk.session.comparison.diagnosis()->nextManeuver);
  QVERIFY(planned_s > 5.0 && button->toolTip().contains(QString::number(std::ceil(planned_s))));
  const std::string before = desk.session.comparison.recording()->name();
  // A slow disk: what moves before the file is open would be lost.
  desk.session.project.inProject([](Project*) -> std::function<void()> {
    QThread::msleep(500);
    return {};
  });
  press(desk.window, "runExperimentButton");
  QVERIFY(QTest::qWaitFor([&] { return desk.session.comparison.recording()->name() != before; }, patience_ms));
  const Recording recording = *desk.session.comparison.recording();
  QVERIFY(recording.time().back() - recording.time().front() > 0.95 * planned_s);
  const auto angle = recording.channel("angle_rad");
  const auto [low, high] = std::minmax_element(angle.begin(), angle.end());
  QVERIFY(*high - *low > 1.0);
  // The bench is the board's own, so that it can be diagnosed at once.
  QCOMPARE(desk.session.comparison.obstacle(), QString());
}

/// What can't be foreseen is counted and drawn in torque.
void TestCompareJourney::slowTurns_areShownInTorque() {
  Desk desk;
  const QString turns = qEnvironmentVariable("BREAKAWAY_SOURCE_DIR") + "/tests/data/diagnose/slow_turns_in_cogging";
  QVERIFY(desk.opened(turns + ".bench.json", turns + ".csv"));
  QVERIFY(desk.diagnosed());
  QCOMPARE(desk.session.comparison.diagnosis()->fit.channel, std::string("torque_Nm"));
  QVERIFY2(desk.text("verdictFigure").contains("mNm"), qPrintable(desk.text("verdictFigure")));
  QVERIFY(desk.session.comparison.shownRmse() > 0.0);
  QCOMPARE(desk.session.comparison.shownChannel(), std::string("angle_rad"));
  QVERIFY(named<ResidualPlots>(desk.window, "residualPlots")->inTorque());
  const auto* plot = named<QCustomPlot>(desk.window, "residualPlot");
  QVERIFY(plot->graph(1)->data()->isEmpty());  // no motion that runs away
  const double most_mNm = 1e3 * desk.session.comparison.diagnosis()->fit.heldoutBefore;
  for (const int residual : {2, 3}) {
    bool found = false;
    const QCPRange drawn = plot->graph(residual)->getValueRange(found);
    QVERIFY(found && drawn.upper < 10.0 * most_mNm && drawn.lower > -10.0 * most_mNm);
  }
}

void TestCompareJourney::cancel_endsTheDiagnosis() {
  Desk desk;
  press(desk.window, "openExampleButton");
  QVERIFY(desk.ready());
  press(desk.window, "diagnoseButton");
  press(desk.window, "cancelButton");
  QVERIFY(!desk.session.comparison.diagnosing());
  QVERIFY(named<QWidget>(desk.window, "diagnoseButton")->isEnabled());
  QTest::qWait(300);
  QVERIFY(!desk.session.comparison.diagnosis().has_value());
}

void TestCompareJourney::badRecording_isSaidInOneLine() {
  QTemporaryDir folder;
  QFile file(folder.filePath("bad.csv"));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write("time_s,angle_rad\n0,1\n0,2\n");
  file.close();
  Desk desk;
  desk.answers.byTitle["Open a recording"] = file.fileName();
  press(desk.window, "openRecordingButton");
  auto* line = named<QLabel>(desk.window, "messageLine");
  QVERIFY(QTest::qWaitFor([&] { return line->text().contains("row 2"); }, 5000));
  QVERIFY(!line->text().contains('\n'));
  QVERIFY(!desk.session.comparison.recording().has_value());
}

/// Chooses as a person does who types the first letters.
static void choose(QWidget& window, const QString& objectName, const QString& item) {
  auto* box = named<QComboBox>(window, qPrintable(objectName));
  const int index = box->findText(item);
  if (index < 0) qFatal("%s doesn't offer %s", qPrintable(objectName), qPrintable(item));
  box->setFocus();
  while (box->currentIndex() != index) QTest::keyClick(box, box->currentIndex() < index ? Qt::Key_Down : Qt::Key_Up);
}

static QString written(const QTemporaryDir& folder, const QByteArray& text) {
  QFile file(folder.filePath("log.csv"));
  if (!file.open(QIODevice::WriteOnly) || file.write(text) < 0) qFatal("no log");
  return file.fileName();
}

void TestCompareJourney::log_isShownAsUnderstoodAndCorrectedByAClick() {
  const QTemporaryDir folder;
  QByteArray text = "t [ms];Winkel [deg];u;x\n";
  for (int k = 0; k < 50; ++k)
    text += QByteArray::number(10 * k) + ";" + QByteArray::number(k * k) + ";" + QByteArray::number(k % 5) + ";" +
            QByteArray::number(0.5 * k) + "\n";
  Desk desk;
  desk.answers.byTitle["Open a recording"] = written(folder, text);
  press(desk.window, "openRecordingButton");
  LogOpening& log = desk.session.comparison.log();
  const auto settled = [&log] { return log.isOpen() && !log.settling(); };
  QVERIFY(QTest::qWaitFor(settled, patience_ms));
  QVERIFY(named<LogPanel>(desk.window, "logPanel")->isVisible());
  QVERIFY(!named<QWidget>(desk.window, "residualPlots")->isVisible());
  const auto* table = named<QTableWidget>(desk.window, "logColumns");
  QCOMPARE(table->rowCount(), 4);
  QCOMPARE(table->item(1, 0)->text(), QString("Winkel [deg]"));
  const auto* taken = named<QComboBox>(desk.window, "logTakenAs1");
  QCOMPARE(taken->currentText(), QString("angle"));
  QVERIFY2(taken->toolTip().contains("angle_rad"), qPrintable(taken->toolTip()));
  QCOMPARE(named<QComboBox>(desk.window, "logUnit1")->currentText(), QString("deg"));
  QCOMPARE(table->item(1, 3)->text(), QString("0  1  4"));
  QCOMPARE(table->item(1, 3)->toolTip(), QString("0  1  4  9"));
  choose(desk.window, "logUnit1", "rev");
  QVERIFY(QTest::qWaitFor([&] { return settled() && log.columns()[1].unit == "rev"; }, patience_ms));
  choose(desk.window, "logTakenAs3", "current");
  QVERIFY(QTest::qWaitFor([&] { return settled() && log.columns()[3].to == "current_A"; }, patience_ms));
  choose(desk.window, "logUnit3", "mA");
  QVERIFY(QTest::qWaitFor([&] { return settled() && log.columns()[3].unit == "mA"; }, patience_ms));
  press(desk.window, "logOpenButton");
  const auto& recording = desk.session.comparison.recording();
  QVERIFY(recording.has_value());
  QVERIFY(std::abs(recording->channel("angle_rad")[3] - 9.0 * 2.0 * M_PI) < 1e-9);
  QVERIFY(std::abs(recording->channel("current_A")[10] - 5e-3) < 1e-12);
  QVERIFY(!named<LogPanel>(desk.window, "logPanel")->isVisible());
}

/// What only the command can do isn't advised in the window.
void TestCompareJourney::advice_isTheWindows() {
  const QTemporaryDir folder;
  QByteArray text = "ms_today;erpm;current_motor;duty_cycle;pos\n";
  for (int k = 0; k < 50; ++k)
    text += QByteArray::number(5 * k) + ";" + QByteArray::number(80.2 * k) + ";0.3;0.01;" +
            QByteArray::number(0.31 + 1.77 * k) + "\n";
  for (const Language language : {Language::english, Language::german}) {
    speak(language);
    Desk desk;
    desk.session.comparison.openRecording(written(folder, text));
    const LogOpening& log = desk.session.comparison.log();
    QVERIFY(QTest::qWaitFor([&log] { return log.isOpen() && !log.settling(); }, patience_ms));
    const auto* table = named<QTableWidget>(desk.window, "logColumns");
    QStringList said{named<QLabel>(desk.window, "logState")->text()};
    for (int row = 0; row < table->rowCount(); ++row) said << table->item(row, 4)->text();
    const QString all = said.join(" | ");
    speak(Language::english);
    QVERIFY2(!all.contains("--map"), qPrintable(all));
    QVERIFY2(all.contains(language == Language::english ? "pole pairs; say it here" : "Polpaar"), qPrintable(all));
  }
}

void TestCompareJourney::benchBesideARecording_isOpenedWithIt() {
  const QTemporaryDir folder;
  const QString example = qEnvironmentVariable("BREAKAWAY_RESOURCES") + "/examples/example";
  const QString recording = folder.filePath("r.csv"), bench = folder.filePath("r.bench.json");
  QVERIFY(QFile::copy(example + ".csv", recording) && QFile::copy(example + ".bench.json", bench));
  {
    Desk desk;
    desk.session.comparison.openRecording(recording);
    QVERIFY(QTest::qWaitFor([&] { return desk.session.comparison.bench().has_value(); }, patience_ms));
    QCOMPARE(desk.session.comparison.bench()->name, std::string("example"));
    QVERIFY(named<QPushButton>(desk.window, "diagnoseButton")->isEnabled());
  }
  // Of two none is meant.
  QVERIFY(QFile::copy(bench, folder.filePath("other.bench.json")));
  Desk desk;
  desk.session.comparison.openRecording(recording);
  QVERIFY(QTest::qWaitFor([&] { return desk.session.comparison.recording().has_value(); }, patience_ms));
  QVERIFY(!desk.session.comparison.bench());
}

void TestCompareJourney::logOfSeveralMotors_isPartedByAClick() {
  const QTemporaryDir folder;
  QByteArray text = "t_ms,motor,angle_deg\n";
  for (int k = 0; k < 50; ++k) {
    for (const char* motor : {"left", "right"})
      text += QByteArray::number(10 * k) + "," + motor + "," + QByteArray::number(*motor == 'l' ? k * k : 7 * k) + "\n";
  }
  Desk desk;
  desk.answers.byTitle["Open a recording"] = written(folder, text);
  press(desk.window, "openRecordingButton");
  LogOpening& log = desk.session.comparison.log();
  const auto settled = [&log] { return log.isOpen() && !log.settling(); };
  QVERIFY(QTest::qWaitFor(settled, patience_ms));
  QVERIFY2(log.fault().find("split") != std::string::npos, log.fault().c_str());
  QVERIFY(!named<QComboBox>(desk.window, "logPart")->isEnabled());
  choose(desk.window, "logSplit", "motor");
  QVERIFY(QTest::qWaitFor([&] { return settled() && log.fault().empty(); }, patience_ms));
  QCOMPARE(log.parts(), QStringList({"left", "right"}));
  choose(desk.window, "logPart", "right");
  QVERIFY(QTest::qWaitFor([&] { return settled() && log.part() == 1; }, patience_ms));
  QCOMPARE(named<QComboBox>(desk.window, "logPart")->currentText(), QString("right"));
  press(desk.window, "logOpenButton");
  const auto& recording = desk.session.comparison.recording();
  QVERIFY(recording.has_value());
  QCOMPARE(recording->rows(), size_t{50});
  QVERIFY(std::abs(recording->channel("angle_rad")[10] - 70.0 * M_PI / 180.0) < 1e-9);
}

void TestCompareJourney::whatNoLogSays_isAskedForAndRemembered() {
  const QTemporaryDir folder;
  QByteArray text = "voltage,angle_deg\n";
  for (int k = 0; k < 50; ++k) text += QByteArray::number(k % 3) + "," + QByteArray::number(k * k) + "\n";
  const QString path = written(folder, text);
  for (const bool again : {false, true}) {
    Desk desk;
    desk.answers.byTitle["Open a recording"] = path;
    press(desk.window, "openRecordingButton");
    LogOpening& log = desk.session.comparison.log();
    const auto settled = [&log] { return log.isOpen() && !log.settling(); };
    QVERIFY(QTest::qWaitFor(settled, patience_ms));
    QCOMPARE(log.fault().find("sample_time_s") != std::string::npos, !again);
    QCOMPARE(named<QWidget>(desk.window, "logOpenButton")->isEnabled(), again);
    auto* apart = named<QLineEdit>(desk.window, "logSampleTime");
    if (!again) {
      QTest::keyClicks(apart, "0.02");
      QTest::keyClick(apart, Qt::Key_Return);
      QVERIFY(QTest::qWaitFor([&] { return settled() && log.fault().empty(); }, patience_ms));
    }
    QCOMPARE(apart->text(), QString("0.02"));
    press(desk.window, "logOpenButton");
    QVERIFY(desk.session.comparison.recording().has_value());
    QVERIFY(std::abs(desk.session.comparison.recording()->time().back() - 0.98) < 1e-12);
  }
  QCOMPARE(QDir(LogOpening::memory()).entryList({"*.map.json"}).size(), 2);
}

JOURNEY_MAIN(TestCompareJourney)
#include "tst_compare_journey.moc"
