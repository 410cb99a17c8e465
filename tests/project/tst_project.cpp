// What was measured is never lost: runs go in whole or not at all, and the index follows the files whatever happens to
// it.
#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QTest>
#include <csignal>

#include "base/atomic_file.h"
#include "base/uuid.h"
#include "project/project.h"
#include "support/small_disk.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

namespace {
bool disksAllowed = false;
}

class TestProject : public QObject {
  Q_OBJECT
 private slots:
  void run_isPutInWithWhatItsFilesSay();
  void otherFolder_isNoProject();
  void mixedFiles_areRefused();
  void oddDatesAndNames_stayInTheProject();
  void noteOfAnotherProgram_isNotOverwritten();
  void runs_areListedByMotorKindAndDate();
  void ambiguousKey_isAnError();
  void history_goesByMotorOverDates();
  void deletedIndex_isMadeAnew();
  void olderIndex_isMadeAnew();
  void damagedIndex_isMadeAnew();
  void indexDamagedWhileItIsOpen_isMadeAnew();
  void damagedMark_isMadeAnew();
  void damagedRun_canBePutInAnew();
  void check_findsWhatIsMissingChangedAndUnknown();
  void twoProcesses_putIntoOneProject();
  void killedWhilePuttingIn_leavesWholeRunsOnly();
  void fullDisk_leavesNothingHalf();
  void recordingCutByAKill_isMendedAtTheNextStart();
  void runningRecording_isLeftAlone();
};

namespace {

std::string diagnosisText(double coulomb, const std::string& run = "11111111-0000-4000-8000-000000000000",
                          const std::string& at = "2026-03-02T09:14:07Z") {
  return R"({"schema": "breakaway.diagnosis/1", "verdict": "named", "base": {"coulomb_Nm": {"value": )" +
         std::to_string(coulomb) + R"(, "ci95": [)" + std::to_string(0.9 * coulomb) + ", " +
         std::to_string(1.1 * coulomb) +
         R"(]}}, "findings": [{"effect": "stribeck", "sentence": "Friction falls."}], "made": {"at": ")" + at +
         R"(", "by": "breakaway 0.1", "command": "breakaway diagnose", "device": {"model": "a board", "serial_number": "s7"}, "run": ")" +
         run + "\"}}\n";
}

std::string benchText(const std::string& serial) {
  return R"({"schema": "breakaway.bench/1", "name": "b", "motor_serial": ")" + serial +
         R"(", "drive": {"input": "torque_Nm"}})";
}

NewRun runOf(double coulomb, const std::string& motor, const std::string& at) {
  NewRun run;
  run.write = [coulomb](const std::string& folder) {
    return writeFile(folder + "/diagnosis.json", diagnosisText(coulomb));
  };
  run.motor = motor;
  run.at = at;
  return run;
}

Project opened(const TemporaryFolder& folder) {
  auto project = Project::open(folder.path("p"), Project::Missing::isMade);
  if (!project) qFatal("%s", project.error().message().c_str());
  return std::move(*project);
}

size_t runsIn(const Project& project) {
  const auto runs = project.index().list({});
  return runs ? runs->size() : 0;
}

}  // namespace

void TestProject::run_isPutInWithWhatItsFilesSay() {
  const TemporaryFolder folder;
  Project project = opened(folder);
  const std::string diagnosis = folder.write("diagnosis.json", diagnosisText(0.02));
  const std::string bench = folder.write("bench.json", benchText("0117"));
  const std::string recording = folder.write("r.csv", "# a: note\ntime_s,angle_rad\n0,1\n");
  const auto put = project.add({.sources = {diagnosis, bench, recording}, .name = "before greasing"});
  VERIFY_OK(put);
  const auto run = project.index().find("before greasing");
  VERIFY_OK(run);
  QVERIFY(*run == *put);
  QCOMPARE(run->kind, std::string("diagnosis"));
  QCOMPARE(run->motor, std::string("0117"));
  QCOMPARE(run->device, std::string("a board"));
  QCOMPARE(run->verdict, std::string("named"));
  QCOMPARE(run->findings, std::vector<std::string>{"stribeck: Friction falls."});
  QVERIFY(run->value("coulomb_Nm") != nullptr && run->value("coulomb_Nm")->high == 0.022);
  QCOMPARE(run->file("recording")->path, std::string("r.csv"));
  QCOMPARE(QFile(QString::fromStdString(project.pathOf(*run, "diagnosis.json"))).size(),
           QFile(QString::fromStdString(diagnosis)).size());
  const auto faults = project.check();
  VERIFY_OK(faults);
  QVERIFY2(faults->lines.empty(), faults->lines.empty() ? "" : faults->lines.front().c_str());
  QCOMPARE(faults->files, size_t{3});
}

void TestProject::otherFolder_isNoProject() {
  const TemporaryFolder folder;
  folder.write("letter.txt", "dear");
  VERIFY_ERROR(Project::open(folder.path()), folder.path() + ": is no project: it has no project.json");
  QVERIFY(!Project::open(folder.path(), Project::Missing::isMade).ok());
  QCOMPARE(folder.names(), QStringList("letter.txt"));
  VERIFY_ERROR(Project::open(folder.path("none")), folder.path("none") + ": is missing, expected a project's folder");
}

void TestProject::mixedFiles_areRefused() {
  const TemporaryFolder folder;
  Project project = opened(folder);
  QDir().mkpath(QString::fromStdString(folder.path("out")));
  folder.write("out/diagnosis.json", diagnosisText(0.02));
  folder.write("out/other.json", diagnosisText(0.02, "22222222-0000-4000-8000-000000000000"));
  VERIFY_ERROR(project.add({.sources = {folder.path("out")}}),
               folder.path("out") + ": holds files of 2 runs, expected one run's");
  QCOMPARE(runsIn(project), size_t{0});
  QVERIFY(QDir(QString::fromStdString(folder.path("p/runs"))).isEmpty());
}

void TestProject::oddDatesAndNames_stayInTheProject() {
  const TemporaryFolder folder;
  Project project = opened(folder);
  size_t put = 0;
  for (const char* at : {"../../elsewhere", "2026/03/02 09:14", "yesterday", "2026-03-02T09:14:07.25Z"}) {
    NewRun run;
    run.write = [at](const std::string& stage) {
      return writeFile(stage + "/diagnosis.json", diagnosisText(0.02, "11111111-0000-4000-8000-000000000000", at));
    };
    run.kind = "../odd";
    run.name = "a\nname\x1b[31m of \"ü\" '; DROP TABLE runs; --";
    const auto added = project.add(run);
    VERIFY_OK(added);
    QVERIFY2(isRunTime(added->at), added->at.c_str());
    QCOMPARE(added->name, std::string("a name [31m of \"ü\" '; DROP TABLE runs; --"));
    QCOMPARE(added->folder.find('/'), added->folder.rfind('/'));
    QCOMPARE(runsIn(opened(folder)), ++put);
  }
  QCOMPARE(project.index().find("last")->at.substr(0, 4), utcNow().substr(0, 4));
  VERIFY_OK(project.annotate("last", {"b\tc", {}, "0117'%"}));
  QCOMPARE(project.index().list({.motor = "0117'%"})->at(0).name, std::string("b c"));
  QCOMPARE(folder.names(), QStringList("p"));
  QVERIFY(project.check()->lines.empty());
}

void TestProject::noteOfAnotherProgram_isNotOverwritten() {
  const TemporaryFolder folder;
  Project project = opened(folder);
  auto run = project.add(runOf(0.02, "0117", "2026-01-05T10:00:00Z"));
  VERIFY_OK(run);
  run->name = "by another";
  VERIFY_OK(writeRunFile(*run, folder.path("p/" + run->folder)));  // which this index hasn't heard of
  VERIFY_OK(project.annotate(run->id, {{}, "cold", {}}));
  QCOMPARE(project.index().find(run->id)->name, std::string("by another"));
  QCOMPARE(opened(folder).index().find(run->id)->remark, std::string("cold"));
}

void TestProject::runs_areListedByMotorKindAndDate() {
  const TemporaryFolder folder;
  Project project = opened(folder);
  VERIFY_OK(project.add(runOf(0.02, "0117", "2026-01-05T10:00:00Z")));
  VERIFY_OK(project.add(runOf(0.03, "0117", "2026-03-05T10:00:00Z")));
  VERIFY_OK(project.add(runOf(0.04, "0118", "2026-02-05T10:00:00Z")));
  const auto dates = [&](const RunFilter& filter) {
    QStringList all;
    const auto runs = project.index().list(filter);
    for (const ProjectRun& run : *runs) all << QString::fromStdString(run.at.substr(0, 7));
    return all.join(' ');
  };
  QCOMPARE(dates({}), QString("2026-03 2026-02 2026-01"));
  QCOMPARE(dates({.motor = "0117"}), QString("2026-03 2026-01"));
  QCOMPARE(dates({.since = "2026-02"}), QString("2026-03 2026-02"));
  QCOMPARE(dates({.until = "2026-02"}), QString("2026-02 2026-01"));
  QCOMPARE(dates({.kind = "tuning"}), QString());
  QCOMPARE(dates({.device = "a board"}), QString("2026-03 2026-02 2026-01"));
  QCOMPARE(dates({.device = "s7"}), QString("2026-03 2026-02 2026-01"));  // by its serial number
  QCOMPARE(dates({.device = "another"}), QString());
  QCOMPARE(dates({.most = 1}), QString("2026-03"));
  QCOMPARE(project.index().motors()->size(), size_t{2});
}

void TestProject::ambiguousKey_isAnError() {
  const TemporaryFolder folder;
  Project project = opened(folder);
  NewRun run = runOf(0.02, "0117", "2026-01-05T10:00:00Z");
  run.name = "the same";
  VERIFY_OK(project.add(run));
  VERIFY_OK(project.add(run));
  QVERIFY(project.index().find("the same").error().fact.starts_with("has 2 runs"));
  QVERIFY(project.index().find("none").error().fact.starts_with("has no run"));
  QVERIFY(!project.index().find("").ok());
  QVERIFY(project.index().find("2026-01-05").error().fact.starts_with("has 2 runs"));
  VERIFY_OK(project.add(runOf(0.02, "0117", "2026-02-05T10:00:00Z")));
  QCOMPARE(project.index().find("2026-02-05")->at, std::string("2026-02-05T10:00:00Z"));
  QVERIFY(!project.index().find("2026-02").ok());
  VERIFY_OK(project.index().find("last"));
}

void TestProject::history_goesByMotorOverDates() {
  const TemporaryFolder folder;
  Project project = opened(folder);
  VERIFY_OK(project.add(runOf(0.03, "0117", "2026-03-05T10:00:00Z")));
  VERIFY_OK(project.add(runOf(0.02, "0117", "2026-01-05T10:00:00Z")));
  VERIFY_OK(project.add(runOf(0.04, "0118", "2026-02-05T10:00:00Z")));
  const auto history = project.index().history({.motor = "0117"});
  VERIFY_OK(history);
  QCOMPARE(history->size(), size_t{2});
  QCOMPARE((*history)[0].value.value, 0.02);
  QCOMPARE((*history)[1].value.value, 0.03);
}

void TestProject::deletedIndex_isMadeAnew() {
  const TemporaryFolder folder;
  { VERIFY_OK(opened(folder).add(runOf(0.02, "0117", "2026-01-05T10:00:00Z"))); }
  QVERIFY(QFile::remove(QString::fromStdString(folder.path("p/index.sqlite"))));
  const Project project = opened(folder);
  QCOMPARE(runsIn(project), size_t{1});
  QCOMPARE(project.said().size(), size_t{1});
  QVERIFY(project.said()[0].find("was missing: made anew from 1 runs") != std::string::npos);
  QVERIFY(opened(folder).said().empty());
}

void TestProject::olderIndex_isMadeAnew() {
  const TemporaryFolder folder;
  { VERIFY_OK(opened(folder).add(runOf(0.02, "0117", "2026-01-05T10:00:00Z"))); }
  sqlite3* database = nullptr;
  QCOMPARE(sqlite3_open(folder.path("p/index.sqlite").c_str(), &database), SQLITE_OK);
  QCOMPARE(sqlite3_exec(database, "DROP TABLE runs; CREATE TABLE runs (old TEXT); PRAGMA user_version = 0", nullptr,
                        nullptr, nullptr),
           SQLITE_OK);
  sqlite3_close(database);
  const Project project = opened(folder);
  QCOMPARE(runsIn(project), size_t{1});
  QVERIFY(project.said().at(0).find("was of another version (0, expected 1)") != std::string::npos);
}

void TestProject::damagedIndex_isMadeAnew() {
  const TemporaryFolder folder;
  { VERIFY_OK(opened(folder).add(runOf(0.02, "0117", "2026-01-05T10:00:00Z"))); }
  QFile file(QString::fromStdString(folder.path("p/index.sqlite")));
  for (const qint64 at : {qint64{0}, qint64{100}, file.size() / 2}) {
    QVERIFY(file.open(QIODevice::ReadWrite));
    QVERIFY(file.seek(at));
    QVERIFY(file.write(QByteArray(5000, 'x')) == 5000);  // more than a page: some page's head is among them
    file.close();
    const Project project = opened(folder);
    QCOMPARE(runsIn(project), size_t{1});
    QVERIFY2(project.said().size() == 1 && project.said()[0].find("was damaged") != std::string::npos,
             qPrintable(QString::number(at)));
  }
}

void TestProject::indexDamagedWhileItIsOpen_isMadeAnew() {
  const TemporaryFolder folder;
  Project project = opened(folder);
  VERIFY_OK(project.add(runOf(0.02, "0117", "2026-01-05T10:00:00Z")));
  {
    QFile file(QString::fromStdString(folder.path("p/index.sqlite")));
    QVERIFY(file.open(QIODevice::ReadWrite));
    const qint64 size = file.size();
    QVERIFY(file.write(QByteArray(static_cast<qsizetype>(size), 'x')) == size);
  }
  VERIFY_OK(project.add(runOf(0.03, "0117", "2026-01-06T10:00:00Z")));
  QCOMPARE(runsIn(project), size_t{2});
  QVERIFY(project.said().back().find("was damaged") != std::string::npos);
  QCOMPARE(runsIn(opened(folder)), size_t{2});
}

void TestProject::damagedMark_isMadeAnew() {
  const TemporaryFolder folder;
  { VERIFY_OK(opened(folder).add(runOf(0.02, "0117", "2026-01-05T10:00:00Z"))); }
  for (const char* content : {"", "{\"schema\": \"brea", "\x01\x02"}) {
    folder.write("p/project.json", content);
    const auto project = Project::open(folder.path("p"));
    VERIFY_OK(project);
    QCOMPARE(runsIn(*project), size_t{1});
    QCOMPARE(project->said().size(), size_t{1});
    QVERIFY(project->said()[0].find("project.json was damaged: made anew") != std::string::npos);
    QVERIFY(opened(folder).said().empty());
  }
  QVERIFY(QFile::remove(QString::fromStdString(folder.path("p/project.json"))));
  VERIFY_OK(Project::open(folder.path("p")));
  folder.write("p/project.json", "{\"schema\": \"breakaway.project/2\"}");  // a later version's is left alone
  QVERIFY(!Project::open(folder.path("p")).ok());
}

void TestProject::damagedRun_canBePutInAnew() {
  const TemporaryFolder folder;
  Project project = opened(folder);
  const auto run = project.add(runOf(0.02, "0117", "2026-01-05T10:00:00Z"));
  VERIFY_OK(run);
  folder.write("p/" + run->folder + "/run.json", "{\"id\": ");
  Project again = opened(folder);
  QCOMPARE(runsIn(again), size_t{0});
  QVERIFY(again.said().at(0).find("the run is left out") != std::string::npos);
  const auto faults = again.check();
  QVERIFY(faults->lines.at(0).find("breakaway project add takes what else is in it") != std::string::npos);
  const auto anew = again.add({.sources = {folder.path("p/" + run->folder)}});
  VERIFY_OK(anew);
  QCOMPARE(anew->verdict, std::string("named"));
}

void TestProject::check_findsWhatIsMissingChangedAndUnknown() {
  const TemporaryFolder folder;
  Project project = opened(folder);
  std::vector<std::string> folders;
  for (int k = 0; k < 3; ++k) {
    const auto run = project.add(runOf(0.02, "0117", "2026-01-05T10:00:00Z"));
    VERIFY_OK(run);
    folders.push_back(run->folder);
  }
  const auto file = [&](size_t k, const char* name) { return "p/" + folders[k] + "/" + name; };
  QVERIFY(QFile::remove(QString::fromStdString(folder.path(file(0, "diagnosis.json")))));
  folder.write(file(1, "diagnosis.json"), diagnosisText(0.05));
  folder.write(file(2, "more.txt"), "more");
  QDir().mkpath(QString::fromStdString(folder.path("p/runs/strange")));
  const auto faults = project.check();
  VERIFY_OK(faults);
  QCOMPARE(faults->lines.size(), size_t{4});
  std::string all;
  for (const std::string& line : faults->lines) all += line + "\n";
  for (const char* words : {"diagnosis.json: is missing", "diagnosis.json: has changed", "more.txt: isn't listed",
                            "runs/strange: has no run.json"})
    QVERIFY2(all.find(words) != std::string::npos, all.c_str());
}

void TestProject::twoProcesses_putIntoOneProject() {
  const TemporaryFolder folder;
  { opened(folder); }
  std::vector<pid_t> children;
  for (int process = 0; process < 3; ++process) {
    const pid_t child = ::fork();
    if (child == 0) {
      Project project = opened(folder);
      bool good = true;
      for (int k = 0; k < 8; ++k) good = project.add(runOf(0.02, "0117", "2026-01-05T10:00:00Z")).ok() && good;
      ::_exit(good ? 0 : 1);
    }
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = 1;
    ::waitpid(child, &status, 0);
    QCOMPARE(status, 0);
  }
  const Project project = opened(folder);
  QCOMPARE(runsIn(project), size_t{24});
  QVERIFY(project.said().empty());
  QVERIFY(project.check()->lines.empty());
}

void TestProject::killedWhilePuttingIn_leavesWholeRunsOnly() {
  const TemporaryFolder folder;
  { opened(folder); }
  for (int kill = 0; kill < 8; ++kill) {
    const pid_t child = ::fork();
    if (child == 0) {
      Project project = opened(folder);
      for (;;) static_cast<void>(project.add(runOf(0.02, "0117", "2026-01-05T10:00:00Z")));
    }
    QTest::qSleep(20 + 7 * kill);
    // A busy machine may have put none in so far.
    const QDir runs(QString::fromStdString(folder.path("p/runs")));
    for (int k = 0; kill == 7 && runs.isEmpty() && k < 2000; ++k) QTest::qSleep(10);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const Project project = opened(folder);
    const auto faults = project.check();
    VERIFY_OK(faults);
    QVERIFY2(faults->lines.empty(), faults->lines.empty() ? "" : faults->lines.front().c_str());
    QCOMPARE(
        static_cast<size_t>(
            QDir(QString::fromStdString(folder.path("p/runs"))).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size()),
        runsIn(project));
  }
  QVERIFY(runsIn(opened(folder)) > 0);
}

void TestProject::fullDisk_leavesNothingHalf() {
  if (!disksAllowed) QSKIP("no mounts are allowed here: a full disk can't be made");
  const TemporaryFolder folder;
  const SmallDisk disk(folder.path(), size_t{300} << 10U);
  QVERIFY(disk.mounted());
  Project project = opened(folder);
  size_t put = 0;
  Result<ProjectRun> last = Error{};
  do {
    NewRun run = runOf(0.02, "0117", "2026-01-05T10:00:00Z");
    run.write = [](const std::string& stage) { return writeFile(stage + "/large.txt", std::string(40000, 'x')); };
    last = project.add(run);
    put += last ? 1 : 0;
  } while (last && put < 20);
  QVERIFY(put > 0 && put < 8);
  QVERIFY2(last.error().fact.find("No space left") != std::string::npos, last.error().message().c_str());
  const Project again = opened(folder);
  QCOMPARE(runsIn(again), put);
  QVERIFY(again.check()->lines.empty());
}

void TestProject::recordingCutByAKill_isMendedAtTheNextStart() {
  const TemporaryFolder folder;
  int told[2];
  QVERIFY(::pipe(told) == 0);
  const pid_t child = ::fork();
  if (child == 0) {
    Project project = opened(folder);
    std::optional<BlockWriter> blocks;
    const auto run = project.beginRecording({}, {{"time_s", "angle_rad"}, {}}, blocks);
    const std::vector<double> rows{0.0, 1.0, 0.1, 1.1, 12.5, 1.2};
    if (!run || !blocks->append(rows)) ::_exit(1);
    if (::write(told[1], "x", 1) == 1) ::pause();
    ::_exit(1);
  }
  char byte = 0;
  QVERIFY(::read(told[0], &byte, 1) == 1);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  const Project project = opened(folder);
  QCOMPARE(project.said().size(), size_t{1});
  QVERIFY2(project.said()[0].find("12.5 s, 3 samples; ended by: a kill") != std::string::npos,
           project.said()[0].c_str());
  const auto run = project.index().find("last");
  VERIFY_OK(run);
  QCOMPARE(run->state, RunState::cut);
  QVERIFY(!run->files.at(0).sha256.empty());
  QCOMPARE(readBlocks(project.pathOf(*run, recordingFile))->rows(), size_t{3});
  QVERIFY(opened(folder).said().empty());
  const auto faults = project.check();
  VERIFY_OK(faults);
  QCOMPARE(faults->lines.size(), size_t{1});
  QVERIFY2(faults->lines[0].find("ended early: 12.5 s, 3 samples; ended by: a kill") != std::string::npos,
           faults->lines[0].c_str());
}

void TestProject::runningRecording_isLeftAlone() {
  const TemporaryFolder folder;
  Project project = opened(folder);
  std::optional<BlockWriter> blocks;
  const auto run = project.beginRecording({}, {{"time_s", "angle_rad"}, {}}, blocks);
  VERIFY_OK(run);
  const Project other = opened(folder);
  QVERIFY(other.said().empty());
  QCOMPARE(other.index().find("last")->state, RunState::recording);
  const std::vector<double> rows{0.0, 1.0, 0.1, 1.1};
  VERIFY_OK(blocks->append(rows));
  VERIFY_OK(blocks->end(""));
  const auto ended = project.endRecording(*run, "");
  VERIFY_OK(ended);
  QCOMPARE(ended->state, RunState::whole);
  QCOMPARE(ended->verdict, std::string("0.1 s, 2 samples"));
  blocks.reset();
  QVERIFY(opened(folder).check()->lines.empty());
}

int main(int argc, char** argv) {
  disksAllowed = takeOwnMounts();
  TestProject test;
  return QTest::qExec(&test, argc, argv);
}
#include "tst_project.moc"
