#include <QTest>
#include <cmath>

#include "recording/import/import.h"
#include "support/temporary.h"
#include "support/two_axes.h"

using namespace breakaway;
using namespace breakaway::test;

/// Rows of several axes in one table, and what only looks so.
class TestImportAxes : public QObject {
  Q_OBJECT
 private slots:
  void severalAxesInOneTable_areAskedToBeParted_data();
  void severalAxesInOneTable_areAskedToBeParted();
  void motorsThatMoveAlike_areAskedToBeParted();
  void oneAxis_isNotAskedToBeParted_data();
  void oneAxis_isNotAskedToBeParted();

 private:
  TemporaryFolder folder_;
};

void TestImportAxes::severalAxesInOneTable_areAskedToBeParted_data() {
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

void TestImportAxes::severalAxesInOneTable_areAskedToBeParted() {
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
void TestImportAxes::motorsThatMoveAlike_areAskedToBeParted() {
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

void TestImportAxes::oneAxis_isNotAskedToBeParted_data() {
  QTest::addColumn<QString>("column");
  QTest::addColumn<int>("period");
  QTest::newRow("a state that changes") << "state" << 50;
  QTest::newRow("a count that goes round") << "frame_id" << 4;
  QTest::newRow("a flag that toggles") << "led" << 2;
  QTest::newRow("one motor") << "motor_id" << 1000;
}

void TestImportAxes::oneAxis_isNotAskedToBeParted() {
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

QTEST_APPLESS_MAIN(TestImportAxes)
#include "tst_import_axes.moc"
