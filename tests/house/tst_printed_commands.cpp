// What README and manual print to be typed works as it is printed.
#include <matio.h>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTest>
#include <memory>

#include "base/atomic_file.h"
#include "house/program.h"
#include "recording/csv.h"
#include "support/sanitized.h"
#include "support/temporary.h"

using namespace breakaway::test;

/// One page after the other, in a folder that has the files that its commands begin with.
class TestPrintedCommands : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void page_data();
  void page();
  void plantedCommand_fails();
  void cleanupTestCase();

 private:
  Outcome typed(const QString& line, const QString& folder) const;
  QString asHere(QString line) const;

  TemporaryFolder files_;
  QProcess board_;
  QString port_, earlierRun_;
};

static QString inSource(const QString& path) {
  return qEnvironmentVariable("BREAKAWAY_SOURCE_DIR") + "/" + path;
}

static QString contentOf(const QString& file) {
  return QString::fromStdString(*breakaway::readFile(inSource(file).toStdString()));
}

/// The lines of a page's blocks that call the program, without what they say of themselves.
static QStringList commandsOf(const QString& page) {
  QStringList commands;
  const QStringList parts = page.split("\n```");
  for (qsizetype k = 1; k < parts.size(); k += 2) {
    for (QString line : parts[k].split('\n')) {
      line = line.section(" #", 0, 0).trimmed();
      if (line.startsWith("breakaway ")) commands << line;
    }
  }
  return commands;
}

/// A log as a lab keeps it: each signal a variable.
static void writeMat(const breakaway::Recording& recording, const std::string& path) {
  const std::unique_ptr<mat_t, int (*)(mat_t*)> file(Mat_CreateVer(path.c_str(), nullptr, MAT_FT_MAT5), Mat_Close);
  for (const auto& [name, values] : recording.channels()) {
    std::vector<double> copied = values;
    size_t shape[] = {copied.size(), 1};
    const std::unique_ptr<matvar_t, void (*)(matvar_t*)> variable(
        Mat_VarCreate(name.c_str(), MAT_C_DOUBLE, MAT_T_DOUBLE, 2, shape, copied.data(), 0), Mat_VarFree);
    Mat_VarWrite(file.get(), variable.get(), MAT_COMPRESSION_NONE);
  }
}

/// In a shell, with the programs in its path.
Outcome TestPrintedCommands::typed(const QString& line, const QString& folder) const {
  return run("/bin/sh", {"-c", "PATH=\"$BREAKAWAY_BIN_DIR:$PATH\"; " + asHere(line)}, folder);
}

/// With this machine's board and run, and without what is no program of ours.
QString TestPrintedCommands::asHere(QString line) const {
  return line.replace("serial:ttyACM0", port_)
      .replace("8b504e58", earlierRun_)
      .remove(QRegularExpression(" \\| jq .*"));
}

void TestPrintedCommands::initTestCase() {
  if (sanitized) QSKIP("takes too long under sanitizers: each command has tests of its own there");
  const QString folder = QString::fromStdString(files_.path("begin"));
  QVERIFY(QDir().mkpath(folder));
  for (const char* bench : {"rig.bench.json", "axis7.bench.json"})
    QVERIFY(QFile::copy(inSource("resources/examples/example.bench.json"), folder + "/" + bench));
  for (const char* recording : {"r.csv", "a.csv"})
    QVERIFY(QFile::copy(inSource("resources/examples/example.csv"), folder + "/" + recording));
  const auto example = breakaway::readCsv(inSource("resources/examples/example.csv").toStdString());
  VERIFY_OK(example);
  writeMat(*example, files_.path("begin/log.mat"));
  files_.write("begin/list.jsonl", R"({"id": "one", "bench":"rig.bench.json","recordings":["r.csv"]})"
                                   "\n");
  QString motor = contentOf("resources/presets/servo.bench.json");
  files_.write("begin/servo.bench.json",
               motor.replace(motor.indexOf('{'), 1, R"({"motor_serial": "0117",)").toStdString());

  board_.start(builtProgram("breakaway-board"), {"--rig", "servo"});
  QVERIFY(board_.waitForReadyRead(10000));
  port_ = QString::fromUtf8(board_.readLine()).trimmed();

  for (const char* line : {
           "breakaway commission --board simulated --out c",
           "cp c/map.json map.json",
           "breakaway diagnose --bench rig.bench.json --recording r.csv --out d",
           "breakaway tune --bench rig.bench.json --stiffness medium --out t",
           "breakaway batch list.jsonl --out results.jsonl",
           "cp results.jsonl shard-1.jsonl; cp results.jsonl shard-2.jsonl",
           "breakaway commission --board simulated --bench servo.bench.json --motor-only --out m1 --project bench3",
           "breakaway commission --board simulated --bench servo.bench.json --motor-only --out m2 --project bench3",
       }) {
    const Outcome done = typed(line, folder);
    QVERIFY2(done.status == 0, qPrintable(QString(line) + ": " + done.err));
  }
  const Outcome runs = typed("breakaway project list bench3 --motor 0117", folder);
  QCOMPARE(runs.status, 0);
  const QStringList lines = runs.out.split('\n', Qt::SkipEmptyParts);
  QVERIFY(lines.size() >= 2);
  earlierRun_ = lines[1].section(' ', 0, 0);
}

void TestPrintedCommands::page_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<int>("atLeast");
  QTest::newRow("README") << "README.md" << 18;
  QTest::newRow("tutorial") << "resources/help/tutorial.md" << 7;
  QTest::newRow("first page") << "resources/help/index.md" << 1;
  QTest::newRow("commands") << "resources/help/commands.md" << 8;
  QTest::newRow("connect") << "resources/help/connect.md" << 3;
  QTest::newRow("simulators") << "resources/help/simulators.md" << 4;
}

void TestPrintedCommands::page() {
  QFETCH(QString, file);
  QFETCH(int, atLeast);
  const QString folder = QString::fromStdString(files_.path(QFileInfo(file).baseName().toStdString()));
  QCOMPARE(run("cp", {"-r", QString::fromStdString(files_.path("begin")), folder}).status, 0);
  const QStringList commands = commandsOf(contentOf(file));
  QVERIFY2(commands.size() >= atLeast, qPrintable(QString::number(commands.size())));
  for (const QString& line : commands) {
    const Outcome done = typed(line, folder);
    QVERIFY2(done.status == 0, qPrintable(line + ": " + done.err));
  }
}

void TestPrintedCommands::plantedCommand_fails() {
  const QStringList commands = commandsOf(
      "text\n```\nbreakaway export --model d/model.json --as nothing --out x # says\n"
      "```\nbreakaway isn't one\n```\nbreakaway exports\n```\n");
  QCOMPARE(commands, (QStringList{"breakaway export --model d/model.json --as nothing --out x", "breakaway exports"}));
  for (const QString& line : commands) QCOMPARE(typed(line, QString::fromStdString(files_.path("begin"))).status, 2);
}

void TestPrintedCommands::cleanupTestCase() {
  board_.terminate();
  if (board_.state() != QProcess::NotRunning) QVERIFY(board_.waitForFinished(10000));
}

QTEST_GUILESS_MAIN(TestPrintedCommands)
#include "tst_printed_commands.moc"
