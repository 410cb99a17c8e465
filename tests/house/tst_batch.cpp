#include <QCryptographicHash>
#include <QDir>
#include <QElapsedTimer>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTest>
#include <random>

#include "base/line_log.h"
#include "house/program.h"
#include "house/pushed_mass.h"
#include "support/sanitized.h"
#include "support/temporary.h"

using namespace breakaway::test;

/// Many diagnoses from one list with the real program: killed, resumed and in shards.
class TestBatch : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void finishedEntries_areNotDoneAgain();
  void halfWrittenLine_isDoneAgain();
  void shards_shareTheList();
  void shardWithoutEntries_leavesEmptyResults();
  void diagnosis_isTheOneOfDiagnose();
  void changedInput_isDoneAgain();
  void mendedInput_isDoneAgain();
  void inputThatIsGone_keepsItsResult();
  void earlierError_staysFinished();
  void furtherFields_areCarriedOver();
  void secondWriter_isRefused();
  void killedOften_endsAsUndisturbed();
  void slurmTasks_giveTheWhole();
  void slurmWithoutFiles_isRefused();
  void slurmScript_isWrittenOverNoResults();
  void resultsOfALaterVersion_areLeftAlone();
  void reports_areNamedInTheResults();

 private:
  Outcome batch(const QStringList& more = {}) const;
  QByteArray results() const;
  static QStringList ids(const QByteArray& results);

  TemporaryFolder folder_;
};

static const char* const manifest =
    R"({"id": "good", "bench": "rigs/b.json", "recordings": ["rigs/r.csv"], "heldout": ["rigs/h.csv"]}
{"id": "bad", "bench": "rigs/none.json", "recordings": ["rigs/r.csv"]}

{"id": 3, "bench": "rigs/b.json", "recordings": ["rigs/r.csv"], "heldout": ["rigs/h.csv"], "comment": "ours"}
)";

/// With 640 rows of 8 ms as short as a search takes; with 100 of 20 ms a diagnosis is soon done.
static std::string coarseRecording(int rows, double step_s) {
  return pushedMassRecording(rows, {}, "time_s,position_m,force_N", step_s).toStdString();
}

void TestBatch::initTestCase() {
  QVERIFY(breakaway::makeFolder(folder_.path("lists/rigs")));
  folder_.write("lists/rigs/b.json", pushedMassBench().toStdString());
  folder_.write("lists/rigs/r.csv", coarseRecording(100, 2e-2));
  folder_.write("lists/rigs/h.csv", coarseRecording(100, 1.95e-2));
  folder_.write("lists/rigs/long.csv", coarseRecording(sanitized ? 400 : 640, 8e-3));
  folder_.write("lists/rigs/longer.csv", coarseRecording(sanitized ? 400 : 640, 7.9e-3));
  folder_.write("lists/l.jsonl", manifest);
}

Outcome TestBatch::batch(const QStringList& more) const {
  return run(builtProgram("breakaway"), QStringList{"batch", "lists/l.jsonl", "--out", "results.jsonl"} + more,
             QString::fromStdString(folder_.path()));
}

QByteArray TestBatch::results() const {
  const auto text = breakaway::readFile(folder_.path("results.jsonl"));
  return text ? QByteArray::fromStdString(*text) : QByteArray();
}

/// The ids in order; "?" where a line is no result.
QStringList TestBatch::ids(const QByteArray& results) {
  QStringList ids;
  for (const QByteArray& line : results.split('\n')) {
    if (line.isEmpty()) continue;
    const QJsonObject object = QJsonDocument::fromJson(line).object();
    const bool good = object.contains("diagnosis") != object.contains("error");
    ids << (good ? object["id"].toVariant().toString() : QString("?"));
  }
  return ids;
}

/// Short words for a batch of its own in `folder`, mostly of entries that end in errors, at once.
static Outcome batchIn(const TemporaryFolder& folder, const QString& words = "l.jsonl --out r.jsonl") {
  return run(builtProgram("breakaway"), QString("batch " + words).split(' '), QString::fromStdString(folder.path()));
}

static QList<QJsonObject> resultsIn(const TemporaryFolder& folder, const std::string& name = "r.jsonl") {
  QList<QJsonObject> results;
  const auto lines = breakaway::readWholeLines(folder.path(name));
  for (const std::string& line : *lines) results << QJsonDocument::fromJson(QByteArray::fromStdString(line)).object();
  return results;
}

void TestBatch::finishedEntries_areNotDoneAgain() {
  const Outcome first = batch();
  QVERIFY2(first.status == 0 && first.err.isEmpty(), qPrintable(first.err));
  const QByteArray once = results();
  QCOMPARE(ids(once), (QStringList{"good", "bad", "3"}));
  const QJsonObject bad = QJsonDocument::fromJson(once.split('\n')[1]).object();
  QVERIFY2(bad["error"].toString().contains("none.json: cannot be read"), qPrintable(bad["error"].toString()));
  QCOMPARE(batch().status, 0);
  QCOMPARE(results(), once);
}

void TestBatch::halfWrittenLine_isDoneAgain() {
  QCOMPARE(batch().status, 0);
  const QByteArray whole = results();
  folder_.write("results.jsonl", whole.left(whole.size() - 100).toStdString());
  QCOMPARE(batch().status, 0);
  QCOMPARE(ids(results()), (QStringList{"good", "bad", "3"}));
  const auto keptTo = whole.lastIndexOf('\n', whole.size() - 2) + 1;
  QCOMPARE(results().left(keptTo), whole.left(keptTo));
}

void TestBatch::shards_shareTheList() {
  QFile::remove(QString::fromStdString(folder_.path("results.jsonl")));
  QCOMPARE(batch({"--shard", "2/2"}).status, 0);
  QCOMPARE(ids(results()), QStringList{"bad"});
  QCOMPARE(batch({"--shard", "1/2"}).status, 0);
  QCOMPARE(ids(results()), (QStringList{"bad", "good", "3"}));
}

void TestBatch::shardWithoutEntries_leavesEmptyResults() {
  QFile::remove(QString::fromStdString(folder_.path("results.jsonl")));
  QCOMPARE(batch({"--shard", "4/4"}).status, 0);
  const auto text = breakaway::readFile(folder_.path("results.jsonl"));
  QVERIFY(text);
  QVERIFY(text->empty());
}

void TestBatch::diagnosis_isTheOneOfDiagnose() {
  folder_.write(
      "lists/long.jsonl",
      R"({"id": 1, "bench": "rigs/b.json", "recordings": ["rigs/long.csv"], "heldout": ["rigs/longer.csv"]})");
  QCOMPARE(batchIn(folder_, "lists/long.jsonl --out long.jsonl").status, 0);
  QJsonObject got = resultsIn(folder_, "long.jsonl")[0]["diagnosis"].toObject();
  const QString words =
      "diagnose --bench lists/rigs/b.json --recording lists/rigs/long.csv --heldout lists/rigs/longer.csv --out d";
  QCOMPARE(run(builtProgram("breakaway"), words.split(' '), QString::fromStdString(folder_.path())).status, 0);
  const auto text = breakaway::readFile(folder_.path("d/diagnosis.json"));
  VERIFY_OK(text);
  QJsonObject expected = QJsonDocument::fromJson(QByteArray::fromStdString(*text)).object();
  QVERIFY(got.contains("elapsed_s") && got.contains("remarks"));
  for (const char* time : {"named_s", "elapsed_s", "cpu_s", "made"}) {
    got.remove(time);
    expected.remove(time);
  }
  QCOMPARE(got, expected);
}

/// A result as if it had been diagnosed from files with these contents.
static QByteArray diagnosedFrom(const QByteArray& id, const QList<QByteArray>& contents) {
  QJsonArray inputs;
  for (const QByteArray& one : contents) {
    const QByteArray hash = QCryptographicHash::hash(one, QCryptographicHash::Sha256).toHex();
    inputs << QJsonObject{{"path", "x"}, {"sha256", QString::fromLatin1(hash)}};
  }
  const QJsonObject diagnosis{{"made", QJsonObject{{"inputs", inputs}}}};
  return QJsonDocument({{"id", QString::fromLatin1(id)}, {"diagnosis", diagnosis}}).toJson(QJsonDocument::Compact) +
         "\n";
}

static const char* const twoEntries = R"({"id": "a", "bench": "b.json", "recordings": ["r.csv"], "heldout": ["h.csv"]}
{"id": "b", "bench": "b.json", "recordings": ["s.csv", "r.csv"]}
)";

void TestBatch::changedInput_isDoneAgain() {
  const TemporaryFolder folder;
  folder.write("l.jsonl", twoEntries);
  for (const char* name : {"b.json", "r.csv", "s.csv", "h.csv"}) folder.write(name, name);
  const QByteArray a = diagnosedFrom("a", {"b.json", "r.csv", "h.csv"}),
                   b = diagnosedFrom("b", {"b.json", "s.csv", "r.csv"});
  folder.write("r.jsonl", (a + b).toStdString());
  QCOMPARE(batchIn(folder).out, QString("r.jsonl: 2 entries, 0 done now\n"));
  QCOMPARE(*breakaway::readFile(folder.path("r.jsonl")), (a + b).toStdString());
  folder.write("s.csv", "changed");
  const Outcome outcome = batchIn(folder);
  QCOMPARE(outcome.out,
           QString("r.jsonl: 1 results done again, their inputs have changed\nr.jsonl: 2 entries, 1 done now\n"));
  const auto results = resultsIn(folder);
  QCOMPARE(results.size(), 2);
  QVERIFY(results[0]["id"] == "a" && results[0].contains("diagnosis"));
  QVERIFY(results[1]["id"] == "b" && results[1].contains("error"));  // b.json is no bench
  // another file in the manifest is another input, too
  folder.write("l.jsonl", QByteArray(twoEntries).replace("h.csv", "s.csv").toStdString());
  QVERIFY(batchIn(folder).out.startsWith("r.jsonl: 1 results done again"));
}

void TestBatch::mendedInput_isDoneAgain() {
  const TemporaryFolder folder;
  folder.write("l.jsonl", R"({"id": "a", "bench": "b.json", "recordings": ["r.csv"]})");
  QCOMPARE(batchIn(folder).status, 0);
  QVERIFY(resultsIn(folder)[0]["error"].toString().startsWith("b.json: cannot be read"));
  const QJsonArray inputs = resultsIn(folder)[0]["made"].toObject()["inputs"].toArray();
  QVERIFY(inputs.size() == 2 && inputs.at(0).toObject()["sha256"].isNull());
  QCOMPARE(batchIn(folder).out, QString("r.jsonl: 1 entries, 0 done now\n"));
  folder.write("b.json", pushedMassBench().toStdString());
  QVERIFY(batchIn(folder).out.endsWith("1 entries, 1 done now\n"));
  QCOMPARE(resultsIn(folder).size(), 1);
  QVERIFY(resultsIn(folder)[0]["error"].toString().startsWith("r.csv: cannot be read"));
}

void TestBatch::inputThatIsGone_keepsItsResult() {
  const TemporaryFolder folder;
  folder.write("l.jsonl", R"({"id": "a", "bench": "b.json", "recordings": ["r.csv"]})");
  folder.write("b.json", "b");
  folder.write("r.jsonl", diagnosedFrom("a", {"b", "r"}).toStdString());
  QCOMPARE(batchIn(folder).out,
           QString("r.jsonl: 1 results kept whose inputs can't be read any more\nr.jsonl: 1 entries, 0 done now\n"));
}

void TestBatch::earlierError_staysFinished() {
  const TemporaryFolder folder;
  folder.write("l.jsonl", R"({"id": "a", "bench": "b.json", "recordings": ["r.csv"]})");
  folder.write("r.jsonl", "{\"id\":\"a\",\"error\":\"of an earlier version\"}\n");
  QCOMPARE(batchIn(folder).out, QString("r.jsonl: 1 entries, 0 done now\n"));
}

void TestBatch::furtherFields_areCarriedOver() {
  const TemporaryFolder folder;
  folder.write(
      "l.jsonl",
      R"({"site": "Graz \u00fc", "id": 7, "bench": "b.json", "recordings": ["r.csv"], "line": 3, "error": "mine",
"diagnosis": 1, "made": {}, "tags": ["x", null]})");
  folder.write(
      "l.jsonl",
      QByteArray::fromStdString(*breakaway::readFile(folder.path("l.jsonl"))).replace('\n', ' ').toStdString());
  QCOMPARE(batchIn(folder).status, 0);
  const QJsonObject result = resultsIn(folder)[0];
  QCOMPARE(result.keys(), (QStringList{"error", "id", "line", "made", "site", "tags"}));
  QCOMPARE(result["site"].toString(), QString::fromUtf8("Graz \xc3\xbc"));
  QCOMPARE(result["line"].toInt(), 3);
  QCOMPARE(result["tags"].toArray().size(), 2);
  QVERIFY(result["error"].toString().startsWith("b.json: cannot be read"));
}

void TestBatch::secondWriter_isRefused() {
  const TemporaryFolder folder;
  folder.write("l.jsonl", R"({"id": "a", "bench": "b.json", "recordings": ["r.csv"]})");
  {
    const auto first = breakaway::OwnLineLog::open(folder.path("r.jsonl"));
    VERIFY_OK(first);
    const Outcome second = batchIn(folder);
    QCOMPARE(second.status, 2);
    QVERIFY2(second.err.startsWith("breakaway: r.jsonl: is written by another process") && second.err.count('\n') == 1,
             qPrintable(second.err));
    QVERIFY(resultsIn(folder).isEmpty());
  }
  QCOMPARE(batchIn(folder).status, 0);
  QCOMPARE(resultsIn(folder).size(), 1);
}

/// Without the run and its time.
static QByteArray lasting(const TemporaryFolder& folder, const std::string& name) {
  QString text = QString::fromStdString(*breakaway::readFile(folder.path(name)));
  return text.remove(QRegularExpression("\"(at|run|command)\":\"[^\"]*\"")).toUtf8();
}

static void writeLongList(const TemporaryFolder& folder, int entries) {
  QByteArray list;
  for (int k = 0; k < entries; ++k)
    list += "{\"id\":" + QByteArray::number(k) + ",\"bench\":\"none.json\",\"recordings\":[\"r.csv\"]}\n";
  folder.write("l.jsonl", list.toStdString());
}

void TestBatch::killedOften_endsAsUndisturbed() {
  constexpr int entries = 800;
  const TemporaryFolder folder;
  writeLongList(folder, entries);
  QElapsedTimer clock;
  clock.start();
  QCOMPARE(batchIn(folder, "l.jsonl --out whole.jsonl").status, 0);
  const auto took_ms = clock.elapsed();
  std::mt19937 random(11);
  std::uniform_real_distribution<double> part(0.05, 0.4);
  int amidst = 0;
  for (int k = 0; k < 8; ++k) {
    QProcess process;
    process.setWorkingDirectory(QString::fromStdString(folder.path()));
    process.start(builtProgram("breakaway"), {"batch", "l.jsonl", "--out", "r.jsonl"});
    QVERIFY(process.waitForStarted());
    process.waitForFinished(static_cast<int>(part(random) * static_cast<double>(took_ms)));
    process.kill();
    process.waitForFinished();
    const auto lines = breakaway::readWholeLines(folder.path("r.jsonl"));
    VERIFY_OK(lines);
    amidst += !lines->empty() && lines->size() < entries ? 1 : 0;
  }
  QVERIFY2(amidst > 0, "no kill came amidst the work");
  QCOMPARE(batchIn(folder).status, 0);
  QCOMPARE(resultsIn(folder).size(), entries);
  QVERIFY(lasting(folder, "r.jsonl") == lasting(folder, "whole.jsonl"));
}

void TestBatch::slurmTasks_giveTheWhole() {
  const TemporaryFolder folder;
  writeLongList(folder, 7);
  QCOMPARE(batchIn(folder, "l.jsonl --out whole.jsonl").status, 0);
  const Outcome outcome = batchIn(folder, "l.jsonl --out r.jsonl --slurm fleet.sh --tasks 3");
  QCOMPARE(outcome.out,
           QString("Submit it: sbatch fleet.sh\nResults: r.*-of-3.jsonl\nfleet.sh: 7 entries in 3 tasks\n"));
  QVERIFY(!folder.names().contains("r.jsonl"));
  const QString script = QString::fromStdString(folder.path("fleet.sh"));
  const QString text = QString::fromStdString(*breakaway::readFile(folder.path("fleet.sh")));
  QVERIFY(text.startsWith("#!/bin/sh\n#SBATCH ") && text.contains("\n#SBATCH --array=1-3\n"));
  QVERIFY(run("sh", {script}).status != 0);  // without a task
  if (const QString checker = QStandardPaths::findExecutable("shellcheck"); !checker.isEmpty()) {
    const Outcome checked = run(checker, {script});
    QVERIFY2(checked.status == 0, qPrintable(checked.out));
  }
  QList<QByteArray> lines;
  for (int task = 1; task <= 3; ++task) {
    for (int twice = 0; twice < 2; ++twice) {  // a task that is queued again does nothing again
      const Outcome done = run("env", {"SLURM_ARRAY_TASK_ID=" + QString::number(task), "sh", script}, QDir::tempPath());
      QVERIFY2(done.status == 0, qPrintable(done.err));
    }
    lines << lasting(folder, "r." + std::to_string(task) + "-of-3.jsonl").split('\n');
  }
  QList<QByteArray> whole = lasting(folder, "whole.jsonl").split('\n');
  lines.removeAll({});
  whole.removeAll({});
  for (QByteArray& line : lines) line.replace(QByteArray::fromStdString(folder.path()) + "/", "");
  std::sort(lines.begin(), lines.end());
  std::sort(whole.begin(), whole.end());
  QCOMPARE(lines, whole);
}

void TestBatch::slurmWithoutFiles_isRefused() {
  const TemporaryFolder folder;
  writeLongList(folder, 1);
  for (const char* words : {"l.jsonl --out - --slurm f.sh", "l.jsonl --out r.jsonl --slurm f.sh --shard 1/2",
                            "l.jsonl --out r.jsonl --slurm l.jsonl", "l.jsonl --out r.jsonl --tasks 3"}) {
    const Outcome outcome = batchIn(folder, words);
    QVERIFY2(outcome.status == 2 && outcome.err.count('\n') == 1, qPrintable(words + outcome.err));
    QCOMPARE(folder.names(), QStringList{"l.jsonl"});
  }
}

void TestBatch::slurmScript_isWrittenOverNoResults() {
  const TemporaryFolder folder;
  writeLongList(folder, 2);
  for (const std::string results : {"r.jsonl", "r.2-of-2.jsonl"}) {
    folder.write(results, R"({"id": "kept", "error": "none"})");
    const Outcome outcome =
        batchIn(folder, "l.jsonl --out r.jsonl --tasks 2 --slurm " + QString::fromStdString(results));
    QCOMPARE(outcome.status, 2);
    QVERIFY2(outcome.err.contains(": holds results, expected another file"), qPrintable(outcome.err));
    const auto left = breakaway::readFile(folder.path(results));
    QVERIFY(left && left->find("kept") != std::string::npos);
  }
  const Outcome odd = run(builtProgram("breakaway"), {"batch", "l.jsonl", "--out", "r.jsonl", "--slurm", "my fleet.sh"},
                          QString::fromStdString(folder.path()));
  QVERIFY2(odd.out.startsWith("Submit it: sbatch 'my fleet.sh'\n"), qPrintable(odd.out));
}

void TestBatch::resultsOfALaterVersion_areLeftAlone() {
  const TemporaryFolder folder;
  writeLongList(folder, 1);
  const std::string later = "{\"id\":0,\"diagnosis\":{\"schema\":\"breakaway.diagnosis/2\"}}\n";
  folder.write("r.jsonl", later);
  const Outcome outcome = batchIn(folder);
  QCOMPARE(outcome.status, 2);
  QVERIFY2(outcome.err.startsWith("breakaway: r.jsonl, line 1, field diagnosis.schema: is \"breakaway.diagnosis/2\""),
           qPrintable(outcome.err));
  const auto left = breakaway::readFile(folder.path("r.jsonl"));
  QVERIFY(left && *left == later);
}

void TestBatch::reports_areNamedInTheResults() {
  QFile::remove(QString::fromStdString(folder_.path("results.jsonl")));
  QCOMPARE(batch({"--shard", "1/3", "--reports", "all/reports"}).status, 0);
  const QJsonObject result = QJsonDocument::fromJson(results()).object();
  QCOMPARE(result["report"].toString(), QString("all/reports/good/report.html"));
  const auto report = breakaway::readFile(folder_.path("all/reports/good/report.html"));
  QVERIFY(report && report->starts_with("<!DOCTYPE html>"));
  const auto diagnosis = breakaway::readFile(folder_.path("all/reports/good/diagnosis.json"));
  VERIFY_OK(diagnosis);
  const QJsonObject written = QJsonDocument::fromJson(QByteArray::fromStdString(*diagnosis)).object();
  QCOMPARE(written["made"], result["diagnosis"].toObject()["made"]);
  QCOMPARE(written["base"], result["diagnosis"].toObject()["base"]);
}

QTEST_APPLESS_MAIN(TestBatch)
#include "tst_batch.moc"
