#include <QTest>

#include "house/program.h"
#include "house/pushed_mass.h"
#include "support/temporary.h"

using namespace breakaway::test;

/// Every bad input ends the real program with status 2, one line on standard error that says where and what, nothing on
/// standard output and no file left behind.
class TestBadInput : public QObject {
  Q_OBJECT
 private slots:
  void badInput_getsOneLineAndStatus2_data();
  void badInput_getsOneLineAndStatus2();
  void goodInput_isAccepted();
};

using Files = QMap<QString, QByteArray>;

static QByteArray noNumbers() {
  QByteArray text = "time_s,position_m,force_N\n";
  for (int k = 0; k < 5000; ++k) text += QByteArray::number(1e-3 * k) + ",nan,1\n";
  return text;
}

static const char* const fit = "fit --bench b.json --recording r.csv --out m.json";
static const char* const diagnose = "diagnose --bench b.json --recording r.csv --out d";

void TestBadInput::badInput_getsOneLineAndStatus2_data() {
  QTest::addColumn<QString>("words");
  QTest::addColumn<Files>("files");
  QTest::addColumn<QString>("line");
  const auto row = [](const QString& name, const char* words, const Files& files, const char* line) {
    QTest::newRow(qPrintable(name + ": " + QString(words).section(' ', 0, 0)))
        << words << files << QString::fromUtf8(line);
  };
  for (const char* words : {fit, diagnose}) {
    const auto ofRecording = [&](const char* name, const QByteArray& text, const char* line) {
      row(name, words, {{"b.json", pushedMassBench()}, {"r.csv", text}}, line);
    };
    ofRecording("missing column", pushedMassRecording(5000, {}, "time_s,position_m,effort"),
                "r.csv: has no column force_N");
    ofRecording("time stands still", "time_s,position_m,force_N\n0,0,0\n0.1,0,0\n0.1,0,0\n",
                "r.csv, row 3, column time_s: 0.1 does not increase");
    ofRecording("text in a number", pushedMassRecording(5000, "abc"),
                "r.csv, row 100, column position_m: expected a finite number, found \"abc\"");
    ofRecording("empty file", "", "r.csv: is empty");
    ofRecording("no numbers", noNumbers(), "r.csv");
    ofRecording("too short", pushedMassRecording(5), "r.csv");
    const auto ofBench = [&](const char* name, const QByteArray& text, const char* line) {
      row(name, words, {{"b.json", text}, {"r.csv", pushedMassRecording()}}, line);
    };
    ofBench("wrong unit", pushedMassBench(R"("viscous_Nm_s_per_rad": 1)"),
            "b.json, field motor.viscous_Nm_s_per_rad: is an unknown field, did you mean viscous_N_s_per_m?");
    ofBench("negative inertia", pushedMassBench(R"("mass_kg": -1)"),
            "b.json, field motor.mass_kg: expected a positive number, found the number -1");
    ofBench("unknown field", pushedMassBench(R"("couloomb_N": 1)"),
            "b.json, field motor.couloomb_N: is an unknown field, did you mean coulomb_N?");
    ofBench("no JSON", "{\n]", "b.json, line 2: is not valid JSON");
    row("no such recording", words, {{"b.json", pushedMassBench()}}, "r.csv: cannot be read");
    row("no such bench", words, {{"r.csv", pushedMassRecording()}}, "b.json: cannot be read");
  }
  row("no such effect", "fit --bench b.json --recording r.csv --effects stribek --out m.json",
      {{"b.json", pushedMassBench()}, {"r.csv", pushedMassRecording()}}, "stribek");
  const QByteArray deep = QByteArray(1000000, '[') + QByteArray(1000000, ']');
  row("endless nesting", diagnose, {{"b.json", R"({"comment":)" + deep + "}"}, {"r.csv", pushedMassRecording()}},
      "b.json: nests deeper than 100 levels");
  row("a field twice", fit, {{"b.json", R"({"name": "a", "name": "b"})"}, {"r.csv", pushedMassRecording()}},
      "b.json: has the field name twice in one object");
  row("a column twice", fit, {{"b.json", pushedMassBench()}, {"r.csv", "time_s,a,a\n0,1,1\n1,1,1\n"}},
      "r.csv: has the column a twice");
  row("no end", "diagnose --bench /dev/zero --recording r.csv --out d", {{"r.csv", pushedMassRecording()}},
      "/dev/zero: gives more than 256 MB without an end");
  QByteArray wide = "time_s";
  for (int k = 0; k < 20000; ++k) wide += ",c" + QByteArray::number(k);
  row("columns and lines without a row", fit,
      {{"b.json", pushedMassBench()}, {"r.csv", wide + "\n" + QByteArray(400000, '\n')}},
      "r.csv: has a header and no rows");
  row("proof on what was learned", "diagnose --bench b.json --recording r.csv --heldout h.csv --out d",
      {{"b.json", pushedMassBench()}, {"r.csv", pushedMassRecording()}, {"h.csv", pushedMassRecording()}},
      "h.csv: is held out, but shares rows with r.csv");
  row("learned twice", "diagnose --bench b.json --recording r.csv r.csv --out d",
      {{"b.json", pushedMassBench()}, {"r.csv", pushedMassRecording()}}, "r.csv: shares rows with r.csv");
  row("model nested without end", "simulate --model m.json --recording r.csv --out s.csv",
      {{"m.json", R"({"effects":)" + deep + "}"}, {"r.csv", pushedMassRecording()}}, "m.json: nests deeper");
  row("map nested without end", "export --map m.json --as csv --out m.csv",
      {{"m.json", R"({"settings":)" + deep + "}"}}, "m.json: nests deeper");
  row("log nested without end", "import l.json --out m.csv", {{"l.json", deep}}, "l.json: nests deeper");
  const auto ofManifest = [&](const char* name, const QByteArray& text, const char* line) {
    row(name, "batch l.jsonl --out results.jsonl", {{"l.jsonl", text}}, line);
  };
  const QByteArray entry = R"({"id": "a", "bench": "b.json", "recordings": ["r.csv"]})";
  ofManifest("no JSON in the list", entry + "\n{]\n", "l.jsonl, line 2: is not valid JSON");
  ofManifest("list nested without end", R"({"id": 1, "recordings": )" + deep + "}", "l.jsonl, line 1: nests deeper");
  ofManifest("no id", R"({"bench": "b.json", "recordings": ["r.csv"]})", "l.jsonl, line 1: has no field id");
  ofManifest("an id twice", entry + "\n\n" + entry, "l.jsonl, line 3: has the id \"a\" once more");
  ofManifest("no bench in the list", R"({"id": 7, "recordings": ["r.csv"]})", "l.jsonl, line 1, field bench");
  ofManifest("recordings no list", R"({"id": 7, "bench": "b.json", "recordings": "r.csv"})",
             "l.jsonl, line 1, field recordings");
  row("shard beyond", "batch l.jsonl --out results.jsonl --shard 3/2", {{"l.jsonl", entry}}, "--shard: expected I/N");
  row("results that are none", "batch l.jsonl --out results.jsonl", {{"l.jsonl", entry}, {"results.jsonl", "mine\n"}},
      "results.jsonl, line 1: is not valid JSON");
  row("no list", "batch l.jsonl --out results.jsonl", {}, "l.jsonl: cannot be read");
  row("no model", "simulate --model m.json --recording r.csv --out s.csv",
      {{"m.json", "{}"}, {"r.csv", pushedMassRecording()}}, "m.json");
  row("MATLAB file cut short", "import r.mat --out r.csv",
      {{"r.mat", QByteArray("MATLAB 5.0 MAT-file").leftJustified(124, ' ') +
                     QByteArray("\x00\x01IM\x0f\x00\x00\x00\xff\xff\x00\x00", 12)}},
      "r.mat: is cut short");
  row("empty MATLAB file", "import r.mat --out r.csv", {{"r.mat", ""}}, "r.mat: is empty");
  row("no table", "import r.txt --out r.csv", {{"r.txt", "hello"}}, "r.txt: holds no table");
  row("map of another file", "import r.txt --out r.csv --map m.json",
      {{"r.txt", "t,q\n0,0\n1,1\n"}, {"m.json", R"({"columns": {"p": {"to": "angle_rad"}}})"}},
      "r.txt: has no column \"p\"");
  row("no map", "export --map m.json --as csv --out m.csv", {{"m.json", R"({"schema": "breakaway.bench/1"})"}},
      "m.json");
  row("output nowhere", "import r.txt --out none/r.csv", {{"r.txt", "t,q\n0,0\n1,1\n"}},
      "none/r.csv: cannot be written");
  row("no such board", "figures --board simulated:serwo --out d", {}, "there is no preset serwo, did you mean servo?");
  row("no such uneven board", "figures --uneven a.rig.json --out d", {}, "board a.rig.json: is no known board");
  row("no motor", "commission --out d --against m.json", {{"m.json", "{}"}}, "m.json, field schema: is missing");
  row("no motor there", "commission --out d --against m.json", {}, "m.json: cannot be read");
  row("a tolerance beyond", "commission --out d --added-inertia 1e-4 --added-tolerance 3", {}, "--added-tolerance");
  row("no time", "diagnose --bench b.json --recording r.csv --out d --time nan", {},
      "--time: is nan, expected a number from 0.001 to 1e+07");
  row("noise that is none", "tune --bench b.json --out d --current-noise-A nan", {},
      "--current-noise-A: is nan, expected a number from 0 to 1e+09");
  row("time in words", "simulate --model m.json --recording r.csv --out s.csv --restart-every often", {},
      "--restart-every: is often, expected a number");
  row("figures nowhere", "figures --out r.txt/d", {{"r.txt", "here"}}, "r.txt/d: cannot be");
  const auto ofBoard = [&](const char* name, const char* uri, const char* line) {
    for (const char* words : {"commission --out d --board ", "profile save --profile p.json --board "})
      row(name, qPrintable(words + QString(uri)), {}, line);
  };
  ofBoard("no such port", "serial:ttyNoSuchPort7", "serial port /dev/ttyNoSuchPort7: there is no such port");
  ofBoard("no serial port", "serial:/dev/null", "serial port /dev/null: is no serial port");
  ofBoard("baud in words", "serial:ttyUSB0@fast", "has the baud rate \"fast\", expected a whole number");
  ofBoard("no TCP port", "tcp:localhost:http", "has the port \"http\", expected tcp:HOST:PORT with 1 to 65535");
  ofBoard("nobody listens", "tcp:127.0.0.1:1", "127.0.0.1:1: refuses the connection");
  ofBoard("no such kind", "usb:1", "is no known board, expected simulated, serial:PORT[@BAUD] or tcp:HOST:PORT");
  ofBoard("unknown option", "serial:ttyUSB0?poles=7", "knows no option \"poles\"");
  row("no profile", "profile restore --board simulated --profile p.json", {}, "p.json: cannot be read");
  row("profile of another kind", "profile compare --board simulated --profile p.json",
      {{"p.json", R"({"schema": "breakaway.map/1"})"}}, "p.json, field schema: is \"breakaway.map/1\"");
  row("unknown action", "profile burn --board simulated --profile p.json", {}, "burn");
  row("unknown command", "diagnoze", {}, "diagnoze");
  row("no command", "", {}, "command");
  row("missing word", "import r.txt", {}, "--out is required");
}

void TestBadInput::badInput_getsOneLineAndStatus2() {
  QFETCH(QString, words);
  QFETCH(Files, files);
  QFETCH(QString, line);
  const TemporaryFolder folder;
  for (auto it = files.begin(); it != files.end(); ++it) folder.write(it.key().toStdString(), it.value().toStdString());
  const Outcome outcome =
      run(builtProgram("breakaway"), words.split(' ', Qt::SkipEmptyParts), QString::fromStdString(folder.path()));
  QVERIFY2(outcome.status == 2, qPrintable(QString("status %1, said: %2").arg(outcome.status).arg(outcome.err)));
  QVERIFY2(outcome.err.count('\n') == 1 && outcome.err.endsWith('\n'), qPrintable(outcome.err));
  QVERIFY2(outcome.err.startsWith("breakaway: ") && outcome.err.contains(line), qPrintable(outcome.err));
  QVERIFY2(outcome.out.isEmpty(), qPrintable(outcome.out));
  QCOMPARE(folder.names(), files.keys());
}

void TestBadInput::goodInput_isAccepted() {
  const TemporaryFolder folder;
  folder.write("b.json", pushedMassBench().toStdString());
  folder.write("r.csv", pushedMassRecording().toStdString());
  const Outcome outcome =
      run(builtProgram("breakaway"), QString(fit).split(' '), QString::fromStdString(folder.path()));
  QVERIFY2(outcome.status == 0 && outcome.err.isEmpty(), qPrintable(outcome.err));
  QVERIFY(folder.names().contains("m.json"));
}

QTEST_APPLESS_MAIN(TestBadInput)
#include "tst_bad_input.moc"
