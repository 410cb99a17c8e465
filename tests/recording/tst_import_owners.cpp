#include <QTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "recording/import/import.h"
#include "support/imported_log.h"
#include "support/temporary.h"

using namespace breakaway;
using breakaway::test::meaning;
using breakaway::test::TemporaryFolder;

/// Whose a column is in wide logs: another machine's, another joint's, what a motor drives, what nothing follows.
class TestImportOwners : public QObject {
  Q_OBJECT
 private slots:
  void referenceInNoUnit_isTakenOnlyIfItIsFollowed_data();
  void referenceInNoUnit_isTakenOnlyIfItIsFollowed();
  void speedReferenceBesideAnAngle_hasTheUnitInWhichItIsFollowed_data();
  void speedReferenceBesideAnAngle_hasTheUnitInWhichItIsFollowed();
  void leanBesideAWheelsSpeed_isKept_data();
  void leanBesideAWheelsSpeed_isKept();
  void angleBehindAGear_isKeptBesideTheMotorsSpeed_data();
  void angleBehindAGear_isKeptBesideTheMotorsSpeed();
  void signalsOfAVehicle_areNoMotorsVoltage_data();
  void signalsOfAVehicle_areNoMotorsVoltage();
  void currentBesideThePhases_isTheSupplys();
  void speedOfAVehicle_isAskedAbout();
  void torqueOfAnotherJoint_isKept();
  void deviceThatIsDriven_isTaken();
  void namesOfElectricMachines_areUnderstood_data();
  void namesOfElectricMachines_areUnderstood();
  void unitOfAngles_isToldAboveTheTable_data();
  void unitOfAngles_isToldAboveTheTable();
  void labelOfASeries_isItsAxis();
  void deviationInAnotherLanguage_isNoAngle();
  void electricalAngleBesideASpeed_asksForNothing();
  void electricalTurnsPerSecond_askForPolePairs();
  void wordBeforeNames_isNoName_data();
  void wordBeforeNames_isNoName();
  void angleCalledAsItsSpeedIs_isTaken_data();
  void angleCalledAsItsSpeedIs_isTaken();

 private:
  using Wave = std::function<double(int)>;
  Result<Imported> logOf(const std::vector<std::pair<const char*, Wave>>& columns, const ImportMap& map = {}) {
    QString text = "time_s";
    for (const auto& [name, at] : columns) text += QString(",") + name;
    for (int k = 0; k < 400; ++k) {
      text += QString("\n%1").arg(0.01 * k);
      for (const auto& [name, at] : columns) text += "," + QString::number(at(k), 'g', 9);
    }
    return importRecording(folder_.write("log.csv", text.toStdString() + "\n"), map);
  }
  TemporaryFolder folder_;
};

constexpr double toDegrees = 180.0 / std::numbers::pi, toRpm = 30.0 / std::numbers::pi;

/// A motion both ways, in rad and rad/s.
static double turnedAt(int k) {
  const double t = 0.01 * k;
  return 4.0 * std::sin(2.0 * t) + 1.5 * std::sin(5.3 * t + 1.0);
}

static double speedAt(int k) {
  const double t = 0.01 * k;
  return 8.0 * std::cos(2.0 * t) + 7.95 * std::cos(5.3 * t + 1.0);
}

static double elsewhereAt(int k) {
  return 12.0 * std::sin(0.31 * k + 0.4);
}

void TestImportOwners::referenceInNoUnit_isTakenOnlyIfItIsFollowed_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<int>("kind");  // followed, another motion, never changes
  QTest::addColumn<bool>("taken");
  QTest::newRow("followed") << "speed_target" << 0 << true;
  QTest::newRow("of another thing, followed") << "hull_speed_target" << 0 << true;
  QTest::newRow("of another thing, not followed") << "hull_speed_target" << 1 << false;
  QTest::newRow("never changes, far from it") << "angular_vel_request" << 2 << false;
}

void TestImportOwners::referenceInNoUnit_isTakenOnlyIfItIsFollowed() {
  QFETCH(QString, name);
  QFETCH(int, kind);
  QFETCH(bool, taken);
  const QByteArray called = name.toUtf8();
  const auto log = logOf({{"motor_rpm", [](int k) { return speedAt(k) * toRpm; }},
                          {called.constData(), [kind](int k) {
                             return kind == 0 ? speedAt(k + 2) * toRpm : kind == 1 ? elsewhereAt(k) * toRpm : 0.1;
                           }}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, name), taken ? std::string("velocity_reference_rad_per_s") : std::string());
}

void TestImportOwners::speedReferenceBesideAnAngle_hasTheUnitInWhichItIsFollowed_data() {
  QTest::addColumn<double>("perRadian");
  QTest::addColumn<bool>("follows");
  QTest::newRow("rad/s") << 1.0 << true;
  QTest::newRow("deg/s") << toDegrees << true;
  QTest::newRow("rpm") << toRpm << true;
  QTest::newRow("not followed") << 1.0 << false;
}

void TestImportOwners::speedReferenceBesideAnAngle_hasTheUnitInWhichItIsFollowed() {
  QFETCH(double, perRadian);
  QFETCH(bool, follows);
  const auto log = logOf({{"pos_turns", [](int k) { return turnedAt(k) / (2.0 * std::numbers::pi); }},
                          {"vel_ref", [=](int k) { return (follows ? speedAt(k + 2) : elsewhereAt(k)) * perRadian; }}});
  VERIFY_OK(log);
  QCOMPARE(log->recording.has("velocity_reference_rad_per_s"), follows);
  if (!follows) return;
  QVERIFY(std::abs(log->recording.channel("velocity_reference_rad_per_s")[100] - speedAt(102)) < 1e-4);
  QVERIFY(log->columns[2].guessed);
}

void TestImportOwners::leanBesideAWheelsSpeed_isKept_data() {
  QTest::addColumn<bool>("leans");
  QTest::newRow("a lean") << true;
  QTest::newRow("the wheel's own angle") << false;
}

void TestImportOwners::leanBesideAWheelsSpeed_isKept() {
  QFETCH(bool, leans);
  const auto log =
      logOf({{"theta_deg", [=](int k) { return leans ? 5.0 * std::sin(0.2 * k) : turnedAt(k) * toDegrees; }},
             {"theta_dot_dps", [=](int k) { return leans ? 100.0 * std::cos(0.2 * k) : speedAt(k) * toDegrees; }},
             {"wheel_rpm", [](int k) { return speedAt(k) * toRpm; }},
             {"cmd_rpm", [](int k) { return speedAt(k + 1) * toRpm; }}});
  VERIFY_OK(log);
  QCOMPARE(log->recording.has("angle_rad"), !leans);
  QVERIFY(std::abs(log->recording.channel("velocity_rad_per_s")[50] - speedAt(50)) < 1e-4);
  QCOMPARE(meaning(*log, "cmd_rpm"), std::string("velocity_reference_rad_per_s"));
}

void TestImportOwners::angleBehindAGear_isKeptBesideTheMotorsSpeed_data() {
  QTest::addColumn<double>("ratio");
  QTest::addColumn<bool>("angle");
  QTest::newRow("a gear of 50") << 50.0 << false;
  QTest::newRow("none") << 1.0 << true;
  QTest::newRow("a unit that is wrong") << 6.0 << true;
}

void TestImportOwners::angleBehindAGear_isKeptBesideTheMotorsSpeed() {
  QFETCH(double, ratio);
  QFETCH(bool, angle);
  const auto log = logOf({{"angle_deg", [=](int k) { return turnedAt(k) * toDegrees / ratio; }},
                          {"motor_speed_rpm", [](int k) { return speedAt(k) * toRpm; }}});
  VERIFY_OK(log);
  QCOMPARE(log->recording.has("angle_rad"), angle);
  QVERIFY(log->recording.has("velocity_rad_per_s"));
  QCOMPARE(log->columns[2].guessed, ratio != 1.0);  // it may be counted in electrical turns, or its unit is wrong
  const bool said = std::any_of(log->remarks.begin(), log->remarks.end(),
                                [](const std::string& one) { return one.starts_with("implausible"); });
  QCOMPARE(said, ratio == 6.0);
}

void TestImportOwners::signalsOfAVehicle_areNoMotorsVoltage_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<bool>("motors");
  QTest::newRow("throttle") << "Throttle Voltage (V)" << false;
  QTest::newRow("brake") << "Brake Voltage (V)" << false;
  QTest::newRow("a sun's panel") << "MPPT0 Current (A)" << false;
  QTest::newRow("a motor's") << "Motor Voltage (V)" << true;
}

void TestImportOwners::signalsOfAVehicle_areNoMotorsVoltage() {
  QFETCH(QString, name);
  QFETCH(bool, motors);
  const QByteArray called = name.toUtf8();
  const auto log = logOf({{"motor_rpm", [](int k) { return speedAt(k) * toRpm; }},
                          {called.constData(), [](int k) { return 3.0 * std::sin(0.02 * k); }}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, name).empty(), !motors);
}

void TestImportOwners::currentBesideThePhases_isTheSupplys() {
  const auto log = logOf({{"motor_rpm", [](int k) { return speedAt(k) * toRpm; }},
                          {"current", [](int k) { return 3.0 * std::sin(0.02 * k); }},
                          {"phase_current", [](int k) { return 9.0 * std::sin(0.02 * k); }},
                          {"Irms1[A]", [](int k) { return 7.0 + std::sin(0.02 * k); }}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "phase_current"), std::string("current_A"));
  QVERIFY(meaning(*log, "current").empty() && meaning(*log, "Irms1[A]").empty());
}

void TestImportOwners::speedOfAVehicle_isAskedAbout() {
  const auto speed = [](int k) { return 10.25 + std::sin(0.02 * k); };
  const auto log = logOf({{"speed", speed}, {"totaldistance", [](int k) { return 0.1 * k; }}});
  QVERIFY(!log.ok());
  QVERIFY2(log.error().message().find("velocity_m_per_s") != std::string::npos, log.error().message().c_str());
  VERIFY_OK(logOf({{"speed", speed}, {"other", [](int k) { return 0.1 * k; }}}));
}

void TestImportOwners::deviceThatIsDriven_isTaken() {
  const auto slow = [](int k) { return std::sin(0.05 * k); };
  const auto log = logOf({{"Claw/Position", slow},
                          {"Arm/Position", turnedAt},
                          {"Arm/Velocity (rad/s)", speedAt},
                          {"Arm/Current", [](int k) { return 0.3 * std::cos(0.05 * k); }}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "Arm/Position"), std::string("angle_rad"));
  QCOMPARE(meaning(*log, "Arm/Velocity (rad/s)"), std::string("velocity_rad_per_s"));
  QCOMPARE(meaning(*log, "Arm/Current"), std::string("current_A"));
  VERIFY_OK(logOf({{"Claw/Position", slow}, {"Arm/Position", turnedAt}}));
}

void TestImportOwners::namesOfElectricMachines_areUnderstood_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QString>("to");
  QTest::newRow("a torque by its letter") << "M_Mot [Nm]"
                                          << "torque_Nm";
  QTest::newRow("a load's") << "M_L [Nm]"
                            << "";
  QTest::newRow("another shaft's") << "M_Ab [Nm]"
                                   << "";
  QTest::newRow("a motor's temperature, told by its inverter") << "INV_Motor_Temp"
                                                               << "temperature_degC";
  QTest::newRow("the inverter's") << "Motor_Inverter_Temp"
                                  << "";
  QTest::newRow("a DC link's") << "U_ZK [V]"
                               << "supply_V";
  QTest::newRow("a winding's") << "T_Wick [°C]"
                               << "temperature_degC";
}

void TestImportOwners::namesOfElectricMachines_areUnderstood() {
  QFETCH(QString, name);
  QFETCH(QString, to);
  const QByteArray called = name.toUtf8();
  const auto log = logOf({{"n_Mot [min-1]", [](int k) { return speedAt(k) * toRpm; }},
                          {called.constData(), [](int k) { return 24.0 + 0.1 * std::sin(0.02 * k); }}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, name), to.toStdString());
}

void TestImportOwners::unitOfAngles_isToldAboveTheTable_data() {
  QTest::addColumn<QString>("line");
  QTest::addColumn<double>("scale");
  QTest::addColumn<bool>("guessed");
  QTest::newRow("in degrees") << "inDegrees=yes" << 1.0 / toDegrees << false;
  QTest::newRow("in radians") << "# All angles are in radians." << 1.0 << false;
  QTest::newRow("nothing said") << "version=1" << 1.0 / toDegrees << true;
}

void TestImportOwners::unitOfAngles_isToldAboveTheTable() {
  QFETCH(QString, line);
  QFETCH(double, scale);
  QFETCH(bool, guessed);
  QString text = "Coordinates\n" + line + "\nendheader\ntime\tknee_angle_r\n";
  for (int k = 0; k < 80; ++k) text += QString("%1\t%2\n").arg(0.01 * k).arg(20.0 * std::sin(0.1 * k));
  const auto log = importRecording(folder_.write("log.mot", text.toStdString()));
  VERIFY_OK(log);
  QVERIFY(std::abs(log->recording.channel("angle_rad")[10] - 20.0 * std::sin(1.0) * scale) < 1e-3);
  QCOMPARE(log->columns[1].guessed, guessed);
}

void TestImportOwners::labelOfASeries_isItsAxis() {
  QString text =
      R"(time_s,"motor_speed_rpm{axis=""1""}","motor_speed_rpm{axis=""2""}","motor_current_amps{axis=""2""}")";
  for (int k = 0; k < 80; ++k)
    text += QString("\n%1,%2,%3,%4").arg(0.01 * k).arg(speedAt(k)).arg(elsewhereAt(k)).arg(std::sin(0.1 * k));
  const auto log = importRecording(folder_.write("log.csv", text.toStdString() + "\n"));
  VERIFY_OK(log);
  QVERIFY(std::abs(log->recording.channel("velocity_rad_per_s")[0] - speedAt(0) / toRpm) < 1e-4);
  QVERIFY(!log->recording.has("current_A"));
}

void TestImportOwners::deviationInAnotherLanguage_isNoAngle() {
  const auto log = logOf({{"\xe5\xae\x9f\xe9\x80\x9f\xe5\xba\xa6[min-1]", [](int k) { return speedAt(k) * toRpm; }},
                          {"\xe4\xbd\x8d\xe7\xbd\xae\xe5\x81\x8f\xe5\xb7\xae[pulse]", elsewhereAt}});
  VERIFY_OK(log);
  QVERIFY(log->recording.has("velocity_rad_per_s") && !log->recording.has("angle_rad"));
}

void TestImportOwners::torqueOfAnotherJoint_isKept() {
  const auto log = logOf({{"arm_joint_1_position", turnedAt},
                          {"arm_joint_1_velocity", speedAt},
                          {"index_1_position", [](int k) { return std::sin(0.05 * k); }},
                          {"index_1_torque", [](int k) { return 0.2 * std::cos(0.05 * k); }}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "arm_joint_1_position"), std::string("angle_rad"));
  QVERIFY(meaning(*log, "index_1_torque").empty());
}

void TestImportOwners::electricalAngleBesideASpeed_asksForNothing() {
  const auto electrical = [](int k) { return std::fmod(100.0 + 4.0 * turnedAt(k), 2.0 * std::numbers::pi); };
  const auto log =
      logOf({{"motor_rpm", [](int k) { return speedAt(k) * toRpm; }}, {"electrical_angle_rad", electrical}});
  VERIFY_OK(log);
  QVERIFY(!log->recording.has("angle_rad") && log->recording.has("velocity_rad_per_s"));
  ImportMap map;
  map.pole_pairs = 4;
  const auto told =
      logOf({{"motor_rpm", [](int k) { return speedAt(k) * toRpm; }}, {"electrical_angle_rad", electrical}}, map);
  VERIFY_OK(told);
  const auto angle = told->recording.channel("angle_rad");
  QVERIFY(std::abs(angle[200] - angle[0] - (turnedAt(200) - turnedAt(0))) < 1e-4);
}

void TestImportOwners::electricalTurnsPerSecond_askForPolePairs() {
  const auto asked = logOf({{"erps", [](int k) { return 20.0 + speedAt(k); }}});
  QVERIFY(!asked.ok());
  QVERIFY2(asked.error().message().find("pole_pairs") != std::string::npos, asked.error().message().c_str());
  ImportMap map;
  map.pole_pairs = 8;
  const auto told = logOf({{"erps", [](int k) { return 20.0 + speedAt(k); }}}, map);
  VERIFY_OK(told);
  QVERIFY(std::abs(told->recording.channel("velocity_rad_per_s")[10] -
                   (20.0 + speedAt(10)) * 2.0 * std::numbers::pi / 8.0) < 1e-6);
}

void TestImportOwners::wordBeforeNames_isNoName_data() {
  QTest::addColumn<QString>("head");
  QTest::addColumn<QString>("tag");
  QTest::newRow("in a comment") << "#PHASE,0=idle,1=up\n#COLS,t_us,phase,rpm,bus_mv\n"
                                << "";
  QTest::newRow("before the rows' tag") << "STATUS,ready\nFORMAT,DATA,t_us,phase,rpm,bus_mv\n"
                                        << "DATA,";
}

void TestImportOwners::wordBeforeNames_isNoName() {
  QFETCH(QString, head);
  QFETCH(QString, tag);
  QString text = head;
  for (int k = 0; k < 60; ++k) text += QString("%1%2,1,%3,%4\n").arg(tag).arg(10000 * k).arg(100.5 + k).arg(24000 - k);
  const auto log = importRecording(folder_.write("log.csv", text.toStdString()));
  VERIFY_OK(log);
  QVERIFY(std::abs(log->recording.channel("time_s")[59] - 0.59) < 1e-9);
  QVERIFY(std::abs(log->recording.channel("velocity_rad_per_s")[0] - 100.5 / toRpm) < 1e-9);
  QVERIFY(std::abs(log->recording.channel("supply_V")[0] - 24.0) < 1e-9);
}

void TestImportOwners::angleCalledAsItsSpeedIs_isTaken_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<bool>("moves");
  QTest::addColumn<bool>("taken");
  QTest::newRow("its own") << "gimbal_yaw" << true << true;
  QTest::newRow("moves otherwise") << "gimbal_yaw" << false << false;
  QTest::newRow("another's") << "gimbal_pitch" << true << false;
}

void TestImportOwners::angleCalledAsItsSpeedIs_isTaken() {
  QFETCH(QString, name);
  QFETCH(bool, moves);
  QFETCH(bool, taken);
  const QByteArray called = name.toUtf8();
  const auto log = logOf({{called.constData(), moves ? turnedAt : elsewhereAt}, {"gimbal_yaw_vel", speedAt}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, name), taken ? std::string("angle_rad") : std::string());
  QVERIFY(!taken || log->columns[1].guessed);
}

QTEST_APPLESS_MAIN(TestImportOwners)
#include "tst_import_owners.moc"
