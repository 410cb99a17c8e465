#include <QTest>
#include <algorithm>
#include <cmath>

#include "recording/import/import.h"
#include "support/imported_log.h"

using namespace breakaway;
using namespace breakaway::test;

/// What columns are by their values, where names say too little or something else.
class TestImportValues : public QObject {
  Q_OBJECT
 private slots:
  void voltageOfASpeedThatFallsAgainAndAgain_isTheSupplys_data();
  void voltageOfASpeedThatFallsAgainAndAgain_isTheSupplys();
  void wholeThousands_areNoVolts();
  void servosOfAnotherMaker_haveTheSpeedThatTheirAngleTells();
  void angleOfARobotBesideItsWheelsSpeed_isSetAside();
  void speedThatContradictsTheAngle_yieldsToOneThatAgrees();
  void ticksOfRowsOfSeveralAxes_areTheTime();
  void valuesBeyondAnyMotor_areKept();
  void outputWithinOneBesideADuty_isNoVoltage();
  void countsBesideATravelInMillimetres_arentAskedAbout();
  void oneOfTwoPositionsBesideAnOdrivesCurrent_isNotInTurns();
  void wholeVoltsBeyondAMotors_areNoSupply();
  void currentBesideAThrottleAndASupply_isDoubted();
  void countsThatStartAnew_areToldByTheSpeed_data();
  void countsThatStartAnew_areToldByTheSpeed();
  void speedInCounts_isToldByTheAngle();
  void periodOfALoop_makesTheTime_data();
  void periodOfALoop_makesTheTime();
  void steadyVoltageBesideADirection_isTheSupplys();
  void steadyVoltageBesideATorqueThatRises_isTheSupplys_data();
  void steadyVoltageBesideATorqueThatRises_isTheSupplys();
  void steadyPercents_areNoDutyOfAMotionBothWays();
  void angleThatStartsAnewAfterTwoPi_tellsTheSpeedsUnit();

 private:
  ImportedLogs logs_;
};

/// A column that turns, the speed of its own, and another one's.
static QString turningBeside(const char* head) {
  QString text = head;
  for (int k = 0; k < 200; ++k)
    text += QString("%1,%2,%3,%4\n")
                .arg(0.01 * k)
                .arg(20.0 * std::sin(0.1 * k))
                .arg(200.0 * std::cos(0.1 * k))
                .arg(300.0 * std::sin(0.023 * k) * std::sin(0.31 * k));
  return text;
}

void TestImportValues::voltageOfASpeedThatFallsAgainAndAgain_isTheSupplys_data() {
  QTest::addColumn<int>("rowsAWave");
  QTest::addColumn<QString>("to");
  QTest::newRow("again and again") << 40 << "supply_V";
  QTest::newRow("switched on and loaded") << 320 << "voltage_V";
}

void TestImportValues::voltageOfASpeedThatFallsAgainAndAgain_isTheSupplys() {
  QFETCH(int, rowsAWave);
  QFETCH(QString, to);
  QString text = "time_s,rpm,voltage\n";
  for (int k = 0; k < 320; ++k)
    text += QString("%1,%2,%3\n").arg(0.01 * k).arg(500.5 - 500.0 * std::cos(2.0 * M_PI * k / rowsAWave)).arg(23.1);
  const auto log = logs_.imported(text);
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "voltage"), to.toStdString());
}

void TestImportValues::wholeThousands_areNoVolts() {
  QString text = "time_s,angle_rad,batt_volt,Supply (volts)\n";
  for (int k = 0; k < 40; ++k) text += QString("%1,%2,36500,325\n").arg(0.01 * k).arg(std::sin(0.1 * k));
  const auto log = logs_.imported(text);
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "batt_volt"), std::string());
}

void TestImportValues::servosOfAnotherMaker_haveTheSpeedThatTheirAngleTells() {
  QString text = "time_s,Present_Position,Present_Speed,Present_Load\n";
  for (int k = 0; k < 100; ++k)
    text += QString("%1,%2,%3,20\n")
                .arg(0.01 * k)
                .arg(2048 + int(900 * std::sin(0.1 * k)))
                .arg(int(9000 * std::cos(0.1 * k)));
  const auto log = logs_.imported(text);
  VERIFY_OK(log);
  const double speed = 9000.0 / 4096.0 * 2.0 * M_PI;
  QVERIFY(std::abs(log->recording.channel("velocity_rad_per_s").front() - speed) < 1e-3 * speed);
}

void TestImportValues::angleOfARobotBesideItsWheelsSpeed_isSetAside() {
  const auto log = logs_.imported(turningBeside("time_s,angle_deg,rate_dps,wheel_speed_rpm\n"));
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "wheel_speed_rpm"), std::string("velocity_rad_per_s"));
  QCOMPARE(meaning(*log, "angle_deg"), std::string());
  const auto pedal = logs_.imported(turningBeside("time_s,pedal_pos,rate_dps,motor_rpm\n"));
  VERIFY_OK(pedal);
  QCOMPARE(meaning(*pedal, "motor_rpm"), std::string("velocity_rad_per_s"));
  QCOMPARE(meaning(*pedal, "pedal_pos"), std::string());
  const auto wheels = logs_.imported(turningBeside("time_s,wheel_angle_deg,rate_dps,wheel_speed_rpm\n"));
  VERIFY_OK(wheels);
  QCOMPARE(meaning(*wheels, "wheel_angle_deg"), std::string("angle_rad"));
}

void TestImportValues::speedThatContradictsTheAngle_yieldsToOneThatAgrees() {
  const auto log = logs_.imported(turningBeside("time_s,angle_deg,hand_speed_dps,speed_dps\n"));
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "hand_speed_dps"), std::string("velocity_rad_per_s"));
  QCOMPARE(meaning(*log, "angle_deg"), std::string("angle_rad"));
}

void TestImportValues::ticksOfRowsOfSeveralAxes_areTheTime() {
  QString text = "id,ticks,speed,bus_voltage\n";
  for (int k = 0; k < 60; ++k) {
    for (int m = 1; m <= 3; ++m)
      text += QString("%1,%2,%3,24\n").arg(m).arg(5000 + 10 * k + m).arg(m * std::sin(0.1 * k));
  }
  const auto log = logs_.imported(text);
  QVERIFY(!log);
  QVERIFY(log.error().message().find("{\"split\": \"id\"}") != std::string::npos);
}

void TestImportValues::valuesBeyondAnyMotor_areKept() {
  QString text = "time_s,angle_rad,current,motor_temp\n", usual = text;
  for (int k = 0; k < 60; ++k) {
    text += QString("%1,%2,%3,9393\n").arg(0.01 * k).arg(std::sin(0.1 * k)).arg(1800.5 * std::cos(0.1 * k));
    usual += QString("%1,%2,%3,93\n").arg(0.01 * k).arg(std::sin(0.1 * k)).arg(18.5 * std::cos(0.1 * k));
  }
  const auto far = logs_.imported(text), log = logs_.imported(usual);
  VERIFY_OK(far);
  VERIFY_OK(log);
  for (const char* name : {"current", "motor_temp"}) {
    QCOMPARE(meaning(*far, name), std::string());
    QVERIFY(!meaning(*log, name).empty());
  }
}

void TestImportValues::outputWithinOneBesideADuty_isNoVoltage() {
  const auto of = [this](double full) {
    QString text = "time_s,theta_rad,u,pwm\n";
    for (int k = 0; k < 60; ++k)
      text += QString("%1,%2,%3,%4\n")
                  .arg(0.01 * k)
                  .arg(std::sin(0.1 * k))
                  .arg(full * std::cos(0.1 * k))
                  .arg(int(255.0 * std::cos(0.1 * k)));
    const auto log = logs_.imported(text);
    return log ? meaning(*log, "u") : log.error().message();
  };
  QCOMPARE(of(1.0), std::string());
  QCOMPARE(of(12.0), std::string("voltage_V"));
}

void TestImportValues::countsBesideATravelInMillimetres_arentAskedAbout() {
  QString text = "time_s,enc,travel_mm\n";
  for (int k = 0; k < 60; ++k)
    text += QString("%1,%2,%3\n").arg(0.01 * k).arg(int(1000.0 * std::sin(0.1 * k))).arg(50.0 * std::sin(0.1 * k));
  const auto log = logs_.imported(text);
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "travel_mm"), std::string("position_m"));
  QVERIFY(!log->recording.has("angle_rad"));
}

void TestImportValues::oneOfTwoPositionsBesideAnOdrivesCurrent_isNotInTurns() {
  const auto unitOf = [this](const QStringList& names) {
    const auto log = logs_.waves(names);
    return log ? log->columns[1].unit : log.error().message();
  };
  QCOMPARE(unitOf({"position", "iq_measured"}), std::string("turns"));
  QCOMPARE(unitOf({"position", "encoder_pos", "iq_measured"}), std::string());
}

void TestImportValues::wholeVoltsBeyondAMotors_areNoSupply() {
  QString text = "time_s,angle_rad,voltage\n";
  for (int k = 0; k < 60; ++k) text += QString("%1,%2,121\n").arg(0.01 * k).arg(std::sin(0.1 * k));
  const auto log = logs_.imported(text);
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "voltage"), std::string());
}

void TestImportValues::currentBesideAThrottleAndASupply_isDoubted() {
  const auto words = [this](const QString& name) {
    QString text = "time_s,rpm,throttle_pct,voltage," + name + "\n";
    for (int k = 0; k < 60; ++k)
      text += QString("%1,%2,%3,22.2,%4\n").arg(0.1 * k).arg(3000.0 + 20 * k).arg(10 + k).arg(1.5 + 0.1 * k);
    const auto log = logs_.imported(text);
    return log ? log->columns[4].inWords().english() : log.error().message();
  };
  QVERIFY(words("current_mA").find("supply's") != std::string::npos);
  QVERIFY(words("current").find("supply's") != std::string::npos);
  QVERIFY(words("motor_current_mA").find("supply's") == std::string::npos);
}

/// A wave of the speed and where it leads to, in radians, at each of 0.01 s.
static double waveSpeed_rad_per_s(int k) {
  return 30.0 * std::sin(0.03 * k);
}
static double waveAngle_rad(int k) {
  return 10.0 * (1.0 - std::cos(0.03 * k));
}

void TestImportValues::countsThatStartAnew_areToldByTheSpeed_data() {
  QTest::addColumn<int>("wrapsAfter");
  QTest::addColumn<bool>("told");
  QTest::newRow("with each turn") << 4096 << true;
  QTest::newRow("a register of 16 bits") << 65536 << true;
  QTest::newRow("four times a turn") << 1024 << false;
}

void TestImportValues::countsThatStartAnew_areToldByTheSpeed() {
  QFETCH(int, wrapsAfter);
  QFETCH(bool, told);
  const double countsPerTurn = wrapsAfter > 60000 ? 40000.0 : 4096.0;
  QString text = "time_s,encoder_count,speed_rpm\n";
  for (int k = 0; k < 400; ++k) {
    const int counts = static_cast<int>(std::floor(waveAngle_rad(k) / (2.0 * M_PI) * countsPerTurn));
    text +=
        QString("%1,%2,%3\n").arg(0.01 * k).arg(counts % wrapsAfter).arg(waveSpeed_rad_per_s(k) * 60.0 / (2.0 * M_PI));
  }
  const auto log = logs_.imported(text);
  QCOMPARE(log.ok(), told);
  if (!told) return;
  for (size_t k = 0; k < 400; ++k)
    QVERIFY(std::abs(log->recording.channel("angle_rad")[k] - waveAngle_rad(static_cast<int>(k))) < 0.002);
}

void TestImportValues::speedInCounts_isToldByTheAngle() {
  QString text = "t_sec,pos_deg,vel_steps_per_sec\n";
  for (int k = 0; k < 400; ++k)
    text += QString("%1,%2,%3\n")
                .arg(0.01 * k)
                .arg(waveAngle_rad(k) * 180.0 / M_PI, 0, 'f', 4)
                .arg(std::round(waveSpeed_rad_per_s(k) * 4096.0 / (2.0 * M_PI)));
  const auto log = logs_.imported(text);
  VERIFY_OK(log);
  for (size_t k = 0; k < 400; ++k)
    QVERIFY(std::abs(log->recording.channel("velocity_rad_per_s")[k] - waveSpeed_rad_per_s(static_cast<int>(k))) <
            0.001);
  QVERIFY(std::any_of(log->remarks.begin(), log->remarks.end(),
                      [](const Message& one) { return one.english().find("4096") != std::string::npos; }));
}

void TestImportValues::periodOfALoop_makesTheTime_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<double>("spread");
  QTest::addColumn<bool>("taken");
  QTest::newRow("a loop's") << "period_us" << 0.02 << true;
  QTest::newRow("a sensor's, which changes with the speed") << "period_us" << 0.8 << false;
  QTest::newRow("no unit") << "period" << 0.02 << false;
}

void TestImportValues::periodOfALoop_makesTheTime() {
  QFETCH(QString, name);
  QFETCH(double, spread);
  QFETCH(bool, taken);
  QString text = "angle_rad," + name + "\n";
  for (int k = 0; k < 400; ++k)
    text += QString("%1,%2\n").arg(waveAngle_rad(k)).arg(1000.0 * (1.0 + spread * std::sin(0.4 * k)));
  const auto log = logs_.imported(text);
  QCOMPARE(log.ok(), taken);
  if (!taken) return;
  QVERIFY(std::abs(log->recording.channel("time_s")[399] - 0.399) < 0.001);
  QVERIFY(log->columns[1].guessed);
}

void TestImportValues::steadyVoltageBesideADirection_isTheSupplys() {
  QString text = "t_ms,dir,speed_rpm,volt_V\n";
  for (int k = 0; k < 400; ++k)
    text += QString("%1,%2,%3,%4\n")
                .arg(10 * k)
                .arg(waveSpeed_rad_per_s(k) < 0.0 ? -1 : 1)
                .arg(10.0 * waveSpeed_rad_per_s(k))
                .arg(k % 3 == 0 ? 11.9 : 12.0);
  const auto log = logs_.imported(text);
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "volt_V"), "supply_V");
}

void TestImportValues::steadyVoltageBesideATorqueThatRises_isTheSupplys_data() {
  QTest::addColumn<double>("slope");
  QTest::addColumn<QString>("to");
  QTest::newRow("a propeller's, which rises with the speed") << 1.0 << "supply_V";
  QTest::newRow("a motor's at its voltage, which falls") << -1.0 << "voltage_V";
}

void TestImportValues::steadyVoltageBesideATorqueThatRises_isTheSupplys() {
  QFETCH(double, slope);
  QFETCH(QString, to);
  QString text = "t_s,torque_nm,voltage_v,rpm\n";
  for (int k = 0; k < 400; ++k)
    text += QString("%1,%2,%3,%4\n").arg(0.03 * k).arg(0.5 + slope * 0.001 * k).arg(16.1).arg(100.0 + 5.0 * k);
  const auto log = logs_.imported(text);
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "voltage_v"), to.toStdString());
}

void TestImportValues::steadyPercents_areNoDutyOfAMotionBothWays() {
  QString text = "time_ms,vel_rad_s,pct\n";
  for (int k = 0; k < 400; ++k) text += QString("%1,%2,40\n").arg(10 * k).arg(waveSpeed_rad_per_s(k));
  const auto log = logs_.imported(text);
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "pct"), "");
}

void TestImportValues::angleThatStartsAnewAfterTwoPi_tellsTheSpeedsUnit() {
  QString text = "time_s,theta_enc,speed_enc,iq\n";
  for (int k = 0; k < 400; ++k)
    text += QString("%1,%2,%3,%4\n")
                .arg(0.01 * k)
                .arg(std::fmod(waveAngle_rad(k), 2.0 * M_PI))
                .arg(waveSpeed_rad_per_s(k) * 60.0 / (2.0 * M_PI))
                .arg(0.1 * std::cos(0.03 * k));
  const auto log = logs_.imported(text);
  VERIFY_OK(log);
  QVERIFY(std::abs(log->recording.channel("velocity_rad_per_s")[50] - waveSpeed_rad_per_s(50)) < 0.001);
  QVERIFY(std::abs(log->recording.channel("angle_rad")[100] - waveAngle_rad(100)) < 0.001);
}

QTEST_APPLESS_MAIN(TestImportValues)
#include "tst_import_values.moc"
