// Compare through the window: open, diagnose, before and after, leave a finding out.
#include <QCheckBox>
#include <QComboBox>
#include <cmath>

#include "app/window_support.h"
#include "support/real_recordings.h"
#include "widgets/facts_table.h"
#include "widgets/residual_plots.h"

using namespace breakaway;
using namespace breakaway::test;

class TestCompareJourney : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void example_isDiagnosed();
  void emps_isDiagnosed();
  void cancel_endsTheDiagnosis();
  void badRecording_isSaidInOneLine();
};

namespace {

constexpr int patience_ms = 240'000;

struct Desk {
  Desk() : session({1.0, 0.005, 600.0}), window(session, answers) {
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
  QString proof(const char* name) { return named<FactsTable>(window, "proof")->value(name); }

  Answers answers;
  Session session;
  MainWindow window;
};

#ifdef __SANITIZE_ADDRESS__
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

/// The first ten seconds of a recording as a file of its own: under sanitizers, where a diagnosis takes ten times as
/// long, the journey is what is tested, not what it finds.
QString shortened(const QString& path, const QTemporaryDir& folder) {
  QFile in(path);
  if (!in.open(QIODevice::ReadOnly)) return path;
  QFile out(folder.filePath("short.csv"));
  if (!out.open(QIODevice::WriteOnly)) return path;
  for (int line = 0; line < 10000 && !in.atEnd(); ++line) out.write(in.readLine());
  return out.fileName();
}

/// Before and after stand on the page, the simulation that is drawn has the error that is claimed, and every place can
/// be shown.
void checkDiagnosis(Desk& desk) {
  const Diagnosis& diagnosis = *desk.session.comparison.diagnosis();
  if (!sanitized) {
    QVERIFY(!diagnosis.findings.empty());
    QVERIFY(diagnosis.fit.heldoutAfter < diagnosis.fit.heldoutBefore);
  }
  QVERIFY2(desk.proof("Held-out error").contains("→"), qPrintable(desk.proof("Held-out error")));
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
}

}  // namespace

void TestCompareJourney::initTestCase() {
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
  QVERIFY(QFile(folder.filePath("report.html")).size() > 5000);
  QVERIFY(QFile(folder.filePath("diagnosis.json")).size() > 500);
  QVERIFY(named<QWidget>(desk.window, "openReportButton")->isEnabled());
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
