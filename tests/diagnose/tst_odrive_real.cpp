#include <QFile>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <complex>

#include "diagnose/diagnosis.h"
#include "recording/csv.h"
#include "support/real_recordings.h"
#include "support/sanitized.h"
#include "support/temporary.h"

using namespace breakaway;

/// An unloaded brushless motor turned slowly once, one way, its current and position recorded
/// (github.com/gchenfc/ODrive, analysis/cogging_torque).
class TestOdriveReal : public QObject {
  Q_OBJECT
 private slots:
  void diagnosis_namesCoggingAndProvesIt();
};

namespace {

/// Amplitude of one order of the drive's own map, A.
double holdingCurrent_A(const std::string& folder, double order) {
  QFile file(QString::fromStdString(folder + "static_map_a_16.csv"));
  if (!file.open(QIODevice::ReadOnly | QIODevice::Text)) return std::nan("");
  std::complex<double> sum;
  double rows = 0.0;
  while (!file.atEnd()) {
    const QList<QByteArray> cells = file.readLine().split(',');
    bool isAngle = false, isCurrent = false;
    const double angle = cells.front().toDouble(&isAngle), current = cells.back().toDouble(&isCurrent);
    if (!isAngle || !isCurrent) continue;
    sum += std::polar(current, -order * angle);
    rows += 1.0;
  }
  return 2.0 * std::abs(sum) / rows;
}

}  // namespace

void TestOdriveReal::diagnosis_namesCoggingAndProvesIt() {
  NEEDS_REAL_RECORDINGS();
  if (test::sanitized) QSKIP(test::likeOthers);
  const std::string folder = test::realRecordings() + "/odrive_cogging/";
  const auto bench = readBench(folder + "odrive.bench.json");
  const auto recording = readCsv(folder + "slow2_nocomp_0.csv");
  VERIFY_OK(bench);
  VERIFY_OK(recording);
  const auto diagnosis = diagnose(*bench, {*recording}, {}, {});
  VERIFY_OK(diagnosis);
  // More is left than belongs to sensors and friction: the waves are there, and not all.
  QVERIFY2(diagnosis->verdict == Verdict::outsideCatalogue, inWords(*diagnosis).c_str());
  QCOMPARE(diagnosis->findings.size(), size_t{1});
  QCOMPARE(diagnosis->findings.front().effect, std::string("cogging"));
  // The drive's own map of the same motor, measured at standstill, has its largest wave seven times per turn.
  const auto& wave = diagnosis->findings.front().parameters;
  const auto named = [&wave](const char* name) {
    return *std::find_if(wave.begin(), wave.end(), [name](const Parameter& one) { return one.name == name; });
  };
  QCOMPARE(named("order").value, 7.0);
  const Parameter amplitude = named("amplitude_Nm");
  const double truth_Nm = *bench->motor.torqueConstant * holdingCurrent_A(folder, 7.0);
  QVERIFY2(amplitude.low95 < truth_Nm && truth_Nm < amplitude.high95, inWords(*diagnosis).c_str());
  // One turn, one way: what is held out are angles that training has never seen, five windows of them.
  QVERIFY2(diagnosis->fit.improvementLow95 > 0.3, inWords(*diagnosis).c_str());
}

QTEST_APPLESS_MAIN(TestOdriveReal)
#include "tst_odrive_real.moc"
