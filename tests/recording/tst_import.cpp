#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "recording/csv.h"
#include "recording/import/column_name.h"
#include "recording/import/import.h"
#include "support/temporary.h"

using namespace breakaway;
using breakaway::test::TemporaryFolder;

/// Rows 0, 1, 2 of time (step 1 ms), angle (0, 90°, 180°) and current (0, 0.5 A, −1.5 A) are what every form below
/// holds.
class TestImport : public QObject {
  Q_OBJECT
 private slots:
  void names_areUnderstood_data();
  void names_areUnderstood();
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
  void angleThatWraps_goesOnCounting();
  void angleThatLeapsElsewhere_staysAsItIs_data();
  void angleThatLeapsElsewhere_staysAsItIs();
  void unusedText_isLeftOut_usedText_isAnError();
  void lineCutShortAtTheEnd_isLeftOut();
  void severalAxesInOneTable_areAskedToBeParted_data();
  void severalAxesInOneTable_areAskedToBeParted();
  void motorsThatMoveAlike_areAskedToBeParted();
  void oneAxis_isNotAskedToBeParted_data();
  void oneAxis_isNotAskedToBeParted();
  void columnsThatAreNotTheMotors_areKeptUnused_data();
  void columnsThatAreNotTheMotors_areKeptUnused();
  void numbersOfRows_areNoCurrent();
  void counterThatStandsStill_isNoAngle();
  void leapsWithinOneTurn_areCalledImplausible();
  void timeOfSteps_isMarkedAsAGuess();
  void voltageThatStandsStill_isTheSupplys_data();
  void voltageThatStandsStill_isTheSupplys();
  void namesAbove_eventsBetween_areFound();
  void stampsWithoutName_areTheTime();
  void wholeSpeedAlone_isAskedAbout();
  void drehzahl_isInRpm();
  void registerThatWraps_isReadAsSigned();
  void registerInterpolatedAcrossItsWrap_isRefused();

 private:
  TemporaryFolder folder_;
};

void TestImport::names_areUnderstood_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QString>("to");
  QTest::addColumn<double>("scale");
  const auto row = [](const char* name, const char* to, double scale = 1.0) {
    QTest::newRow(name) << name << to << scale;
  };
  constexpr double degree = std::numbers::pi / 180.0;
  row("time_s", "time_s");
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

void TestImport::names_areUnderstood() {
  QFETCH(QString, name);
  QFETCH(QString, to);
  QFETCH(double, scale);
  const auto meaning = understandName(name.toStdString());
  QCOMPARE(meaning.to, to.toStdString());
  QCOMPARE(meaning.aside.empty(), meaning.understood());
  if (meaning.understood())
    QVERIFY2(std::abs(meaning.scale - scale) <= 1e-15 * scale, qPrintable(QString::number(meaning.scale, 'g', 17)));
}

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
  row("thousands", "time;angle\n0,5;0\n1,5;1.000,5\n2,5;0\n",
      "row 2, column angle: expected a number, found \"1.000,5\"");
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

void TestImport::angleThatWraps_goesOnCounting() {
  const auto imported = importRecording(
      folder_.write("log.csv", "t,angle_deg\n0,300\n1e-3,345\n2e-3,5\n3e-3,\n4e-3,40\n5e-3,10\n6e-3,350\n"));
  VERIFY_OK(imported);
  const auto angle = imported->recording.channel("angle_rad");
  const double expected[]{300, 345, 365, NAN, 400, 370, 350};
  for (size_t k = 0; k < angle.size(); ++k) {
    if (k == 3) {
      QVERIFY(std::isnan(angle[k]));
    } else {
      QVERIFY2(std::abs(angle[k] * 180.0 / std::numbers::pi - expected[k]) < 1e-9, qPrintable(QString::number(k)));
    }
  }
  QVERIFY(std::any_of(imported->remarks.begin(), imported->remarks.end(),
                      [](const std::string& one) { return one.find("in 2 places") != std::string::npos; }));
}

void TestImport::angleThatLeapsElsewhere_staysAsItIs_data() {
  QTest::addColumn<QByteArray>("rows");
  QTest::newRow("leap of half a turn") << QByteArray("0,0.1\n1e-3,3.5\n2e-3,0.1\n");
  QTest::newRow("more than a turn") << QByteArray("0,0.1\n1e-3,6.3\n2e-3,7.9\n");
  QTest::newRow("no leap") << QByteArray("0,0.1\n1e-3,2.3\n2e-3,4.9\n3e-3,6.2\n");
}

void TestImport::angleThatLeapsElsewhere_staysAsItIs() {
  QFETCH(QByteArray, rows);
  const auto imported = importRecording(folder_.write("log.csv", "time_s,angle_rad\n" + rows.toStdString()));
  VERIFY_OK(imported);
  const QList<QByteArray> lines = rows.trimmed().split('\n');
  for (qsizetype k = 0; k < lines.size(); ++k)
    QCOMPARE(imported->recording.channel("angle_rad")[static_cast<size_t>(k)], lines[k].split(',')[1].toDouble());
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

void TestImport::severalAxesInOneTable_areAskedToBeParted_data() {
  QTest::addColumn<QString>("column");
  QTest::addColumn<QString>("first");
  QTest::addColumn<QString>("second");
  QTest::addColumn<bool>("inTurn");
  QTest::newRow("numbers in turn") << "motor_id"
                                   << "1"
                                   << "2" << true;
  QTest::newRow("texts in turn") << "joint_name"
                                 << "hip/left"
                                 << "hip/right" << true;
  QTest::newRow("texts of any name in turn") << "topic"
                                             << "a"
                                             << "b" << true;
  QTest::newRow("JSON") << "joint"
                        << "a"
                        << "b" << true;
  QTest::newRow("instances") << "Instance"
                             << "0"
                             << "1" << true;
  QTest::newRow("one after the other") << "motor"
                                       << "1"
                                       << "2" << false;
}

void TestImport::severalAxesInOneTable_areAskedToBeParted() {
  QFETCH(QString, column);
  QFETCH(QString, first);
  QFETCH(QString, second);
  QFETCH(bool, inTurn);
  const bool json = QString(QTest::currentDataTag()) == "JSON";
  const QString row =
      json ? R"({"time_s": %1, "joint": "%2", "angle_rad": %3, "velocity_rad_per_s": %4})" : QString("%1,%2,%3,%4");
  QString text = json ? QString() : "time_s," + column + ",angle_rad,velocity_rad_per_s\n";
  for (int line = 0; line < 200; ++line) {
    const int axis = inTurn ? 1 + line % 2 : 1 + line / 100, k = inTurn ? line / 2 : line % 100;
    text += (row + "\n")
                .arg(0.01 * k)
                .arg(axis == 1 ? first : second)
                .arg(angleOf(axis, k), 0, 'g', 12)
                .arg(speedOf(axis, k), 0, 'g', 12);
  }
  const std::string file = folder_.write("log.csv", text.toStdString());
  const auto whole = importRecordings(file);
  QVERIFY(!whole.ok());
  const QString asked = QString::fromStdString(whole.error().message());
  QVERIFY2(asked.contains("rows of 2 axes") && asked.contains(R"({"split": ")" + column + "\"}"), qPrintable(asked));
  ImportMap map;
  map.split = column.toStdString();
  const auto parts = importRecordings(file, map);
  VERIFY_OK(parts);
  QCOMPARE(parts->size(), size_t(2));
  for (int axis = 1; axis <= 2; ++axis) {
    const Recording& part = (*parts)[size_t(axis - 1)].recording;
    QCOMPARE(part.rows(), size_t(100));
    for (int k = 0; k < 100; ++k) {
      QVERIFY(std::abs(part.time()[size_t(k)] - 0.01 * k) < 1e-12);
      QVERIFY(std::abs(part.channel("angle_rad")[size_t(k)] - angleOf(axis, k)) < 1e-9);
    }
  }
}

/// By its name alone, even where the motors move nearly alike at the same stamps.
void TestImport::motorsThatMoveAlike_areAskedToBeParted() {
  QString text = "timestamp,motor_name,velocity_rpm\n";
  for (int k = 0; k < 100; ++k) {
    for (const double share : {1.0, 0.95})
      text += QString("%1,%2,%3\n")
                  .arg(0.02 * k)
                  .arg(share == 1.0 ? "left" : "right")
                  .arg(share * 90.0 * std::sin(0.1 * k));
  }
  const auto imported = importRecording(folder_.write("log.csv", text.toStdString()));
  QVERIFY(!imported.ok());
  QVERIFY2(imported.error().message().find("\"split\": \"motor_name\"") != std::string::npos,
           imported.error().message().c_str());
}

void TestImport::oneAxis_isNotAskedToBeParted_data() {
  QTest::addColumn<QString>("column");
  QTest::addColumn<int>("period");
  QTest::newRow("a state that changes") << "state" << 50;
  QTest::newRow("a count that goes round") << "frame_id" << 4;
  QTest::newRow("a flag that toggles") << "led" << 2;
  QTest::newRow("one motor") << "motor_id" << 1000;
}

void TestImport::oneAxis_isNotAskedToBeParted() {
  QFETCH(QString, column);
  QFETCH(int, period);
  QString text = "time_s," + column + ",angle_rad\n";
  for (int k = 0; k < 200; ++k) {
    const int kind = period > 4 ? k / period : k % period;
    text += QString("%1,%2,%3\n")
                .arg(0.01 * k)
                .arg(column == "state" ? "s" + QString::number(kind) : QString::number(kind))
                .arg(angleOf(1, k), 0, 'g', 12);
  }
  VERIFY_OK(importRecording(folder_.write("log.csv", text.toStdString())));
}

void TestImport::columnsThatAreNotTheMotors_areKeptUnused_data() {
  QTest::addColumn<QString>("head");
  QTest::addColumn<QString>("cells");
  QTest::addColumn<QString>("why");
  QTest::newRow("duties of phases") << "dutyA,dutyB,dutyC"
                                    << "0.5,0.6,0.4"
                                    << "is one phase's";
  QTest::newRow("currents of phases") << "i_u_mA,i_v_mA,i_w_mA"
                                      << "500,-200,-300"
                                      << "is one phase's";
  QTest::newRow("a controller's terms") << "p,i,d"
                                        << "1.5,0.5,0.1"
                                        << "integral term";
  QTest::newRow("nothing in it") << "torque_x,current"
                                 << ",n/a"
                                 << "holds no number";
  QTest::newRow("a load cell's counts") << "flag,force_raw"
                                        << "1,8345120"
                                        << "a converter's counts";
  QTest::newRow("thousandths of the rated torque") << "statusword,actual_torque"
                                                   << "0x1237,312"
                                                   << "thousandths of the drive's";
  QTest::newRow("a vehicle's speed") << "speed_mps,speed (km/h)"
                                     << "1.5,5.4"
                                     << "beside a motor that turns";
  QTest::newRow("a coordinate that is there beside its target") << "TargetX,CurrX"
                                                                << "3.5,3.2"
                                                                << "where it is now";
  QTest::newRow("a line of an encoder") << "mark,encA"
                                        << "7,1"
                                        << "one of an encoder's lines";
  QTest::newRow("what counts on while the motor stands still in it") << "mark,pwm_time"
                                                                     << "7,1512"
                                                                     << "how long something takes";
  QTest::newRow("pulses of radio control") << "mark,servo_pwm"
                                           << "7,1512"
                                           << "pulse widths";
}

void TestImport::columnsThatAreNotTheMotors_areKeptUnused() {
  QFETCH(QString, head);
  QFETCH(QString, cells);
  QFETCH(QString, why);
  QString text = "time_s,angle_rad," + head + "\n";
  for (int k = 0; k < 60; ++k) text += QString("%1,%2,").arg(0.01 * k).arg(angleOf(1, k), 0, 'g', 12) + cells + "\n";
  const auto imported = importRecording(folder_.write("log.csv", text.toStdString()));
  VERIFY_OK(imported);
  size_t said = 0;
  for (const ColumnFate& column : imported->columns) {
    if (column.from == "time_s" || column.from == "angle_rad") continue;
    QVERIFY2(column.kind != ColumnFate::Kind::used, column.inWords().c_str());
    said += column.why.find(why.toStdString()) != std::string::npos ? 1 : 0;
  }
  QVERIFY2(said > 0, imported->columns.back().inWords().c_str());
}

void TestImport::numbersOfRows_areNoCurrent() {
  QString text = "i,time_s,theta (deg)\n";
  for (int k = 0; k < 60; ++k) text += QString("%1,%2,%3\n").arg(k).arg(0.01 * k).arg(30.0 * std::sin(0.1 * k));
  const auto imported = importRecording(folder_.write("log.csv", text.toStdString()));
  VERIFY_OK(imported);
  QVERIFY(!imported->recording.has("current_A"));
  QVERIFY2(imported->columns[0].why.find("counts the rows") != std::string::npos, imported->columns[0].why.c_str());
}

void TestImport::counterThatStandsStill_isNoAngle() {
  QString text = "time_s,steps,rpm\n";
  for (int k = 0; k < 60; ++k) text += QString("%1,2048,%2\n").arg(0.01 * k).arg(30.0 + k);
  const auto imported = importRecording(folder_.write("log.csv", text.toStdString()));
  VERIFY_OK(imported);
  QVERIFY(!imported->recording.has("angle_rad") && imported->recording.has("velocity_rad_per_s"));
}

/// Nobody can tell which way an axis went that leaps within its turn.
void TestImport::leapsWithinOneTurn_areCalledImplausible() {
  for (const double reach : {300.0, 100.0}) {
    QString text = "time_s,angle_deg\n";
    for (int k = 0; k < 30; ++k) text += QString("%1,%2\n").arg(3.0 * k).arg(10.0 + reach * ((k * 7) % 10) / 9.0);
    const auto imported = importRecording(folder_.write("log.csv", text.toStdString()));
    VERIFY_OK(imported);
    const bool said = std::any_of(imported->remarks.begin(), imported->remarks.end(), [](const std::string& one) {
      return one.starts_with("implausible") && one.find("which way") != std::string::npos;
    });
    QCOMPARE(said, reach > 200.0);
  }
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

void TestImport::voltageThatStandsStill_isTheSupplys_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<bool>("bothWays");
  QTest::addColumn<bool>("duty");
  QTest::addColumn<QString>("taken");
  QTest::newRow("turning both ways") << "voltage" << true << false << "supply_V";
  QTest::newRow("under a duty that changes") << "Voltage (V)" << false << true << "supply_V";
  QTest::newRow("while the speed goes up and down") << "Volt" << true << false << "supply_V";
  QTest::newRow("a step of the motor's") << "voltage" << false << false << "voltage_V";
  QTest::newRow("the motor's by its name") << "motor_voltage" << true << false << "voltage_V";
}

void TestImport::voltageThatStandsStill_isTheSupplys() {
  QFETCH(QString, name);
  QFETCH(bool, bothWays);
  QFETCH(bool, duty);
  QFETCH(QString, taken);
  QString text = "time_s,velocity_rad_per_s," + name + (duty ? ",duty\n" : "\n");
  for (int k = 0; k < 200; ++k) {
    text += QString("%1,%2,%3").arg(0.01 * k).arg(bothWays ? speedOf(1, k) : 10.0 + 0.01 * k).arg(24.0 - 0.1 * (k % 3));
    text += duty ? QString(",%1\n").arg(0.2 + 0.003 * k) : QString("\n");
  }
  const auto imported = importRecording(folder_.write("log.csv", text.toStdString()));
  VERIFY_OK(imported);
  const ColumnFate& fate = imported->columns[2];
  QCOMPARE(QString::fromStdString(fate.to), taken);
  QCOMPARE(fate.guessed, taken == "supply_V" || fate.unit.empty());
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

void TestImport::wholeSpeedAlone_isAskedAbout() {
  QString whole = "time_s,speed\n", parts = whole, beside = "time_s,angle_rad,speed\n";
  for (int k = 0; k < 60; ++k) {
    whole += QString("%1,%2\n").arg(0.01 * k).arg(100 + k);
    parts += QString("%1,%2\n").arg(0.01 * k).arg(10.25 + 0.5 * k);
    beside += QString("%1,%2,%3\n").arg(0.01 * k).arg(0.01 * k * (100 + 0.5 * k)).arg(100 + k);
  }
  const auto asked = importRecording(folder_.write("log.csv", whole.toStdString()));
  QVERIFY(!asked.ok());
  QVERIFY2(asked.error().message().find("\"unit\": \"rpm\"") != std::string::npos, asked.error().message().c_str());
  VERIFY_OK(importRecording(folder_.write("log.csv", parts.toStdString())));
  VERIFY_OK(importRecording(folder_.write("log.csv", beside.toStdString())));
}

void TestImport::drehzahl_isInRpm() {
  QString text = "Zeit [s];Motordrehzahl\n";
  for (int k = 0; k < 60; ++k) text += QString("%1;%2\n").arg(0.01 * k).arg(100 + k);
  const auto imported = importRecording(folder_.write("log.csv", text.toStdString()));
  VERIFY_OK(imported);
  QVERIFY(imported->columns[1].guessed);
  QVERIFY(std::abs(imported->recording.channel("velocity_rad_per_s")[0] - 100.0 * std::numbers::pi / 30.0) < 1e-9);
}

static std::string xl330(const std::string& first, const std::string& second, const std::string& third) {
  std::string entries;
  double t = 0.0;
  for (const auto& load : {first, second, third}) {
    entries += (entries.empty() ? "" : ", ") + std::string(R"({"timestamp": )") + std::to_string(t += 0.005) +
               R"(, "position": 0.1, "input_volts": 7.0, "torque_enable": true, "load": )" + load + "}";
  }
  return R"({"motor": "xl330", "entries": [)" + entries + "]}";
}

void TestImport::registerThatWraps_isReadAsSigned() {
  const auto imported = importRecording(folder_.write("log.json", xl330("177", "0", "65447")));
  VERIFY_OK(imported);
  QCOMPARE(imported->recording.channel("duty")[0], 0.2);
  QCOMPARE(imported->recording.channel("duty")[2], -89.0 / 885.0);
  QCOMPARE(imported->recording.channel("voltage_V")[0], 1.4);
  QCOMPARE(imported->recording.channel("enabled")[0], 1.0);
}

void TestImport::registerInterpolatedAcrossItsWrap_isRefused() {
  const auto imported = importRecording(folder_.write("log.json", xl330("4", "17920.88", "65529.53")));
  QVERIFY(!imported.ok());
  QVERIFY2(imported.error().message().find("entry 2, field load: 17920.88") != std::string::npos,
           imported.error().message().c_str());
  VERIFY_OK(importRecording(folder_.write("log.json", xl330("4", "3.5", "3"))));
}

QTEST_APPLESS_MAIN(TestImport)
#include "tst_import.moc"
