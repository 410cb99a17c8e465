#include <QTest>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "recording/import/import.h"
#include "support/imported_log.h"
#include "support/temporary.h"

using namespace breakaway;
using breakaway::test::meaning;
using breakaway::test::TemporaryFolder;

/// Logs of several motors, joints, or sides of a gear: motion, drive and reference that are taken are one's.
class TestImportWide : public QObject {
  Q_OBJECT
 private slots:
  void whatIsTaken_isOneOwners_data();
  void whatIsTaken_isOneOwners();
  void numberBehindAUnit_isTheAxis();
  void threeNumberedMotors_areNoPhases();
  void currentOfAnotherJoint_isKept();
  void currentOfAnotherWord_isAGuess();
  void torqueBesideBothSidesOfAGear_isKept();
  void torqueOfTheMotor_goesBeforeAShaftsSensor();
  void placeOfWhatAMotorMoves_isKept();
  void letterBehindAModelsBlock_isTaken();
  void jointsOfAGimbal_areTaken();
  void wearOfATool_isNoTime();
  void dutyWithoutADirection_isKeptBesideACurrent();
  void temperatureOfAnotherThing_isAGuess();
  void commandThatGoesFurtherThanTheSpeed_isNoReference_data();
  void commandThatGoesFurtherThanTheSpeed_isNoReference();

 private:
  using Wave = std::function<double(int)>;
  Result<Imported> logOf(const std::vector<std::pair<QString, Wave>>& columns, const QString& first = "time_s") {
    QString text = first;
    for (const auto& [name, at] : columns) text += ",\"" + name + "\"";
    for (int k = 0; k < 300; ++k) {
      text += QString("\n%1").arg(0.01 * k);
      for (const auto& [name, at] : columns) text += "," + QString::number(at(k), 'g', 9);
    }
    return importRecording(folder_.write("log.csv", text.toStdString() + "\n"));
  }
  TemporaryFolder folder_;
};

constexpr double toDegrees = 180.0 / std::numbers::pi, toRpm = 30.0 / std::numbers::pi;

/// Two motions (0, 1) that have little in common, and what drives each: acceleration and friction.
static double speedOf(int which, int k) {
  const double t = 0.01 * k;
  return which == 0 ? 8.0 * std::cos(4.0 * t) + 7.0 * std::cos(10.6 * t + 1.0)
                    : 9.0 * std::sin(6.7 * t + 2.0) + 6.0 * std::cos(17.0 * t);
}

static double placeOf(int which, int k) {
  const double t = 0.01 * k;
  return which == 0 ? 2.0 * std::sin(4.0 * t) + 7.0 / 10.6 * std::sin(10.6 * t + 1.0)
                    : -9.0 / 6.7 * std::cos(6.7 * t + 2.0) + 6.0 / 17.0 * std::sin(17.0 * t);
}

static double driveOf(int which, int k) {
  return 0.4 * (speedOf(which, k + 1) - speedOf(which, k)) + 0.3 * std::tanh(speedOf(which, k));
}

void TestImportWide::whatIsTaken_isOneOwners_data() {
  QTest::addColumn<QString>("pattern");
  QTest::addColumn<QStringList>("owners");
  QTest::addColumn<QStringList>("quantities");  // of the first, of the second
  const std::vector<QStringList> pairs = {
      {"shoulder", "elbow"}, {"motor", "load"}, {"motor", "joint"}, {"rotor", "link"}, {"motor", "brake"},
      {"motor", "dyno"},     {"pan", "tilt"},   {"left", "right"},  {"drum", "motor"}, {"thigh", "calf"}};
  const std::vector<QStringList> kinds = {{"speed current", "speed current"},    {"speed", "speed current"},
                                          {"speed current", "speed torque"},     {"angle current", "speed current"},
                                          {"angle speed", "angle speed torque"}, {"voltage speed", "current angle"}};
  const QStringList patterns = {"%1_%2_%3", "%2_%1_%3", "%1 %2 [%3]", "/%1/%2 (%3)"};
  qsizetype turn = 0;  // each pair meets each pattern
  for (const QStringList& owners : pairs) {
    for (const QStringList& quantities : kinds) {
      const QString& pattern = patterns[turn++ % patterns.size()];
      QTest::addRow("%s", qPrintable(pattern + ": " + owners.join(", ") + ": " + quantities.join(", ")))
          << pattern << owners << quantities;
    }
  }
}

void TestImportWide::whatIsTaken_isOneOwners() {
  QFETCH(QString, pattern);
  QFETCH(QStringList, owners);
  QFETCH(QStringList, quantities);
  const std::map<QString, QString> units = {
      {"speed", "rpm"}, {"angle", "deg"}, {"current", "A"}, {"torque", "Nm"}, {"voltage", "V"}};
  std::vector<std::pair<QString, Wave>> columns;
  for (const int which : {1, 0}) {
    for (const QString& quantity : quantities[which].split(' ')) {
      columns.emplace_back(pattern.arg(owners[which], quantity, units.at(quantity)), [which, quantity](int k) {
        return quantity == "speed"   ? speedOf(which, k) * toRpm
               : quantity == "angle" ? placeOf(which, k) * toDegrees
                                     : driveOf(which, k);
      });
    }
  }
  const auto log = logOf(columns);
  VERIFY_OK(log);
  QStringList sure[2];
  for (const ColumnFate& fate : log->columns) {
    if (fate.kind != ColumnFate::Kind::used || fate.to == "time_s" || fate.guessed) continue;
    const QString from = QString::fromStdString(fate.from);
    for (const int which : {0, 1}) {
      if (from.contains(owners[which])) sure[which].append(from);
    }
  }
  QVERIFY2(sure[0].isEmpty() || sure[1].isEmpty(), qPrintable(sure[0].join(", ") + " and " + sure[1].join(", ")));
}

void TestImportWide::numberBehindAUnit_isTheAxis() {
  const auto log = logOf({{"Motor Amps 2", [](int k) { return driveOf(1, k); }},
                          {"Motor Amps 1", [](int k) { return driveOf(0, k); }},
                          {"Encoder Speed RPM 1", [](int k) { return speedOf(0, k) * toRpm; }},
                          {"Encoder Speed RPM 2", [](int k) { return speedOf(1, k) * toRpm; }}});
  VERIFY_OK(log);
  const int axis = meaning(*log, "Encoder Speed RPM 1").empty() ? 1 : 0;
  QVERIFY(std::abs(log->recording.channel("velocity_rad_per_s")[50] - speedOf(axis, 50)) < 1e-6);
  QVERIFY(std::abs(log->recording.channel("current_A")[50] - driveOf(axis, 50)) < 1e-6);
}

void TestImportWide::threeNumberedMotors_areNoPhases() {
  std::vector<std::pair<QString, Wave>> columns;
  for (const int motor : {1, 2, 3}) {
    columns.emplace_back(QString("M%1_Speed_rpm").arg(motor), [motor](int k) { return speedOf(motor % 2, k) * toRpm; });
    columns.emplace_back(QString("M%1_Current_A").arg(motor), [motor](int k) { return driveOf(motor % 2, k); });
  }
  const auto log = logOf(columns);
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "M1_Speed_rpm"), std::string("velocity_rad_per_s"));
  QCOMPARE(meaning(*log, "M1_Current_A"), std::string("current_A"));
}

void TestImportWide::currentOfAnotherJoint_isKept() {
  const auto log = logOf({{"shoulder_speed_rpm", [](int k) { return speedOf(0, k) * toRpm; }},
                          {"elbow_current_A", [](int k) { return driveOf(1, k); }}});
  VERIFY_OK(log);
  QVERIFY(!log->recording.has("current_A"));
}

void TestImportWide::currentOfAnotherWord_isAGuess() {
  const auto log = logOf({{"motor_speed_rpm", [](int k) { return speedOf(0, k) * toRpm; }},
                          {"load_current_A", [](int k) { return driveOf(0, k); }}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "load_current_A"), std::string("current_A"));
  QVERIFY(log->columns[2].guessed);
}

void TestImportWide::torqueBesideBothSidesOfAGear_isKept() {
  const auto log = logOf({{"link_position_rad", [](int k) { return placeOf(0, k) / 50.0; }},
                          {"motor_position_rad", [](int k) { return placeOf(0, k); }},
                          {"effort_Nm", [](int k) { return 40.0 * driveOf(0, k); }},
                          {"motor_current_A", [](int k) { return driveOf(0, k); }}});
  VERIFY_OK(log);
  QCOMPARE(meaning(*log, "motor_position_rad"), std::string("angle_rad"));
  QCOMPARE(meaning(*log, "motor_current_A"), std::string("current_A"));
  QVERIFY(!log->recording.has("torque_Nm"));
}

void TestImportWide::torqueOfTheMotor_goesBeforeAShaftsSensor() {
  const auto log = logOf({{"motor_enc_rad", [](int k) { return placeOf(0, k); }},
                          {"shaft_torque_sensor_Nm", [](int k) { return driveOf(1, k); }},
                          {"motor_tau_Nm", [](int k) { return driveOf(0, k); }}});
  VERIFY_OK(log);
  QVERIFY(std::abs(log->recording.channel("torque_Nm")[50] - driveOf(0, 50)) < 1e-6);
}

void TestImportWide::placeOfWhatAMotorMoves_isKept() {
  const auto log = logOf({{"Car_Position_m", [](int k) { return 0.01 * placeOf(0, k); }},
                          {"Car_Speed_m_s", [](int k) { return 0.01 * speedOf(0, k); }},
                          {"Motor_Speed_rpm", [](int k) { return speedOf(0, k) * toRpm; }},
                          {"Motor_Torque_Nm", [](int k) { return driveOf(0, k); }}});
  VERIFY_OK(log);
  QVERIFY(!log->recording.has("position_m") && !log->recording.has("velocity_m_per_s"));
  QVERIFY(std::abs(log->recording.channel("velocity_rad_per_s")[50] - speedOf(0, 50)) < 1e-6);
  QVERIFY(std::abs(log->recording.channel("torque_Nm")[50] - driveOf(0, 50)) < 1e-6);
}

void TestImportWide::letterBehindAModelsBlock_isTaken() {
  const auto log = logOf({{"Model/Encoder/theta_motor [rad]", [](int k) { return placeOf(0, k); }},
                          {"Model/Controller/u_cmd [V]", [](int k) { return driveOf(0, k); }}});
  VERIFY_OK(log);
  QVERIFY(std::abs(log->recording.channel("voltage_V")[50] - driveOf(0, 50)) < 1e-6);
  QVERIFY(log->columns[2].guessed);
}

void TestImportWide::jointsOfAGimbal_areTaken() {
  const auto log = logOf({{"yaw_current_mA", [](int k) { return 1000.0 * driveOf(1, k); }},
                          {"pitch_enc_deg", [](int k) { return placeOf(0, k) * toDegrees; }},
                          {"pitch_current_mA", [](int k) { return 1000.0 * driveOf(0, k); }},
                          {"yaw_enc_deg", [](int k) { return placeOf(1, k) * toDegrees; }}});
  VERIFY_OK(log);
  const int axis = meaning(*log, "pitch_enc_deg").empty() ? 1 : 0;
  QVERIFY(std::abs(log->recording.channel("angle_rad")[50] - placeOf(axis, 50)) < 1e-6);
  QVERIFY(std::abs(log->recording.channel("current_A")[50] - driveOf(axis, 50)) < 1e-6);
}

void TestImportWide::wearOfATool_isNoTime() {
  QString text = "Rotational speed [rpm],Torque [Nm],Tool wear [min]\n";
  for (int k = 0; k < 100; ++k) text += QString("%1,%2,%3\n").arg(1500.0 + k % 7).arg(40.0 + k % 5).arg(k);
  const auto log = importRecording(folder_.write("log.csv", text.toStdString()));
  QVERIFY(!log.ok());
  QVERIFY(log.error().message().find("sample_time_s") != std::string::npos);
}

void TestImportWide::temperatureOfAnotherThing_isAGuess() {
  const auto log = logOf({{"speed_rpm", [](int k) { return speedOf(0, k) * toRpm; }},
                          {"Process temperature [K]", [](int k) { return 308.15 + 0.01 * k; }}});
  VERIFY_OK(log);
  QVERIFY(std::abs(log->recording.channel("temperature_degC")[100] - 36.0) < 1e-6);
  QVERIFY(log->columns[2].guessed);
}

void TestImportWide::dutyWithoutADirection_isKeptBesideACurrent() {
  const auto log = logOf({{"speed_rpm", [](int k) { return speedOf(0, k) * toRpm; }},
                          {"current_A", [](int k) { return driveOf(0, k); }},
                          {"pwm", [](int k) { return std::round(std::abs(driveOf(0, k)) * 230.0); }}});
  VERIFY_OK(log);
  QVERIFY(!log->recording.has("duty"));
  QCOMPARE(meaning(*log, "current_A"), std::string("current_A"));
}

void TestImportWide::commandThatGoesFurtherThanTheSpeed_isNoReference_data() {
  QTest::addColumn<double>("times");
  QTest::addColumn<bool>("taken");
  QTest::newRow("as far") << 1.0 << true;
  QTest::newRow("a little further") << 1.1 << true;
  QTest::newRow("a drive's thousandths") << 1.5 << false;
}

void TestImportWide::commandThatGoesFurtherThanTheSpeed_isNoReference() {
  QFETCH(double, times);
  QFETCH(bool, taken);
  const auto log = logOf({{"Motor Command", [times](int k) { return times * speedOf(0, k + 1) * toRpm; }},
                          {"Encoder Speed (RPM)", [](int k) { return speedOf(0, k) * toRpm; }}});
  VERIFY_OK(log);
  QCOMPARE(log->recording.has("velocity_reference_rad_per_s"), taken);
}

QTEST_APPLESS_MAIN(TestImportWide)
#include "tst_import_wide.moc"
