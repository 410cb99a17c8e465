#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "recording/import/import.h"
#include "support/temporary.h"

using namespace breakaway;
using breakaway::test::TemporaryFolder;

/// What a column is, and how it is counted, by the columns beside it.
class TestImportBeside : public QObject {
  Q_OBJECT
 private slots:
  void countsBesideASpeed_tellHowManyAreOneTurn_data();
  void countsBesideASpeed_tellHowManyAreOneTurn();
  void countsBesideAnotherMotion_areAskedAbout();
  void clockThatCannotBe_isTakenForSeconds_data();
  void clockThatCannotBe_isTakenForSeconds();
  void wheelAlone_isAsGoodAsTheMotor();
  void angleBesideGyro_isNoMotors_data();
  void angleBesideGyro_isNoMotors();
  void voltageThatStandsStillBesideTheSupplys_isNoMotors();
  void tableWithOtherNames_endsTheFirst();
  void rowsThatLoseACell_areAnError();
  void axesInBlocks_areAskedToBeParted();
  void sentencesThatReadAlike_areRows_othersAreLeftOutAndSaid();
  void entriesOfSeveralLines_areRows();
  void nameOfTheNextValue_isNoUnit();
  void rowsOfSeveralTablesInTurn_areReadOfTheMotors_data();
  void rowsOfSeveralTablesInTurn_areReadOfTheMotors();
  void textWithNumbers_isNoTable();
  void listsOfRows_areNoSignals();
  void pwmOf16Bits_isADuty();

 private:
  Result<Imported> imported(const QString& text) {
    return importRecording(folder_.write("log.csv", text.toStdString()));
  }
  TemporaryFolder folder_;
};

constexpr double step_s = 0.01;

static double speedAt(int row) {
  return 60.0 * std::sin(0.05 * row);
}

static double angleAt(int row) {
  return 60.0 / 0.05 * step_s * (1.0 - std::cos(0.05 * row));
}

static const ColumnFate& fateOf(const Imported& imported, const std::string& from) {
  const auto it = std::find_if(imported.columns.begin(), imported.columns.end(),
                               [&](const ColumnFate& one) { return one.from == from; });
  return it == imported.columns.end() ? imported.columns.front() : *it;
}

static bool says(const Imported& imported, const std::string& words) {
  return std::any_of(imported.remarks.begin(), imported.remarks.end(),
                     [&](const auto& remark) { return remark.find(words) != std::string::npos; });
}

void TestImportBeside::countsBesideASpeed_tellHowManyAreOneTurn_data() {
  QTest::addColumn<double>("counts");
  QTest::addColumn<double>("taken");
  QTest::newRow("a usual number") << 4096.0 << 4096.0;
  QTest::newRow("nearly a usual number, as a speed of few digits has it") << 1010.0 << 1000.0;
  QTest::newRow("behind a gear") << 1632.0 << 1632.0;
}

void TestImportBeside::countsBesideASpeed_tellHowManyAreOneTurn() {
  QFETCH(double, counts);
  QFETCH(double, taken);
  QString text = "time_s,ticks,rpm\n";
  for (int k = 0; k < 200; ++k)
    text += QString("%1,%2,%3\n")
                .arg(step_s * k)
                .arg(std::floor(angleAt(k) / (2.0 * std::numbers::pi) * counts))
                .arg(speedAt(k) * 30.0 / std::numbers::pi, 0, 'f', 3);
  const auto log = imported(text);
  VERIFY_OK(log);
  const double scale = fateOf(*log, "ticks").scale;
  QVERIFY2(std::abs(2.0 * std::numbers::pi / scale / taken - 1.0) < 2e-3, qPrintable(QString::number(scale)));
  QVERIFY(says(*log, "a guess"));
}

void TestImportBeside::countsBesideAnotherMotion_areAskedAbout() {
  QString text = "time_s,ticks,rpm\n";
  for (int k = 0; k < 200; ++k) text += QString("%1,%2,%3\n").arg(step_s * k).arg(40 * k).arg(speedAt(k), 0, 'f', 3);
  const auto log = imported(text);
  QVERIFY(!log.ok());
  QVERIFY(log.error().message().find("counts_per_rev") != std::string::npos);
}

void TestImportBeside::clockThatCannotBe_isTakenForSeconds_data() {
  QTest::addColumn<double>("step");
  QTest::addColumn<QString>("name");
  QTest::addColumn<double>("trueStep_s");
  QTest::newRow("called µs, and in s") << 0.005 << "time_us" << 0.005;
  QTest::newRow("called µs, and in s, but short") << 0.0005 << "time_us" << 0.0005;
  QTest::newRow("in µs") << 250.5 << "time_us" << 250.5e-6;
  QTest::newRow("whole µs, however short") << 1.0 << "time_us" << 1e-6;
  QTest::newRow("a fast capture in ms") << 0.02 << "time_ms" << 0.02e-3;
}

void TestImportBeside::clockThatCannotBe_isTakenForSeconds() {
  QFETCH(double, step);
  QFETCH(QString, name);
  QFETCH(double, trueStep_s);
  QString text = name + ",rpm\n";
  for (int k = 0; k < 80; ++k) text += QString("%1,%2\n").arg(step * k).arg(10 * k);
  const auto log = imported(text);
  VERIFY_OK(log);
  const double last = log->recording.time().back();
  QVERIFY2(std::abs(last / (79.0 * trueStep_s) - 1.0) < 1e-6, qPrintable(QString::number(last)));
  const bool doubted = name == "time_us" && step < 1.0;
  QCOMPARE(says(*log, "its time was taken for s"), doubted);
  QCOMPARE(fateOf(*log, name.toStdString()).guessed, doubted);
}

void TestImportBeside::wheelAlone_isAsGoodAsTheMotor() {
  QString alone = "time_s,wheel [rpm],current_A\n", beside = "time_s,wheel_speed [rpm],motor_rpm\n";
  for (int k = 0; k < 80; ++k) {
    alone += QString("%1,%2,0.5\n").arg(step_s * k).arg(speedAt(k));
    beside += QString("%1,%2,%3\n").arg(step_s * k).arg(speedAt(k)).arg(3.0 * speedAt(k));
  }
  const auto wheels = imported(alone), motors = imported(beside);
  VERIFY_OK(wheels);
  QCOMPARE(fateOf(*wheels, "wheel [rpm]").to, std::string("velocity_rad_per_s"));
  VERIFY_OK(motors);
  QCOMPARE(fateOf(*motors, "motor_rpm").to, std::string("velocity_rad_per_s"));
  QVERIFY(fateOf(*motors, "wheel_speed [rpm]").kind == ColumnFate::Kind::kept);
}

void TestImportBeside::angleBesideGyro_isNoMotors_data() {
  QTest::addColumn<QString>("others");
  QTest::addColumn<bool>("taken");
  QTest::newRow("a robot's lean, with a motor's speed") << "accel,gyro,motor_rpm" << false;
  QTest::newRow("no gyro") << "accel,foo,motor_rpm" << true;
  QTest::newRow("no other motion") << "accel,gyro,foo" << true;
}

void TestImportBeside::angleBesideGyro_isNoMotors() {
  QFETCH(QString, others);
  QFETCH(bool, taken);
  QString text = "time_s,angle," + others + "\n";
  for (int k = 0; k < 80; ++k)
    text += QString("%1,%2,0.5,%3,%4\n").arg(step_s * k).arg(0.1 * std::sin(0.2 * k)).arg(k % 7).arg(10.5 * k);
  const auto log = imported(text);
  VERIFY_OK(log);
  QCOMPARE(log->recording.has("angle_rad"), taken);
}

void TestImportBeside::voltageThatStandsStillBesideTheSupplys_isNoMotors() {
  for (const bool steady : {true, false}) {
    QString text = "time_s,rpm,battery_voltage,aux_voltage\n";
    for (int k = 0; k < 80; ++k)
      text += QString("%1,%2,24.5,%3\n").arg(step_s * k).arg(20 * k).arg(steady ? 12.5 : 0.1 * k);
    const auto log = imported(text);
    VERIFY_OK(log);
    QCOMPARE(log->recording.has("voltage_V"), !steady);
  }
}

void TestImportBeside::tableWithOtherNames_endsTheFirst() {
  QString text = "time_s,angle_rad,current_A\n";
  for (int k = 0; k < 60; ++k) text += QString("%1,%2,0.5\n").arg(step_s * k).arg(angleAt(k));
  for (const bool other : {true, false}) {  // a board that resets says the same names again
    QString below = other ? "time_s,torque_Nm,temperature_degC\n" : "time_s,angle_rad,current_A\n";
    for (int k = 60; k < 80; ++k) below += QString("%1,%2,0.5\n").arg(step_s * k).arg(angleAt(k));
    const auto log = imported(text + below);
    VERIFY_OK(log);
    QCOMPARE(log->recording.rows(), size_t(other ? 60 : 80));
    QCOMPARE(says(*log, "a table with other names begins below row 60"), other);
  }
}

void TestImportBeside::rowsThatLoseACell_areAnError() {
  QString text = "time_s,angle_rad,current_A\n", fewer;
  for (int k = 0; k < 60; ++k) text += QString("%1,%2,0.5\n").arg(step_s * k).arg(angleAt(k));
  for (int k = 60; k < 80; ++k) fewer += QString("%1,%2\n").arg(step_s * k).arg(angleAt(k));
  QVERIFY(!imported(text + fewer).ok());
  const auto parted = imported(text + "\ntime_s,temperature_degC\n" + fewer);  // a table of its own
  VERIFY_OK(parted);
  QCOMPARE(parted->recording.rows(), size_t(60));
}

void TestImportBeside::axesInBlocks_areAskedToBeParted() {
  const auto log = [&](const QString& name, int first, int second) {
    QString text = "q,dq," + name + "\n";
    for (int k = 0; k < 120; ++k)
      text += QString("%1,%2,%3\n").arg(angleAt(k)).arg(speedAt(k)).arg(k < 60 ? first : second);
    return imported(text).error().message();
  };
  QVERIFY(log("joint", 0, 1).find("{\"split\": \"joint\"}") != std::string::npos);
  QVERIFY(log("motor", 0, 200).find("sample_time_s") != std::string::npos);  // what a motor was told, not which one
}

void TestImportBeside::sentencesThatReadAlike_areRows_othersAreLeftOutAndSaid() {
  QString text = "Tilt bench, firmware 2.1\n";
  for (int k = 0; k < 60; ++k) {
    if (k == 30) text += "Warning: belt is 3 mm loose\n";
    text += QString("Lever angle is %1 rad; motor speed now %2 rad/s.\n").arg(angleAt(k)).arg(speedAt(k));
  }
  const auto asked = imported(text);
  QVERIFY(!asked);
  QVERIFY2(asked.error().message().find("sample_time_s") != std::string::npos, asked.error().message().c_str());
  ImportMap map;
  map.sample_time_s = step_s;
  const auto log = importRecording(folder_.write("log.txt", text.toStdString()), map);
  VERIFY_OK(log);
  QCOMPARE(log->recording.time().size(), size_t{60});
  QCOMPARE(fateOf(*log, "Lever angle [rad]").to, std::string("angle_rad"));
  QCOMPARE(fateOf(*log, "motor speed [rad/s]").to, std::string("velocity_rad_per_s"));
  QVERIFY(says(*log, "2 lines read otherwise"));
}

void TestImportBeside::entriesOfSeveralLines_areRows() {
  const auto text = [](const char* stamp) {
    QString lines = "Bench ready\n";
    for (int k = 0; k < 60; ++k) {
      const QString at = QString(stamp).arg(step_s * k);
      if (k == 30) lines += at + "fed the watchdog 3 times\n";
      lines += at + QString("shaft angle: %1 rad\n").arg(angleAt(k)) + at + QString("speed = %1\n\n").arg(speedAt(k));
      if (k != 20) lines += at + "current 0.5 A\n";
    }
    return lines;
  };
  const auto log = imported(text("[%1] "));
  VERIFY_OK(log);
  QCOMPARE(log->recording.rows(), size_t{60});
  QVERIFY(std::abs(log->recording.time().back() - 59.0 * step_s) < 1e-9);
  QVERIFY(std::abs(log->recording.channel("angle_rad")[40] - angleAt(40)) < 1e-4 * std::abs(angleAt(40)));
  QVERIFY(std::abs(log->recording.channel("velocity_rad_per_s")[40] - speedAt(40)) < 1e-4 * std::abs(speedAt(40)));
  QVERIFY(std::isnan(log->recording.channel("current_A")[20]));
  QVERIFY(says(*log, "entries of 3 lines"));
  QVERIFY(says(*log, "1 line is of no entry"));
  QString clocks;
  for (int k = 0; k < 40; ++k)
    clocks += QString("10:20:%1\nshaft angle: %2 rad\n").arg(10.0 + step_s * k, 0, 'f', 2).arg(angleAt(k));
  const auto stamped = imported(clocks);
  VERIFY_OK(stamped);
  QVERIFY(std::abs(stamped->recording.time().back() - 39.0 * step_s) < 1e-6);
  const auto asked = imported(text("").replace("%1", ""));
  QVERIFY(!asked && asked.error().message().find("sample_time_s") != std::string::npos);
}

void TestImportBeside::nameOfTheNextValue_isNoUnit() {
  QString text;
  for (int k = 0; k < 60; ++k)
    text += QString("2024-05-01 10:20:%1: ESC {TimeUS : %2, Instance : 0, RPM : %3, Curr : 0.5}\n")
                .arg(10.0 + step_s * k, 5, 'f', 2)
                .arg(int(1e6 * step_s * k))
                .arg(speedAt(k));
  const auto log = imported(text);
  VERIFY_OK(log);
  const double rpm = log->recording.channel("velocity_rad_per_s")[30] * 30.0 / M_PI;
  QVERIFY(std::abs(rpm - speedAt(30)) < 1e-4 * std::abs(speedAt(30)));
}

void TestImportBeside::rowsOfSeveralTablesInTurn_areReadOfTheMotors_data() {
  QTest::addColumn<QString>("head");
  QTest::newRow("by formats") << "FMT, 164, 45, ESC, QBf, TimeUS,RPM,Curr\nFMT, 30, 31, ATT, Qff, TimeUS,Roll\n";
  QTest::newRow("by a line of names each") << "ESC,TimeUS,RPM,Curr\nATT,TimeUS,Roll\n";
}

void TestImportBeside::rowsOfSeveralTablesInTurn_areReadOfTheMotors() {
  QFETCH(QString, head);
  QString text = head;
  for (int k = 0; k < 60; ++k) {
    text += QString("ATT,%1,0.3\n").arg(int(1e6 * step_s * k) + 300);
    text += QString("ESC,%1,%2,0.5\n").arg(int(1e6 * step_s * k)).arg(speedAt(k));
  }
  const auto log = imported(text);
  VERIFY_OK(log);
  QCOMPARE(log->recording.rows(), size_t{60});
  QVERIFY(std::abs(log->recording.time().back() - 59.0 * step_s) < 1e-9);
  QVERIFY(log->recording.has("velocity_rad_per_s") && log->recording.has("current_A"));
  QVERIFY(says(*log, "the rows that begin with ESC were taken; 6"));
  // One table with a word before its rows is one.
  QString states = "STATE,t,rpm\n";
  for (int k = 0; k < 60; ++k)
    states += QString("%1,%2,%3\n").arg(k < 30 ? "RUN" : "STOP").arg(step_s * k).arg(speedAt(k));
  const auto whole = imported(states);
  VERIFY_OK(whole);
  QCOMPARE(whole->recording.rows(), size_t{60});
}

void TestImportBeside::textWithNumbers_isNoTable() {
  QVERIFY(!imported("The bench was built in 2019 by 3 people.\nIt has 2 motors.\nIts speed is 300 rpm at 24 V.\n"));
  QVERIFY(!imported("chapter 1 of 12\nchapter 2 of 12\nchapter 3 of 12\nchapter 4 of 12\n"));
}

void TestImportBeside::listsOfRows_areNoSignals() {
  QString column = "t = [0", rows = "t = [0";
  for (int k = 1; k < 30; ++k) {
    column += QString("; %1").arg(0.01 * k);
    rows += QString("%1 %2").arg(k % 2 == 0 ? ";" : "").arg(0.01 * k);
  }
  QString rpm = "];\nrpm = [0";
  for (int k = 1; k < 30; ++k) rpm += QString(" %1").arg(10 * k);
  const auto log = imported(column + rpm + "];\n");
  VERIFY_OK(log);
  QCOMPARE(log->recording.time().size(), size_t{30});
  QVERIFY(!imported(rows + rpm + "];\n"));
}

void TestImportBeside::pwmOf16Bits_isADuty() {
  QString text = "t,pwm,rpm\n";
  for (int k = 0; k < 40; ++k)
    text += QString("%1,%2,%3\n").arg(0.01 * k).arg(k < 20 ? 65535 : -16384).arg(k < 20 ? 300 : -75);
  const auto log = imported(text);
  VERIFY_OK(log);
  QCOMPARE(fateOf(*log, "pwm").to, std::string("duty"));
  QVERIFY(std::abs(log->recording.channel("duty")[0] - 1.0) < 1e-9);
}

QTEST_APPLESS_MAIN(TestImportBeside)
#include "tst_import_beside.moc"
