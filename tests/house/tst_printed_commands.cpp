// What README and manual print to be typed works as it is printed, and says what they print below it.
#include <fmt/core.h>
#include <matio.h>

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QProcess>
#include <QRegularExpression>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>

#include "base/atomic_file.h"
#include "house/program.h"
#include "plant/rig.h"
#include "recording/csv.h"
#include "support/printed_output.h"
#include "support/sanitized.h"
#include "support/temporary.h"
#include "support/vesc_fake.h"

using namespace breakaway::test;

/// One page after the other, in a folder that has the files that its commands begin with.
class TestPrintedCommands : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void page_data();
  void page();
  void everyBlock_isHeld();
  void plantedCommand_fails();
  void plantedOutput_fails_data();
  void plantedOutput_fails();
  void cleanupTestCase();

 private:
  Outcome typed(const QString& line, const QString& folder) const;
  void servesAs(const QString& line);
  QString asHere(QString line) const;

  TemporaryFolder files_;
  QProcess board_, served_;
  std::unique_ptr<VescFake> vesc_;
  QString port_, earlierRun_, address_;
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

/// The same as another tool's log: counts of an encoder, and a converter's steps of a current that counts the other
/// way.
static std::string logOfAnother(const breakaway::Recording& recording) {
  const auto angle = recording.channel("angle_rad"), current = recording.channel("current_A");
  std::string text = "time_s,enc1,adc3\n";
  for (size_t row = 0; row < recording.rows(); ++row)
    text += fmt::format("{},{},{}\n", recording.time()[row], std::lround(angle[row] / 0.0015339807878856412),
                        std::lround((10.0 - current[row]) / 0.0049));
  return text;
}

/// In a shell, with the programs in its path.
Outcome TestPrintedCommands::typed(const QString& line, const QString& folder) const {
  return run("/bin/sh", {"-c", "PATH=\"$BREAKAWAY_BIN_DIR:$PATH\"; " + asHere(line)}, folder);
}

/// A board in the background, at any free port of this machine.
void TestPrintedCommands::servesAs(const QString& line) {
  QString words = line;
  served_.start(builtProgram("breakaway-board"),
                words.replace(QRegularExpression("--tcp \\d+"), "--tcp 0").split(' ').mid(1));
  QVERIFY(served_.waitForReadyRead(10000));
  address_ = QString::fromUtf8(served_.readLine()).trimmed();
}

/// With this machine's boards and run, and without what is no program of ours. Only a simulated board can be given a
/// disc here.
QString TestPrintedCommands::asHere(QString line) const {
  return line.replace("build/release/bin/", "")
      .replace("serial:ttyACM0 --out disc", "simulated:disc.rig.json --out disc")
      .replace("serial:ttyACM0 --out bare", "simulated:bare.rig.json --out bare")
      .replace("serial:ttyACM0?pole_pairs", "serial:" + QString::fromStdString(vesc_->path()) + "?pole_pairs")
      .replace("serial:ttyACM0", port_)
      .replace("tcp:127.0.0.1:7000", address_)
      .replace("8b504e58", earlierRun_)
      .remove(QRegularExpression(" \\| jq .*"));
}

/// The page's own map of columns, for the log that it tells of.
static void leaveMap(const QString& page, const QString& folder) {
  for (const Block& block : blocksOf(page)) {
    QFile file(folder + "/columns.json");
    if (block.language == "json" && block.lines.join(' ').contains("\"columns\"") && file.open(QIODevice::WriteOnly))
      file.write(block.lines.join('\n').toUtf8());
  }
}

/// Empty, or why the lines don't compile and run behind what they include.
static QString compiled(const Block& block, const QString& folder) {
  QFile file(folder + "/printed.c");
  if (!file.open(QIODevice::WriteOnly)) return "no place for " + file.fileName();
  const auto includes = [](const QString& line) { return line.startsWith('#'); };
  const QStringList& lines = block.lines;
  const auto body = std::find_if_not(lines.begin(), lines.end(), includes);
  QString text = QStringList(lines.begin(), body).join('\n') + "\nint main(void) {\n";
  text += QStringList(body, lines.end()).join('\n') + "\nreturn 0;\n}\n";
  file.write(text.toUtf8());
  file.close();
  const Outcome done =
      run("/bin/sh", {"-c", "gcc -std=c99 -Wall -Wextra printed.c -o printed -lm && ./printed"}, folder);
  return done.status == 0 ? QString() : "printed.c: " + done.err;
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
  files_.write("begin/log.csv", logOfAnother(*example));
  QCOMPARE(run("/bin/sh", {"-c", "gzip -c r.csv > march.log.gz"}, folder).status, 0);
  QVERIFY(QFile::link(inSource("resources"), folder + "/resources"));
  const QString rig = contentOf("resources/presets/servo.rig.json");
  files_.write("begin/bare.rig.json", rig.toStdString());
  QString disc = rig;
  files_.write("begin/disc.rig.json",
               disc.replace("\"motor\": {", R"("motor": { "added_inertia_kg_m2": 9e-5,)").toStdString());
  QVERIFY(disc != rig);
  const auto servo = breakaway::readRig(inSource("resources/presets/servo.rig.json").toStdString());
  VERIFY_OK(servo);
  vesc_ = std::make_unique<VescFake>(*servo);
  files_.write("begin/list.jsonl", R"({"id": "one", "bench":"march.bench.json","recordings":["march.csv"]})"
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
           "cp results.jsonl shard-1.jsonl; sed 's/\"one\"/\"two\"/' results.jsonl > shard-2.jsonl",
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

/// README and the manual's pages.
static QStringList pages() {
  QStringList names = {"README.md"};
  for (const QString& name : QDir(inSource("resources/help")).entryList({"*.md"})) names << "resources/help/" + name;
  return names;
}

void TestPrintedCommands::page_data() {
  QTest::addColumn<QString>("file");
  size_t all = 0;
  for (const QString& page : pages()) {
    const size_t here = commandsOf(contentOf(page)).size();
    if (here > 0) QTest::newRow(qPrintable(page)) << page;
    all += here;
  }
  QVERIFY2(all > 50, qPrintable(QString::number(all)));
}

/// The folder that the pages begin in has outputs already.
static QString withoutEarlier(const QString& said) {
  const QString first = said.section('\n', 0, 0);
  return first.endsWith(": what an earlier run left there is replaced") ? said.section('\n', 1) : said;
}

void TestPrintedCommands::page() {
  QFETCH(QString, file);
  const QString folder = QString::fromStdString(files_.path(QFileInfo(file).baseName().toStdString()));
  QCOMPARE(run("cp", {"-r", QString::fromStdString(files_.path("begin")), folder}).status, 0);
  const auto commands = commandsOf(contentOf(file));
  leaveMap(contentOf(file), folder);
  QStringList wrong;  // all of them at once: a run takes long
  for (const auto& [line, output] : commands) {
    if (line.startsWith("breakaway-board ")) {
      servesAs(line);
      continue;
    }
    const Outcome done = typed(line, folder);
    if (done.status != 0) wrong << line + ": " + done.err;
    const QString fault = output.isEmpty() ? QString() : notSaid(output, withoutEarlier(done.out));
    if (!fault.isEmpty()) wrong << line + "\n" + fault;
  }
  for (const Block& block : blocksOf(contentOf(file)))
    if (block.language == "c") wrong << compiled(block, folder);
  wrong.removeAll(QString());
  QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
}

/// Lines that other tests run.
static const char* const elsewhere[] = {
    "./dev ",                                                            // .ci/run
    "qemu-system-arm ",                                                  // tests/firmware, with the same options
    "arm-none-eabi-objcopy ",                                            // ./dev test firmware
    "build/release/bin/breakaway commission --board serial:/dev/pts/N",  // tests/firmware
    "sudo apt install ./build/package/",                                 // tests/package
    "cmake --preset package",                                            // ./dev package
    "cmake --build --preset package",                                    // the same
    "cmake --install build/package --prefix",                            // tst_install
};

/// What is wrong with a block; empty: it is run, compared, read, compiled, or run elsewhere.
static QString faultOf(const Block& block) {
  if (block.language == "output" || block.language == "c") return {};
  if (block.language == "json") {
    QString text = block.lines.join('\n').trimmed();
    if (text.startsWith('"')) text = "{" + text + "}";
    QJsonParseError error{};
    QJsonDocument::fromJson(text.toUtf8(), &error);
    return error.error == QJsonParseError::NoError ? QString() : error.errorString() + ": " + text;
  }
  if (!block.language.isEmpty()) return "a language that nobody reads: " + block.language;
  if (block.lines.contains("rule fleet:")) return {};  // tests/fleet/on_many_machines
  for (const QString& line : block.lines) {
    if (isRunHere(line) || line.isEmpty()) continue;
    if (!std::any_of(std::begin(elsewhere), std::end(elsewhere), [&](const char* one) { return line.startsWith(one); }))
      return "nobody runs " + line;
  }
  return {};
}

void TestPrintedCommands::everyBlock_isHeld() {
  QStringList wrong;
  for (const QString& page : pages()) {
    const QString text = contentOf(page);
    for (const Block& block : blocksOf(text))
      if (const QString fault = faultOf(block); !fault.isEmpty()) wrong << page + ": " + fault;
    const auto commands = commandsOf(text);
    if (std::count_if(commands.begin(), commands.end(), [](const auto& one) { return !one.output.isEmpty(); }) !=
        text.count("\n```output\n"))
      wrong << page + ": an output of no command";
  }
  QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
  for (const Block& planted : {Block{"json", {"{"}}, Block{"basic", {"10"}}, Block{"", {"format it"}}})
    QVERIFY(!faultOf(planted).isEmpty());
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
  for (QProcess* board : {&board_, &served_}) {
    board->terminate();
    if (board->state() != QProcess::NotRunning) QVERIFY(board->waitForFinished(10000));
  }
}

QTEST_GUILESS_MAIN(TestPrintedCommands)
#include "tst_printed_commands.moc"
