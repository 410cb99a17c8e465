#include <QTest>
#include <cmath>

#include "recording/import/import.h"
#include "support/temporary.h"

using namespace breakaway;
using breakaway::test::TemporaryFolder;

/// Which of several columns is the motor's motion, by names and values together.
class TestImportMotion : public QObject {
  Q_OBJECT
 private slots:
  void speedThatIsCalledAsTheAngle_isTaken();
  void unknownWordBesideASpeed_isTheAngleIfItMovesSo();
  void unknownWordThatMovesOtherwise_isKept();
  void countsThatMoveAsTheSpeedSays_areTheAngle();
  void lettersOfAMotorsFrames_areItsState_data();
  void lettersOfAMotorsFrames_areItsState();
  void lettersThatSayActual_areTheState();
  void cartWithAPole_isTheCarts();
  void wheelsOwnMotion_goesBeforeALean();
  void cartsOwnMotion_goesBeforeAPoles();
  void motorsOwnMotion_goesBeforeAWheels();
  void quaternionsAndVectors_areNoMotors();
  void speedOfSomethingElse_isKept();
  void vehiclesSpeed_yieldsToItsMotors();
  void forceBesideASpeedOfRotation_isKept();
  void poseOfAVehicle_isNoCart();
  void wayOfAVehicle_isNoMotorsPosition();
  void goalOfAHeading_isNoEncoders();
  void busIsTheSupplyBeforeABattery();
  void outputOfAController_isADutyIfNothingElseDrives_data();
  void outputOfAController_isADutyIfNothingElseDrives();
  void lineOfPropertiesBelowTheNames_isNoLineOfUnits();
  void currentOfAnotherMakersServo_isKept();
  void inputAndOutputOfAGear_areItsSides();
  void inputBesideAnOutputAlone_isAReference();
  void inputThatTurnsAMultipleOfItsOutput_isTheMotors_data();
  void inputThatTurnsAMultipleOfItsOutput_isTheMotors();
  void whatGoesInBesideWhatComesOut_isAReference();
  void torqueOfSomethingElseThanTheMotor_isKept_data();
  void torqueOfSomethingElseThanTheMotor_isKept();
  void motorsMotionUnderOtherNames_isFound_data();
  void motorsMotionUnderOtherNames_isFound();
  void tachometerOfAVesc_isElectrical();
  void torqueOfTheJoint_isNotTheMotors();
  void rawSpeed_yieldsToTheMeasuredOne();

 private:
  struct Wave {
    const char* name;
    double angle, speed, constant;  ///< shares of the motion
  };
  /// A table of these columns beside a time, of one motion: 40 sin(3 t) rad/s.
  Result<Imported> moving(const std::vector<Wave>& columns, const ImportMap& map = {}) {
    QString text = "time_s";
    for (const Wave& column : columns) text += QString(",") + column.name;
    for (int k = 0; k < 300; ++k) {
      const double t_s = 0.01 * k, speed = 40.0 * std::sin(3.0 * t_s), angle = 40.0 / 3.0 * (1.0 - std::cos(3.0 * t_s));
      text += QString("\n%1").arg(t_s);
      for (const Wave& column : columns) {
        const double value = column.constant + column.angle * angle + column.speed * speed;
        text += QString(",%1").arg(value, 0, 'g', 9);
      }
    }
    return importRecording(folder_.write("log.csv", text.toStdString() + "\n"), map);
  }
  static std::string meaning(const Imported& log, const std::string& name) {
    for (const ColumnFate& fate : log.columns) {
      if (fate.from == name) return fate.kind == ColumnFate::Kind::used ? fate.to : std::string();
    }
    return "not there";
  }
  TemporaryFolder folder_;
};

void TestImportMotion::speedThatIsCalledAsTheAngle_isTaken() {
  const auto log = moving({{"omega_ekf", 0, 7, 0}, {"theta_enc", 1, 0, 0}, {"omega_enc", 0, 1, 0}});
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, "omega_enc"), "velocity_rad_per_s");
  QCOMPARE(meaning(*log, "omega_ekf"), "");
}

void TestImportMotion::unknownWordBesideASpeed_isTheAngleIfItMovesSo() {
  const auto log = moving({{"loc_cmd", 1, 0, 0.1}, {"loc_state", 1, 0, 0}, {"speed_state", 0, 1, 0}});
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, "loc_state"), "angle_rad");
  QCOMPARE(meaning(*log, "loc_cmd"), "angle_reference_rad");
  for (const ColumnFate& fate : log->columns) QVERIFY(fate.from != "loc_state" || fate.guessed);
}

void TestImportMotion::unknownWordThatMovesOtherwise_isKept() {
  const auto log = moving({{"loc_state", 0, 1, 3}, {"speed_state", 0, 1, 0}});
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, "loc_state"), "");
}

void TestImportMotion::countsThatMoveAsTheSpeedSays_areTheAngle() {
  const auto log = moving({{"Motor speed(rad/s)", 0, 1, 0},
                           {"Droop pulses(pulse)", 0, 0.5, 0},
                           {"Cumulative feedback pulses(pulse)", 651.8986, 0, 0}});
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, "Cumulative feedback pulses(pulse)"), "angle_rad");
  QCOMPARE(meaning(*log, "Droop pulses(pulse)"), "");
  QVERIFY(std::abs(log->recording.channel("angle_rad").back() - 40.0 / 3.0 * (1.0 - std::cos(3.0 * 2.99))) < 0.05);
}

void TestImportMotion::lettersOfAMotorsFrames_areItsState_data() {
  QTest::addColumn<QString>("first");
  QTest::addColumn<QString>("second");
  QTest::addColumn<QString>("to");
  QTest::newRow("beside what they shall be") << "p_des"
                                             << "v_des"
                                             << "angle_reference_rad";
  QTest::newRow("beside gains") << "kp"
                                << "kd"
                                << "";
}

void TestImportMotion::lettersOfAMotorsFrames_areItsState() {
  QFETCH(QString, first);
  QFETCH(QString, second);
  QFETCH(QString, to);
  const QByteArray one = first.toUtf8(), two = second.toUtf8();
  const auto log = moving({{one.constData(), 1, 0, 0.1}, {two.constData(), 0, 1, 1}, {"p", 1, 0, 0}, {"v", 0, 1, 0}});
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, "p"), "angle_rad");
  QCOMPARE(meaning(*log, "v"), "velocity_rad_per_s");
  QCOMPARE(meaning(*log, first.toStdString()), to.toStdString());
}

void TestImportMotion::lettersThatSayActual_areTheState() {
  const auto log = moving({{"p_des", 1, 0, 0.1}, {"p_act", 1, 0, 0}, {"v_des", 0, 1, 1}, {"v_act", 0, 1, 0}});
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, "p_act"), "angle_rad");
  QCOMPARE(meaning(*log, "v_act"), "velocity_rad_per_s");
}

void TestImportMotion::cartWithAPole_isTheCarts() {
  const auto log = moving({{"x", 0.01, 0, 0}, {"x_dot", 0, 0.01, 0}, {"theta", 0.1, 0, 3}, {"theta_dot", 0, 0.1, 0}});
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, "x"), "position_m");
  QCOMPARE(meaning(*log, "x_dot"), "velocity_m_per_s");
  QCOMPARE(meaning(*log, "theta"), "");
}

void TestImportMotion::wheelsOwnMotion_goesBeforeALean() {
  const auto log =
      moving({{"theta_deg", 0.3, 0, 0}, {"theta_dot_dps", 0, 0.3, 0}, {"wheel_pos", 1, 0, 0}, {"wheel_vel", 0, 1, 0}});
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, "wheel_pos"), "angle_rad");
  QCOMPARE(meaning(*log, "wheel_vel"), "velocity_rad_per_s");
  QCOMPARE(meaning(*log, "theta_deg"), "");
}

void TestImportMotion::cartsOwnMotion_goesBeforeAPoles() {
  const auto log = moving({{"Angle", 0.3, 0, 3},
                           {"Angular Velocity", 0, 0.3, 0},
                           {"Cart Position", 0.01, 0, 0},
                           {"Cart Speed", 0, 0.01, 0}});
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, "Cart Position"), "position_m");
  QCOMPARE(meaning(*log, "Cart Speed"), "velocity_m_per_s");
}

void TestImportMotion::motorsOwnMotion_goesBeforeAWheels() {
  const auto log =
      moving({{"motor_pos", 10, 0, 0}, {"motor_vel", 0, 10, 0}, {"wheel_pos", 1, 0, 0}, {"wheel_vel", 0, 1, 0}});
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, "motor_pos"), "angle_rad");
  QCOMPARE(meaning(*log, "motor_vel"), "velocity_rad_per_s");
}

void TestImportMotion::quaternionsAndVectors_areNoMotors() {
  std::vector<Wave> columns;
  for (const char* name : {"q_w", "q_x", "q_y", "q_z", "w_x", "w_y", "w_z"}) columns.push_back({name, 0.01, 0, 0});
  QVERIFY(!moving(columns));
  columns.push_back({"wheel_vel1", 0, 1, 0});
  const auto log = moving(columns);
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, "wheel_vel1"), "velocity_rad_per_s");
  QCOMPARE(meaning(*log, "q_x"), "");
}

void TestImportMotion::speedOfSomethingElse_isKept() {
  const auto log = moving({{"hood_angle", 0.3, 0, 0},
                           {"target_hood_angle", 0.3, 0, 0.1},
                           {"robot_velocity", 0.01, 0, 2},
                           {"target_rpm", 0, 0, 3000}});
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, "hood_angle"), "angle_rad");
  QCOMPARE(meaning(*log, "robot_velocity"), "");
  QCOMPARE(meaning(*log, "target_rpm"), "");
}

void TestImportMotion::vehiclesSpeed_yieldsToItsMotors() {
  const auto log = moving({{"speed", 0, 0.1, 0}, {"motor_speed", 0, 1, 0}, {"odometer", 0.1, 0, 0}});
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, "motor_speed"), "velocity_rad_per_s");
  const auto bench = moving({{"speed", 0, 0.1, 0}, {"motor_speed", 0, 1, 0}});
  QVERIFY(bench.ok());
  QCOMPARE(meaning(*bench, "speed"), "velocity_rad_per_s");
}

void TestImportMotion::forceBesideASpeedOfRotation_isKept() {
  const auto log = moving({{"rpm", 0, 9.5, 0}, {"force", 0, 0, 0.5}});
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, "force"), "");
}

void TestImportMotion::poseOfAVehicle_isNoCart() {
  const auto log = moving(
      {{"x", 0.01, 0, 0}, {"y", 0.02, 0, 0}, {"x_dot", 0, 0.01, 0}, {"theta", 0.1, 0, 3}, {"theta_dot", 0, 0.1, 0}});
  QVERIFY(!log.ok() || meaning(*log, "x").empty());
}

void TestImportMotion::wayOfAVehicle_isNoMotorsPosition() {
  const std::vector<Wave> robot{
      {"enc_l", 200, 0, 0}, {"enc_r", 190, 0, 0}, {"pwm_l", 0, 0.01, 0}, {"pwm_r", 0, 0.01, 0}, {"travel_mm", 3, 0, 0}};
  ImportMap map;
  map.counts_per_rev = 1000.0;
  const auto log = moving(robot, map);
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, "travel_mm"), "");
  QCOMPARE(meaning(*log, "pwm_l"), "duty");
}

void TestImportMotion::goalOfAHeading_isNoEncoders() {
  const auto log = moving(
      {{"heading_deg", 0.2, 0, 0}, {"target_deg", 0.2, 0, 1}, {"shaft_rev", 0.159155, 0, 0}, {"rpm", 0, 9.5493, 0}});
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, "shaft_rev"), "angle_rad");
  QCOMPARE(meaning(*log, "target_deg"), "");
}

void TestImportMotion::busIsTheSupplyBeforeABattery() {
  const auto log = moving({{"rpm", 0, 9.5, 0}, {"batt_voltage", 0, 0, 12.6}, {"bus_voltage", 0, 0.001, 96}});
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, "bus_voltage"), "supply_V");
  QCOMPARE(meaning(*log, "batt_voltage"), "");
}

void TestImportMotion::outputOfAController_isADutyIfNothingElseDrives_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QString>("beside");
  QTest::addColumn<QString>("to");
  QTest::newRow("an actuation") << "Actuation Level [%]"
                                << "note"
                                << "duty";
  QTest::newRow("a throttle") << "Throttle(%)"
                              << "note"
                              << "duty";
  QTest::newRow("a pedal") << "Throttle(%)"
                           << "Brake(%)"
                           << "";
  QTest::newRow("beside a current") << "Throttle(%)"
                                    << "current_A"
                                    << "";
}

void TestImportMotion::outputOfAController_isADutyIfNothingElseDrives() {
  QFETCH(QString, name);
  QFETCH(QString, beside);
  QFETCH(QString, to);
  const QByteArray one = name.toUtf8(), two = beside.toUtf8();
  const auto log = moving({{"rpm", 0, 9.5, 0}, {one.constData(), 0, 1, 0}, {two.constData(), 0, 0.1, 0}});
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, name.toStdString()), to.toStdString());
}

void TestImportMotion::lineOfPropertiesBelowTheNames_isNoLineOfUnits() {
  std::string text = "time,actPos:1,actVel:1\n,Interp: linear,Interp: linear\n";
  for (int k = 0; k < 100; ++k)
    text += std::to_string(0.01 * k) + "," + std::to_string(std::sin(0.01 * k)) + "," +
            std::to_string(std::cos(0.01 * k)) + "\n";
  const auto log = importRecording(folder_.write("log.csv", text));
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, "actPos:1"), "angle_rad");
  QCOMPARE(meaning(*log, "actVel:1"), "velocity_rad_per_s");
}

void TestImportMotion::currentOfAnotherMakersServo_isKept() {
  std::string text = "time,Present Position,Present Speed,Present Current\n";
  for (int k = 0; k < 200; ++k) {
    const double t_s = 0.01 * k;
    text += std::to_string(t_s) + "," + std::to_string(std::lround(2048.0 + 900.0 * std::sin(2.0 * t_s))) + "," +
            std::to_string(std::lround(1800.0 * std::cos(2.0 * t_s))) + "," + std::to_string(k % 40) + "\n";
  }
  const auto log = importRecording(folder_.write("log.csv", text));
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, "Present Position"), "angle_rad");
  QCOMPARE(meaning(*log, "Present Current"), "");
}

void TestImportMotion::inputAndOutputOfAGear_areItsSides() {
  const auto log = moving({{"input_speed_rpm", 0, 9.5, 0},
                           {"output_speed_rpm", 0, 0.95, 0},
                           {"input_torque_Nm", 0, 0.01, 0},
                           {"output_torque_Nm", 0, 0.09, 0}});
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, "input_speed_rpm"), "velocity_rad_per_s");
  QCOMPARE(meaning(*log, "input_torque_Nm"), "torque_Nm");
  QCOMPARE(meaning(*log, "output_speed_rpm"), "");
  QCOMPARE(meaning(*log, "output_torque_Nm"), "");
  const auto encoders = moving({{"InputEncoder[deg]", 57, 0, 0},
                                {"OutputEncoder[deg]", 0.57, 0, 0},
                                {"InputTorque[Nm]", 0, 0.01, 0},
                                {"OutputTorque[Nm]", 0, 0.8, 0}});
  QVERIFY(encoders.ok());
  QCOMPARE(meaning(*encoders, "InputEncoder[deg]"), "angle_rad");
  QCOMPARE(meaning(*encoders, "InputTorque[Nm]"), "torque_Nm");
}

void TestImportMotion::inputBesideAnOutputAlone_isAReference() {
  const auto log = moving({{"input_speed_rpm", 0, 9.5, 1}, {"output_speed_rpm", 0, 9.5, 0}});
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, "input_speed_rpm"), "velocity_reference_rad_per_s");
  QCOMPARE(meaning(*log, "output_speed_rpm"), "velocity_rad_per_s");
}

void TestImportMotion::inputThatTurnsAMultipleOfItsOutput_isTheMotors_data() {
  QTest::addColumn<QString>("input");
  QTest::addColumn<QString>("output");
  QTest::newRow("in words") << "input_speed_rpm"
                            << "output_speed_rpm";
  QTest::newRow("in and out") << "speed_in_rpm"
                              << "speed_out_rpm";
}

void TestImportMotion::inputThatTurnsAMultipleOfItsOutput_isTheMotors() {
  QFETCH(QString, input);
  QFETCH(QString, output);
  const QByteArray in = input.toUtf8(), out = output.toUtf8();
  const auto log = moving({{out.constData(), 0, 1.9, 0}, {in.constData(), 0, 9.5, 0}});
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, input.toStdString()), "velocity_rad_per_s");
  QCOMPARE(meaning(*log, output.toStdString()), "");
}

void TestImportMotion::whatGoesInBesideWhatComesOut_isAReference() {
  const auto log = moving({{"speed_in_rpm", 0, 9.5, 1}, {"speed_out_rpm", 0, 9.5, 0}});
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, "speed_in_rpm"), "velocity_reference_rad_per_s");
  QCOMPARE(meaning(*log, "speed_out_rpm"), "velocity_rad_per_s");
  for (const ColumnFate& fate : log->columns) {
    if (fate.from == "speed_in_rpm") QVERIFY(fate.guessed);
  }
}

void TestImportMotion::torqueOfSomethingElseThanTheMotor_isKept_data() {
  QTest::addColumn<QString>("motion");
  QTest::addColumn<QString>("torque");
  QTest::addColumn<bool>("taken");
  QTest::newRow("a pedal's") << "motor_rad_per_s"
                             << "pedal_torque_Nm" << false;
  QTest::newRow("a steering's") << "motor_speed [rad/s]"
                                << "steering_torque_Nm" << false;
  QTest::newRow("the motor's") << "motor_speed [rad/s]"
                               << "motor_torque_Nm" << true;
  QTest::newRow("nobody's") << "motor_speed [rad/s]"
                            << "torque_Nm" << true;
  QTest::newRow("a bench's") << "motor_speed [rad/s]"
                             << "dyno_torque_Nm" << true;
  QTest::newRow("both the knee's") << "knee_speed [rad/s]"
                                   << "knee_torque_Nm" << true;
}

void TestImportMotion::torqueOfSomethingElseThanTheMotor_isKept() {
  QFETCH(QString, motion);
  QFETCH(QString, torque);
  QFETCH(bool, taken);
  const QByteArray one = motion.toUtf8(), two = torque.toUtf8();
  const auto log = moving({{one.constData(), 0, 1, 0}, {two.constData(), 0, 0.01, 0}});
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, motion.toStdString()), "velocity_rad_per_s");
  QCOMPARE(meaning(*log, torque.toStdString()), taken ? "torque_Nm" : "");
}

void TestImportMotion::motorsMotionUnderOtherNames_isFound_data() {
  QTest::addColumn<QString>("first");
  QTest::addColumn<QString>("second");
  QTest::addColumn<QString>("name");
  QTest::addColumn<QString>("to");
  const auto row = [](const char* first, const char* second, const char* name, const char* to) {
    QTest::newRow(name) << first << second << name << to;
  };
  row("abs_encoder_deg", "inc_encoder_counts", "abs_encoder_deg", "angle_rad");
  row("speed_abs", "angle_deg", "speed_abs", "");
  row("tilt_angle", "omega_motor", "tilt_angle", "");
  row("tilt_servo_angle", "note", "tilt_servo_angle", "angle_rad");
  row("extruder_pos_mm", "extruder_cmd_mm", "extruder_cmd_mm", "position_reference_m");
  row("pump_rpm", "motor_current_A", "pump_rpm", "velocity_rad_per_s");
  row("pump_rpm", "motor_rpm", "pump_rpm", "");
  row("velocity_mms", "position_mm", "velocity_mms", "velocity_m_per_s");
}

void TestImportMotion::motorsMotionUnderOtherNames_isFound() {
  QFETCH(QString, first);
  QFETCH(QString, second);
  QFETCH(QString, name);
  QFETCH(QString, to);
  const QByteArray one = first.toUtf8(), two = second.toUtf8();
  const bool secondTurns = second.contains("rpm") || second.contains("omega");
  const auto log = moving({{one.constData(), first.contains("vel") || first.contains("rpm") ? 0.0 : 1.0,
                            first.contains("vel") || first.contains("rpm") ? 1.0 : 0.0, 0},
                           {two.constData(), secondTurns ? 0.0 : 1.0, secondTurns ? 1.0 : 0.0, 0.1}});
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, name.toStdString()), to.toStdString());
}

void TestImportMotion::tachometerOfAVesc_isElectrical() {
  const std::vector<Wave> columns{{"rpm", 0, 66.85, 0},   {"tach", 6.684, 0, 0}, {"tachAbs", 6.684, 0, 0},
                                  {"imotor", 0, 0.01, 0}, {"iin", 0, 0.003, 0},  {"vbat", 0, 0, 24}};
  QVERIFY(!moving(columns));
  ImportMap map;
  map.pole_pairs = 7.0;
  const auto log = moving(columns, map);
  QVERIFY(log.ok());
  QVERIFY(std::abs(log->recording.channel("velocity_rad_per_s")[50] - 40.0 * std::sin(1.5)) < 0.1);
  QCOMPARE(meaning(*log, "imotor"), "current_A");
  QCOMPARE(meaning(*log, "iin"), "");
}

void TestImportMotion::torqueOfTheJoint_isNotTheMotors() {
  const auto both = moving({{"motor_pos(rad)", 1, 0, 0},
                            {"motor_vel(rad/s)", 0, 1, 0},
                            {"joint_pos(rad)", 0.02, 0, 0},
                            {"joint_vel(rad/s)", 0, 0.02, 0},
                            {"joint_torque(Nm)", 0, 0.3, 0}});
  QVERIFY(both.ok());
  QCOMPARE(meaning(*both, "motor_vel(rad/s)"), "velocity_rad_per_s");
  QCOMPARE(meaning(*both, "joint_torque(Nm)"), "");
  const auto joint =
      moving({{"joint_pos(rad)", 1, 0, 0}, {"joint_vel(rad/s)", 0, 1, 0}, {"motor_torque(Nm)", 0, 1, 0}});
  QVERIFY(joint.ok());
  QCOMPARE(meaning(*joint, "motor_torque(Nm)"), "torque_Nm");
}

void TestImportMotion::rawSpeed_yieldsToTheMeasuredOne() {
  const auto log = moving({{"vel_raw", 0.1, 1, 0}, {"vel_meas", 0, 1, 0}, {"iq_meas", 0, 0.01, 0}});
  QVERIFY(log.ok());
  QCOMPARE(meaning(*log, "vel_meas"), "velocity_rad_per_s");
  QCOMPARE(meaning(*log, "vel_raw"), "");
}

QTEST_APPLESS_MAIN(TestImportMotion)
#include "tst_import_motion.moc"
