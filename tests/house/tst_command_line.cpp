#include <fmt/core.h>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "house/program.h"
#include "recording/csv.h"
#include "support/temporary.h"

using namespace breakaway::test;
using breakaway::readCsv;

/// The line that a person types: help, version, answers for people and for programs, and what is said of a wrong one.
class TestCommandLine : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void version_isTheSameEverywhere();
  void help_isThatOfTheCommand();
  void everyHelp_hasExamplesThatAreRight();
  void wrongLine_namesTheRightHelp_data();
  void wrongLine_namesTheRightHelp();
  void lists_areForPeopleAndPrograms();
  void json_isOneObjectAndQuietSaysNothing();
  void importedGuess_comesWithItsDoubt();
  void lastLine_saysWhereTheResultIs();
  void dash_isStandardInput();
  void import_takesAStretch();
  void twoJobs_giveWhatOneGives();
  void header_holdsOnlyWhatCCanRead();
  void window_withoutDisplay_saysSoInOneLine();

 private:
  Outcome breakaway(const QString& words, const QByteArray& input = {}) const;

  TemporaryFolder folder_;
};

namespace {

QJsonObject objectIn(const QString& text) {
  return QJsonDocument::fromJson(text.toUtf8()).object();
}

/// Without a display to be found, whatever this machine has.
Outcome withoutDisplay(const QStringList& words) {
  QProcess process;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) environment.remove(name);
  process.setProcessEnvironment(environment);
  process.start(builtProgram("breakaway-gui"), words);
  if (!process.waitForFinished(300000) || process.exitStatus() != QProcess::NormalExit) return {};
  return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
          QString::fromUtf8(process.readAllStandardError())};
}

}  // namespace

Outcome TestCommandLine::breakaway(const QString& words, const QByteArray& input) const {
  QProcess process;
  process.setWorkingDirectory(QString::fromStdString(folder_.path()));
  process.start(builtProgram("breakaway"), words.split(' ', Qt::SkipEmptyParts));
  process.write(input);
  process.closeWriteChannel();
  if (!process.waitForFinished(300000) || process.exitStatus() != QProcess::NormalExit) return {};
  return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
          QString::fromUtf8(process.readAllStandardError())};
}

/// Of a table as CSV, whose head stays; what is diagnosed of it is as much in a third of the time.
static QString everyFourthRow(const QString& table) {
  QStringList kept;
  int row = 0;
  for (const QString& line : table.split('\n')) {
    if (line.startsWith('#') || line.contains("time_s") || row++ % 4 == 0) kept << line;
  }
  return kept.join('\n') + "\n";
}

void TestCommandLine::initTestCase() {
  const std::string examples = qEnvironmentVariable("BREAKAWAY_SOURCE_DIR").toStdString() + "/resources/examples/";
  folder_.write("b.json", *breakaway::readFile(examples + "example.bench.json"));
  const QString rows = QString::fromStdString(*breakaway::readFile(examples + "example.csv")).section('\n', 0, 6001);
  folder_.write("r.csv", (rows + "\n").toStdString());
  folder_.write("coarse.csv", everyFourthRow(rows).toStdString());
}

void TestCommandLine::version_isTheSameEverywhere() {
  const QString version = breakaway("--version").out.section(' ', 1).trimmed();
  QVERIFY(version.size() >= 5);
  QCOMPARE(run(builtProgram("breakaway-board"), {"--version"}).out.section(' ', 1).trimmed(), version);
  QCOMPARE(withoutDisplay({"--version"}).out.section(' ', 1).trimmed(), version);
}

void TestCommandLine::help_isThatOfTheCommand() {
  QCOMPARE(breakaway("help").out, breakaway("--help").out);
  for (const QString& command : commands()) {
    const Outcome help = breakaway("help " + command);
    QCOMPARE(help.status, 0);
    if (command != "help") QCOMPARE(help.out, breakaway(command + " --help").out);
  }
}

void TestCommandLine::everyHelp_hasExamplesThatAreRight() {
  int examples = 0;
  for (const QString& command : commands()) {
    const QString help = breakaway("help " + command).out;
    const QStringList lines = help.section("Example", 1).split('\n');
    for (const QString& line : lines) {
      if (!line.startsWith("  ") || !line.contains("breakaway " + command)) continue;
      ++examples;
      const QString words = line.section("breakaway " + command, 1).section(" | ", 0, 0);
      for (const QString& word : words.split(' ', Qt::SkipEmptyParts))
        QVERIFY2(!word.startsWith("--") || help.contains(word + " "), qPrintable(command + ": " + word));
    }
    QVERIFY2(help.contains("Example"), qPrintable(command));
    QVERIFY2(command == "help" || (help.contains("--json ") && help.contains("--quiet ")), qPrintable(command));
  }
  QVERIFY(examples >= commands().size());
}

void TestCommandLine::wrongLine_namesTheRightHelp_data() {
  QTest::addColumn<QString>("words");
  QTest::addColumn<QString>("line");
  const auto row = [](const char* words, const char* line) { QTest::newRow(words) << QString(words) << QString(line); };
  row("diagnoze", "knows no command diagnoze (did you mean diagnose?); see breakaway --help");
  row("help diagnoze", "knows no command diagnoze (did you mean diagnose?); see breakaway --help");
  row("diagnose --recordin r.csv --bench b.json --out d",
      "diagnose knows no option --recordin (did you mean --recording?); see breakaway diagnose --help");
  row("fit --bench=b.json --methd=inverse", "fit knows no option --methd (did you mean --method?)");
  row("tune --bench b.json", "--out is required; see breakaway tune --help");
  row("tune --bench b.json --out t --stiffness hard", "hard not in {soft,medium,stiff}; see breakaway tune --help");
  row("export --map m.json --as yaml --out m",
      "yaml not in {csv,json,c-header,mat,modelica}; see breakaway export --help");
  row("list effect", "effect not in {effects,criteria,presets,columns}; see breakaway list --help");
  row("batch l.jsonl --out r.jsonl --jobs 0", "--jobs");
  row("diagnose --bench - --recording - --out d", "-: is named twice, but standard input can be read once only");
  row("import r.csv --out - --json", "--json: has no place where --out - has standard output for itself");
}

void TestCommandLine::wrongLine_namesTheRightHelp() {
  QFETCH(QString, words);
  QFETCH(QString, line);
  const Outcome outcome = breakaway(words);
  QCOMPARE(outcome.status, 2);
  QVERIFY2(outcome.err.contains(line), qPrintable(outcome.err));
  QCOMPARE(outcome.err.count('\n'), 1);
  QVERIFY2(outcome.out.isEmpty(), qPrintable(outcome.out));
}

void TestCommandLine::lists_areForPeopleAndPrograms() {
  const struct {
    const char *what, *one;
  } lists[] = {{"effects", "stribeck"}, {"presets", "servo"}, {"columns", "angle_rad"}};
  for (const auto& [what, one] : lists) {
    const QString words = breakaway(QString("list ") + what).out;
    const QJsonArray array = objectIn(breakaway(QString("list %1 --json").arg(what)).out)[what].toArray();
    QCOMPARE(words.count('\n'), array.size());
    QVERIFY(words.contains(one));
    QVERIFY(std::any_of(array.begin(), array.end(),
                        [one = one](const auto& entry) { return entry.toObject()["name"] == one; }));
  }
}

void TestCommandLine::json_isOneObjectAndQuietSaysNothing() {
  const QString fit = "fit --bench b.json --recording r.csv --out m.json";
  const QJsonObject answer = objectIn(breakaway(fit + " --json").out);
  QCOMPARE(answer["base"], objectIn(QString::fromStdString(*breakaway::readFile(folder_.path("m.json"))))["base"]);
  QVERIFY(answer["fit"].toObject()["train"].toDouble() > 0.0);
  const Outcome quiet = breakaway(fit + " --quiet");
  QCOMPARE(quiet.status, 0);
  QVERIFY(quiet.out.isEmpty() && quiet.err.isEmpty());
  const Outcome wrong = breakaway("fit --bench none.json --recording r.csv --out m.json --quiet --json");
  QCOMPARE(wrong.status, 2);
  QVERIFY(wrong.out.isEmpty() && wrong.err.contains("none.json"));
}

void TestCommandLine::importedGuess_comesWithItsDoubt() {
  // A current that never falls below zero, beside a supply's voltage: it may be the supply's, too.
  std::string log = "t,pos_rad,current_A,bus_voltage_V\n";
  for (int k = 0; k < 600; ++k) {
    const double t = 0.01 * k, push = 0.4 * std::cos(0.8 * t) + std::copysign(0.1, std::cos(0.8 * t));
    log += fmt::format("{:.2f},{:.5f},{:.4f},24.1\n", t, 20.0 * std::sin(0.8 * t), std::abs(push));
  }
  folder_.write("guess.csv", log);
  const QJsonObject answer = objectIn(breakaway("import guess.csv --explain --json").out);
  const QJsonArray columns = answer["recordings"].toArray().at(0)["columns"].toArray();
  QCOMPARE(columns.size(), 4);
  QVERIFY2(columns[2]["doubt"].toString().contains("supply"), qPrintable(columns[2]["doubt"].toString()));
  QVERIFY(columns[2]["guessed"].toBool());
  QVERIFY(columns[1]["doubt"].isNull());
}

void TestCommandLine::lastLine_saysWhereTheResultIs() {
  const struct {
    const char *words, *last;
  } rows[] = {{"diagnose --bench b.json --recording coarse.csv --out d", "Report: d/report.html"},
              {"fit --bench b.json --recording r.csv --out m.json", "Model: m.json"},
              {"import r.csv --out i.csv", "i.csv: 6000 rows, 3 columns"}};
  for (const auto& [words, last] : rows) {
    const Outcome outcome = breakaway(words);
    QCOMPARE(outcome.status, 0);
    QCOMPARE(outcome.out.trimmed().section('\n', -1), last);
  }
}

void TestCommandLine::dash_isStandardInput() {
  const QByteArray recording = QByteArray::fromStdString(*breakaway::readFile(folder_.path("r.csv")));
  QCOMPARE(breakaway("fit --bench b.json --recording r.csv --out m.json").status, 0);
  QCOMPARE(breakaway("simulate --model m.json --recording r.csv --out file.csv").status, 0);
  const Outcome piped = breakaway("simulate --model m.json --recording - --out piped.csv", recording);
  QVERIFY2(piped.status == 0, qPrintable(piped.err));
  QCOMPARE(*breakaway::readFile(folder_.path("piped.csv")), *breakaway::readFile(folder_.path("file.csv")));
  const Outcome imported = breakaway("import - --out i.csv", recording);
  QVERIFY2(imported.status == 0 && imported.out.contains("i.csv: 6000 rows"), qPrintable(imported.err));
}

void TestCommandLine::import_takesAStretch() {
  const Outcome part = breakaway("import r.csv --from 2 --to 4 --out part.csv");
  QVERIFY2(part.status == 0, qPrintable(part.err));
  const auto whole = readCsv(folder_.path("r.csv")), read = readCsv(folder_.path("part.csv"));
  VERIFY_OK(whole);
  VERIFY_OK(read);
  size_t within = 0;
  for (const double t_s : whole->time()) within += t_s >= 2.0 && t_s <= 4.0 ? 1 : 0;
  QVERIFY(within > 100);
  QCOMPARE(read->rows(), within);
  QVERIFY(read->time().front() >= 2.0 && read->time().back() <= 4.0);
  const auto& notes = read->notes();
  QVERIFY(std::any_of(notes.begin(), notes.end(), [](const auto& one) { return one.first == "cut_from"; }));
  const Outcome none = breakaway("import r.csv --from 4000 --out none.csv");
  QVERIFY2(none.status == 2 && none.err.contains("fewer than two rows between 4000 s"), qPrintable(none.err));
  QVERIFY(!QFile::exists(QString::fromStdString(folder_.path("none.csv"))));
}

void TestCommandLine::twoJobs_giveWhatOneGives() {
  QByteArray list;
  for (int k = 0; k < 3; ++k)
    list += "{\"id\":" + QByteArray::number(k) + R"(,"bench":"b.json","recordings":["coarse.csv"]})" + "\n";
  folder_.write("l.jsonl", list.toStdString());
  QMap<int, QJsonObject> found[2];
  for (int jobs = 1; jobs <= 2; ++jobs) {
    const QString out = QString("results%1.jsonl").arg(jobs);
    const Outcome outcome = breakaway(QString("batch l.jsonl --out %1 --jobs %2").arg(out).arg(jobs));
    QCOMPARE(outcome.status, 0);
    QCOMPARE(outcome.out, out + ": 3 entries, 3 done now\n");
    const auto text = breakaway::readFile(folder_.path(out.toStdString()));
    for (const QString& line : QString::fromStdString(*text).split('\n', Qt::SkipEmptyParts)) {
      QJsonObject diagnosis = objectIn(line)["diagnosis"].toObject();
      QCOMPARE(diagnosis["made"].toObject()["inputs"].toArray().size(), 2);
      for (const char* name : {"made", "named_s", "elapsed_s", "cpu_s"}) diagnosis.remove(name);
      found[jobs - 1][objectIn(line)["id"].toInt()] = diagnosis;
    }
  }
  QCOMPARE(found[0].size(), 3);
  QCOMPARE(found[0], found[1]);
}

void TestCommandLine::header_holdsOnlyWhatCCanRead() {
  QCOMPARE(breakaway("commission --turns 1 --bins 36 --run-s 2 --out c --quiet").status, 0);
  QCOMPARE(breakaway("export --map c/map.json --as c-header --out good.h").status, 0);
  const Outcome compiled =
      run("gcc", {"-fsyntax-only", "-Wall", "-Wno-unused-variable", "-Werror", "-x", "c", "good.h"},
          QString::fromStdString(folder_.path()));
  QVERIFY2(compiled.status == 0, qPrintable(compiled.err));
  QString map = QString::fromStdString(*breakaway::readFile(folder_.path("c/map.json")));
  const qsizetype bin = map.indexOf("\"static_ccw_Nm\":", map.indexOf("\"bins\""));
  const qsizetype number = map.indexOf(':', bin) + 1;
  map.replace(number, map.indexOf(',', number) - number, "1e39");
  folder_.write("huge.json", map.toStdString());
  const Outcome huge = breakaway("export --map huge.json --as c-header --out huge.h");
  QCOMPARE(huge.status, 2);
  QCOMPARE(huge.err,
           "breakaway: huge.json, bin 1, column static_ccw_Nm: is 1e+39, expected what a float of C can hold\n");
  QVERIFY(!folder_.names().contains("huge.h"));
}

void TestCommandLine::window_withoutDisplay_saysSoInOneLine() {
  const Outcome window = withoutDisplay({});
  QCOMPARE(window.status, 2);
  QVERIFY2(window.err.count('\n') == 1 && window.err.contains("has no display"), qPrintable(window.err));
  QVERIFY(window.out.isEmpty());
  const Outcome help = withoutDisplay({"--help"});
  QCOMPARE(help.status, 0);
  QVERIFY(help.out.contains("--board") && help.out.contains("Examples:"));
}

QTEST_APPLESS_MAIN(TestCommandLine)
#include "tst_command_line.moc"
