#include <QTest>
#include <cmath>

#include "recording/import/import.h"
#include "support/temporary.h"
#include "support/two_axes.h"

using namespace breakaway;
using namespace breakaway::test;

/// What is on a motor's electrical side and what is not, and columns that are none of its own.
class TestImportElectrical : public QObject {
  Q_OBJECT
 private slots:
  void columnsThatAreNotTheMotors_areKeptUnused_data();
  void columnsThatAreNotTheMotors_areKeptUnused();
  void numbersOfRows_areNoCurrent();
  void voltageThatStandsStill_isTheSupplys_data();
  void voltageThatStandsStill_isTheSupplys();
  void currentOfAnInverter_isDoubted_data();
  void currentOfAnInverter_isDoubted();
  void fieldsWinding_isNotTheArmatures_data();
  void fieldsWinding_isNotTheArmatures();
  void registerThatWraps_isReadAsSigned();
  void registerInterpolatedAcrossItsWrap_isRefused();

 private:
  TemporaryFolder folder_;
};

void TestImportElectrical::columnsThatAreNotTheMotors_areKeptUnused_data() {
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

void TestImportElectrical::columnsThatAreNotTheMotors_areKeptUnused() {
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

void TestImportElectrical::numbersOfRows_areNoCurrent() {
  QString text = "i,time_s,theta (deg)\n";
  for (int k = 0; k < 60; ++k) text += QString("%1,%2,%3\n").arg(k).arg(0.01 * k).arg(30.0 * std::sin(0.1 * k));
  const auto imported = importRecording(folder_.write("log.csv", text.toStdString()));
  VERIFY_OK(imported);
  QVERIFY(!imported->recording.has("current_A"));
  QVERIFY2(imported->columns[0].why.find("counts the rows") != std::string::npos, imported->columns[0].why.c_str());
}

void TestImportElectrical::voltageThatStandsStill_isTheSupplys_data() {
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

void TestImportElectrical::voltageThatStandsStill_isTheSupplys() {
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

void TestImportElectrical::currentOfAnInverter_isDoubted_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<double>("least");
  QTest::addColumn<bool>("doubted");
  QTest::newRow("an amount") << "Output current (A)" << 0.5 << true;
  QTest::newRow("both ways") << "Output current (A)" << -0.5 << false;
  QTest::newRow("the motor's") << "Motor current (A)" << 0.5 << false;
}

void TestImportElectrical::currentOfAnInverter_isDoubted() {
  QFETCH(QString, name);
  QFETCH(double, least);
  QFETCH(bool, doubted);
  QString text = "time_s,Output frequency (Hz),Motor speed (rpm)," + name + "\n";
  for (int k = 0; k < 200; ++k)
    text += QString("%1,%2,%3,%4\n").arg(0.1 * k).arg(0.1 * k).arg(6.0 * k).arg(least + 0.01 * k);
  const auto log = importRecording(folder_.write("log.csv", text.toStdString()));
  VERIFY_OK(log);
  QCOMPARE(log->columns[3].to, "current_A");
  QCOMPARE(log->columns[3].guessed, doubted);
}

void TestImportElectrical::fieldsWinding_isNotTheArmatures_data() {
  QTest::addColumn<QString>("head");
  QTest::newRow("letters") << "i_f,i_a,v_f,v_a";
  QTest::newRow("letters with units") << "i_f_A,i_a_A,v_f_V,v_a_V";
  QTest::newRow("words") << "field_current_A,armature_current_A,excitation_voltage_V,armature_voltage_V";
}

void TestImportElectrical::fieldsWinding_isNotTheArmatures() {
  QFETCH(QString, head);
  QString text = "time_s,velocity_rad_per_s," + head + "\n";
  for (int k = 0; k < 200; ++k)
    text += QString("%1,%2,0.8,%3,200,%4\n")
                .arg(0.01 * k)
                .arg(speedOf(1, k))
                .arg(0.1 + 0.01 * speedOf(1, k))
                .arg(0.2 + 0.05 * speedOf(1, k));
  const auto log = importRecording(folder_.write("log.csv", text.toStdString()));
  VERIFY_OK(log);
  QVERIFY(std::abs(log->recording.channel("current_A")[50] - (0.1 + 0.01 * speedOf(1, 50))) < 1e-4);
  QVERIFY(std::abs(log->recording.channel("voltage_V")[50] - (0.2 + 0.05 * speedOf(1, 50))) < 1e-4);
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

void TestImportElectrical::registerThatWraps_isReadAsSigned() {
  const auto imported = importRecording(folder_.write("log.json", xl330("177", "0", "65447")));
  VERIFY_OK(imported);
  QCOMPARE(imported->recording.channel("duty")[0], 0.2);
  QCOMPARE(imported->recording.channel("duty")[2], -89.0 / 885.0);
  QCOMPARE(imported->recording.channel("voltage_V")[0], 1.4);
  QCOMPARE(imported->recording.channel("enabled")[0], 1.0);
}

void TestImportElectrical::registerInterpolatedAcrossItsWrap_isRefused() {
  const auto imported = importRecording(folder_.write("log.json", xl330("4", "17920.88", "65529.53")));
  QVERIFY(!imported.ok());
  QVERIFY2(imported.error().message().find("entry 2, field load: 17920.88") != std::string::npos,
           imported.error().message().c_str());
  VERIFY_OK(importRecording(folder_.write("log.json", xl330("4", "3.5", "3"))));
}

QTEST_APPLESS_MAIN(TestImportElectrical)
#include "tst_import_electrical.moc"
