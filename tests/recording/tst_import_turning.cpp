#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "recording/import/import.h"
#include "support/temporary.h"

using namespace breakaway;
using breakaway::test::TemporaryFolder;

/// Angles and speeds by their values: turns, registers, units, leaps.
class TestImportTurning : public QObject {
  Q_OBJECT
 private slots:
  void angleThatWraps_goesOnCounting();
  void angleThatLeapsElsewhere_staysAsItIs_data();
  void angleThatLeapsElsewhere_staysAsItIs();
  void counterThatStandsStill_isNoAngle();
  void leapsWithinOneTurn_areCalledImplausible();
  void wholeSpeedAlone_isAskedAbout();
  void drehzahl_isInRpm();
  void rps_areTurnsOrRadiansByTheAngle_data();
  void rps_areTurnsOrRadiansByTheAngle();

 private:
  TemporaryFolder folder_;
};

void TestImportTurning::angleThatWraps_goesOnCounting() {
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

void TestImportTurning::angleThatLeapsElsewhere_staysAsItIs_data() {
  QTest::addColumn<QByteArray>("rows");
  QTest::newRow("leap of half a turn") << QByteArray("0,0.1\n1e-3,3.5\n2e-3,0.1\n");
  QTest::newRow("more than a turn") << QByteArray("0,0.1\n1e-3,6.3\n2e-3,7.9\n");
  QTest::newRow("no leap") << QByteArray("0,0.1\n1e-3,2.3\n2e-3,4.9\n3e-3,6.2\n");
}

void TestImportTurning::angleThatLeapsElsewhere_staysAsItIs() {
  QFETCH(QByteArray, rows);
  const auto imported = importRecording(folder_.write("log.csv", "time_s,angle_rad\n" + rows.toStdString()));
  VERIFY_OK(imported);
  const QList<QByteArray> lines = rows.trimmed().split('\n');
  for (qsizetype k = 0; k < lines.size(); ++k)
    QCOMPARE(imported->recording.channel("angle_rad")[static_cast<size_t>(k)], lines[k].split(',')[1].toDouble());
}

void TestImportTurning::counterThatStandsStill_isNoAngle() {
  QString text = "time_s,steps,rpm\n";
  for (int k = 0; k < 60; ++k) text += QString("%1,2048,%2\n").arg(0.01 * k).arg(30.0 + k);
  const auto imported = importRecording(folder_.write("log.csv", text.toStdString()));
  VERIFY_OK(imported);
  QVERIFY(!imported->recording.has("angle_rad") && imported->recording.has("velocity_rad_per_s"));
}

/// Nobody can tell which way an axis went that leaps within its turn.
void TestImportTurning::leapsWithinOneTurn_areCalledImplausible() {
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

void TestImportTurning::wholeSpeedAlone_isAskedAbout() {
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

void TestImportTurning::drehzahl_isInRpm() {
  QString text = "Zeit [s];Motordrehzahl\n";
  for (int k = 0; k < 60; ++k) text += QString("%1;%2\n").arg(0.01 * k).arg(100 + k);
  const auto imported = importRecording(folder_.write("log.csv", text.toStdString()));
  VERIFY_OK(imported);
  QVERIFY(imported->columns[1].guessed);
  QVERIFY(std::abs(imported->recording.channel("velocity_rad_per_s")[0] - 100.0 * std::numbers::pi / 30.0) < 1e-9);
}

void TestImportTurning::rps_areTurnsOrRadiansByTheAngle_data() {
  QTest::addColumn<double>("scale");
  QTest::addColumn<bool>("angle");
  QTest::newRow("turns") << 2.0 * std::numbers::pi << true;
  QTest::newRow("radians") << 1.0 << true;
  QTest::newRow("no angle") << 2.0 * std::numbers::pi << false;
}

void TestImportTurning::rps_areTurnsOrRadiansByTheAngle() {
  QFETCH(double, scale);
  QFETCH(bool, angle);
  QString text = angle ? "time_s,vel_rps,pos_rad\n" : "time_s,vel_rps\n";
  for (int k = 0; k < 100; ++k) {
    text += QString("%1,%2").arg(0.01 * k).arg(30.0 * std::cos(0.1 * k) / scale);
    text += angle ? QString(",%1\n").arg(3.0 * std::sin(0.1 * k)) : "\n";
  }
  const auto imported = importRecording(folder_.write("log.csv", text.toStdString()));
  VERIFY_OK(imported);
  QVERIFY(std::abs(imported->recording.channel("velocity_rad_per_s")[0] - 30.0) < 1e-3);
  QCOMPARE(imported->columns[1].guessed, !angle || scale == 1.0);
}

QTEST_APPLESS_MAIN(TestImportTurning)
#include "tst_import_turning.moc"
