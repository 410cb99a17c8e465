#include <QTest>

#include "diagnose/diagnosis.h"
#include "recording/csv.h"
#include "support/real_recordings.h"
#include "support/temporary.h"

using namespace breakaway;

/// An unloaded brushless motor turned slowly once, one way, its current and position recorded
/// (github.com/gchenfc/ODrive, analysis/cogging_torque).
class TestOdriveReal : public QObject {
  Q_OBJECT
 private slots:
  void diagnosis_namesCoggingAndProvesIt();
};

void TestOdriveReal::diagnosis_namesCoggingAndProvesIt() {
  NEEDS_REAL_RECORDINGS();
  const std::string folder = test::realRecordings() + "/odrive_cogging/";
  const auto bench = readBench(folder + "odrive.bench.json");
  const auto recording = readCsv(folder + "slow2_nocomp_0.csv");
  VERIFY_OK(bench);
  VERIFY_OK(recording);
  const auto diagnosis = diagnose(*bench, {*recording}, {}, {});
  VERIFY_OK(diagnosis);
  // More is left than belongs to sensors and friction: the waves are there, and not all.
  QVERIFY2(diagnosis->verdict == Verdict::outsideCatalogue, inWords(*diagnosis).c_str());
  QVERIFY2(!diagnosis->findings.empty(), inWords(*diagnosis).c_str());
  QCOMPARE(diagnosis->findings.front().effect, std::string("cogging"));
  QVERIFY2(diagnosis->fit.improvementLow95 > 0.0, inWords(*diagnosis).c_str());
}

QTEST_APPLESS_MAIN(TestOdriveReal)
#include "tst_odrive_real.moc"
