#include <QCryptographicHash>
#include <QDirIterator>
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTest>

#include "house/program.h"
#include "support/temporary.h"

using namespace breakaway::test;

/// Every JSON file, report and figure that a command writes says which run of which program made it, of what.
class TestProvenance : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void everyOutput_saysWhereItComesFrom_data();
  void everyOutput_saysWhereItComesFrom();
  void everyCommand_isInThisTest();
  void inputs_areNamedWithTheirHash();
  void measurements_nameTheBoardAndItsTime();
  void sameCommand_differsInTimeAndRunOnly();
  void fileWithoutIt_wouldBeFound();

 private:
  Outcome breakaway(const QString& words) const;
  QString path(const QString& name) const { return QString::fromStdString(folder_.path(name.toStdString())); }

  TemporaryFolder folder_;
  QString version_;
  QSet<QString> seen_;
};

namespace {

struct Row {
  const char* words;
  int files;  ///< at least so many that must say it
};

// In this order: later ones read what earlier ones wrote.
const Row rows[] = {
    {"diagnose --bench b.json --recording r.csv --out out/d --seed 3 --json", 5},
    {"check --bench b.json --recording r.csv --json", 0},
    {"fit --bench b.json --recording r.csv --out out/fit.json --json", 1},
    {"simulate --model out/fit.json --recording r.csv --out out/s.csv --json", 0},
    {"batch l.jsonl --out out/results.jsonl --json", 1},
    {"summary out/results.jsonl --out out/fleet.html --json", 1},
    {"trial --seed 3 --family clean --out out/t --json", 7},
    {"import r.csv --out out/i.csv --json", 0},
    {"commission --turns 1 --bins 36 --run-s 2 --out out/c --json", 4},
    {"export --map out/c/map.json --as json --out out/map.json --json", 1},
    {"tune --bench out/c/bench.json --out out/tune --json", 11},
    {"profile save --board simulated --profile out/p.json --json", 1},
    {"figures --bins 36 --turns 1 --out out/f --json", 30},
    {"ports --json", 0},
    {"list effects --json", 0},
    {"list presets --json", 0},
    {"list columns --json", 0},
    {"project add p out/c --json", 0},
    {"project list p --json", 0},
};

QByteArray contentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QJsonObject objectIn(const QByteArray& text) {
  return QJsonDocument::fromJson(text).object();
}

QString between(const QString& text, const QString& begin, const QString& end) {
  return text.contains(begin) ? text.section(begin, 1).section(end, 0, 0) : QString();
}

/// The text of an element.
QByteArray plain(QString text) {
  return text.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&").toUtf8();
}

/// What the file says of its making; empty where it says nothing, and nothing for other kinds of files.
std::optional<QJsonObject> madeIn(const QString& path) {
  const QByteArray content = contentOf(path);
  if (path.endsWith(".jsonl")) return objectIn(content.split('\n').first())["diagnosis"].toObject()["made"].toObject();
  if (path.endsWith(".json")) return objectIn(content)["made"].toObject();
  if (path.endsWith(".html")) return objectIn(plain(between(content, "<pre id=\"made\">", "</pre>")));
  if (path.endsWith(".svg")) return objectIn(plain(between(content, "<metadata>", "</metadata>")));
  if (path.endsWith(".png")) return objectIn(QImage(path).text("made").toUtf8());
  return {};
}

/// What is wrong with it; empty: nothing.
QString faultOf(const QJsonObject& made, const QString& version, const QString& words) {
  QStringList keys = made.keys();
  keys.sort();
  if (keys != QStringList{"at", "by", "command", "device", "inputs", "rig_time_s", "run", "seed"})
    return "has the fields " + keys.join(' ');
  if (made["by"].toString() != version) return "is by " + made["by"].toString();
  if (made["command"].toString() != "breakaway " + words) return "is by the command " + made["command"].toString();
  return made["run"].toString().size() == 36 ? QString() : "has no run";
}

}  // namespace

Outcome TestProvenance::breakaway(const QString& words) const {
  return run(builtProgram("breakaway"), words.split(' ', Qt::SkipEmptyParts), path({}));
}

void TestProvenance::initTestCase() {
  const std::string examples = qEnvironmentVariable("BREAKAWAY_SOURCE_DIR").toStdString() + "/resources/examples/";
  folder_.write("b.json", *breakaway::readFile(examples + "example.bench.json"));
  const QString table = QString::fromStdString(*breakaway::readFile(examples + "example.csv")).section('\n', 0, 6001);
  folder_.write("r.csv", (table + "\n").toStdString());
  folder_.write("l.jsonl", R"({"id": 1, "bench": "b.json", "recordings": ["r.csv"]})");
  QVERIFY(breakaway::makeFolder(folder_.path("out")));
  version_ = breakaway("--version").out.trimmed();
  QVERIFY2(QRegularExpression("^breakaway \\d+\\.\\d+\\.\\d+(\\+[0-9a-f]+(-dirty)?)?$").match(version_).hasMatch(),
           qPrintable(version_));
}

void TestProvenance::everyOutput_saysWhereItComesFrom_data() {
  QTest::addColumn<QString>("words");
  QTest::addColumn<int>("files");
  for (const Row& row : rows) QTest::newRow(row.words) << QString(row.words) << row.files;
}

void TestProvenance::everyOutput_saysWhereItComesFrom() {
  QFETCH(QString, words);
  QFETCH(int, files);
  const Outcome outcome = breakaway(words);
  QVERIFY2(outcome.status == 0 && outcome.err.isEmpty(), qPrintable(outcome.err));
  const QJsonObject answer = objectIn(outcome.out.toUtf8())["made"].toObject();
  QVERIFY2(faultOf(answer, version_, words).isEmpty(), qPrintable(faultOf(answer, version_, words) + outcome.out));
  int found = 0;
  QDirIterator walk(path("out"), QDir::Files, QDirIterator::Subdirectories);
  while (walk.hasNext()) {
    const QString file = walk.next();
    const auto made = madeIn(file);
    if (!made || seen_.contains(file)) continue;  // or an earlier command's
    seen_ << file;
    ++found;
    const QString fault = faultOf(*made, version_, words);
    QVERIFY2(fault.isEmpty(), qPrintable(file + " " + fault));
    QCOMPARE((*made)["run"], answer["run"]);
  }
  QVERIFY2(found >= files, qPrintable(QString("only %1 files").arg(found)));
}

void TestProvenance::everyCommand_isInThisTest() {
  QStringList here{"help", "burst"};  // the one writes nothing, the other only a recording, from a board with bytes
  for (const Row& row : rows) here << QString(row.words).section(' ', 0, 0);
  for (const QString& line : breakaway("--help").out.section("Subcommands:", 1).split("\n\n").first().split('\n')) {
    const QString command = line.trimmed().section(' ', 0, 0);
    QVERIFY2(command.isEmpty() || here.contains(command), qPrintable(command));
  }
}

void TestProvenance::inputs_areNamedWithTheirHash() {
  const auto made = madeIn(path("out/d/model.json"));
  QVERIFY(made);
  QCOMPARE((*made)["seed"].toInt(), 3);
  const QJsonArray inputs = (*made)["inputs"].toArray();
  QCOMPARE(inputs.size(), 2);
  for (const auto& one : inputs) {
    const QByteArray hash =
        QCryptographicHash::hash(contentOf(path(one.toObject()["path"].toString())), QCryptographicHash::Sha256);
    QCOMPARE(one.toObject()["sha256"].toString().toUtf8(), hash.toHex());
  }
  QVERIFY((*made)["device"].isNull() && (*made)["rig_time_s"].isNull());
}

void TestProvenance::measurements_nameTheBoardAndItsTime() {
  const auto made = madeIn(path("out/c/report.html"));
  QVERIFY(made);
  QVERIFY((*made)["device"]["model"].toString().size() > 3);
  QVERIFY((*made)["rig_time_s"].toDouble() > 1.0);
  QCOMPARE((*made)["seed"].toInt(), 1);
}

void TestProvenance::sameCommand_differsInTimeAndRunOnly() {
  const QString words = "fit --bench b.json --recording r.csv --out out/again.json";
  QList<QJsonObject> twice;
  for (int k = 0; k < 2; ++k) {
    QCOMPARE(breakaway(words).status, 0);
    twice << objectIn(contentOf(path("out/again.json")));
  }
  QVERIFY(twice[0] != twice[1]);
  for (QJsonObject& one : twice) {
    QJsonObject made = one["made"].toObject();
    made.remove("at");
    made.remove("run");
    one["made"] = made;
  }
  QCOMPARE(twice[0], twice[1]);
}

void TestProvenance::fileWithoutIt_wouldBeFound() {
  folder_.write("bare.json", R"({"schema": "breakaway.map/1"})");
  QVERIFY(!faultOf(madeIn(path("bare.json")).value(), version_, "x").isEmpty());
  folder_.write("bare.svg", "<svg></svg>");
  QVERIFY(!faultOf(madeIn(path("bare.svg")).value(), version_, "x").isEmpty());
}

QTEST_GUILESS_MAIN(TestProvenance)
#include "tst_provenance.moc"
