#include <QTest>
#include <cmath>

#include "recording/import/import.h"
#include "support/imported_log.h"
#include "support/temporary.h"

using namespace breakaway;
using breakaway::test::ImportedLogs;

/// Speeds and drives that are never negative, beside a column that tells which way.
class TestImportDirection : public QObject {
  Q_OBJECT
 private slots:
  void speedWithoutASign_hasThatOfTheDirection_data();
  void speedWithoutASign_hasThatOfTheDirection();
  void directionOfARamp_isNoTurn();
  void dutyWithoutASign_goesWithTheMotion_data();
  void dutyWithoutASign_goesWithTheMotion();

 private:
  ImportedLogs logs_;
};

static double speedAt(int k) {
  return 50.0 * std::sin(0.07 * k) + 20.0 * std::sin(0.031 * k + 1.0);
}

constexpr int directionRows = 200;

void TestImportDirection::speedWithoutASign_hasThatOfTheDirection_data() {
  QTest::addColumn<QString>("column");
  QTest::addColumn<QString>("forward");
  QTest::addColumn<QString>("back");
  QTest::addColumn<bool>("told");
  QTest::addColumn<bool>("guessed");
  QTest::newRow("1 and 0") << "dir"
                           << "1"
                           << "0" << true << true;
  QTest::newRow("1 and -1") << "direction"
                            << "1"
                            << "-1" << true << true;
  QTest::newRow("a direction that is commanded") << "dir_cmd"
                                                 << "1"
                                                 << "-1" << true << true;
  QTest::newRow("words") << "Motor_Direction"
                         << "FWD"
                         << "REV" << true << true;
  QTest::newRow("German words") << "Drehrichtung"
                                << "rechts"
                                << "links" << true << true;
  QTest::newRow("French words") << "sens"
                                << "AVANT"
                                << "ARRIERE" << true << true;
  QTest::newRow("one way, and stops") << "direction"
                                      << "FWD"
                                      << "STOP" << false << false;
  QTest::newRow("a wind's direction") << "wind_direction"
                                      << "1"
                                      << "0" << false << false;
  QTest::newRow("words that tell none") << "direction"
                                        << "north"
                                        << "south" << false << true;
  QTest::newRow("an angle in degrees") << "direction_deg"
                                       << "90"
                                       << "270" << false << false;
}

void TestImportDirection::speedWithoutASign_hasThatOfTheDirection() {
  QFETCH(QString, column);
  QFETCH(QString, forward);
  QFETCH(QString, back);
  QFETCH(bool, told);
  QFETCH(bool, guessed);
  QString text = "time_s,velocity_rad_per_s," + column + "\n";
  for (int k = 0; k < directionRows; ++k)
    text += QString("%1,%2,%3\n").arg(0.01 * k).arg(std::abs(speedAt(k))).arg(speedAt(k) >= 0.0 ? forward : back);
  const auto log = logs_.imported(text);
  VERIFY_OK(log);
  QCOMPARE(log->columns[1].guessed, guessed);
  QCOMPARE(log->columns[1].inWords().english().find(column.toStdString()) != std::string::npos, guessed);
  for (int k = 0; k < directionRows; ++k) {
    const double wanted = told ? speedAt(k) : std::abs(speedAt(k));
    QVERIFY(std::abs(log->recording.channel("velocity_rad_per_s")[static_cast<size_t>(k)] - wanted) < 1e-3);
  }
}

/// Up and down again: the speed is highest where it changes.
void TestImportDirection::directionOfARamp_isNoTurn() {
  QString text = "time_s,velocity_rad_per_s,direction\n";
  for (int k = 0; k < directionRows; ++k)
    text += QString("%1,%2,%3\n").arg(0.01 * k).arg(k < 100 ? k : 200 - k).arg(k < 100 ? "up" : "down");
  const auto log = logs_.imported(text);
  VERIFY_OK(log);
  QVERIFY(!log->columns[1].guessed);
  QCOMPARE(log->recording.channel("velocity_rad_per_s")[150], 50.0);
}

void TestImportDirection::dutyWithoutASign_goesWithTheMotion_data() {
  QTest::addColumn<double>("forward");
  QTest::addColumn<double>("speed");
  QTest::newRow("1 is forward") << 1.0 << 1.0;
  QTest::newRow("0 is forward") << 0.0 << 1.0;
  QTest::newRow("a speed without a sign, too, has the direction's own") << 1.0 << 0.0;
}

void TestImportDirection::dutyWithoutASign_goesWithTheMotion() {
  QFETCH(double, forward);
  QFETCH(double, speed);
  QString text = "time_s,velocity_rad_per_s,duty,dir\n";
  for (int k = 0; k < directionRows; ++k) {
    const double measured = speed > 0.0 ? speedAt(k) : std::abs(speedAt(k));
    text += QString("%1,%2,%3,%4\n")
                .arg(0.01 * k)
                .arg(measured)
                .arg(std::abs(0.01 * speedAt(k)))
                .arg(speedAt(k) >= 0.0 ? forward : 1.0 - forward);
  }
  const auto log = logs_.imported(text);
  VERIFY_OK(log);
  QVERIFY(log->columns[2].guessed);
  for (int k = 0; k < directionRows; ++k)
    QVERIFY(std::abs(log->recording.channel("duty")[static_cast<size_t>(k)] - 0.01 * speedAt(k)) < 1e-5);
}

QTEST_APPLESS_MAIN(TestImportDirection)
#include "tst_import_direction.moc"
