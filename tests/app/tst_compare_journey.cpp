// Compare through the window: open, diagnose, before and after, leave a finding out.
#include <qcustomplot.h>

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QThread>
#include <cmath>

#include "app/compare_desk.h"
#include "app/rendered_tree.h"
#include "app/technician.h"
#include "app/window_support.h"
#include "base/atomic_file.h"
#include "house/program.h"
#include "support/real_recordings.h"
#include "support/sanitized.h"
#include "widgets/facts_table.h"
#include "widgets/residual_plots.h"

using namespace breakaway;
using namespace breakaway::test;

class TestCompareJourney : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void example_isDiagnosed();
  void clicks_areAsTheManualCounts();
  void finishing_takesWhatWasFoundByThen();
  void emps_isDiagnosed();
  void sealedTrial_isDiagnosedAndUnsealed();
  void nextExperiment_isRunOnTheBoardAndOpened();
  void slowTurns_areShownInTorque();
  void cancel_endsTheDiagnosis();
  void badRecording_isSaidInOneLine();

 private:
  const QTemporaryDir settings_;
};

namespace {

constexpr double hurried = 30.0;  ///< board seconds per wall second

/// The first rows of a recording as a file of its own: under sanitizers, where a diagnosis takes ten times as
/// long, the journey is what is tested, not what it finds.
QString shortened(const QString& path, const QTemporaryDir& folder, int rows) {
  QFile in(path);
  if (!in.open(QIODevice::ReadOnly)) return path;
  QFile out(folder.filePath("short.csv"));
  if (!out.open(QIODevice::WriteOnly)) return path;
  for (int line = 0; line <= rows && !in.atEnd(); ++line) out.write(in.readLine());
  return out.fileName();
}

/// By its button; under sanitizers its beginning after it.
bool openedExample(Desk& desk, const QTemporaryDir& folder) {
  press(desk.window, "openExampleButton");
  if (!desk.ready()) return false;
  if (!sanitized) return true;
  const QString example = qEnvironmentVariable("BREAKAWAY_RESOURCES") + "/examples/example";
  return desk.opened(example + ".bench.json", shortened(example + ".csv", folder, 6000)) &&
         QTest::qWaitFor([&] { return desk.session.comparison.recording()->rows() < 10000; }, patience_ms);
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

/// What others in a finding's place err by stands beneath it, whatever the window's size: the finding, each of them,
/// the base and a perfect model.
void checkRivals(Desk& desk, const Diagnosis& diagnosis) {
  for (const Finding& finding : diagnosis.findings) {
    auto* bars = desk.window.findChild<QWidget*>("rivals_" + QString::fromStdString(finding.effect));
    QCOMPARE(bars != nullptr, !finding.rivals.empty());
    if (bars == nullptr) continue;
    QCOMPARE(bars->toolTip().count('\n'), static_cast<qsizetype>(finding.rivals.size()) + 2);
    QVERIFY(bars->width() >= bars->minimumSizeHint().width());
  }
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
    QVERIFY(QTest::qWaitFor([&] { return desk.session.comparison.evidence() != nullptr; }, patience_ms));
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
  for (const Evidence& one : desk.session.comparison.evidences()) {
    if (one.effect.empty()) continue;
    auto* link = named<QLabel>(desk.window, qPrintable("evidence_" + QString::fromStdString(one.effect)));
    QVERIFY(!link->isHidden());
    emit link->linkActivated(QString::fromStdString(one.effect));
    QCOMPARE(desk.session.comparison.evidence()->effect, one.effect);
    QVERIFY(named<QWidget>(desk.window, "evidencePlot")->isVisible());
  }
  checkRivals(desk, diagnosis);
  for (const Evidence& one : desk.session.comparison.evidences()) {
    // Of a few seconds a law may have no place with instants enough.
    if (!sanitized || diagnosis.findings.empty()) QCOMPARE(one.law.at.empty(), diagnosis.findings.empty());
  }
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
  QVERIFY(openedExample(desk, folder));
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
  QTRY_VERIFY_WITH_TIMEOUT(preview->toPlainText().contains("All parameters"), patience_ms);
  if (!sanitized) QVERIFY(preview->toPlainText().contains("Where it shows"));
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
  const auto inEnglish = [&] {  // it is written after the report
    const auto text = readFile(other.filePath("diagnosis.json").toStdString());
    return text && text->find("Near standstill friction is") != std::string::npos;
  };
  QTRY_VERIFY_WITH_TIMEOUT(inEnglish(), patience_ms);
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

void TestCompareJourney::finishing_takesWhatWasFoundByThen() {
  const QTemporaryDir folder;
  Desk desk;
  QVERIFY(openedExample(desk, folder));
  const auto* finish = named<QPushButton>(desk.window, "finishButton");
  QVERIFY(!finish->isEnabled());
  press(desk.window, "diagnoseButton");
  QVERIFY(finish->isEnabled());
  press(desk.window, "finishButton");
  QVERIFY(!finish->isEnabled() && finish->toolTip().startsWith("It looks no further"));
  QVERIFY(QTest::qWaitFor([&] { return desk.session.comparison.diagnosis().has_value(); }, patience_ms));
  const Diagnosis& diagnosis = *desk.session.comparison.diagnosis();
  QVERIFY(diagnosis.cutShort);
  QCOMPARE(nameOf(diagnosis.verdict), std::string("undecided"));
  QVERIFY2(inWords(diagnosis).find("give it more") != std::string::npos, inWords(diagnosis).c_str());
  QVERIFY(!finish->isEnabled() && finish->toolTip().startsWith("No diagnosis"));
}

void TestCompareJourney::emps_isDiagnosed() {
  NEEDS_REAL_RECORDINGS();
  const QString folder = QString::fromStdString(realRecordings()) + "/emps/";
  Desk desk;
  const QTemporaryDir temporary;
  const QString recording = folder + "DATA_EMPS.csv";
  QVERIFY(desk.opened(folder + "emps.bench.json", sanitized ? shortened(recording, temporary, 4000) : recording));
  QVERIFY(desk.diagnosed());
  checkDiagnosis(desk);
  if (desk.session.comparison.diagnosis()->findings.empty() && sanitized) return;
  const std::string first = desk.session.comparison.diagnosis()->findings.front().effect;
  const double with = desk.session.comparison.shownRmse();
  auto* box = named<QCheckBox>(desk.window, ("finding_" + first).c_str());
  box->setFocus();
  QTest::keyClick(box, Qt::Key_Return);
  QVERIFY(!desk.session.comparison.includes(first));
  const double worse = sanitized ? 1.0 : 1.5;
  QVERIFY(QTest::qWaitFor([&] { return desk.session.comparison.shownRmse() > worse * with; }, patience_ms));
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
  QVERIFY(desk.diagnosed(sanitized));
  press(desk.window, "unsealButton");
  QVERIFY(trial.truth());
  const QString said = named<QLabel>(desk.window, "trialWords")->text();
  QVERIFY(!unseal->isEnabled() && unseal->toolTip().startsWith("It is unsealed"));
  QVERIFY2(said.contains("Concealed was") || said.contains("Nothing was concealed"), qPrintable(said));
  QFile file(QFileInfo(QString::fromStdString(desk.session.comparison.recording()->name())).path() + "/trial.json");
  QVERIFY(file.open(QIODevice::ReadOnly));
  const QJsonObject command = QJsonDocument::fromJson(file.readAll()).object();
  if (!sanitized) QCOMPARE(trial.truth()->answer.isRight, command["right"].toBool());  // it has all the time
  QCOMPARE(said.contains("The answer is right"), trial.truth()->answer.isRight);
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
  QVERIFY(openedExample(desk, place) && desk.diagnosed());
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

JOURNEY_MAIN(TestCompareJourney)
#include "tst_compare_journey.moc"
