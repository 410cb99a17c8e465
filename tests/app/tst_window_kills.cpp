// The window killed at random moments: what was recorded up to the last second is there, the project opens, and what is
// missing is said. Called with --at-work WORK FOLDER, it is the window that is killed.
#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <cstdio>
#include <random>

#include "app/desk.h"
#include "app/streaming_drive.h"
#include "bench/window_kills.h"
#include "commission/commission_progress.h"
#include "friction/map_export.h"
#include "project/project.h"
#include "support/noisy_map.h"
#include "support/small_disk.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

class TestWindowKills : public QObject {
  Q_OBJECT
 private slots:
  void fullDisk_leavesWhatWasRecorded();
  void killedWindow_losesLessThanASecond_data();
  void killedWindow_losesLessThanASecond();
  void killedSweep_goesOnInTheNextWindow();
  void killedInASpeed_losesLessThanASecondOfIt();
};

namespace {

bool disksAllowed = false;
constexpr double rate_Hz = 10'000.0;

void begun() {
  std::puts("at work");
  std::fflush(stdout);
}

/// Maps go in one after the other, and recordings of a tenth of a second are written as CSV.
void saveForEver(Desk& desk, const QString& folder) {
  begun();
  for (int k = 0;; ++k) {
    NewRun run;
    run.write = [](const std::string& into) { return exportMap(noisyMap(0.02, 1), "json", into + "/map.json"); };
    desk.session.project.put(run);
    desk.session.live.startRecording();
    QTest::qWait(100);
    desk.session.live.finishRecording();
    QTest::qWait(20);
    desk.session.live.saveLast(folder + "/../saved.csv");
  }
}

/// Two maps of the project, of which one is put in each time, as words and as report.
int compareForEver(Desk& desk, const QString& folder) {
  ProjectRuns& runs = desk.session.runs;
  desk.window.showPage("runsPage");
  for (unsigned k = 1;; ++k) {
    NewRun run;
    run.write = [k](const std::string& into) { return exportMap(noisyMap(0.02, k), "json", into + "/map.json"); };
    const size_t before = runs.all();
    desk.session.project.put(run);
    if (!QTest::qWaitFor([&] { return runs.all() > before; }, patience_ms)) return 1;
    if (runs.runs().size() < 2) continue;
    bool compared = false;
    runs.compare(runs.runs()[0].id, runs.runs()[1].id, &runs, [&](const RunComparison& comparison) {
      runs.writeReport(comparison, folder + "/../compared");
      compared = true;
    });
    if (!QTest::qWaitFor([&] { return compared; }, patience_ms)) return 1;
    if (k == 2) begun();
  }
}

/// The next window after one that was killed in its sweep: says what it took up, goes on, and says how it ended.
int goOn(const QString& folder) {
  Desk desk;
  desk.session.project.open(folder);
  const BenchRuns& bench = desk.session.bench;
  if (!desk.connected()) return 1;
  if (!QTest::qWaitFor([&] { return !bench.known().breakaways.empty(); }, 5000)) return 1;
  std::printf("took up %zu\n", bench.known().breakaways.size());
  desk.window.showPage("frictionPage");
  press(desk.window, "continueSweepButton");
  if (!QTest::qWaitFor([&] { return bench.known().knows(Known::map) && !desk.session.connection.run().running(); },
                       patience_ms))
    return 1;
  std::printf("ended in part %zu with %zu\n", bench.known().part, bench.known().breakaways.size());
  return QTest::qWaitFor([&] { return QDir(folder + "/unfinished").isEmpty(); }, 20'000) ? 0 : 1;
}

/// How many turns of which run were measured when, for ever.
void sayTurns(const BenchRuns& bench) {
  for (;;) {
    QTest::qWait(20);
    const auto& runs = bench.known().runs;
    if (runs.empty()) continue;
    std::printf("%zu %.3f\n", runs.size(), runs.back().duration_s);
    std::fflush(stdout);
  }
}

int work(const QString& what, const QString& folder) {
  if (what == "going on") return goOn(folder);
  const bool sweeping = what.startsWith("sweeping");
  Desk desk(sweeping ? hurried : 1.0);
  desk.session.project.open(folder);
  if (sweeping) {
    if (!desk.connected()) return 1;
    desk.quickSpeeds();
    if (what == "sweeping at real pace") named<QDoubleSpinBox>(desk.window, "speedDuration")->setValue(30.0);
    desk.sweep(36, 1);
    if (!QTest::qWaitFor([&] { return desk.session.connection.run().running(); }, 5000)) return 1;
    begun();
    if (what == "sweeping at real pace") {
      if (!QTest::qWaitFor([&] { return desk.session.bench.known().knows(Known::index); }, patience_ms)) return 1;
      desk.session.connection.setPace(1.0);
      QTest::qWait(500);  // until the board's thread has heard of it
      sayTurns(desk.session.bench);
    }
    // A busy machine must not miss the whole of it.
    const bool slow = what == "sweeping slowly" &&
                      QTest::qWaitFor([&] { return desk.session.bench.known().knows(Known::runs); }, patience_ms);
    if (slow) desk.session.connection.setPace(0.2 * unhurried);
    QTest::qWait(slow ? patience_ms : 60'000);
    return 1;
  }
  desk.session.connection.adopt(std::make_unique<StreamingDrive>(rate_Hz), "streaming");
  if (what == "saving") saveForEver(desk, folder);
  if (what == "comparing") return compareForEver(desk, folder);
  desk.window.showLive(true);
  press(desk.window, "recordButton");
  if (!QTest::qWaitFor([&] { return desk.session.connection.link().recorded_s > 0.0; }, 5000)) return 1;
  begun();
  QTest::qWait(60'000);
  return 1;
}

}  // namespace

void TestWindowKills::killedWindow_losesLessThanASecond_data() {
  QTest::addColumn<QString>("what");
  for (const char* what : windowWorks) QTest::addRow("%s", what) << QString(what);
}

void TestWindowKills::killedWindow_losesLessThanASecond() {
  QFETCH(QString, what);
  const QTemporaryDir place;
  const auto seed = std::random_device{}();
  std::mt19937 random(seed);
  const ProjectKills left =
      killsOfTheWindow(QCoreApplication::applicationFilePath(), what, place.filePath("p"), 3, random);
  QStringList faults;
  for (const std::string& fault : left.faults) faults << QString::fromStdString(fault);
  QVERIFY2(left.faults.empty(), qPrintable(QString("seed %1: %2").arg(seed).arg(faults.join("; "))));
  QVERIFY2(left.good(), qPrintable(QString("seed %1: %2 of %3 open, %4 whole, %5 of %6 said, %7 s lost")
                                       .arg(seed)
                                       .arg(left.opened)
                                       .arg(left.kills)
                                       .arg(left.whole)
                                       .arg(left.said)
                                       .arg(left.cut)
                                       .arg(left.worst_s)));
  if (what == "recording") QCOMPARE(left.cut, 3);
}

void TestWindowKills::fullDisk_leavesWhatWasRecorded() {
  if (!disksAllowed) QSKIP("no mounts are allowed here: a full disk can't be made");
  const QTemporaryDir place;
  const ProjectKills left = fullDisksWhileRecording(place.path().toStdString(), 3);
  QStringList faults;
  for (const std::string& fault : left.faults) faults << QString::fromStdString(fault);
  QVERIFY2(left.faults.empty(), qPrintable(faults.join("; ")));
  QVERIFY2(left.good() && left.cut == 3, qPrintable(QString("%1 open, %2 whole, %3 said, %4 s")
                                                        .arg(left.opened)
                                                        .arg(left.whole)
                                                        .arg(left.said)
                                                        .arg(left.worst_s)));
}

void TestWindowKills::killedSweep_goesOnInTheNextWindow() {
  const QTemporaryDir place;
  const QString folder = place.filePath("p");
  const auto window = [&folder](QProcess& process, const QString& what) {
    auto environment = QProcessEnvironment::systemEnvironment();
    environment.insert("QT_QPA_PLATFORM", "offscreen");
    process.setProcessEnvironment(environment);
    process.start(QCoreApplication::applicationFilePath(), {"--at-work", what, folder});
    return process.waitForStarted();
  };
  const auto kept = [&folder]() -> size_t {
    const QStringList jobs = QDir(folder + "/unfinished").entryList(QDir::Dirs | QDir::NoDotAndDotDot);
    const auto progress =
        jobs.isEmpty() ? Result<Commission>(Error{}) : readProgress((folder + "/unfinished/" + jobs[0]).toStdString());
    return progress ? progress->breakaways.size() : 0;
  };
  QProcess killed, next;
  QVERIFY(window(killed, "sweeping slowly"));
  QVERIFY(QTest::qWaitFor([&] { return kept() >= 5; }, patience_ms));
  killed.kill();
  QVERIFY(killed.waitForFinished());
  const size_t left = kept();
  QVERIFY2(left >= 5 && left < 72, qPrintable(QString("%1 of 72 breakaways").arg(left)));
  QVERIFY(window(next, "going on"));
  QVERIFY(next.waitForFinished(2 * patience_ms));
  const QString said = next.readAllStandardOutput();
  QVERIFY2(next.exitStatus() == QProcess::NormalExit && next.exitCode() == 0, qPrintable(said));
  QVERIFY2(said.contains(QString("took up %1\n").arg(left)), qPrintable(said));
  QVERIFY2(said.contains("ended in part 2 with 7"), qPrintable(said));
  const auto project = Project::open(folder.toStdString());
  VERIFY_OK(project);
  const auto maps = project->index().list({.kind = "commission"});
  VERIFY_OK(maps);
  QCOMPARE(maps->size(), size_t{1});
}

/// The last that the window showed of a speed is nearly all there, and the next window begins with it.
void TestWindowKills::killedInASpeed_losesLessThanASecondOfIt() {
  const QTemporaryDir place;
  const QString folder = place.filePath("p");
  QProcess killed;
  auto environment = QProcessEnvironment::systemEnvironment();
  environment.insert("QT_QPA_PLATFORM", "offscreen");
  killed.setProcessEnvironment(environment);
  killed.start(QCoreApplication::applicationFilePath(), {"--at-work", "sweeping at real pace", folder});
  QVERIFY(killed.waitForStarted());
  QByteArray said;
  const auto last = [&said] { return said.trimmed().split('\n').last().split(' '); };
  double first_s = -1.0;
  const bool far = QTest::qWaitFor(
      [&] {
        killed.waitForReadyRead(10);
        said += killed.readAllStandardOutput();
        if (!said.endsWith('\n') || last().size() != 2 || last()[0] == "at") return false;
        const double now_s = last()[1].toDouble();
        if (first_s < 0.0) first_s = now_s;
        return now_s > first_s + 1.2;
      },
      patience_ms);
  killed.kill();
  QVERIFY(killed.waitForFinished());
  said += killed.readAllStandardOutput();
  QVERIFY2(far, said.constData());
  const QStringList jobs = QDir(folder + "/unfinished").entryList(QDir::Dirs | QDir::NoDotAndDotDot);
  QCOMPARE(jobs.size(), 1);
  const auto kept = readProgress((folder + "/unfinished/" + jobs[0]).toStdString());
  VERIFY_OK(kept);
  QCOMPARE(kept->runs.size(), last()[0].toULong());
  const double lost_s = last()[1].toDouble() - kept->runs.back().duration_s;
  QVERIFY2(lost_s < 1.0, qPrintable(QString("%1 s of\n%2").arg(lost_s).arg(QString(said))));
}

int main(int argc, char** argv) {
  const QTemporaryDir kept;
  for (const char* name : {"XDG_RUNTIME_DIR", "XDG_DATA_HOME", "XDG_CONFIG_HOME"}) qputenv(name, kept.path().toUtf8());
  if (argc == 4 && QByteArray(argv[1]) == "--at-work") {
    QApplication application(argc, argv);
    wear(Theme::light);
    return work(argv[2], argv[3]);
  }
  disksAllowed = takeOwnMounts();
  QCoreApplication application(argc, argv);
  TestWindowKills test;
  return QTest::qExec(&test, argc, argv);
}
#include "tst_window_kills.moc"
