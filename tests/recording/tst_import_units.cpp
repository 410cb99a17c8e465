#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "recording/import/import.h"
#include "support/temporary.h"

using namespace breakaway;
using breakaway::test::TemporaryFolder;

using At = std::function<double(double)>;

/// A column's name, and what it holds at each time in s.
struct TimedWave {
  QString name;
  At at;
};

constexpr double perRadian_deg = 180.0 / std::numbers::pi, perRadianPerSecond_rpm = 30.0 / std::numbers::pi;

static At times(double factor, double (*wave)(double)) {
  return [=](double t_s) { return factor * wave(t_s); };
}

/// A joint's motion within two rad either way, its speed, and a motion that has nothing to do with it.
static double jointAt(double t_s) {
  return 1.2 * std::sin(2.0 * t_s) + 0.4 * std::sin(5.3 * t_s);
}

static double rateAt(double t_s) {
  return 2.4 * std::cos(2.0 * t_s) + 2.12 * std::cos(5.3 * t_s);
}

static double otherAt(double t_s) {
  return std::sin(11.0 * t_s + 0.7 * t_s * t_s);
}

/// Turned by a motor that runs at 40 to 80 rad/s.
static double turnedAt(double t_s) {
  return 60.0 * t_s - 10.0 * (std::cos(2.0 * t_s) - 1.0);
}

static double runAt(double t_s) {
  return 60.0 + 20.0 * std::sin(2.0 * t_s);
}

/// What stands still at each of 30, 90 and 60, and a motor that follows it.
static double stepsAt(double t_s) {
  return std::array{30.0, 90.0, 60.0}[static_cast<size_t>(t_s / 2.0) % 3];
}

static double afterStepsAt(double t_s) {
  return stepsAt(t_s) + 0.3 * std::sin(17.0 * t_s);
}

/// Units that no name tells, electrical turns beside the shaft's, and choices that only their order makes.
class TestImportUnits : public QObject {
  Q_OBJECT
 private slots:
  void unitThatNoNameTells_isTakenFromWhatTellsIt_data();
  void unitThatNoNameTells_isTakenFromWhatTellsIt();
  void roundSetPoints_tellTheUnit();
  void unitThatNothingTells_isAskedFor_data();
  void unitThatNothingTells_isAskedFor();
  void electricalTurnsBesideTheShafts_areKept();
  void columnOfSomethingElse_isKept_data();
  void columnOfSomethingElse_isKept();
  void choiceThatOnlyTheOrderMade_isAGuess();
  void lineOfUnitsAboveTheNames_isUnderstood();
  void greekLettersWithNumbers_areAxes();
  void letterWithItsUnit_isTheMotors();
  void letterBesideAnotherOfThatPath_isASpeed();
  void angleOfNobody_yieldsToAnEncoders();
  void dateAndTimeWithABlank_areOneCell();
  void minutesSecondsAndMilliseconds_areATime();

 private:
  Result<Imported> logOf(const std::vector<TimedWave>& columns) {
    QString text = "time_s";
    for (const TimedWave& one : columns) text += "," + one.name;
    for (int k = 0; k < 600; ++k) {
      text += QString("\n%1").arg(0.01 * k);
      for (const TimedWave& one : columns) text += "," + QString::number(one.at(0.01 * k), 'g', 9);
    }
    return importRecording(folder_.write("log.csv", (text + "\n").toStdString()));
  }
  static const ColumnFate* fateOf(const Imported& log, const std::string& name) {
    const auto it =
        std::find_if(log.columns.begin(), log.columns.end(), [&](const ColumnFate& one) { return one.from == name; });
    return it == log.columns.end() ? nullptr : &*it;
  }
  static std::string meaning(const Imported& log, const std::string& name) {
    const ColumnFate* fate = fateOf(log, name);
    return fate != nullptr && fate->kind == ColumnFate::Kind::used ? fate->to : std::string();
  }
  TemporaryFolder folder_;
};

void TestImportUnits::unitThatNoNameTells_isTakenFromWhatTellsIt_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<double>("factor");
  QTest::addColumn<QString>("beside");
  QTest::addColumn<QString>("unit");
  QTest::newRow("a rate beside it") << "position" << perRadian_deg << "gimbal_rate [deg/s]"
                                    << "deg";
  QTest::newRow("another angle beside it") << "position" << 1.0 << "arm_angle [rad]"
                                           << "rad";
  QTest::newRow("a lean about an axis tells nothing") << "motor_position" << 1.0 << "angle_x [deg]"
                                                      << "";
  QTest::newRow("a lean beside it tells nothing") << "position" << 1.0 << "pitch [deg]"
                                                  << "";
  QTest::newRow("a joint doesn't turn so many radians") << "elbow_position" << perRadian_deg << "note"
                                                        << "deg";
  QTest::newRow("a motor may") << "motor_velocity" << 1.0 << "note"
                               << "";
  QTest::newRow("ROS counts in radians") << "elbow_position" << 10.0 << "elbow_effort"
                                         << "rad";
}

void TestImportUnits::unitThatNoNameTells_isTakenFromWhatTellsIt() {
  QFETCH(QString, name);
  QFETCH(double, factor);
  QFETCH(QString, beside);
  QFETCH(QString, unit);
  const auto log = logOf({{name, times(factor, jointAt)}, {beside, otherAt}});
  VERIFY_OK(log);
  const ColumnFate* fate = fateOf(*log, name.toStdString());
  QVERIFY(fate != nullptr);
  QCOMPARE(QString::fromStdString(fate->unit), unit);
  QVERIFY(fate->guessed);
}

void TestImportUnits::roundSetPoints_tellTheUnit() {
  const auto servo = logOf({{"target_angle", stepsAt}, {"measured_angle", afterStepsAt}});
  VERIFY_OK(servo);
  QCOMPARE(fateOf(*servo, "measured_angle")->unit, std::string("deg"));
  QVERIFY(std::abs(servo->recording.channel("angle_rad")[250] - afterStepsAt(2.5) / perRadian_deg) < 1e-6);
  const auto motor = logOf({{"target_speed", times(10.0, stepsAt)}, {"measured_speed", times(10.0, afterStepsAt)}});
  VERIFY_OK(motor);
  QCOMPARE(fateOf(*motor, "measured_speed")->unit, std::string("rpm"));
  QVERIFY(fateOf(*motor, "measured_speed")->guessed);
}

void TestImportUnits::unitThatNothingTells_isAskedFor_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<double>("factor");
  QTest::addColumn<QString>("beside");
  QTest::addColumn<QString>("asks");
  QTest::newRow("an angle") << "angle" << perRadian_deg << "current_A"
                            << "degrees, radians or turns";
  QTest::newRow("a motor's angle") << "joint.0.motor-pos-fb" << perRadian_deg << "current_A"
                                   << "degrees, radians or turns";
  QTest::newRow("a small angle needs none") << "angle" << 1.0 << "current_A"
                                            << "";
  QTest::newRow("a fast speed") << "speed" << 1500.0 << "torque_Nm"
                                << "tells no unit";
  QTest::newRow("a slow one needs none") << "speed" << 100.0 << "torque_Nm"
                                         << "";
  QTest::newRow("a place") << "position" << 100.0 << "force"
                           << "tells no unit";
  QTest::newRow("a near one needs none") << "position" << 0.1 << "force"
                                         << "";
}

void TestImportUnits::unitThatNothingTells_isAskedFor() {
  QFETCH(QString, name);
  QFETCH(double, factor);
  QFETCH(QString, beside);
  QFETCH(QString, asks);
  const auto log = logOf({{name, times(factor, jointAt)}, {beside, times(0.1, otherAt)}});
  QCOMPARE(log.ok(), asks.isEmpty());
  if (!asks.isEmpty())
    QVERIFY2(log.error().message().find(asks.toStdString()) != std::string::npos, log.error().message().c_str());
}

void TestImportUnits::electricalTurnsBesideTheShafts_areKept() {
  constexpr double polePairs = 7.0;
  const auto log = logOf({{"Theta_EKF", [](double t_s) { return std::fmod(polePairs * turnedAt(t_s), 6.283185307); }},
                          {"Omega_EKF", times(polePairs, runAt)},
                          {"Theta_enc", turnedAt},
                          {"Omega_enc", runAt}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "Theta_enc"), std::string("angle_rad"));
  QCOMPARE(meaning(*log, "Omega_enc"), std::string("velocity_rad_per_s"));
  QCOMPARE(meaning(*log, "Omega_EKF"), std::string());
  const auto plc = logOf(
      {{"MC_Axis000.Act.Pos", times(perRadian_deg, turnedAt)}, {"MC_Axis000.Act.Vel", times(perRadian_deg, runAt)}});
  QVERIFY(!plc.ok());
  const auto gear = logOf({{"motor_speed [rpm]", times(5.0 * perRadianPerSecond_rpm, runAt)},
                           {"wheel_speed [rpm]", times(perRadianPerSecond_rpm, runAt)}});
  VERIFY_OK(gear);
  QCOMPARE(meaning(*gear, "motor_speed [rpm]"), std::string("velocity_rad_per_s"));
}

void TestImportUnits::columnOfSomethingElse_isKept_data() {
  QTest::addColumn<QStringList>("names");
  QTest::addColumn<QString>("kept");
  QTest::newRow("a pendulum") << QStringList{"pendulum_angle_mrad", "arm_angle_mrad"} << "pendulum_angle_mrad";
  QTest::newRow("a lean about an axis") << QStringList{"angleX", "gyroY", "motor_rpm"} << "angleX";
  QTest::newRow("a place in a plane") << QStringList{"x_position", "y_position", "heading", "motor_rpm"}
                                      << "x_position";
  QTest::newRow("all motors together") << QStringList{"rotor1_rpm", "rotor2_rpm", "torque_total_Nm"}
                                       << "torque_total_Nm";
  QTest::newRow("a balance") << QStringList{"motor_rpm", "Aero Torque [Nm]", "Drag Torque [Nm]", "Tail Torque [Nm]"}
                             << "Aero Torque [Nm]";
  QTest::newRow("a pose") << QStringList{"left_velocity", "right_velocity", "x", "y", "rot"} << "rot";
  QTest::newRow("a manipulated variable") << QStringList{"sp_deg", "pv_deg", "pv_dps", "mv"} << "mv";
  QTest::newRow("a phase's voltage") << QStringList{"motor_rpm", "output_phase_voltage"} << "output_phase_voltage";
}

void TestImportUnits::columnOfSomethingElse_isKept() {
  QFETCH(QStringList, names);
  QFETCH(QString, kept);
  std::vector<TimedWave> columns;
  for (const QString& name : names) {
    const auto at = static_cast<double>(columns.size());
    columns.push_back({name, [at](double t_s) { return 10.0 * std::sin((2.0 + at) * t_s + at * t_s * t_s); }});
  }
  const auto log = logOf(columns);
  VERIFY_OK(log);
  QVERIFY(fateOf(*log, kept.toStdString()) != nullptr);
  QCOMPARE(meaning(*log, kept.toStdString()), std::string());
}

void TestImportUnits::choiceThatOnlyTheOrderMade_isAGuess() {
  const auto log = logOf({{"front_angle_deg", times(30.0, jointAt)}, {"tail_angle_deg", times(30.0, otherAt)}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "front_angle_deg"), std::string("angle_rad"));
  QVERIFY(fateOf(*log, "front_angle_deg")->guessed);
  const auto same = logOf({{"angle_deg", times(perRadian_deg, jointAt)}, {"angle_rad", jointAt}});
  VERIFY_OK(same);
  QVERIFY(!fateOf(*same, "angle_rad")->guessed);
}

void TestImportUnits::lineOfUnitsAboveTheNames_isUnderstood() {
  QString text = ",rpm,Nm,,s\n,N_MOTOR,M_SHAFT,stamp,seconds\n";
  for (int k = 0; k < 100; ++k)
    text += QString("%1,%2,%3,x,%4\n").arg(k).arg(500.0 + k).arg(0.1 + 0.001 * k).arg(0.01 * k);
  const auto log = importRecording(folder_.write("units.csv", text.toStdString()));
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "N_MOTOR"), std::string("velocity_rad_per_s"));
  QVERIFY(std::abs(log->recording.channel("velocity_rad_per_s")[10] - 510.0 / perRadianPerSecond_rpm) < 1e-6);
}

void TestImportUnits::dateAndTimeWithABlank_areOneCell() {
  QString text = "Date/Time\tMotor Speed (RPM)\tDC Bus Voltage (V)\n";
  for (int k = 0; k < 50; ++k) text += QString("2026-03-10 09:24:%1\t%2\t560\n").arg(10 + k, 2).arg(700.5 + k);
  const auto log = importRecording(folder_.write("drive.txt", text.toStdString()));
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "Motor Speed (RPM)"), std::string("velocity_rad_per_s"));
  QCOMPARE(log->recording.time().back(), 49.0);
}

void TestImportUnits::greekLettersWithNumbers_areAxes() {
  const auto log = logOf({{"θ1_d(°)", times(perRadian_deg, jointAt)},
                          {"θ1(°)", times(perRadian_deg, jointAt)},
                          {"θ2(°)", otherAt},
                          {"v1(°/s)", times(perRadian_deg, rateAt)},
                          {"v2(°/s)", otherAt}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "θ1(°)"), std::string("angle_rad"));
  QCOMPARE(meaning(*log, "v1(°/s)"), std::string("velocity_rad_per_s"));
  QCOMPARE(meaning(*log, "θ1_d(°)"), std::string("angle_reference_rad"));
}

void TestImportUnits::letterWithItsUnit_isTheMotors() {
  const auto log = logOf({{"theta (deg)", jointAt}, {"V_m (V)", otherAt}, {"Te_Nm", otherAt}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "V_m (V)"), std::string("voltage_V"));
  QCOMPARE(meaning(*log, "Te_Nm"), std::string("torque_Nm"));
}

void TestImportUnits::letterBesideAnotherOfThatPath_isASpeed() {
  const auto log = logOf({{"left_joint_0.q", jointAt}, {"left_joint_0.v", rateAt}, {"left_joint_0.tau_meas", otherAt}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "left_joint_0.v"), std::string("velocity_rad_per_s"));
}

void TestImportUnits::angleOfNobody_yieldsToAnEncoders() {
  const auto log = logOf({{"angle_x(deg)", otherAt}, {"motor_pos", jointAt}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "motor_pos"), std::string("angle_rad"));
  QCOMPARE(meaning(*log, "angle_x(deg)"), std::string());
  QVERIFY(fateOf(*log, "motor_pos")->guessed);
}

void TestImportUnits::minutesSecondsAndMilliseconds_areATime() {
  QString text = "#WEBOTS_MOTION,V1.0,LHipPitch,RKneePitch\n";
  for (int k = 0; k < 60; ++k)
    text += QString("00:%1:%2,Pose%3,%4,0.2\n")
                .arg(k * 40 / 1000, 2, 10, QChar('0'))
                .arg(k * 40 % 1000, 3, 10, QChar('0'))
                .arg(k + 1)
                .arg(std::sin(0.1 * k), 0, 'f', 4);
  const auto log = importRecording(folder_.write("walk.motion", text.toStdString()));
  VERIFY_OK(log);
  QVERIFY(std::abs(log->recording.time().back() - 2.36) < 1e-9);
  QCOMPARE(meaning(*log, "LHipPitch"), std::string("angle_rad"));
}

QTEST_APPLESS_MAIN(TestImportUnits)
#include "tst_import_units.moc"
