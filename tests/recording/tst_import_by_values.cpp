#include <QTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "recording/import/import.h"
#include "support/temporary.h"

using namespace breakaway;
using breakaway::test::TemporaryFolder;

/// A column's name, and what it holds in each row.
struct NamedWave {
  const char* name;
  std::function<double(int)> at;
};

constexpr double stepOfMotion_s = 0.01;

/// A motion that doesn't repeat itself, both ways, in rad and rad/s.
static double turnedBy(int k) {
  const double t = stepOfMotion_s * k;
  return 4.0 * std::sin(2.0 * t) + 1.5 * std::sin(5.3 * t + 1.0) + 0.7 * std::sin(11.7 * t + 2.0);
}

static double speedOfMotion(int k) {
  const double t = stepOfMotion_s * k;
  return 8.0 * std::cos(2.0 * t) + 7.95 * std::cos(5.3 * t + 1.0) + 8.19 * std::cos(11.7 * t + 2.0);
}

/// What moves it: inertia and friction.
static double torqueOfMotion(int k) {
  const double speed = speedOfMotion(k), gained = (speedOfMotion(k + 1) - speed) / stepOfMotion_s;
  return 2e-4 * gained + 1e-4 * speed + (speed > 0.0 ? 0.01 : -0.01);
}

/// No motion's: waves of other periods.
static double elsewhere(int k) {
  return 0.02 * std::sin(0.31 * k) + 0.01 * std::sin(0.017 * k * k / 100.0);
}

/// What no name tells, values may, as a guess; where they contradict, nothing is taken.
class TestImportByValues : public QObject {
  Q_OBJECT
 private slots:
  void driveWithoutAKnownName_isTakenWhereItMovesTheMotor_data();
  void driveWithoutAKnownName_isTakenWhereItMovesTheMotor();
  void motionThatRepeatsItself_saysNothingOfADrive();
  void memberCalledByALetter_hasNoUnit();
  void setPoint_isWhatIsFollowed_data();
  void setPoint_isWhatIsFollowed();
  void referenceThatGoesNowhereNear_isKept();
  void speedWithoutAKnownName_isTakenWhereTheAngleMovesSo_data();
  void speedWithoutAKnownName_isTakenWhereTheAngleMovesSo();
  void motionInAnUnknownLanguage_isTakenAsAGuess();
  void meterThatOnlyGoesUp_isNoAngle();
  void rowsByNumber_areNoTime();
  void placeThatDoesNotGoWithARotation_isKept_data();
  void placeThatDoesNotGoWithARotation_isKept();
  void headingThatTurnsWithItsDrive_isNoMotors();
  void voltageOfAnInputThatGoesBelowZero_isTheMotors();
  void jointAlone_isItsAngleWhereNothingElseMoves();
  void referenceOfWhatMovesOtherwise_isKept();
  void axisByAnUnknownWord_hasItsTorque();
  void motionThatTheTorqueDrives_isTaken_data();
  void motionThatTheTorqueDrives_isTaken();
  void plainNameBesideAMeasuredOne_isItsReference();
  void estimate_yieldsToWhatWasMeasured();
  void angleInElectricalTurns_isKeptBesideItsSpeed_data();
  void angleInElectricalTurns_isKeptBesideItsSpeed();
  void speedInElectricalTurns_isKeptBesideItsAngle();
  void wayFromRowToRow_isNoAngle();
  void dutyOfUnknownScale_isKeptBesideACurrent();
  void largeValuesOfALetterAlone_areKept();
  void countsWithoutAUnit_yieldToAnAngleThatTellsIt();
  void oneOfTwoThatOnlyTheirPlaceTellsApart_goesWithTheMotion_data();
  void oneOfTwoThatOnlyTheirPlaceTellsApart_goesWithTheMotion();

 private:
  Result<Imported> logOf(const std::vector<NamedWave>& columns, int rows = 600) {
    QString text;
    for (const NamedWave& one : columns) text += (text.isEmpty() ? "" : ",") + QString::fromUtf8(one.name);
    for (int k = 0; k < rows; ++k) {
      for (size_t c = 0; c < columns.size(); ++c)
        text += (c == 0 ? "\n" : ",") + QString::number(columns[c].at(k), 'g', 9);
    }
    return importRecording(folder_.write("log.csv", (text + "\n").toStdString()));
  }
  static const ColumnFate& fateOf(const Imported& log, const std::string& name) {
    const auto it =
        std::find_if(log.columns.begin(), log.columns.end(), [&](const ColumnFate& one) { return one.from == name; });
    return it == log.columns.end() ? log.columns.front() : *it;
  }
  static std::string meaning(const Imported& log, const std::string& name) {
    const ColumnFate& fate = fateOf(log, name);
    return fate.kind == ColumnFate::Kind::used ? fate.to : std::string();
  }
  TemporaryFolder folder_;
};

static double clockOf(int k) {
  return stepOfMotion_s * k;
}

void TestImportByValues::driveWithoutAKnownName_isTakenWhereItMovesTheMotor_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<bool>("moves");
  QTest::addColumn<QString>("to");
  QTest::newRow("a torque") << "Kanal7 [Nm]" << true << "torque_Nm";
  QTest::newRow("a current") << "Welle7 [A]" << true << "current_A";
  QTest::newRow("another torque") << "Kanal7 [Nm]" << false << "";
  QTest::newRow("a load's") << "load_torque_x [Nm]" << true << "";
  QTest::newRow("a brake's") << "Bremse [Nm]" << true << "";
  QTest::newRow("a phase's") << "phase_a [A]" << true << "";
}

void TestImportByValues::driveWithoutAKnownName_isTakenWhereItMovesTheMotor() {
  QFETCH(QString, name);
  QFETCH(bool, moves);
  QFETCH(QString, to);
  const QByteArray called = name.toUtf8();
  const auto log = logOf({{"time_s", clockOf},
                          {"velocity_rad_per_s", speedOfMotion},
                          {called.constData(), moves ? torqueOfMotion : elsewhere}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, name.toStdString()), to.toStdString());
  if (to.isEmpty()) return;
  QVERIFY(fateOf(*log, name.toStdString()).guessed);
  QCOMPARE(log->recording.channel(to.toStdString())[100],
           std::stod(QString::number(torqueOfMotion(100), 'g', 9).toStdString()));
}

void TestImportByValues::memberCalledByALetter_hasNoUnit() {
  const auto gained = [](int k) { return (speedOfMotion(k + 1) - speedOfMotion(k)) / stepOfMotion_s; };
  const auto log =
      logOf({{"time", clockOf}, {"inertia.phi", turnedBy}, {"inertia.w", speedOfMotion}, {"inertia.a", gained}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "inertia.w"), std::string("velocity_rad_per_s"));
  QCOMPARE(meaning(*log, "inertia.a"), std::string());
}

void TestImportByValues::motionThatRepeatsItself_saysNothingOfADrive() {
  const auto wave = [](int k) { return 5.0 * std::sin(0.1 * k); };
  const auto later = [](int k) { return 0.02 * std::sin(0.1 * k + 0.4); };
  const auto log = logOf({{"time_s", clockOf}, {"velocity_rad_per_s", wave}, {"Kanal7 [Nm]", later}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "Kanal7 [Nm]"), "");
}

void TestImportByValues::setPoint_isWhatIsFollowed_data() {
  QTest::addColumn<double>("share");
  QTest::addColumn<bool>("taken");
  QTest::newRow("as far") << 1.05 << true;
  QTest::newRow("not half as far") << 3.0 << false;
  QTest::newRow("the other way") << -1.0 << false;
}

void TestImportByValues::setPoint_isWhatIsFollowed() {
  QFETCH(double, share);
  QFETCH(bool, taken);
  const auto log = logOf({{"time_s", clockOf},
                          {"rpm", [](int k) { return 9.5 * speedOfMotion(k); }},
                          {"Setpoint", [share](int k) { return share * 9.5 * speedOfMotion(k + 2); }}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "Setpoint"), taken ? "velocity_reference_rad_per_s" : "");
  QCOMPARE(fateOf(*log, "Setpoint").guessed, taken);
}

/// "left_cmd" within ±1 is no speed that a wheel of 80 rpm shall have.
void TestImportByValues::referenceThatGoesNowhereNear_isKept() {
  const auto log = logOf({{"time_s", clockOf},
                          {"left_rpm", [](int k) { return 9.5 * speedOfMotion(k); }},
                          {"left_cmd", [](int k) { return 0.04 * speedOfMotion(k); }}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "left_rpm"), "velocity_rad_per_s");
  QCOMPARE(meaning(*log, "left_cmd"), "");
}

void TestImportByValues::speedWithoutAKnownName_isTakenWhereTheAngleMovesSo_data() {
  QTest::addColumn<double>("share");
  QTest::addColumn<double>("later");
  QTest::addColumn<QString>("unit");
  QTest::newRow("rad/s") << 1.0 << 0.0 << "rad/s";
  QTest::newRow("deg/s") << 57.29578 << 0.0 << "deg/s";
  QTest::newRow("rpm") << 9.549297 << 0.0 << "rpm";
  QTest::newRow("in no usual unit") << 400.0 << 0.0 << "";
  QTest::newRow("another motion") << 1.0 << 40.0 << "";
}

void TestImportByValues::speedWithoutAKnownName_isTakenWhereTheAngleMovesSo() {
  QFETCH(double, share);
  QFETCH(double, later);
  QFETCH(QString, unit);
  const auto log =
      logOf({{"time_s", clockOf}, {"angle_rad", turnedBy}, {"v0", [share, later](int k) {
                                                              return share * speedOfMotion(k + static_cast<int>(later));
                                                            }}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "v0"), unit.isEmpty() ? "" : "velocity_rad_per_s");
  if (unit.isEmpty()) return;
  QCOMPARE(QString::fromStdString(fateOf(*log, "v0").unit), unit);
  QVERIFY(std::abs(log->recording.channel("velocity_rad_per_s")[100] - speedOfMotion(100)) < 1e-4);
  QVERIFY(fateOf(*log, "v0").guessed);
}

void TestImportByValues::motionInAnUnknownLanguage_isTakenAsAGuess() {
  const auto log = logOf({{"ժամ", clockOf}, {"անկյուն", turnedBy}, {"արագություն", speedOfMotion}, {"այլ", elsewhere}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "ժամ"), "time_s");
  QCOMPARE(meaning(*log, "անկյուն"), "angle_rad");
  QCOMPARE(meaning(*log, "արագություն"), "velocity_rad_per_s");
  QCOMPARE(meaning(*log, "այլ"), "");
  for (const char* name : {"ժամ", "անկյուն", "արագություն"}) QVERIFY(fateOf(*log, name).guessed);
}

void TestImportByValues::meterThatOnlyGoesUp_isNoAngle() {
  const auto oneWay = [](int k) { return 20.0 + 0.1 * speedOfMotion(k); };
  const auto meter = [](int k) { return 0.2 * k + 0.01 * std::sin(0.4 * k); };
  const auto log = logOf({{"ժամ", clockOf}, {"հաշվիչ", meter}, {"արագություն", oneWay}});
  QVERIFY(!log.ok());
}

void TestImportByValues::rowsByNumber_areNoTime() {
  const auto log = logOf({{"թիվ", [](int k) { return double(k); }}, {"angle_rad", turnedBy}});
  QVERIFY(!log.ok());
  QVERIFY2(log.error().message().find("sample_time_s") != std::string::npos, log.error().message().c_str());
}

void TestImportByValues::placeThatDoesNotGoWithARotation_isKept_data() {
  QTest::addColumn<bool>("screw");
  QTest::newRow("a screw's nut") << true;
  QTest::newRow("a rotor off its centre") << false;
}

void TestImportByValues::placeThatDoesNotGoWithARotation_isKept() {
  QFETCH(bool, screw);
  const auto log =
      logOf({{"time [s]", clockOf},
             {"rotor speed [rpm]", [](int k) { return 9.5 * speedOfMotion(k); }},
             {"axial displacement [m]", [screw](int k) { return screw ? 1e-3 * turnedBy(k) : 1e-6 * elsewhere(k); }}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "rotor speed [rpm]"), "velocity_rad_per_s");
  QCOMPARE(meaning(*log, "axial displacement [m]"), screw ? "position_m" : "");
}

void TestImportByValues::headingThatTurnsWithItsDrive_isNoMotors() {
  const auto log = logOf({{"time_s", clockOf},
                          {"yaw_motor_rpm", [](int k) { return 9.5 * speedOfMotion(k); }},
                          {"nacelle_yaw_deg", [](int k) { return 0.1 * turnedBy(k); }}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "nacelle_yaw_deg"), "");
}

void TestImportByValues::voltageOfAnInputThatGoesBelowZero_isTheMotors() {
  const auto log = logOf({{"time_s", clockOf}, {"angle_rad", turnedBy}, {"input_voltage", speedOfMotion}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "input_voltage"), "voltage_V");
  QVERIFY(fateOf(*log, "input_voltage").guessed);
}

void TestImportByValues::jointAlone_isItsAngleWhereNothingElseMoves() {
  const auto still = [](int) { return 0.5; };
  const auto sooner = [](int k) { return turnedBy(k + 2); };
  const auto joints = logOf({{"time_s", clockOf}, {"elbow_cmd", sooner}, {"elbow_act", turnedBy}, {"wrist", still}});
  VERIFY_OK(joints);
  QCOMPARE(meaning(*joints, "elbow_act"), std::string("angle_rad"));
  QCOMPARE(meaning(*joints, "elbow_cmd"), std::string("angle_reference_rad"));
  QCOMPARE(meaning(*joints, "wrist"), std::string());
  QVERIFY(fateOf(*joints, "elbow_act").guessed);
  const auto beside = logOf({{"time_s", clockOf}, {"knee", elsewhere}, {"velocity_rad_per_s", speedOfMotion}});
  VERIFY_OK(beside);
  QCOMPARE(meaning(*beside, "knee"), std::string());
  const auto current = logOf({{"time_s", clockOf}, {"knee [A]", elsewhere}});
  QVERIFY(!current.ok());
  const auto far = logOf({{"time_s", clockOf}, {"knee", [](int k) { return 30.0 * turnedBy(k); }}});
  VERIFY_OK(far);
  QCOMPARE(fateOf(*far, "knee").unit, std::string("deg"));
  const auto learnt =
      logOf({{"time_s", clockOf}, {"observation.state.joint_00", turnedBy}, {"action.joint_00", sooner}});
  VERIFY_OK(learnt);
  QCOMPARE(meaning(*learnt, "observation.state.joint_00"), std::string("angle_rad"));
  QCOMPARE(meaning(*learnt, "action.joint_00"), std::string("angle_reference_rad"));
}

void TestImportByValues::referenceOfWhatMovesOtherwise_isKept() {
  const auto rpm = [](int k) { return 9.5493 * speedOfMotion(k); };
  const auto lean = [](int k) { return 0.05 * std::sin(0.31 * k); };
  const auto leans = [](int k) { return 0.05 * 31.0 * std::cos(0.31 * k); };
  const auto log =
      logOf({{"time_s", clockOf}, {"theta", lean}, {"theta_dot", leans}, {"theta_ref", elsewhere}, {"motor_rpm", rpm}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "theta"), std::string());
  QCOMPARE(meaning(*log, "theta_ref"), std::string());
  QCOMPARE(meaning(*log, "motor_rpm"), std::string("velocity_rad_per_s"));
}

void TestImportByValues::axisByAnUnknownWord_hasItsTorque() {
  const auto log = logOf({{"time_s", clockOf},
                          {"iiwa_joint_1_q", turnedBy},
                          {"iiwa_joint_1_w", speedOfMotion},
                          {"iiwa_joint_1_tau", torqueOfMotion},
                          {"iiwa_joint_2_tau", elsewhere}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "iiwa_joint_1_tau"), std::string("torque_Nm"));
  QCOMPARE(meaning(*log, "iiwa_joint_2_tau"), std::string());
}

/// A motion of something else, and how fast it is.
static double placeElsewhere(int k) {
  return 3.0 * std::sin(0.017 * k + 0.5) + 2.0 * std::sin(0.031 * k);
}

static double speedElsewhere(int k) {
  return (3.0 * 0.017 * std::cos(0.017 * k + 0.5) + 2.0 * 0.031 * std::cos(0.031 * k)) / stepOfMotion_s;
}

void TestImportByValues::motionThatTheTorqueDrives_isTaken_data() {
  QTest::addColumn<bool>("drives");
  QTest::addColumn<QString>("taken");
  QTest::newRow("the second's") << true << "table";
  QTest::newRow("neither's") << false << "stage";
}

void TestImportByValues::motionThatTheTorqueDrives_isTaken() {
  QFETCH(bool, drives);
  QFETCH(QString, taken);
  const auto log = logOf({{"time_s", clockOf},
                          {"stage_angle_rad", placeElsewhere},
                          {"stage_speed_rad_s", speedElsewhere},
                          {"table_angle_rad", turnedBy},
                          {"table_speed_rad_s", speedOfMotion},
                          {"torque_Nm", drives ? torqueOfMotion : elsewhere}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, taken.toStdString() + "_angle_rad"), std::string("angle_rad"));
  QCOMPARE(meaning(*log, taken.toStdString() + "_speed_rad_s"), std::string("velocity_rad_per_s"));
  QCOMPARE(fateOf(*log, taken.toStdString() + "_angle_rad").guessed, !drives);  // nothing but their order told
}

void TestImportByValues::plainNameBesideAMeasuredOne_isItsReference() {
  const auto wanted = [](int k) { return speedOfMotion(k + 2); };
  const auto log = logOf({{"time_s", clockOf}, {"spd[rad/s]", wanted}, {"spd_fb[rad/s]", speedOfMotion}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "spd_fb[rad/s]"), std::string("velocity_rad_per_s"));
  QCOMPARE(meaning(*log, "spd[rad/s]"), std::string("velocity_reference_rad_per_s"));
  QVERIFY(fateOf(*log, "spd[rad/s]").guessed);
  const auto told = logOf({{"time_s", clockOf}, {"spd_ref", wanted}, {"spd", elsewhere}, {"spd_fb", speedOfMotion}});
  VERIFY_OK(told);
  QCOMPARE(meaning(*told, "spd_fb"), std::string("velocity_rad_per_s"));
  QCOMPARE(meaning(*told, "spd_ref"), std::string("velocity_reference_rad_per_s"));
  QCOMPARE(meaning(*told, "spd"), std::string());
}

void TestImportByValues::estimate_yieldsToWhatWasMeasured() {
  const auto late = [](int k) { return speedOfMotion(k - 8); };
  const auto log = logOf({{"time_s", clockOf}, {"omega_hat", late}, {"omega", speedOfMotion}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "omega"), std::string("velocity_rad_per_s"));
  const auto alone = logOf({{"time_s", clockOf}, {"omega_hat", late}});
  VERIFY_OK(alone);
  QCOMPARE(meaning(*alone, "omega_hat"), std::string("velocity_rad_per_s"));
}

void TestImportByValues::angleInElectricalTurns_isKeptBesideItsSpeed_data() {
  QTest::addColumn<double>("times");
  QTest::addColumn<bool>("taken");
  QTest::newRow("mechanical") << 1.0 << true;
  QTest::newRow("five pole pairs") << 5.0 << false;
  QTest::newRow("too fast for its rows") << 28.3 << false;
}

void TestImportByValues::angleInElectricalTurns_isKeptBesideItsSpeed() {
  QFETCH(double, times);
  QFETCH(bool, taken);
  const auto angle = [times](int k) {
    const double degrees = std::fmod(times * turnedBy(k) * 180.0 / std::numbers::pi, 360.0);
    return degrees < 0.0 ? degrees + 360.0 : degrees;
  };
  const auto rpm = [](int k) { return speedOfMotion(k) * 30.0 / std::numbers::pi; };
  const auto log = logOf({{"time_s", clockOf}, {"Motor_Angle", angle}, {"Motor_Speed [rpm]", rpm}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "Motor_Angle"), taken ? std::string("angle_rad") : std::string());
  QCOMPARE(meaning(*log, "Motor_Speed [rpm]"), std::string("velocity_rad_per_s"));
  QCOMPARE(fateOf(*log, "Motor_Speed [rpm]").guessed, times == 5.0);
}

void TestImportByValues::speedInElectricalTurns_isKeptBesideItsAngle() {
  const auto rpm = [](int k) { return 7.0 * speedOfMotion(k) * 30.0 / std::numbers::pi; };
  const auto log = logOf({{"time_s", clockOf}, {"theta_rad", turnedBy}, {"rpm", rpm}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "rpm"), std::string());
  QCOMPARE(meaning(*log, "theta_rad"), std::string("angle_rad"));
  QVERIFY(fateOf(*log, "theta_rad").guessed);  // the speed may be before a gear
}

void TestImportByValues::wayFromRowToRow_isNoAngle() {
  const auto way = [](int k) { return (turnedBy(k) - turnedBy(k - 1)) * 180.0 / std::numbers::pi; };
  const auto log = logOf({{"time_s", clockOf}, {"angle_deg", way}, {"omega_rad_s", speedOfMotion}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "angle_deg"), std::string());
  QCOMPARE(meaning(*log, "omega_rad_s"), std::string("velocity_rad_per_s"));
}

void TestImportByValues::dutyOfUnknownScale_isKeptBesideACurrent() {
  const auto pwm = [](int k) { return std::round(60.0 * speedOfMotion(k)); };
  const auto log = logOf({{"time_s", clockOf}, {"omega_rad_s", speedOfMotion}, {"pwm", pwm}, {"iq_A", torqueOfMotion}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "pwm"), std::string());
  QCOMPARE(meaning(*log, "iq_A"), std::string("current_A"));
  QVERIFY(!logOf({{"time_s", clockOf}, {"omega_rad_s", speedOfMotion}, {"pwm", pwm}}).ok());  // asks
}

void TestImportByValues::largeValuesOfALetterAlone_areKept() {
  const auto log = logOf({{"time_s", clockOf},
                          {"omega_rad_s", speedOfMotion},
                          {"I", [](int k) { return 2e4 * torqueOfMotion(k); }},
                          {"U", [](int k) { return 0.5 * speedOfMotion(k); }}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "I"), std::string());
  QCOMPARE(meaning(*log, "U"), std::string("voltage_V"));
  QVERIFY(!log->remarks.empty());
}

void TestImportByValues::countsWithoutAUnit_yieldToAnAngleThatTellsIt() {
  const auto counts = [](int k) { return std::round(500.0 * turnedBy(k)); };
  const auto degrees = [](int k) { return turnedBy(k) * 180.0 / std::numbers::pi; };
  const auto log = logOf({{"ms", [](int k) { return 10.0 * k; }}, {"step_pos", counts}, {"motor_deg", degrees}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "motor_deg"), std::string("angle_rad"));
}

void TestImportByValues::oneOfTwoThatOnlyTheirPlaceTellsApart_goesWithTheMotion_data() {
  QTest::addColumn<QString>("first");
  QTest::addColumn<QString>("second");
  QTest::addColumn<bool>("firstsOwn");
  QTest::addColumn<QString>("to");
  for (const bool firstsOwn : {true, false}) {
    QTest::addRow("currents %d", firstsOwn) << "x_current_A"
                                            << "y_current_A" << firstsOwn << "current_A";
    QTest::addRow("torques %d", firstsOwn) << "pan_torque_Nm"
                                           << "lift_torque_Nm" << firstsOwn << "torque_Nm";
    QTest::addRow("references %d", firstsOwn) << "cmd1_rad_s"
                                              << "cmd2_rad_s" << firstsOwn << "velocity_reference_rad_per_s";
  }
}

void TestImportByValues::oneOfTwoThatOnlyTheirPlaceTellsApart_goesWithTheMotion() {
  QFETCH(QString, first);
  QFETCH(QString, second);
  QFETCH(bool, firstsOwn);
  QFETCH(QString, to);
  const bool reference = to.contains("reference");
  const QByteArray one = first.toUtf8(), two = second.toUtf8();
  const auto own = [reference](int k) { return reference ? speedOfMotion(k + 2) : torqueOfMotion(k); };
  const auto other = [reference](int k) { return elsewhere(k) * (reference ? 500.0 : 1.0); };
  const auto log = logOf({{"time_s", clockOf},
                          {"speed_rad_s", speedOfMotion},
                          {one.constData(), firstsOwn ? std::function<double(int)>(own) : other},
                          {two.constData(), firstsOwn ? std::function<double(int)>(other) : own}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, first.toStdString()), firstsOwn ? to.toStdString() : "");
  QCOMPARE(meaning(*log, second.toStdString()), firstsOwn ? "" : to.toStdString());
  if (!firstsOwn) QVERIFY(fateOf(*log, second.toStdString()).guessed);
}

QTEST_APPLESS_MAIN(TestImportByValues)
#include "tst_import_by_values.moc"
