#include <QTest>
#include <cmath>
#include <numbers>

#include "recording/import/column_name.h"

using namespace breakaway;

/// Names of columns, each by itself.
class TestImportWords : public QObject {
  Q_OBJECT
 private slots:
  void names_areUnderstood_data();
  void names_areUnderstood();
};

void TestImportWords::names_areUnderstood_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QString>("to");
  QTest::addColumn<double>("scale");
  const auto row = [](const char* name, const char* to, double scale = 1.0) {
    QTest::newRow(name) << name << to << scale;
  };
  constexpr double degree = std::numbers::pi / 180.0;
  row("time_s", "time_s");
  row("theta_unwrapped", "angle_rad");
  row("unsaturated_current_A", "");
  row("t_offset_s", "time_s");
  row("time_offset_ms", "time_s", 1e-3);
  row("position_offset_s", "");
  row("t", "time_s");
  row("Timestamp", "time_s");
  row("Zeit [ms]", "time_s", 1e-3);
  row("angle_centideg", "angle_rad", 0.01 * degree);
  row("speed_centidegps", "velocity_rad_per_s", 0.01 * degree);
  row("current_milliampere", "current_A", 1e-3);
  row("velocity (mrev/s)", "velocity_rad_per_s", 2e-3 * std::numbers::pi);
  row("motor_current_in_amps", "current_A");
  row("current_in_A", "");
  row("rpm_x10", "");
  row("Zeit 1 - Standardmessrate [s]", "time_s");
  row("Solldrehzahl [1/min]", "velocity_reference_rad_per_s", std::numbers::pi / 30.0);
  row("rpm_sp", "velocity_reference_rad_per_s", std::numbers::pi / 30.0);
  row("Vsupply", "supply_V");
  row("motor_psu [V]", "supply_V");
  row("vesc", "");
  row("speed_fdb", "velocity_rad_per_s");
  row("omega_pll", "velocity_rad_per_s");
  row("wm_ref", "velocity_reference_rad_per_s");
  row("motorspeed", "velocity_rad_per_s");
  row("TARGETPOSITION", "angle_reference_rad");
  row("omega [1/s]", "velocity_rad_per_s");
  row("left_rpm", "velocity_rad_per_s", std::numbers::pi / 30.0);
  row("vel_steps_per_sec", "velocity_rad_per_s", 2.0 * std::numbers::pi);
  row("M [Nm]", "torque_Nm");
  row("winding_temp_F", "temperature_degC", 5.0 / 9.0);
  row("timestamps", "time_s");
  row("CLK", "time_s");
  row("v_in", "supply_V");
  row("esc_voltage", "supply_V");
  row("esc_current", "");
  row("battery_level", "");
  row("kv", "");
  row("theta_hall", "");
  row("Lastmoment [Nm]", "");
  row("Reibmoment [Nm]", "");
  row("Nennstrom [A]", "");
  row("Stromistwert feldbildend [A]", "");
  row("Torque (a)", "");
  row("Max 3 speed [rpm]", "");
  row("Im (A)", "current_A");
  row("AppliedVolts", "voltage_V");
  row("Actual current (mA rms)", "current_A", 1e-3);
  row("time_us", "time_s", 1e-6);
  row("t / µs", "time_s", 1e-6);
  row("angle_rad", "angle_rad");
  row("Winkel in °", "angle_rad", degree);
  row("motorPosition (deg)", "angle_rad", degree);
  row("shaft angle [rev]", "angle_rad", 2.0 * std::numbers::pi);
  row("pos [mm]", "position_m", 1e-3);
  row("position_m", "position_m");
  // Words written as one are parted where both are known.
  row("batvolt", "supply_V");
  row("velcmd", "velocity_reference_rad_per_s");
  row("posact", "angle_rad");
  row("trqact", "torque_Nm");
  row("poserr", "");
  row("wrist", "");
  row("wrist_angle", "angle_rad");
  row("dqservo0", "");
  // A symbol says again what stands before it, but not a phase's or a load's.
  row("Electromagnetic torque Te (N*m)", "torque_Nm");
  row("Torque Tl (N*m)", "");
  row("Armature current Ia (A)", "current_A");
  row("Stator current Ia (A)", "");
  row("motor input voltage V_m (V)", "voltage_V");
  row("DC motor voltage [V]", "voltage_V");
  row("motor DC voltage [V]", "supply_V");
  row("theta_b_dot", "velocity_rad_per_s");
  row("Lageistwert Geber 1 [Grd]", "angle_rad", degree);
  row("RPM_Esq", "velocity_rad_per_s", std::numbers::pi / 30.0);
  row("t_motor [C]", "temperature_degC");
  row("Temperatura (C)", "temperature_degC");
  row("Motortemperatur [°C]", "temperature_degC");
  row("Wicklungstemperatur [°C]", "temperature_degC");
  row("Oeltemperatur_C", "");
  row("speed_req [rpm]", "velocity_reference_rad_per_s", std::numbers::pi / 30.0);
  row("udcb [V]", "supply_V");
  row("U_dc", "supply_V");
  row("电机位置(度)", "angle_rad", degree);
  row("转速(转/分)", "velocity_rad_per_s", std::numbers::pi / 30.0);
  row("Rotation (deg)", "angle_rad", degree);
  row("16-17 Speed [RPM]", "velocity_rad_per_s", std::numbers::pi / 30.0);
  row("Torque Transducer (N-m)", "torque_Nm");
  row("goal_position", "angle_reference_rad");
  row("position_reference_m", "position_reference_m");
  row("target speed [mm/s]", "velocity_reference_m_per_s", 1e-3);
  row("target angle (deg)", "angle_reference_rad", degree);
  row("velocity_rad_per_s", "velocity_rad_per_s");
  row("Drehzahl [1/min]", "velocity_rad_per_s", std::numbers::pi / 30.0);
  row("speed_rpm", "velocity_rad_per_s", std::numbers::pi / 30.0);
  row("Velocity (deg/s)", "velocity_rad_per_s", degree);
  row("velocity [mm/s]", "velocity_m_per_s", 1e-3);
  row("motor_current_mA", "current_A", 1e-3);
  row("Iq", "current_A");
  row("current_reference_A", "current_reference_A");
  row("input_volts", "supply_V");
  row("Supply Voltage (mV)", "supply_V", 1e-3);
  row("motor voltage [V]", "voltage_V");
  row("pwm [%]", "duty", 0.01);
  row("torque (N·m)", "torque_Nm");
  row("force_N", "force_N");
  row("temp", "temperature_degC");
  row("current_10mA", "current_A", 10e-3);
  row("speed [0.1 rpm]", "velocity_rad_per_s", std::numbers::pi / 300.0);
  row("$\\dot{\\theta}$ (rad/s)", "velocity_rad_per_s");
  row("u_cmd", "voltage_V");
  row("Vitesse (tr/min)", "velocity_rad_per_s", std::numbers::pi / 30.0);
  row("r78 Current actual value torque-generating [Arms]", "current_A");
  row("rpm_filtered", "velocity_rad_per_s", std::numbers::pi / 30.0);
  row("rpm_left", "velocity_rad_per_s", std::numbers::pi / 30.0);
  row("actual_rpm", "velocity_rad_per_s", std::numbers::pi / 30.0);
  row("current_rpm", "velocity_rad_per_s", std::numbers::pi / 30.0);
  row("rpm_setpoint", "velocity_reference_rad_per_s", std::numbers::pi / 30.0);
  row("pos_deg_target", "angle_reference_rad", degree);
  row("Vitesse mesurée (tr/min)", "velocity_rad_per_s", std::numbers::pi / 30.0);
  row("Consigne (tr/min)", "velocity_reference_rad_per_s", std::numbers::pi / 30.0);
  row("时间(ms)", "time_s", 1e-3);
  row("目标转速", "velocity_reference_rad_per_s");
  row("电机电流(mA)", "current_A", 1e-3);
  row("trs605-5 torque [Nm]", "torque_Nm");
  row("time (millisec)", "time_s", 1e-3);
  row("bms_voltage_V", "supply_V");
  row("vel_rads", "velocity_rad_per_s");
  row("speed_mps", "velocity_m_per_s");
  row("vel_revolute_4_degps", "velocity_rad_per_s", degree);
  row("velocity measured [Hz]", "velocity_rad_per_s", 2.0 * std::numbers::pi);
  row("rpm0", "velocity_rad_per_s", std::numbers::pi / 30.0);
  row("theta_d", "angle_reference_rad");
  row("tgt_rpm", "velocity_reference_rad_per_s", std::numbers::pi / 30.0);
  row("wrist_joint/roll/position", "angle_rad");
  row("encoderA", "angle_rad");
  row("q_A", "current_A");
  row("母线电压(V)", "supply_V");
  row("q轴电流", "current_A");
  row("电角度", "angle_rad");
  row("01.07 Motor current [A]", "current_A");
  row("Torque/AVE (Nm)", "torque_Nm");
  row("I_Wirk [A]", "current_A");
  row("Lage_Ist [Inkr]", "angle_rad", 2.0 * std::numbers::pi);
  row("q2_ref", "angle_reference_rad");
  row("Kanal2_Drehzahl[U/min]", "velocity_rad_per_s", std::numbers::pi / 30.0);
  row("pos_current", "angle_rad");
  row("speed_current_rpm", "velocity_rad_per_s", std::numbers::pi / 30.0);
  row("torque_current", "current_A");
  row("motor_hv_voltage", "supply_V");
  row("Stepper output (degs)", "angle_rad", degree);
  row("knee [deg]", "angle_rad", degree);
  row("Udc_V", "supply_V");
  row("motrpm", "velocity_rad_per_s", std::numbers::pi / 30.0);
  row("motamps", "current_A");
  row("tensao_V", "voltage_V");
  row("指令値[deg]", "angle_reference_rad", degree);
  row("ticksL", "angle_rad", 2.0 * std::numbers::pi);
  row("tau_J[0]", "torque_Nm");
  row("pwm_used", "duty");
  row("mot_volt", "voltage_V");
  row("Motor Speed (krad/s)", "velocity_rad_per_s", 1e3);
  row("MCU Target (deg)", "angle_reference_rad", degree);
  row("Torque(in-lbs)", "torque_Nm", 0.45359237 * 9.80665 * 0.0254);
  for (const char* unknown : {"",
                              "velocity error",
                              "current [foo]",
                              "angle [A]",
                              "status",
                              "disturbance",
                              "input",
                              "torque_x1000",
                              "angle*10",
                              "sin_theta",
                              "predicted angle [deg]",
                              "joint_3deg",
                              "curr_state",
                              "fan_rpm",
                              "home_position",
                              "rpm_error",
                              "Actual_Speed_Kmh",
                              "PWM_Time",
                              "rise time (s)",
                              "sample_rate [Hz]",
                              "hz",
                              "roll",
                              "roll_rate_dps",
                              "COOLANT_TEMP",
                              "ctrlTemp",
                              "wattHours",
                              "tau_f",
                              "母线电流",
                              "d轴电流",
                              "motor_temp_c10",
                              "motor_hv_current",
                              "PID (deg)",
                              "Reactive Current [A]",
                              "speed_scaling",
                              "motor_eff"})
    row(unknown, "");
}

void TestImportWords::names_areUnderstood() {
  QFETCH(QString, name);
  QFETCH(QString, to);
  QFETCH(double, scale);
  const auto meaning = understandName(name.toStdString());
  QCOMPARE(meaning.to, to.toStdString());
  QCOMPARE(meaning.aside.empty(), meaning.understood());
  if (meaning.understood())
    QVERIFY2(std::abs(meaning.scale - scale) <= 1e-15 * scale, qPrintable(QString::number(meaning.scale, 'g', 17)));
}

QTEST_APPLESS_MAIN(TestImportWords)
#include "tst_import_words.moc"
