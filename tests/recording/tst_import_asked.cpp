#include <QTest>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "recording/import/import.h"
#include "support/imported_log.h"
#include "support/temporary.h"

using namespace breakaway;
using breakaway::test::meaning;
using breakaway::test::TemporaryFolder;

/// What a log tells by how its tool writes, and what it doesn't tell and is asked about instead of guessed.
class TestImportAsked : public QObject {
  Q_OBJECT
 private slots:
  void unitWithItsQuantityBehind_isThatUnit_data();
  void unitWithItsQuantityBehind_isThatUnit();
  void transistorsTemperature_tellsAVesc();
  void numberBeforeACapital_isTheAxis();
  void ticksByOnes_askForTheRate();
  void ticksInLongerSteps_areTheTime();
  void onlyColumnInDegrees_isTheAngle_data();
  void onlyColumnInDegrees_isTheAngle();
  void countsWithAnIndex_areCounts();
  void factorBeforeAnIndex_isNoSpeed();
  void drivesThatGoNearlyAsTheSpeed_areNone();
  void comBesideEnc_isWhatWasCommanded();
  void torquesOfBothSides_areAGears_data();
  void torquesOfBothSides_areAGears();
  void outputsTorque_isKeptBesideTheMotors();
  void armatureBehindIn_isTheMotors();
  void systemsCurrent_isTheSupplys();
  void loggersName_isNobodys();
  void motionControllersAxis_isAskedAbout();
  void farAngleWithoutAUnit_isDoubted();
  void doubtBesideTheUnits_isSaidToo();
  void bracketAmidAName_isNoUnit();
  void speedsThatTheirUnitAloneTells_areAskedAbout();
  void receiversSpeed_isNotTheMotors();

 private:
  using Wave = std::function<double(int)>;
  using Columns = std::vector<std::pair<QString, Wave>>;
  Result<Imported> logOf(const Columns& columns, const QString& head = {}, const ImportMap& map = {}) {
    QString text = head;
    for (const auto& [name, at] : columns) text += (&at == &columns.front().second ? "\"" : ",\"") + name + "\"";
    for (int k = 0; k < 300; ++k) {
      text += "\n";
      for (const auto& [name, at] : columns)
        text += (&at == &columns.front().second ? "" : ",") + QString::number(at(k), 'g', 12);
    }
    return importRecording(folder_.write("log.csv", text.toStdString() + "\n"), map);
  }
  TemporaryFolder folder_;
};

constexpr double toDegrees = 180.0 / std::numbers::pi, toRpm = 30.0 / std::numbers::pi, turn = 2.0 * std::numbers::pi;

static double placeAt(int k) {
  const double t = 0.01 * k;
  return 2.0 * std::sin(4.0 * t) + 0.7 * std::sin(10.6 * t + 1.0);
}

static double speedAt(int k) {
  const double t = 0.01 * k;
  return 8.0 * std::cos(4.0 * t) + 7.42 * std::cos(10.6 * t + 1.0);
}

/// What moves it: inertia and friction.
static double torqueAt(int k) {
  return 0.02 * (speedAt(k + 1) - speedAt(k)) + 0.02 * std::tanh(speedAt(k));
}

static double secondsAt(int k) {
  return 0.01 * k;
}

static bool isAsked(const Result<Imported>& log, const std::string& word) {
  return !log.ok() && log.error().message().find(word) != std::string::npos;
}

void TestImportAsked::unitWithItsQuantityBehind_isThatUnit_data() {
  QTest::addColumn<QString>("unit");
  QTest::addColumn<bool>("understood");
  QTest::newRow("with its quantity") << "°/s (Angular velocity)" << true;
  QTest::newRow("unknown") << "furlong (Angular velocity)" << false;
}

void TestImportAsked::unitWithItsQuantityBehind_isThatUnit() {
  QFETCH(QString, unit);
  QFETCH(bool, understood);
  QString text = "Time;ActPos;ActVelo\ns;° (Angle);" + unit + "\n";
  for (int k = 0; k < 300; ++k)
    text += QString("%1;%2;%3\n").arg(secondsAt(k)).arg(toDegrees * placeAt(k)).arg(toDegrees * speedAt(k));
  const auto log = importRecording(folder_.write("log.csv", text.toStdString()));
  VERIFY_OK(log);
  QVERIFY(std::abs(log->recording.channel("angle_rad")[50] - placeAt(50)) < 1e-3);
  QCOMPARE(log->recording.has("velocity_rad_per_s"), understood);
  if (understood) QVERIFY(std::abs(log->recording.channel("velocity_rad_per_s")[50] - speedAt(50)) < 1e-3);
}

void TestImportAsked::transistorsTemperature_tellsAVesc() {
  const Columns columns = {{"Temp Mos", [](int k) { return 31.0 + 0.01 * k; }},
                           {"Current In", [](int k) { return 0.3 * torqueAt(k); }},
                           {"Motor Current", torqueAt},
                           {"Duty", [](int k) { return 0.05 * speedAt(k); }},
                           {"RPM ", [](int k) { return 7.0 * toRpm * speedAt(k); }},
                           {"Voltage in", [](int k) { return 12.0 - 0.1 * torqueAt(k); }}};
  ImportMap map;
  map.sample_time_s = 0.01;
  QVERIFY(isAsked(logOf(columns, {}, map), "pole_pairs"));
  map.pole_pairs = 7.0;
  const auto log = logOf(columns, {}, map);
  VERIFY_OK(log);
  QVERIFY(std::abs(log->recording.channel("velocity_rad_per_s")[50] - speedAt(50)) < 1e-6);
  QVERIFY(log->recording.has("supply_V") && !log->recording.has("voltage_V"));
}

void TestImportAsked::numberBeforeACapital_isTheAxis() {
  const auto log = logOf({{"time", secondsAt},
                          {"ODrive0Position", [](int k) { return placeAt(k) / turn; }},
                          {"ODrive1Position", [](int k) { return placeAt(k + 90) / turn; }},
                          {"ODrive0Velocity", [](int k) { return speedAt(k) / turn; }},
                          {"ODrive1Velocity", [](int k) { return speedAt(k + 90) / turn; }},
                          {"ODrive0Current", torqueAt},
                          {"ODrive1Current", [](int k) { return torqueAt(k + 90); }}});
  VERIFY_OK(log);
  QVERIFY(std::abs(log->recording.channel("angle_rad")[50] - placeAt(50)) < 1e-6);
  QVERIFY(std::abs(log->recording.channel("velocity_rad_per_s")[50] - speedAt(50)) < 1e-6);
  QVERIFY(std::abs(log->recording.channel("current_A")[50] - torqueAt(50)) < 1e-6);
}

void TestImportAsked::ticksByOnes_askForTheRate() {
  const auto log = logOf({{"tick", [](int k) { return 55120.0 + k; }}, {"joint_pos_rad", placeAt}});
  QVERIFY(isAsked(log, "sample_time_s"));
}

void TestImportAsked::ticksInLongerSteps_areTheTime() {
  const auto log = logOf({{"tick", [](int k) { return 55120.0 + 10.0 * k; }}, {"joint_pos_rad", placeAt}});
  VERIFY_OK(log);
  QVERIFY(std::abs(log->recording.time()[100] - log->recording.time()[0] - 1.0) < 1e-9);
}

void TestImportAsked::onlyColumnInDegrees_isTheAngle_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<bool>("taken");
  QTest::newRow("letters that aren't known") << "R_KFE_deg" << true;
  QTest::newRow("a direction") << "KFE_azimuth_deg" << false;
  QTest::newRow("a phase") << "Phase KFE [deg]" << false;
}

void TestImportAsked::onlyColumnInDegrees_isTheAngle() {
  QFETCH(QString, name);
  QFETCH(bool, taken);
  const auto log = logOf({{"Elapsed Time(ms)", [](int k) { return 10.0 * k; }},
                          {name, [](int k) { return toDegrees * placeAt(k); }},
                          {"R_KFE_fLoad", torqueAt}});
  QCOMPARE(log.ok(), taken);
  if (!taken) return;
  QVERIFY(std::abs(log->recording.channel("angle_rad")[50] - placeAt(50)) < 1e-6);
  QVERIFY(log->columns[1].guessed);
}

void TestImportAsked::countsWithAnIndex_areCounts() {
  const auto log =
      logOf({{"time_s", secondsAt}, {"cnt_now[0]", [](int k) { return std::round(1200.0 * placeAt(k) / turn); }}});
  QVERIFY(isAsked(log, "counts_per_rev"));
}

void TestImportAsked::factorBeforeAnIndex_isNoSpeed() {
  const auto log = logOf({{"time_s", secondsAt}, {"pos_rad", placeAt}, {"omega_res_x10[0]", [](int k) {
                                                                          return std::round(10.0 * speedAt(k));
                                                                        }}});
  VERIFY_OK(log);
  QVERIFY(!log->recording.has("velocity_rad_per_s"));  // not in rpm, which is nearly ten times as much
}

void TestImportAsked::drivesThatGoNearlyAsTheSpeed_areNone() {
  const auto log = logOf({{"time_s", secondsAt}, {"pos_rad", placeAt}, {"signal", [](int k) {
                                                                          return 1.18 * speedAt(k) + 0.05 * torqueAt(k);
                                                                        }}});
  VERIFY_OK(log);
  QVERIFY(!log->recording.has("velocity_rad_per_s"));  // a back-EMF's voltage, say
}

void TestImportAsked::comBesideEnc_isWhatWasCommanded() {
  const auto log = logOf({{"Time_ms", [](int k) { return 10.0 * k; }},
                          {"com_Pos_mm", [](int k) { return placeAt(k + 3); }},
                          {"enc_Pos_mm", placeAt},
                          {"com_Vel_mm_per_s", [](int k) { return speedAt(k + 3); }}});
  VERIFY_OK(log);
  QVERIFY(std::abs(log->recording.channel("position_m")[50] - 1e-3 * placeAt(50)) < 1e-9);
  QVERIFY(!log->recording.has("velocity_m_per_s"));
  QCOMPARE(meaning(*log, "com_Vel_mm_per_s"), std::string("velocity_reference_m_per_s"));
}

void TestImportAsked::torquesOfBothSides_areAGears_data() {
  QTest::addColumn<QString>("motion");
  QTest::addColumn<QString>("torque");
  QTest::newRow("the motor's motion") << "P_RPM"
                                      << "INPUT_TORQUE";
  QTest::newRow("the output's motion") << "output_speed_rpm"
                                       << "OUTPUT_TORQUE";
}

void TestImportAsked::torquesOfBothSides_areAGears() {
  QFETCH(QString, motion);
  QFETCH(QString, torque);
  const auto log = logOf({{"time_s", secondsAt},
                          {motion, [](int k) { return toRpm * speedAt(k); }},
                          {"INPUT_TORQUE", torqueAt},
                          {"OUTPUT_TORQUE", [](int k) { return 2.2 * torqueAt(k) + 0.02 * speedAt(k); }}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, torque), std::string("torque_Nm"));
}

void TestImportAsked::outputsTorque_isKeptBesideTheMotors() {
  const auto log = logOf({{"time_s", secondsAt},
                          {"Motor_Position_rad", placeAt},
                          {"Motor_Current_A", torqueAt},
                          {"Output_Torque_Nm", [](int k) { return 9.0 * torqueAt(k); }},
                          {"Command_Torque_Nm", [](int k) { return 9.0 * torqueAt(k + 1); }}});
  VERIFY_OK(log);
  QVERIFY(!log->recording.has("torque_Nm"));
  QCOMPARE(meaning(*log, "Motor_Current_A"), std::string("current_A"));
}

void TestImportAsked::armatureBehindIn_isTheMotors() {
  const auto log = logOf({{"t in ms", [](int k) { return 10.0 * k; }},
                          {"phi in °", [](int k) { return toDegrees * placeAt(k); }},
                          {"I_A in A", torqueAt},
                          {"U_A in V", [](int k) { return torqueAt(k) + 0.3 * speedAt(k); }}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "I_A in A"), std::string("current_A"));
  QCOMPARE(meaning(*log, "U_A in V"), std::string("voltage_V"));
}

void TestImportAsked::systemsCurrent_isTheSupplys() {
  const auto log = logOf({{"time_s", secondsAt},
                          {"motor_speed_rpm", [](int k) { return toRpm * speedAt(k); }},
                          {"System_Current_A", [](int k) { return 1.0 + std::abs(torqueAt(k)); }},
                          {"System_Voltage_V", [](int k) { return 24.0 - std::abs(torqueAt(k)); }}});
  VERIFY_OK(log);
  QVERIFY(!log->recording.has("current_A") && !log->recording.has("voltage_V"));
  QCOMPARE(meaning(*log, "System_Voltage_V"), std::string("supply_V"));
}

void TestImportAsked::loggersName_isNobodys() {
  QString text;
  for (int k = 0; k < 120; ++k) {
    const QString stamp = QString("00:00:%1").arg(0.2 * k, 6, 'f', 3, '0') + "    Info quasarMotor ";
    text += stamp + QString("sample current %1 mA\n").arg(std::lround(1000.0 * torqueAt(k)));
    text += stamp + QString("Main Voltage %1 mV\n").arg(12000 - std::lround(100.0 * std::abs(torqueAt(k))));
    text += stamp + QString("motor position %1 deg\n").arg(toDegrees * placeAt(k), 0, 'f', 3);
  }
  const auto log = importRecording(folder_.write("log.txt", text.toStdString()));
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "motor position [deg]"), std::string("angle_rad"));
  QVERIFY(!log->recording.has("voltage_V"));  // "quasarMotor" doesn't make it the motor's
}

void TestImportAsked::motionControllersAxis_isAskedAbout() {
  const Columns columns = {{"Time[ms]", [](int k) { return 10.0 * k; }},
                           {"FPOS(0)", [](int k) { return toDegrees * placeAt(k); }},
                           {"FVEL(0)", [](int k) { return toDegrees * speedAt(k); }}};
  QVERIFY(isAsked(logOf(columns), "FPOS(0)"));
}

void TestImportAsked::farAngleWithoutAUnit_isDoubted() {
  const auto doubtOf = [this](double times) {
    const auto log = logOf({{"time_s", secondsAt},
                            {"pos", [times](int k) { return times * placeAt(k); }},
                            {"vel", [times](int k) { return times * speedAt(k); }}});
    return log.ok() ? std::string(log->columns[1].inWords()) : log.error().message();
  };
  QVERIFY(doubtOf(20.0).find("in degrees or turns") != std::string::npos);
  QVERIFY(doubtOf(1.0).find("in degrees or turns") == std::string::npos);
}

void TestImportAsked::doubtBesideTheUnits_isSaidToo() {
  const auto log = logOf({{"time_s", secondsAt},
                          {"sigma", [](int k) { return toDegrees * placeAt(k); }},
                          {"kappa", [](int k) { return toRpm * speedAt(k); }}});
  VERIFY_OK(log);
  const std::string words = log->columns[1].inWords();
  QVERIFY2(words.find("agrees with kappa") != std::string::npos, words.c_str());
  QVERIFY2(words.find("nothing but its values tells it") != std::string::npos, words.c_str());
}

void TestImportAsked::bracketAmidAName_isNoUnit() {
  const auto log = logOf({{"leg:timestamp", secondsAt},
                          {"knee[Actpack]:motor_position", placeAt},
                          {"knee[Actpack]:motor_velocity", speedAt}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "knee[Actpack]:motor_position"), "angle_rad");
  QCOMPARE(meaning(*log, "knee[Actpack]:motor_velocity"), "velocity_rad_per_s");
}

void TestImportAsked::speedsThatTheirUnitAloneTells_areAskedAbout() {
  const auto rpm = [](int k) { return 300.0 + toRpm * speedAt(k); };
  const Columns one = {{"t [s]", secondsAt}, {"N_HM [1/min]", rpm}};
  VERIFY_OK(logOf(one));
  const auto set = [](int k) { return 290.0 + toRpm * speedAt(k + 2); };
  QVERIFY(isAsked(logOf({{"t [s]", secondsAt}, {"SO_N_HM [1/min]", set}, {"N_HM [1/min]", rpm}}), "N_HM"));
}

void TestImportAsked::receiversSpeed_isNotTheMotors() {
  const auto log = logOf({{"time_s", secondsAt}, {"position_deg", placeAt}, {"gnss_gVel", speedAt}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "gnss_gVel"), "");
}

QTEST_APPLESS_MAIN(TestImportAsked)
#include "tst_import_asked.moc"
