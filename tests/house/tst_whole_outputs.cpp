#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <map>

#include "house/program.h"
#include "house/pushed_mass.h"
#include "support/disturbed_output.h"
#include "support/small_disk.h"
#include "support/temporary.h"

using namespace breakaway::test;

static bool disksAllowed = false;

/// Outputs of the real program when it is killed, its disk is full, or another writes there: whole, or as before. The
/// long form is ./dev bench faults.
class TestWholeOutputs : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void killed_leavesTheWholeOrWhatWasThere_data() { outputs(); }
  void killed_leavesTheWholeOrWhatWasThere();
  void fullDisk_leavesWhatWasThereAndIsSaid_data() { outputs(); }
  void fullDisk_leavesWhatWasThereAndIsSaid();
  void killedWhileItSearches_leavesWhatWasThere();
  void twoAtOnce_areNeverMixed_data();
  void twoAtOnce_areNeverMixed();
  void damagedOutput_isSeen();

 private:
  void outputs() const;
  const DisturbedOutput& fetched() const;
  DisturbedOutput searching() const;
  TemporaryFolder files_;
  std::map<QString, DisturbedOutput> outputs_;
  OutputJob search_;
};

void TestWholeOutputs::initTestCase() {
  const auto file = [this](const char* name, const QByteArray& content) {
    return QString::fromStdString(files_.write(name, content.toStdString()));
  };
  const auto diagnosed = [bench = file("b.json", pushedMassBench())](const QString& recording) {
    return QStringList{"diagnose", "--bench", bench, "--recording", recording, "--out", "out"};
  };
  const auto recording = [&file](const char* name, int rows) {
    return file(name, pushedMassRecording(rows, {}, "time_s,position_m,force_N", 4e-2));
  };
  // Too short to search in: what it takes is reading and writing, and there the kills are to come.
  search_ = {"diagnose", diagnosed(recording("long.csv", 200))};
  const OutputJob all[] = {
      {"diagnose", diagnosed(recording("r.csv", 100))},
      {"import", {"import", file("log.csv", pushedMassRecording(20000)), "--out", "out"}, OutputJob::Kind::file}};
  for (const OutputJob& job : all) {
    DisturbedOutput output(builtProgram("breakaway"), job);
    const QString fault = output.measure();
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
    outputs_.emplace(job.name, output);
  }
}

/// A diagnosis of a few seconds, most of which is search.
DisturbedOutput TestWholeOutputs::searching() const {
  DisturbedOutput output(builtProgram("breakaway"), search_);
  const QString fault = output.measure();
  if (!fault.isEmpty()) qFatal("%s", qPrintable(fault));
  return output;
}

void TestWholeOutputs::outputs() const {
  QTest::addColumn<QString>("command");
  for (const auto& [name, output] : outputs_) QTest::newRow(qPrintable(name)) << name;
}

const DisturbedOutput& TestWholeOutputs::fetched() const {
  QFETCH(QString, command);
  return outputs_.at(command);
}

void TestWholeOutputs::killed_leavesTheWholeOrWhatWasThere() {
  const DisturbedOutput& output = fetched();
  for (const double part : {0.1, 0.6, 0.8, 0.9, 0.95, 1.0}) {
    for (const bool over : {false, true}) {
      const QTemporaryDir place;
      if (over) output.lay(place.path());
      output.kill(place.path(), static_cast<int>(part * static_cast<double>(output.took_ms())));
      QVERIFY2(output.left(place.path(), over) != Left::half, qPrintable(output.difference(place.path())));
      if (part < 0.9) continue;
      QCOMPARE(output.run(place.path()).status, 0);
      QVERIFY2(output.onlyWhole(place.path()), qPrintable(output.difference(place.path())));
    }
  }
}

void TestWholeOutputs::fullDisk_leavesWhatWasThereAndIsSaid() {
  if (!disksAllowed) QSKIP("the system lets this process mount no disk of its own");
  const DisturbedOutput& output = fetched();
  for (const double part : {0.0, 0.3, 0.7, 1.2}) {
    for (const bool over : {false, true}) {
      const QTemporaryDir place;
      const QString folder = place.filePath("disk");
      QVERIFY(QDir().mkpath(folder));
      const auto earlier = static_cast<double>(over ? output.bytes() : 0);
      const SmallDisk disk(folder.toStdString(),
                           static_cast<size_t>(4096 + part * static_cast<double>(output.bytes()) + earlier));
      QVERIFY(disk.mounted());
      if (over) output.lay(folder);
      const Ended ended = output.run(folder);
      if (part > 1.0) {
        QVERIFY2(ended.status == 0 && output.onlyWhole(folder), ended.said.constData());
        continue;
      }
      QVERIFY2(output.left(folder, over) == Left::before, qPrintable(output.difference(folder)));
      QCOMPARE(ended.status, 2);
      QVERIFY2(ended.said.count('\n') == 1 && ended.said.contains("No space left"), ended.said.constData());
    }
  }
}

void TestWholeOutputs::killedWhileItSearches_leavesWhatWasThere() {
  const DisturbedOutput output = searching();
  for (const bool over : {false, true}) {
    const QTemporaryDir place;
    if (over) output.lay(place.path());
    // On a machine that is busy now and then, a run may take a third of what the one before took.
    output.kill(place.path(), static_cast<int>(0.3 * static_cast<double>(output.took_ms())));
    QVERIFY2(output.left(place.path(), over) == Left::before, qPrintable(output.difference(place.path())));
  }
}

void TestWholeOutputs::twoAtOnce_areNeverMixed_data() {
  QTest::addColumn<bool>("searches");
  QTest::newRow("diagnose") << true;
  QTest::newRow("import") << false;
}

void TestWholeOutputs::twoAtOnce_areNeverMixed() {
  QFETCH(bool, searches);
  const DisturbedOutput output = searches ? searching() : outputs_.at("import");
  const QTemporaryDir place;
  QVERIFY(output.runTwo(place.path()));
  QVERIFY2(output.onlyWhole(place.path()), qPrintable(output.difference(place.path())));
}

/// What the others ask of outputs doesn't hold of one that is cut short, lacks a file or is a mixture.
void TestWholeOutputs::damagedOutput_isSeen() {
  const DisturbedOutput& output = outputs_.at("diagnose");
  const QTemporaryDir place;
  output.lay(place.path());
  QCOMPARE(output.left(place.path(), true), Left::before);
  QCOMPARE(output.left(place.path(), false), Left::whole);
  QFile model(place.filePath("out/model.json")), report(place.filePath("out/report.html"));
  const qint64 size = model.size();
  QVERIFY(model.resize(size - 1));
  QCOMPARE(output.left(place.path(), true), Left::half);
  QVERIFY(model.remove());
  QCOMPARE(output.difference(place.path()), QString("model.json"));
  output.lay(place.path());
  QVERIFY(report.open(QIODevice::Append) && report.write("00000000-0000-4000-8000-000000000000") > 0 && report.flush());
  QCOMPARE(output.left(place.path(), true), Left::half);
}

int main(int argc, char** argv) {
  disksAllowed = takeOwnMounts();
  TestWholeOutputs test;
  return QTest::qExec(&test, argc, argv);
}
#include "tst_whole_outputs.moc"
