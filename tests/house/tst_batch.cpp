#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "house/program.h"
#include "house/pushed_mass.h"
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

/// As short as a diagnosis takes, and soon done.
static QByteArray coarseRecording(double step_s) {
  return pushedMassRecording(640, {}, "time_s,position_m,force_N", step_s);
}

void TestBatch::initTestCase() {
  QVERIFY(breakaway::makeFolder(folder_.path("lists/rigs")));
  folder_.write("lists/rigs/b.json", pushedMassBench().toStdString());
  folder_.write("lists/rigs/r.csv", coarseRecording(8e-3).toStdString());
  folder_.write("lists/rigs/h.csv", coarseRecording(7.9e-3).toStdString());
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
  QFile::remove(QString::fromStdString(folder_.path("results.jsonl")));
  QCOMPARE(batch({"--shard", "1/3"}).status, 0);
  QJsonObject got = QJsonDocument::fromJson(results()).object()["diagnosis"].toObject();
  const QString words =
      "diagnose --bench lists/rigs/b.json --recording lists/rigs/r.csv --heldout lists/rigs/h.csv --out d";
  QCOMPARE(run(builtProgram("breakaway"), words.split(' '), QString::fromStdString(folder_.path())).status, 0);
  const auto text = breakaway::readFile(folder_.path("d/diagnosis.json"));
  VERIFY_OK(text);
  QJsonObject expected = QJsonDocument::fromJson(QByteArray::fromStdString(*text)).object();
  QVERIFY(got.contains("elapsed_s") && got.contains("remarks"));
  for (const char* time : {"named_s", "elapsed_s", "made"}) {
    got.remove(time);
    expected.remove(time);
  }
  QCOMPARE(got, expected);
}

QTEST_APPLESS_MAIN(TestBatch)
#include "tst_batch.moc"
