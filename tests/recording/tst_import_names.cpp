#include <QTest>
#include <cmath>

#include "recording/import/import.h"
#include "support/imported_log.h"

using namespace breakaway;
using namespace breakaway::test;

/// Names that say too little alone, by the names beside them.
class TestImportNames : public QObject {
  Q_OBJECT
 private slots:
  void whatNamesBesideTell_isTaken_data();
  void whatNamesBesideTell_isTaken();
  void positionInMetres_isTakenBeforeCounts();
  void namesForFewerColumns_nameTheFirst();
  void odriveByItsCurrentAlone_needsMotionWithoutUnits();
  void unknownWordWithAUnit_isAGuessWhereNothingElseMoves();
  void countsWithoutAName_areAskedAboutWhereNothingElseMoves();
  void numberedNamesAboveTheRows_areTheColumns_data();
  void numberedNamesAboveTheRows_areTheColumns();
  void loggersTagBeforeLabels_isNoName();
  void commandedTorqueWithoutAUnit_isCalledSo();
  void driveBehindAStrangeWord_isAGuess();

 private:
  ImportedLogs logs_;
};

void TestImportNames::whatNamesBesideTell_isTaken_data() {
  QTest::addColumn<QStringList>("names");
  QTest::addColumn<QString>("name");
  QTest::addColumn<QString>("to");
  QTest::newRow("an effort") << QStringList{"elbow_pos", "elbow_vel", "elbow_eff"} << "elbow_eff"
                             << "torque_Nm";
  QTest::newRow("an efficiency") << QStringList{"motor_pos", "motor_vel", "gear_eff"} << "gear_eff"
                                 << "";
  QTest::newRow("a joint's target") << QStringList{"q_0", "qd_0", "tq_0", "tqd_0"} << "tq_0"
                                    << "angle_reference_rad";
  QTest::newRow("a target's speed") << QStringList{"q_0", "qd_0", "tq_0", "tqd_0"} << "tqd_0"
                                    << "velocity_reference_rad_per_s";
  QTest::newRow("the target of another shaft")
      << QStringList{"motor_angle", "cam_angle", "cam_angle_cmd"} << "cam_angle_cmd"
      << "";
  QTest::newRow("the target of the one taken") << QStringList{"motor_angle", "motor_angle_cmd"} << "motor_angle_cmd"
                                               << "angle_reference_rad";
  QTest::newRow("a cable's force") << QStringList{"motor_angle", "cable_force"} << "cable_force"
                                   << "";
  QTest::newRow("an actuator's force") << QStringList{"joint_angle", "actuator_force"} << "actuator_force"
                                       << "torque_Nm";
  QTest::newRow("a side within a name") << QStringList{"rpm_L_real", "rpm_R_real"} << "rpm_L_real"
                                        << "velocity_rad_per_s";
  QTest::newRow("the other side within a name") << QStringList{"rpm_L_real", "rpm_R_real"} << "rpm_R_real"
                                                << "";
  QTest::newRow("an electrical torque before a shaft's")
      << QStringList{"w_rad_s", "drive.tauElectrical", "drive.tauShaft"} << "drive.tauElectrical"
      << "torque_Nm";
  QTest::newRow("a torque by a current") << QStringList{"motor_angle", "motor_torque_from_current"}
                                         << "motor_torque_from_current"
                                         << "torque_Nm";
  QTest::newRow("a force in N beside an angle") << QStringList{"angle_deg", "ActualForce_N"} << "ActualForce_N"
                                                << "";
  QTest::newRow("a force in N beside a place") << QStringList{"position_mm", "ActualForce_N"} << "ActualForce_N"
                                               << "force_N";
  QTest::newRow("a force beside a torque") << QStringList{"motor_angle", "torque", "force"} << "force"
                                           << "";
  QTest::newRow("the logic's supply") << QStringList{"rpm", "logic_supply_v", "dc_bus_v"} << "logic_supply_v"
                                      << "";
  QTest::newRow("the motor's supply") << QStringList{"rpm", "logic_supply_v", "dc_bus_v"} << "dc_bus_v"
                                      << "supply_V";
  QTest::newRow("how a vehicle turns") << QStringList{"x", "y", "omega", "motor_rpm"} << "omega"
                                       << "";
  const QStringList vehicle{"t_ms", "x(in)", "y(in)", "theta(deg)", "v_l(ips)", "v_r(ips)", "motor (rpm)"};
  QTest::newRow("where a vehicle heads") << vehicle << "theta(deg)"
                                         << "";
  QTest::newRow("an arm's angle beside its end")
      << QStringList{"x (mm)", "y (mm)", "theta1 (deg)", "omega1 (rpm)"} << "theta1 (deg)"
      << "angle_rad";
  QTest::newRow("a circuit's node") << QStringList{"angle (deg)", "V(speed)"} << "V(speed)"
                                    << "";
  QTest::newRow("a winding's current") << QStringList{"angle (deg)", "Current(Winding_A) [A]"}
                                       << "Current(Winding_A) [A]"
                                       << "";
  QTest::newRow("a stepper's target beside an encoder") << QStringList{"target_steps", "encoder_deg"} << "target_steps"
                                                        << "";
  QTest::newRow("a goal in another folder")
      << QStringList{"/Arm/PositionRad", "/RealOutputs/Arm/GoalRad"} << "/RealOutputs/Arm/GoalRad"
      << "angle_reference_rad";
  QTest::newRow("a goal of another mechanism")
      << QStringList{"/Arm/PositionRad", "/RealOutputs/Climber/GoalRad"} << "/RealOutputs/Climber/GoalRad"
      << "";
  const QStringList leg{"FL_hip_q", "FL_hip_dq", "FL_hip_tau", "FL_thigh_q", "FL_thigh_dq", "FL_thigh_tau"};
  QTest::newRow("a leg's first joint") << leg << leg[0] << "angle_rad";
  QTest::newRow("its torque") << leg << leg[2] << "torque_Nm";
  QTest::newRow("a leg's second joint") << leg << leg[3] << "";
  QTest::newRow("a wheel's voltage") << QStringList{"wheel1_vel", "wheel1_cur", "wheel1_vol"} << "wheel1_vol"
                                     << "voltage_V";
  QTest::newRow("a volume") << QStringList{"motor_vel", "tank_vol"} << "tank_vol"
                            << "";
  QTest::newRow("a mark that is no unit") << QStringList{"angle (deg)", "rotation (*/s)"} << "rotation (*/s)"
                                          << "";
  QTest::newRow("a motor's speed beside one coordinate") << QStringList{"x", "theta", "omega"} << "omega"
                                                         << "velocity_rad_per_s";
  QTest::newRow("another channel") << QStringList{"Ch1 Drehzahl [U/min]", "Ch2 Drehmoment [Nm]"}
                                   << "Ch2 Drehmoment [Nm]"
                                   << "torque_Nm";
  QTest::newRow("a torque") << QStringList{"q_0", "qd_0", "tq_0"} << "tq_0"
                            << "torque_Nm";
  QTest::newRow("an armature's voltage") << QStringList{"theta_m", "omega_m", "u_a"} << "u_a"
                                         << "voltage_V";
  QTest::newRow("an armature's current") << QStringList{"theta", "ia"} << "ia"
                                         << "current_A";
  QTest::newRow("an armature's, with units") << QStringList{"phi [deg]", "u_a [V]", "i_a [A]"} << "i_a [A]"
                                             << "current_A";
  QTest::newRow("a phase's, with units") << QStringList{"phi [deg]", "i_a [A]", "i_b [A]", "i_c [A]"} << "i_a [A]"
                                         << "";
  const QStringList device{"Power Max [3] Velocity", "Power Max [3] Position", "Power Max [3] Bus Voltage"};
  QTest::newRow("behind a device's name") << device << device[1] << "angle_rad";
  QTest::newRow("a device's supply") << device << device[2] << "supply_V";
  QTest::newRow("a joint's limits") << QStringList{"Joint Max [1] Velocity", "Joint Max [1] Position",
                                                   "Joint Max [1] Torque", "angle"}
                                    << "Joint Max [1] Position"
                                    << "";
  QTest::newRow("the most of a speed") << QStringList{"angle", "Max [3] Velocity"} << "Max [3] Velocity"
                                       << "";
  QTest::newRow("a derivative") << QStringList{"phi [deg]", "dphi/dt [deg/s]"} << "dphi/dt [deg/s]"
                                << "velocity_rad_per_s";
  QTest::newRow("a load's torque") << QStringList{"phi [deg]", "M_L [Nm]"} << "M_L [Nm]"
                                   << "";
  QTest::newRow("a controller's output") << QStringList{"ang_rad", "u_cmd_Amps"} << "u_cmd_Amps"
                                         << "current_reference_A";
  QTest::newRow("a side as a letter or a word") << QStringList{"rpm_l", "rpm_r", "amps_l", "amps_r"} << "amps_l"
                                                << "current_A";
  QTest::newRow("the other side") << QStringList{"rpm_l", "rpm_r", "amps_l", "amps_r"} << "amps_r"
                                  << "";
  QTest::newRow("tenths of an ampere") << QStringList{"rpm", "current_da"} << "current_da"
                                       << "current_A";
  QTest::newRow("tenths of a degree") << QStringList{"rpm", "motor_temp_dc"} << "motor_temp_dc"
                                      << "";
  QTest::newRow("how a speed was come by") << QStringList{"angle_deg", "rpm_from_counts"} << "rpm_from_counts"
                                           << "velocity_rad_per_s";
  const QStringList joints{"joint1_angle", "joint1_ref", "joint2_angle", "joint2_ref"};
  QTest::newRow("what a joint's angle shall be") << joints << "joint1_ref"
                                                 << "angle_reference_rad";
  QTest::newRow("angle or speed") << QStringList{"joint1_angle", "joint1_speed", "joint1_ref"} << "joint1_ref"
                                  << "";
  QTest::newRow("a controller's output") << QStringList{"rpm", "Output_%"} << "Output_%"
                                         << "duty";
  QTest::newRow("an output beside a current") << QStringList{"rpm", "current_A", "Output_%"} << "Output_%"
                                              << "";
  QTest::newRow("a power's share") << QStringList{"rpm", "output_power_%"} << "output_power_%"
                                   << "";
  QTest::newRow("a controller's effort") << QStringList{"rpm", "control_effort"} << "control_effort"
                                         << "";
  const QStringList sides{"enc_r", "l_pwm", "r_pwm"};
  QTest::newRow("the other side's duty") << sides << "l_pwm"
                                         << "";
  QTest::newRow("this side's duty") << sides << "r_pwm"
                                    << "duty";
  QTest::newRow("what a heading shall be") << QStringList{"heading_deg", "target_deg", "rpm"} << "target_deg"
                                           << "";
  QTest::newRow("what an angle shall be") << QStringList{"angle_deg", "target_deg", "rpm"} << "target_deg"
                                          << "angle_reference_rad";
  QTest::newRow("several of them") << QStringList{"joint_position", "joint_temperatures"} << "joint_temperatures"
                                   << "temperature_degC";
  QTest::newRow("a degree as one sign") << QStringList{"angle(°)", "motor temp(℃)"} << "motor temp(℃)"
                                        << "temperature_degC";
  QTest::newRow("another channel of one run")
      << QStringList{"Angle, Ch P1 (rad) Run #1", "Output Voltage, Ch 01 (V) Run #1"}
      << "Output Voltage, Ch 01 (V) Run #1"
      << "voltage_V";
  QTest::newRow("a feedback by a letter") << QStringList{"FPOS(0)", "RPOS(0)"} << "FPOS(0)"
                                          << "angle_rad";
  QTest::newRow("a reference by a letter") << QStringList{"FPOS(0)", "RPOS(0)"} << "RPOS(0)"
                                           << "angle_reference_rad";
  QTest::newRow("a filtered current") << QStringList{"mechPos", "iqf"} << "iqf"
                                      << "current_A";
  const QStringList paths{"/state/motor_state[0]/q", "/state/motor_state[1]/q", "/cmd/motor_cmd[0]/q", "/imu/0/q"};
  QTest::newRow("a letter behind a path") << paths << paths[0] << "angle_rad";
  QTest::newRow("another motor's") << paths << paths[1] << "";
  QTest::newRow("behind a path of commands") << paths << paths[2] << "angle_reference_rad";
  QTest::newRow("behind a path of another thing") << paths << paths[3] << "";
  const QStringList present{"angle", "torque_ref", "torque_cur"};
  QTest::newRow("a torque as it is now") << present << "torque_cur"
                                         << "torque_Nm";
  QTest::newRow("the current of a torque") << QStringList{"angle", "torque_cur"} << "torque_cur"
                                           << "current_A";
  QTest::newRow("a command in percent") << QStringList{"rpm", "command_pct"} << "command_pct"
                                        << "duty";
  QTest::newRow("percent before a PWM") << QStringList{"rpm", "%PWM"} << "%PWM"
                                        << "duty";
  QTest::newRow("what was read") << QStringList{"speed_target_rpm", "speed_read"} << "speed_read"
                                 << "velocity_rad_per_s";
  QTest::newRow("thousandths per second") << QStringList{"theta_mrad", "theta_dot_mradps"} << "theta_dot_mradps"
                                          << "velocity_rad_per_s";
  const QStringList wheels{"l_rpm", "r_rpm", "rpm_l_ref", "rpm_r_ref"};
  QTest::newRow("what this side shall be") << wheels << "rpm_l_ref"
                                           << "velocity_reference_rad_per_s";
  QTest::newRow("what the other side shall be") << wheels << "rpm_r_ref"
                                                << "";
  QTest::newRow("a rope's tension") << QStringList{"theta", "tension"} << "tension"
                                    << "";
  QTest::newRow("a voltage in Spanish") << QStringList{"velocidad", "tension"} << "tension"
                                        << "voltage_V";
  const QStringList bracketed{"ACTUAL_JOINT_POSITIONS (J1)", "ACTUAL_JOINT_POSITIONS (J2)", "JOINT_TORQUES (J1)"};
  QTest::newRow("an axis in brackets") << bracketed << bracketed[0] << "angle_rad";
  QTest::newRow("another one") << bracketed << bracketed[1] << "";
  QTest::newRow("of the axis in brackets") << bracketed << bracketed[2] << "torque_Nm";
  QTest::newRow("a set point") << QStringList{"CL_POS_FBK_VALUE", "CL_POS_SET_POINT_VALUE"} << "CL_POS_SET_POINT_VALUE"
                               << "angle_reference_rad";
  QTest::newRow("a bus of direct current") << QStringList{"X1_ActualPosition", "X1_DCBusVoltage"} << "X1_DCBusVoltage"
                                           << "supply_V";
  QTest::newRow("a phone's gyroscope") << QStringList{"rpm", "Gyroscope x (rad/s)"} << "Gyroscope x (rad/s)"
                                       << "";
  QTest::newRow("a letter behind a model's path") << QStringList{"inertia1.phi", "inertia1.w"} << "inertia1.w"
                                                  << "velocity_rad_per_s";
  QTest::newRow("a letter behind an unknown path") << QStringList{"angle", "wind.w"} << "wind.w"
                                                   << "";
  const QStringList stator{"rpm", "Stator current:1", "Stator current:2", "Stator current:3"};
  QTest::newRow("a numbered phase's") << stator << stator[1] << "";
  const QStringList motors{"rpm_1", "rpm_2", "rpm_3", "current_1", "current_2", "current_3"};
  QTest::newRow("a numbered motor's") << motors << "current_1"
                                      << "current_A";
  const QStringList wheelsOfFour{"PWM_vl", "RPM_vl", "PWM_hr", "RPM_hr"};
  QTest::newRow("a wheel by an unknown word") << wheelsOfFour << "RPM_vl"
                                              << "velocity_rad_per_s";
  QTest::newRow("its duty") << wheelsOfFour << "PWM_vl"
                            << "duty";
  QTest::newRow("another wheel's duty") << wheelsOfFour << "PWM_hr"
                                        << "";
  const QStringList legs{"joint_pos/FL_hip", "joint_pos/FL_thigh", "joint_vel/FL_hip", "joint_vel/FL_thigh"};
  QTest::newRow("a joint behind its quantity") << legs << legs[0] << "angle_rad";
  QTest::newRow("its speed") << legs << legs[2] << "velocity_rad_per_s";
  QTest::newRow("another joint's speed") << legs << legs[3] << "";
  const QStringList models{"angle_rad", "DC_Motor.i (A)", "DC_Bus.i (A)"};
  QTest::newRow("a letter with its unit behind a motor") << models << models[1] << "current_A";
  QTest::newRow("a letter with its unit behind a bus") << models << models[2] << "";
  QTest::newRow("an armature behind a path") << QStringList{"inertia.phi", "dcpm.ia"} << "dcpm.ia"
                                             << "current_A";
  QTest::newRow("an effort by itself") << QStringList{"q", "vel", "eff"} << "eff"
                                       << "torque_Nm";
  const QStringList servo{"nckServoDataActVelMot64 [deg/s]", "nckServoDataTrqAct64 [Nm]"};
  QTest::newRow("a torque that is called as the motor's speed is") << servo << servo[1] << "torque_Nm";
  const QStringList axes{"$AXIS_ACT.A1 [deg]", "$TORQUE_AXIS_ACT[1] [Nm]", "$TORQUE_AXIS_ACT[2] [Nm]"};
  QTest::newRow("the torque of axis A1") << axes << axes[1] << "torque_Nm";
  QTest::newRow("the torque of another axis") << axes << axes[2] << "";
  QTest::newRow("a phase's voltage") << QStringList{"theta_m", "u_a", "u_b", "u_c"} << "u_a"
                                     << "";
}

void TestImportNames::whatNamesBesideTell_isTaken() {
  QFETCH(QStringList, names);
  QFETCH(QString, name);
  QFETCH(QString, to);
  const auto log = logs_.waves(names);
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, name), to.toStdString());
}

void TestImportNames::positionInMetres_isTakenBeforeCounts() {
  QString text = "time_s,position_counts,pos_um,vel_um_s\n";
  for (int k = 0; k < 60; ++k) {
    const double x = 2e4 * std::sin(0.1 * k);
    text += QString("%1,%2,%3,%4\n").arg(0.01 * k).arg(int(2.0 * x)).arg(int(x)).arg(int(2e5 * std::cos(0.1 * k)));
  }
  const auto log = logs_.imported(text);
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "pos_um"), std::string("position_m"));
  QVERIFY(!log->recording.has("angle_rad"));
}

void TestImportNames::namesForFewerColumns_nameTheFirst() {
  QString text = "duration, success rate, q[0], dq[0], tau_J[0],sent commands,\n";
  for (int k = 0; k < 60; ++k)
    text +=
        QString("%1,1,%2,%3,0.5,,%4,0,\n").arg(5000 + k).arg(std::sin(0.01 * k)).arg(10.0 * std::cos(0.01 * k)).arg(k);
  const auto log = logs_.imported(text);
  VERIFY_OK(log);
  QVERIFY(std::abs(log->recording.time().back() - log->recording.time().front() - 0.059) < 1e-9);
  QCOMPARE(meaning(*log, "q[0]"), std::string("angle_rad"));
  QCOMPARE(meaning(*log, "dq[0]"), std::string("velocity_rad_per_s"));
  QCOMPARE(meaning(*log, "tau_J[0]"), std::string("torque_Nm"));
}

void TestImportNames::odriveByItsCurrentAlone_needsMotionWithoutUnits() {
  QString own = "time_s,position,velocity,iq_measured\n", told = "time_s,angle,turns,velocity,iq_measured\n";
  for (int k = 0; k < 80; ++k) {
    const double turns = 3.0 * std::sin(0.1 * k), perSecond = 30.0 * std::cos(0.1 * k);
    own += QString("%1,%2,%3,0.5\n").arg(0.01 * k).arg(turns, 0, 'f', 6).arg(perSecond, 0, 'f', 6);
    told += QString("%1,%2,%3,%4,0.5\n")
                .arg(0.01 * k)
                .arg(360.0 * turns, 0, 'f', 4)
                .arg(turns, 0, 'f', 6)
                .arg(60.0 * perSecond, 0, 'f', 4);
  }
  const auto odrive = logs_.imported(own), other = logs_.imported(told);
  VERIFY_OK(odrive);
  VERIFY_OK(other);
  for (const Imported* log : {&*odrive, &*other}) {
    const double speed = 30.0 * 2.0 * M_PI;
    QVERIFY(std::abs(log->recording.channel("velocity_rad_per_s").front() - speed) < 1e-3 * speed);
  }
}

void TestImportNames::unknownWordWithAUnit_isAGuessWhereNothingElseMoves() {
  const auto alone = logs_.waves({"speed_pi_raw_rpm", "current_A"});
  VERIFY_OK(alone);
  QCOMPARE(meaning(*alone, "speed_pi_raw_rpm"), std::string("velocity_rad_per_s"));
  QVERIFY(alone->columns[1].guessed);
  const auto beside = logs_.waves({"speed_pi_raw_rpm", "motor_angle"});
  VERIFY_OK(beside);
  QCOMPARE(meaning(*beside, "speed_pi_raw_rpm"), std::string());
  QVERIFY(!logs_.waves({"speed_scaling", "current_A"}));
  QVERIFY(!logs_.waves({"speed_error_rpm", "current_A"}));
}

void TestImportNames::countsWithoutAName_areAskedAboutWhereNothingElseMoves() {
  const auto log = [this](const QString& name) {
    QString text = "time_s," + name + ",current_A\n";
    for (int k = 0; k < 60; ++k) text += QString("%1,%2,0.5\n").arg(0.01 * k).arg(7 * k);
    const auto read = logs_.imported(text);
    return read ? std::string() : read.error().message();
  };
  QVERIFY(log("enconder(steps)").find("counts_per_rev") != std::string::npos);
  QVERIFY(log("load cell (counts)").find("counts_per_rev") == std::string::npos);
}

void TestImportNames::numberedNamesAboveTheRows_areTheColumns_data() {
  QTest::addColumn<QString>("form");
  QTest::addColumn<bool>("taken");
  QTest::newRow("from 1, behind %") << "% 1 time (s)\n% 2 angle (rad)\n% 3 motor current\n" << true;
  QTest::newRow("from 0, as text") << "0: time (s)\n1: angle (rad)\n2: motor current\n" << true;
  QTest::newRow("behind a word") << "% NAME0 = time (s)\n% NAME1 = angle (rad)\n% NAME2 = motor current\n" << true;
  QTest::newRow("a word and a number alone") << "% name0 time\n% name1 angle\n% name2 motor current\n" << false;
  QTest::newRow("in a line that says so") << "% columns: time  angle  motor current\n" << true;
  QTest::newRow("one too few") << "% 1 time (s)\n% 2 angle (rad)\n" << false;
  QTest::newRow("one is missing") << "% 1 time (s)\n% 3 angle (rad)\n% 4 motor current\n" << false;
}

void TestImportNames::numberedNamesAboveTheRows_areTheColumns() {
  QFETCH(QString, form);
  QFETCH(bool, taken);
  QString text = "% Motor test, 3 columns\n" + form;
  for (int k = 0; k < 60; ++k)
    text += QString("%1 %2 %3\n").arg(0.01 * k).arg(std::sin(0.1 * k)).arg(std::cos(0.1 * k));
  const auto log = logs_.imported(text);
  QCOMPARE(log.ok(), taken);
  if (taken) QCOMPARE(meaning(*log, "motor current"), std::string("current_A"));
}

void TestImportNames::loggersTagBeforeLabels_isNoName() {
  QString text = "I (300) main: started\n";
  for (int k = 0; k < 60; ++k)
    text += QString("I (%1) DRIVE: Axis 1 | Pos: %2 rad | Vel: %3 rad/s\n")
                .arg(500 + 10 * k)
                .arg(std::sin(0.1 * k))
                .arg(10.0 * std::cos(0.1 * k));
  const auto log = logs_.imported(text);
  VERIFY_OK(log);
  QCOMPARE(log->recording.rows(), size_t{60});
  QVERIFY(std::abs(log->recording.time()[59] - log->recording.time()[0] - 0.59) < 1e-9);
  QVERIFY(log->recording.has("angle_rad") && log->recording.has("velocity_rad_per_s"));
}

void TestImportNames::commandedTorqueWithoutAUnit_isCalledSo() {
  const auto log = logs_.waves({"actual_q_0", "target_moment_0"});
  VERIFY_OK(log);
  QVERIFY(log->columns[2].inWords().english().find("what was commanded") != std::string::npos);
}

void TestImportNames::driveBehindAStrangeWord_isAGuess() {
  const auto isGuess = [this](const QString& name) {
    const auto log = logs_.waves({"angle_rad", name});
    return log && log->columns[2].kind == ColumnFate::Kind::used && log->columns[2].guessed;
  };
  for (const char* name : {"quux_current_A", "quux_torque_Nm", "quux_voltage_V"}) QVERIFY2(isGuess(name), name);
  for (const char* name : {"motor_current_A", "knee_torque_Nm", "iq_actual_A"}) QVERIFY2(!isGuess(name), name);
}

QTEST_APPLESS_MAIN(TestImportNames)
#include "tst_import_names.moc"
