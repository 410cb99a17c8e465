#include <QTest>
#include <set>

#include "motor/bench.h"
#include "recording/columns.h"
#include "recording/csv.h"
#include "recording/import/import.h"
#include "recording/sample_recording.h"
#include "support/temporary.h"

using namespace breakaway;
using breakaway::test::TemporaryFolder;

/// The table of columns, and that whoever reads or writes recordings keeps to it on both axes.
class TestColumns : public QObject {
  Q_OBJECT
 private slots:
  void eachQuantity_hasOneNameOnEachAxis();
  void text_isRefusedInEachColumnByCsvAndImport();
  void flags_areZeroOrOne();
  void recorder_writesColumnsOfTheTable();
  void bench_readsItsDriveInputFromTheTable();
  void manual_namesEachColumn();

 private:
  TemporaryFolder folder_;
};

void TestColumns::eachQuantity_hasOneNameOnEachAxis() {
  for (const Axis axis : {Axis::rotary, Axis::linear}) {
    std::set<Quantity> found;
    for (const Column& column : columns()) {
      QCOMPARE(columnNamed(column.name), &column);
      QCOMPARE(columnIn(column.unit, column.quantity), &column);
      if (column.axis.value_or(axis) != axis) continue;
      QVERIFY2(found.insert(column.quantity).second, column.name);
      QCOMPARE(std::string(columnName(column.quantity, axis)), std::string(column.name));
    }
    for (const Column& column : columns()) QVERIFY2(found.contains(column.quantity), column.name);
  }
  QVERIFY(columnNamed("status") == nullptr);
}

void TestColumns::text_isRefusedInEachColumnByCsvAndImport() {
  for (const Column& column : columns()) {
    if (column.quantity == Quantity::time) continue;
    const std::string name = column.name;
    const std::string expected = column.cell == Cell::flag ? "0 or 1" : "a finite number";
    VERIFY_ERROR(readCsvText("time_s," + name + "\n0,1\n1,off\n", "r.csv"),
                 "r.csv, row 2, column " + name + ": expected " + expected + ", found \"off\"");
    const char* motion = column.axis == Axis::linear ? ",position_m" : ",angle_rad";  // of the same axis
    const std::string place = column.quantity == Quantity::position ? "" : motion;
    const std::string cells = place.empty() ? "" : ",0";
    const std::string path = folder_.write(
        "log.csv", "time_s," + name + place + "\n0,1" + cells + "\n1,off" + cells + "\n2,1" + cells + "\n");
    QVERIFY2(!importRecording(path).ok(), column.name);
  }
}

void TestColumns::flags_areZeroOrOne() {
  VERIFY_OK(readCsvText("time_s,enabled,index\n0,0,1\n1,1,0\n2,0.5,\n", "r.csv"));
  VERIFY_ERROR(readCsvText("time_s,enabled\n0,1\n1,7\n", "r.csv"),
               "r.csv, row 2, column enabled: expected 0 or 1, found \"7\"");
  VERIFY_ERROR(readCsvText("time_s,index\n0,-1\n", "r.csv"),
               "r.csv, row 1, column index: expected 0 or 1, found \"-1\"");
}

void TestColumns::recorder_writesColumnsOfTheTable() {
  std::vector<Sample> ticks(2);
  ticks[1].time_s = 1e-3;
  ticks[1].angle_reference_rad = 0.5;
  for (const Axis axis : {Axis::rotary, Axis::linear}) {
    const auto recording = sealSamples("step", ticks, {}, axis);
    VERIFY_OK(recording);
    for (const Channel& channel : recording->channels()) {
      const Column* column = columnNamed(channel.name);
      QVERIFY2(column != nullptr && column->axis.value_or(axis) == axis, channel.name.c_str());
    }
    QCOMPARE(recording->channel(columnName(Quantity::positionReference, axis))[1], 0.5);
  }
}

void TestColumns::bench_readsItsDriveInputFromTheTable() {
  QVERIFY(driveInputNamed("torque_Nm", Axis::rotary) == DriveInput::torque);
  QVERIFY(driveInputNamed("force_N", Axis::linear) == DriveInput::torque);
  QVERIFY(!driveInputNamed("force_N", Axis::rotary));
  QVERIFY(!driveInputNamed("torque_Nm", Axis::linear));
  for (const Axis axis : {Axis::rotary, Axis::linear}) {
    for (const DriveInput input : {DriveInput::voltage, DriveInput::duty, DriveInput::current, DriveInput::torque}) {
      Bench bench;
      bench.axis = axis;
      bench.input = input;
      QVERIFY(driveInputNamed(bench.inputChannel(), axis) == input);
      for (const std::string& name : {bench.positionChannel(), bench.velocityChannel(), bench.inputChannel()}) {
        QVERIFY2(columnNamed(name) != nullptr && columnNamed(name)->axis.value_or(axis) == axis, name.c_str());
      }
    }
  }
}

void TestColumns::manual_namesEachColumn() {
  const auto manual = readFile(qgetenv("BREAKAWAY_SOURCE_DIR").toStdString() + "/resources/help/files.md");
  VERIFY_OK(manual);
  for (const Column& column : columns()) {
    QVERIFY2(manual->find('`' + std::string(column.name) + '`') != std::string::npos, column.name);
  }
}

QTEST_APPLESS_MAIN(TestColumns)
#include "tst_columns.moc"
