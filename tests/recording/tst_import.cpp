#include <QTest>
#include <cmath>
#include <numbers>

#include "recording/csv.h"
#include "recording/import/import.h"
#include "support/temporary.h"

using namespace breakaway;
using breakaway::test::TemporaryFolder;

/// Rows 0, 1, 2 of time (step 1 ms), angle (0, 90°, 180°) and current (0, 0.5 A, −1.5 A) are what every form below
/// holds.
class TestImport : public QObject {
  Q_OBJECT
 private slots:
  void everyForm_givesTheSameRecording_data();
  void everyForm_givesTheSameRecording();
  void badFiles_getOneLine_data();
  void badFiles_getOneLine();
  void map_comesBeforeGuessing();
  void mapThatDoesNotFit_isTold_data();
  void mapThatDoesNotFit_isTold();
  void timeWithoutUnit_isJudgedByItsSteps();
  void timesOfDay_startAtZero();
  void clocksWithoutMarks_areRead_data();
  void clocksWithoutMarks_areRead();
  void unusedText_isLeftOut_usedText_isAnError();
  void lineCutShortAtTheEnd_isLeftOut();
  void timeOfSteps_isMarkedAsAGuess();
  void namesAbove_eventsBetween_areFound();
  void stampsWithoutName_areTheTime();

 private:
  TemporaryFolder folder_;
};

void TestImport::everyForm_givesTheSameRecording_data() {
  QTest::addColumn<QByteArray>("text");
  const auto row = [](const char* name, const QByteArray& text) { QTest::newRow(name) << text; };
  const QByteArray rad = "1.5707963267948966", turn = "3.141592653589793";
  row("our own", "time_s,angle_rad,current_A\n0,0,0\n0.001," + rad + ",0.5\n0.002," + turn + ",-1.5\n");
  row("mark, CRLF, semicolons, decimal commas, German names",
      "\xEF\xBB\xBFZeit [ms];Winkel [°];Strom [A]\r\n0,0;0,0;0,0\r\n1,0;90,0;0,5\r\n2,0;180,0;-1,5\r\n");
  row("tabs, µs, mA", "t_us\tangle_deg\tcurrent_mA\n0\t0\t0\n1000\t90\t500\n2000\t180\t-1500\n");
  row("blanks, header behind a comment mark",
      "# rig: 3\n# time angle_deg iq\n 0 0 0\n 0.001  90 0.5\n0.002 180 -1.5\n");
  row("a line of units", "Time;Angle;Current\nms;deg;mA\n0;0;0\n1;90;500\n2;180;-1500\n");
  row("quotes, preamble, an unused column",
      "Logger 3000\nSerial;17\n\n\"time (s)\",\"angle, shaft (deg)\",\"state\",\"current "
      "(A)\"\n0,0,RUN,0\n0.001,90,RUN,0.5\n0.002,180,STOP,-1.5\n");
  row("old Mac line ends, bars", "time_s|angle_deg|current_A\r0|0|0\r0.001|90|0.5\r0.002|180|-1.5\r");
  row("JSON",
      R"({"rig": "x", "entries": [{"time": 0, "angle_deg": 0, "iq": 0}, {"time": 0.001, "angle_deg": 90, "iq": 0.5},
      {"time": 0.002, "angle_deg": 180, "iq": -1.5}]})");
  QByteArray utf16("\xFF\xFE", 2);
  for (const char c : QByteArray("time_s\tangle_deg\tiq\r\n0\t0\t0\r\n0,001\t90\t0,5\r\n0,002\t180\t-1,5\r\n"))
    utf16.append(c).append('\0');
  row("UTF-16", utf16);
}

void TestImport::everyForm_givesTheSameRecording() {
  QFETCH(QByteArray, text);
  const auto imported = importRecording(folder_.write("log.txt", text.toStdString()));
  VERIFY_OK(imported);
  const Recording& recording = imported->recording;
  QCOMPARE(recording.rows(), size_t(3));
  for (const char* name : {"time_s", "angle_rad", "current_A"}) QVERIFY2(recording.has(name), name);
  const double current[] = {0.0, 0.5, -1.5};
  for (size_t k = 0; k < 3; ++k) {
    QVERIFY(std::abs(recording.time()[k] - 1e-3 * double(k)) < 1e-15);
    QVERIFY(std::abs(recording.channel("angle_rad")[k] - double(k) * std::numbers::pi / 2.0) < 1e-14);
    QVERIFY(std::abs(recording.channel("current_A")[k] - current[k]) < 1e-15);
  }
  VERIFY_OK(writeCsv(recording, folder_.path("r.csv")));
  VERIFY_OK(readCsv(folder_.path("r.csv")));
}

void TestImport::badFiles_getOneLine_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QString>("line");
  const auto row = [](const char* name, const QByteArray& text, const char* line) {
    QTest::newRow(name) << text << QString::fromUtf8(line);
  };
  row("empty", "", "is empty, expected a table");
  row("a text that looks like Python", "[\"{'\"]",
      "holds no log: expected \"entries\": an array of objects, one per sample, or arrays by name");
  row("a range without end", "# name: t\n# type: range\n# base, limit, increment\n0 1e300 1e-3\n",
      "the range t has more values than a log");
  row("prose", "Dear colleague,\nthe log is on the other disk.\n",
      "holds no table: expected rows of at least two numbers, separated by commas, semicolons, tabs or blanks");
  row("no time", "angle,current\n0,0\n1,1\n",
      "no column could be taken for the time; there are: angle_rad, current_A; say which with --map, or how far the "
      "rows are apart: "
      "{\"sample_time_s\": 0.01}");
  row("no angle", "time,current\n0,0\n1,1\n",
      "no column could be taken for the angle, position or speed; there are: time_s, current_A; say which with --map "
      "{\"columns\": {\"NAME\": {\"to\": \"angle_rad\", \"unit\": \"deg\"}}}");
  row("times fall", "time;angle\n0;0\n0,2;1\n0,1;2\n0,3;2\n",
      "row 3, column time_s: 0.1 does not increase after 0.2, expected strictly increasing times");
  row("text in a number", "time;angle\n0;0\n1;abc\n2;0\n", "row 2, column angle: expected a number, found \"abc\"");
  row("a point and a comma", "time;angle\n0,5;0\n1,5;1.00,5\n2,5;0\n",
      "row 2, column angle: expected a number, found \"1.00,5\"");
  row("ragged", "time,angle\n0,0\n1,1,1\n2,2\n3,3\n", "row 2: has 3 cells, expected 2");
  row("broken JSON", "{\"entries\":\n [{\"t\": }]}", "line 2: is not valid JSON");
  row("JSON without a log", "{\"a\": 1}",
      "holds no log: expected \"entries\": an array of objects, one per sample, or arrays by name");
  row("JSON with a hole", R"([{"t": 0, "q": 1}, {"t": 1}])", "entry 2: lacks the field q");
}

void TestImport::badFiles_getOneLine() {
  QFETCH(QByteArray, text);
  QFETCH(QString, line);
  const std::string path = folder_.write("log.txt", text.toStdString());
  const auto imported = importRecording(path);
  QVERIFY(!imported.ok());
  const std::string message = imported.error().message();
  QVERIFY2(message == path + ": " + line.toStdString() || message == path + ", " + line.toStdString(), message.c_str());
}

void TestImport::map_comesBeforeGuessing() {
  const auto map =
      readImportMap(folder_.write("map.json", R"({"columns": {"angle": {"to": "angle_rad", "scale": 0.5, "offset": 1},
      "amps": {"to": "current_A"}, "voltage": {"to": "monitor"}}})"));
  VERIFY_OK(map);
  const auto imported = importRecording(folder_.write("log.csv", "t,angle,amps,voltage\n0,2,3,5\n0.1,4,3,5\n"), *map);
  VERIFY_OK(imported);
  QCOMPARE(imported->recording.channel("angle_rad")[1], 3.0);
  QCOMPARE(imported->recording.channel("current_A")[0], 3.0);
  QVERIFY(imported->recording.has("monitor") && !imported->recording.has("voltage_V"));
}

void TestImport::mapThatDoesNotFit_isTold_data() {
  QTest::addColumn<QByteArray>("map");
  QTest::addColumn<QString>("line");
  const auto row = [](const char* name, const QByteArray& map, const char* line) {
    QTest::newRow(name) << map << QString(line);
  };
  row("no such column", R"({"columns": {"angel": {"to": "angle_rad"}}})",
      "has no column \"angel\", which the map names, did you mean angle?");
  row("two into one", R"({"columns": {"angle": {"to": "x"}, "t": {"to": "x"}}})", "two columns become x");
  row("unknown field", R"({"columns": {"angle": {"to": "x", "scael": 2}}})",
      "columns.angle.scael: is an unknown field, did you mean scale?");
  row("a unit that isn't one", R"({"columns": {"angle": {"to": "angle_rad", "unit": "furlongs"}}})",
      "columns.angle.unit: is no unit that import knows");
  row("a unit and a scale", R"({"columns": {"angle": {"to": "angle_rad", "unit": "deg", "scale": 2}}})",
      "stands beside scale or offset");
  row("unknown key", R"({"sampletime_s": 0.01})", "sampletime_s: is an unknown field, did you mean sample_time_s?");
  row("no step", R"({"sample_time_s": 0})", "sample_time_s");
  row("sign that is none", R"({"sign": {"angle": 2}})", "must be 1 or -1");
  row("scale of nothing", R"({"columns": {"angle": {"to": "x", "scale": 0}}})",
      "is 0, which would leave nothing of the column");
  row("a comma in a name", R"({"columns": {"angle": {"to": "a,b"}}})", "expected a column's name");
}

void TestImport::mapThatDoesNotFit_isTold() {
  QFETCH(QByteArray, map);
  QFETCH(QString, line);
  const std::string log = folder_.write("log.csv", "t,angle\n0,2\n0.1,4\n");
  const auto read = readImportMap(folder_.write("map.json", map.toStdString()));
  const auto imported = read ? importRecording(log, *read) : Result<Imported>(read.error());
  QVERIFY(!imported.ok());
  QVERIFY2(imported.error().message().find(line.toStdString()) != std::string::npos,
           imported.error().message().c_str());
}

void TestImport::timeWithoutUnit_isJudgedByItsSteps() {
  const auto last = [this](const char* text) {
    const auto imported = importRecording(folder_.write("log.csv", text));
    return imported ? imported->recording.time().back() : -1.0;
  };
  QCOMPARE(last("t,q\n0,0\n0.25,0\n0.5,0\n"), 0.5);
  QCOMPARE(last("t,q\n0,0\n1,0\n2,0\n"), 0.002);
  QCOMPARE(last("t,q\n0,0\n1000,0\n2000,0\n"), 0.002);
  QCOMPARE(last("time_s,q\n0,0\n1,0\n2,0\n"), 2.0);
}

void TestImport::timesOfDay_startAtZero() {
  const auto imported =
      importRecording(folder_.write("log.csv", "time_ms,q\n1763668800000,0\n1763668800001,0\n1763668800002,0\n"));
  VERIFY_OK(imported);
  QCOMPARE(imported->recording.time()[0], 0.0);
  QVERIFY(std::abs(imported->recording.time()[2] - 0.002) < 1e-6);
}

void TestImport::clocksWithoutMarks_areRead_data() {
  QTest::addColumn<QString>("form");
  QTest::newRow("ISO 8601 without marks") << "20240501T1020%1.%2Z";
  QTest::newRow("as files are named") << "20240501_1020%1_%2";
  QTest::newRow("milliseconds behind a semicolon") << "10:20:%1;%2";
  QTest::newRow("milliseconds behind a colon") << "2024-05-01 10:20:%1:%2";
}

void TestImport::clocksWithoutMarks_areRead() {
  QFETCH(QString, form);
  QString text = "Time,angle_rad,current_A\n";
  for (int k = 0; k < 200; ++k)
    text += form.arg(10 + k / 100, 2, 10, QChar('0')).arg(10 * (k % 100), 3, 10, QChar('0')) +
            QString(",%1,0.5\n").arg(std::sin(0.04 * k));
  const auto imported = importRecording(folder_.write("log.csv", text.toStdString()));
  VERIFY_OK(imported);
  QVERIFY(std::abs(imported->recording.time().back() - imported->recording.time().front() - 1.99) < 1e-6);
}

void TestImport::unusedText_isLeftOut_usedText_isAnError() {
  const auto imported = importRecording(folder_.write("log.csv", "t,q,note\n0,0,1\n0.1,0,a\n0.2,0,b\n"));
  VERIFY_OK(imported);
  QVERIFY(!imported->recording.has("note"));
  QVERIFY(!importRecording(folder_.write("log.csv", "t,q,iq\n0,0,1\n0.1,0,a\n0.2,0,b\n")).ok());
}

void TestImport::lineCutShortAtTheEnd_isLeftOut() {
  const auto imported = importRecording(folder_.write("log.csv", "t,q,iq\n0,0,1\n0.1,0,2\n0.2,0"));
  VERIFY_OK(imported);
  QCOMPARE(imported->recording.rows(), size_t(2));
  QVERIFY(imported->remarks.front().find("cut short") != std::string::npos);
}

/// A motion to and fro of one axis, another of the second; in SI.
static double angleOf(int axis, int k) {
  return axis == 1 ? 5.0 * std::sin(0.04 * k) : 40.0 + 0.3 * k;
}
static double speedOf(int axis, int k) {
  return axis == 1 ? 20.0 * std::cos(0.04 * k) : 30.0;
}

void TestImport::timeOfSteps_isMarkedAsAGuess() {
  struct Form {
    const char* name;
    double step, step_s;
  };
  for (const Form& form :
       {Form{"dt", 0.01, 0.01}, {"deltaT", 10.0, 0.01}, {"delta_t", 5000.0, 0.005}, {"dt_ms", 4.0, 0.004}}) {
    QString text = QString("rpm,%1\n").arg(form.name);
    for (int k = 0; k < 60; ++k) text += QString("%1,%2\n").arg(30.0 + k).arg(form.step);
    const auto imported = importRecording(folder_.write("log.csv", text.toStdString()));
    VERIFY_OK(imported);
    const double last = imported->recording.time().back();
    QVERIFY2(std::abs(last - 59.0 * form.step_s) < 1e-9, qPrintable(QString("%1: %2").arg(form.name).arg(last)));
    QVERIFY(imported->columns[1].guessed);
  }
  const auto backwards = importRecording(folder_.write("log.csv", "rpm,dt\n1,0.1\n2,-0.1\n3,0.1\n"));
  QVERIFY(!backwards.ok());
}

void TestImport::namesAbove_eventsBetween_areFound() {
  QString text = "S,trial,t_us,rpm_left\nready\nE,1,start,1000,120,0\n";
  for (int k = 0; k < 50; ++k) text += QString("S,1,%1,%2\n").arg(1000 + 5000 * k).arg(30.0 + k);
  const auto imported = importRecording(folder_.write("log.txt", text.toStdString()));
  VERIFY_OK(imported);
  QCOMPARE(imported->recording.rows(), size_t(50));
  QVERIFY(std::abs(imported->recording.channel("velocity_rad_per_s")[49] - 79.0 * std::numbers::pi / 30.0) < 1e-9);
}

void TestImport::stampsWithoutName_areTheTime() {
  QString text = "1750000000.123,POSITION_FB,SPEED_FB\n";
  for (int k = 0; k < 50; ++k)
    text += QString("%1,%2,%3\n").arg(1750000000.25 + 0.01 * k, 0, 'f', 3).arg(angleOf(1, k)).arg(speedOf(1, k));
  const auto imported = importRecording(folder_.write("log.csv", text.toStdString()));
  VERIFY_OK(imported);
  QVERIFY(std::abs(imported->recording.time()[49] - 0.49) < 1e-6);
}

QTEST_APPLESS_MAIN(TestImport)
#include "tst_import.moc"
