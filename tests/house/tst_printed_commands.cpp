// What README and manual print to be typed works as it is printed, and says what they print below it.
#include <matio.h>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTest>
#include <algorithm>
#include <iterator>
#include <memory>

#include "base/atomic_file.h"
#include "house/program.h"
#include "recording/csv.h"
#include "support/printed_output.h"
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
  void printedOutput_isOfACommandThatIsRun();
  void plantedCommand_fails();
  void plantedOutput_fails_data();
  void plantedOutput_fails();
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
  for (const char* end : {".csv", ".bench.json"})
    QVERIFY(QFile::copy(inSource("tests/data/scale/angle_times_four") + end, folder + "/march" + end));
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

struct Page {
  const char* file;
  int atLeast;  ///< commands
};

constexpr Page pages[] = {{"README.md", 18},
                          {"resources/help/tutorial.md", 7},
                          {"resources/help/index.md", 1},
                          {"resources/help/commands.md", 8},
                          {"resources/help/connect.md", 3},
                          {"resources/help/diagnosis.md", 1},
                          {"resources/help/simulators.md", 4}};

void TestPrintedCommands::page_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<int>("atLeast");
  for (const Page& page : pages) QTest::newRow(page.file) << page.file << page.atLeast;
}

/// The folder that the pages begin in has outputs already.
static QString withoutEarlier(const QString& said) {
  const QString first = said.section('\n', 0, 0);
  return first.endsWith(": what an earlier run left there is replaced") ? said.section('\n', 1) : said;
}

void TestPrintedCommands::page() {
  QFETCH(QString, file);
  QFETCH(int, atLeast);
  const QString folder = QString::fromStdString(files_.path(QFileInfo(file).baseName().toStdString()));
  QCOMPARE(run("cp", {"-r", QString::fromStdString(files_.path("begin")), folder}).status, 0);
  const auto commands = commandsOf(contentOf(file));
  QVERIFY2(commands.size() >= static_cast<size_t>(atLeast), qPrintable(QString::number(commands.size())));
  QStringList wrong;  // all of them at once: a run takes long
  for (const auto& [line, output] : commands) {
    const Outcome done = typed(line, folder);
    if (done.status != 0) wrong << line + ": " + done.err;
    const QString fault = output.isEmpty() ? QString() : notSaid(output, withoutEarlier(done.out));
    if (!fault.isEmpty()) wrong << line + "\n" + fault;
  }
  QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
}

/// On every page, so that no output stands below what nobody runs.
void TestPrintedCommands::printedOutput_isOfACommandThatIsRun() {
  for (const QString& name : QDir(inSource("resources/help")).entryList({"*.md"})) {
    const QString page = "resources/help/" + name, text = contentOf(page);
    if (text.count("\n```output\n") == 0) continue;
    QVERIFY2(std::any_of(std::begin(pages), std::end(pages), [&](const Page& one) { return page == one.file; }),
             qPrintable(page));
    const auto commands = commandsOf(text);
    QCOMPARE(std::count_if(commands.begin(), commands.end(), [](const auto& one) { return !one.output.isEmpty(); }),
             text.count("\n```output\n"));
  }
}

void TestPrintedCommands::plantedCommand_fails() {
  const auto commands = commandsOf(
      "text\n```\nbreakaway export --model d/model.json --as nothing --out x # says\n"
      "```\nbreakaway isn't one\n```output\nno form\n```\n```\nbreakaway exports\n```\n");
  QCOMPARE(commands.size(), size_t{2});
  QCOMPARE(commands[0].line, QString("breakaway export --model d/model.json --as nothing --out x"));
  QCOMPARE(commands[0].output, QStringList{"no form"});
  QVERIFY(commands[1].line == "breakaway exports" && commands[1].output.isEmpty());
  for (const auto& one : commands) QCOMPARE(typed(one.line, QString::fromStdString(files_.path("begin"))).status, 2);
}

void TestPrintedCommands::plantedOutput_fails_data() {
  QTest::addColumn<QString>("printed");
  QTest::addColumn<bool>("good");
  QTest::newRow("as it is") << "The gain is 1.142 A, by 3.83 ms.\nkp = 12  [11, 13]\nReport: d/report.html" << true;
  QTest::newRow("a figure that moved") << "The gain is 1.15 A, by 3.8 ms.\nkp = 12 [11, 13]\nReport: d/report.html"
                                       << true;
  QTest::newRow("left out in the line") << "The gain … ms.\nkp = 12 [11, 13]\nReport: d/report.html" << true;
  QTest::newRow("lines left out") << "The gain is 1.142 A, by 3.83 ms.\n…\nReport: d/report.html" << true;
  QTest::newRow("the rest left out") << "The gain is 1.142 A, by 3.83 ms.\n…" << true;
  QTest::newRow("another word") << "The gains is 1.142 A, by 3.83 ms.\n…" << false;
  QTest::newRow("another unit") << "The gain is 1.142 A, by 3.83 s.\n…" << false;
  QTest::newRow("far off") << "The gain is 1.25 A, by 3.83 ms.\n…" << false;
  QTest::newRow("another count") << "…\nkp = 13 [11, 13]\n…" << false;
  QTest::newRow("another sign") << "The gain is -1.142 A, by 3.83 ms.\n…" << false;
  QTest::newRow("another name") << "…\nki = 12 [11, 13]\nReport: d/report.html" << false;
  QTest::newRow("a line too few") << "The gain is 1.142 A, by 3.83 ms.\nReport: d/report.html" << false;
  QTest::newRow("a line too many") << "…\nReport: d/report.html\nDone" << false;
  QTest::newRow("without the end") << "The gain is 1.142 A, by 3.83 ms.\nkp = 12 [11, 13]" << false;
}

void TestPrintedCommands::plantedOutput_fails() {
  QFETCH(QString, printed);
  QFETCH(bool, good);
  const QString said = "The gain is 1.142 A, by 3.83 ms.\n    kp = 12  [11, 13]\nReport: d/report.html\n";
  QCOMPARE(notSaid(printed.split('\n'), said).isEmpty(), good);
}

void TestPrintedCommands::cleanupTestCase() {
  board_.terminate();
  if (board_.state() != QProcess::NotRunning) QVERIFY(board_.waitForFinished(10000));
}

QTEST_GUILESS_MAIN(TestPrintedCommands)
#include "tst_printed_commands.moc"
