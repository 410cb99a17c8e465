#include <QTest>
#include <cmath>

#include "recording/import/import.h"
#include "recording/import/told_rate.h"
#include "support/temporary.h"

using namespace breakaway;
using breakaway::test::TemporaryFolder;

/// What lines and fields beside the rows tell: how far rows are apart, whose signals these are, when they were.
class TestImportTold : public QObject {
  Q_OBJECT
 private slots:
  void rateBesideTheRows_isTheirs_data();
  void rateBesideTheRows_isTheirs();
  void ratesThatDisagree_tellNothing();
  void rateBesideATime_changesNothing();
  void signalsWithTheirOwnStamps_areATable_data();
  void signalsWithTheirOwnStamps_areATable();
  void sentencesWithBars_areRows();
  void sentencesThatBeginWithATime_haveIt_data();
  void sentencesThatBeginWithATime_haveIt();
  void jointsInUnknownUnits_stayAside();

 private:
  Result<Imported> imported(const QString& text, const char* name = "log.txt") {
    return importRecording(folder_.write(name, text.toStdString()));
  }
  TemporaryFolder folder_;
};

constexpr int rows = 60;

static double angleAt(int k) {
  return std::sin(0.1 * k);
}

void TestImportTold::rateBesideTheRows_isTheirs_data() {
  QTest::addColumn<QString>("line");
  QTest::addColumn<double>("step_s");
  const auto row = [](const char* line, double step_s) { QTest::newRow(line) << line << step_s; };
  row("# sample rate: 100 Hz", 0.01);
  row("# Fs = 200", 0.005);
  row("Sampling Period;10;ms", 0.01);
  row("# dt: 0.002", 0.002);
  row("Period: 10 ms", 0.01);
  row("rate_hz,50", 0.02);
  row("# sample_time_us: 500", 0.0005);
  row("# period: 10", 0.0);  // of what?
  row("# gear ratio: 100", 0.0);
  row("# frame rate: fast", 0.0);
  row("# dt: 0", 0.0);
}

void TestImportTold::rateBesideTheRows_isTheirs() {
  QFETCH(QString, line);
  QFETCH(double, step_s);
  QString text = line + "\nangle_rad,current_A\n";
  for (int k = 0; k < rows; ++k) text += QString("%1,0.5\n").arg(angleAt(k));
  const auto log = imported(text);
  QCOMPARE(log.ok(), step_s > 0.0);
  if (!log) return;
  QVERIFY(std::abs(log->recording.time()[1] - step_s) < 1e-9);
  QVERIFY(std::any_of(log->remarks.begin(), log->remarks.end(), [](const auto& remark) {
    return remark.english().find("sample interval") != std::string::npos;
  }));
}

void TestImportTold::ratesThatDisagree_tellNothing() {
  RawTable table;
  table.notes = {{"dt", "0.01"}, {"sample rate", "50 Hz"}};
  QVERIFY(!toldStep_s(table));
  table.notes[1].second = "100 Hz";
  QVERIFY(toldStep_s(table).has_value());
  table.notes[1].second = "1e300 Hz";
  QVERIFY(toldStep_s(table).has_value());
}

void TestImportTold::rateBesideATime_changesNothing() {
  QString text = "# dt: 0.5\ntime_s,angle_rad\n";
  for (int k = 0; k < rows; ++k) text += QString("%1,%2\n").arg(0.01 * k).arg(angleAt(k));
  const auto log = imported(text);
  QVERIFY(log.ok());
  QVERIFY(std::abs(log->recording.time()[1] - 0.01) < 1e-9);
}

void TestImportTold::signalsWithTheirOwnStamps_areATable_data() {
  QTest::addColumn<QString>("before");
  QTest::addColumn<QString>("between");
  QTest::addColumn<QString>("behind");
  QTest::addColumn<bool>("pairs");
  QTest::newRow("x and y by name") << R"({"arm/angle_rad": {)"
                                   << R"(}, "arm/speed [rad/s]": {)"
                                   << "}}" << false;
  QTest::newRow("time and value with units") << R"([{"name": "angle", "unit": "rad", )"
                                             << R"(}, {"name": "speed", "unit": "rad/s", )"
                                             << "}]" << false;
  QTest::newRow("pairs") << R"({"series": [{"label": "angle_rad", "values": )"
                         << R"(}, {"label": "speed_rad_s", "values": )"
                         << "}]}" << true;
}

void TestImportTold::signalsWithTheirOwnStamps_areATable() {
  QFETCH(QString, before);
  QFETCH(QString, between);
  QFETCH(QString, behind);
  QFETCH(bool, pairs);
  const auto signal = [pairs](bool speed) {
    QStringList times, values, both;
    for (int k = 0; k < rows; ++k) {
      times.append(QString::number(0.01 * k));
      values.append(QString::number(speed ? 10.0 * std::cos(0.1 * k) : angleAt(k)));
      both.append("[" + times.back() + ", " + values.back() + "]");
    }
    return pairs ? "[" + both.join(", ") + "]"
                 : "\"x\": [" + times.join(", ") + "], \"y\": [" + values.join(", ") + "]";
  };
  const auto log = imported(before + signal(false) + between + signal(true) + behind, "log.json");
  QVERIFY(log.ok());
  QCOMPARE(log->recording.rows(), size_t{rows});
  QVERIFY(std::abs(log->recording.time().back() - 0.59) < 1e-9);
  QVERIFY(std::abs(log->recording.channel("angle_rad")[10] - angleAt(10)) < 1e-5);
  QVERIFY(std::abs(log->recording.channel("velocity_rad_per_s")[10] - 10.0 * std::cos(1.0)) < 1e-4);
}

void TestImportTold::sentencesWithBars_areRows() {
  QString text = "firmware 1.3\n";
  for (int k = 0; k < rows; ++k)
    text += QString("t=%1 ms | pos=%2 deg | I=0.5 A\n").arg(10 * k).arg(90.0 * angleAt(k), 0, 'f', 3);
  const auto log = imported(text);
  QVERIFY(log.ok());
  QCOMPARE(log->recording.rows(), size_t{rows});
  QVERIFY(std::abs(log->recording.channel("angle_rad")[10] - 0.5 * M_PI * angleAt(10)) < 1e-4);
  QVERIFY(std::abs(log->recording.time().back() - 0.59) < 1e-9);
}

void TestImportTold::sentencesThatBeginWithATime_haveIt_data() {
  QTest::addColumn<QString>("before");
  QTest::addColumn<QString>("behind");
  QTest::newRow("a unit behind it") << ""
                                    << " s: theta = ";
  QTest::newRow("in brackets, before a node's name") << "["
                                                     << "] [motor_driver]: theta ";
}

void TestImportTold::sentencesThatBeginWithATime_haveIt() {
  QFETCH(QString, before);
  QFETCH(QString, behind);
  QString text;
  for (int k = 0; k < rows; ++k)
    text += before + QString::number(0.01 * k, 'f', 3) + behind +
            QString("%1 rad, omega %2 rad/s\n").arg(angleAt(k), 0, 'f', 4).arg(10.0 * std::cos(0.1 * k), 0, 'f', 4);
  const auto log = imported(text);
  QVERIFY(log.ok());
  QVERIFY(std::abs(log->recording.time().back() - 0.59) < 1e-9);
  QVERIFY(std::abs(log->recording.channel("angle_rad")[10] - angleAt(10)) < 1e-3);
}

void TestImportTold::jointsInUnknownUnits_stayAside() {
  QString text = "timestamp,shoulder_pan.pos,shoulder_pan.vel,elbow_flex.pos,elbow_flex.vel\n";
  for (int k = 0; k < rows; ++k)
    text += QString("%1,%2,%3,%2,%3\n").arg(0.01 * k).arg(angleAt(k)).arg(10.0 * std::cos(0.1 * k));
  QVERIFY(!imported(text));
}

QTEST_APPLESS_MAIN(TestImportTold)
#include "tst_import_told.moc"
