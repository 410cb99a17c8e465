#include <QTest>
#include <algorithm>

#include "diagnose/diagnosed.h"
#include "diagnose/diagnosis.h"
#include "motor/bench.h"
#include "recording/csv.h"
#include "support/plain_motor.h"

using namespace breakaway;

namespace {

std::string fileOf(const QString& name) {
  return (qEnvironmentVariable("BREAKAWAY_SOURCE_DIR") + "/tests/data/diagnose/" + name).toStdString();
}

}  // namespace

/// Slow logs of plain motors, of which the bench knows nothing: the plants have nothing but friction, made by other
/// programs than ours.
class TestSoundLogs : public QObject {
  Q_OBJECT
 private slots:
  void plainMotor_lacksNothing_data();
  void plainMotor_lacksNothing();
  void drivenInSteps_wandersAsItDoes();
  void measuredCurrent_wasReadAtItsInstant();
};

void TestSoundLogs::plainMotor_lacksNothing_data() {
  QTest::addColumn<QString>("name");
  QTest::newRow("100 Hz, steps of the duty, of 300 rad/s") << "duty_in_steps";
  if (!test::sanitized) QTest::newRow("50 Hz, reversals from 800 rad/s") << "fast_reversals_50_Hz";
}

void TestSoundLogs::plainMotor_lacksNothing() {
  QFETCH(QString, name);
  const auto bench = readBench(fileOf(name + ".bench.json"));
  const auto recording = readCsv(fileOf(name + ".csv"));
  if (!bench || !recording) qFatal("no data");
  const auto diagnosis = diagnose(*bench, {test::partToFit(*recording)}, {}, {});
  if (!diagnosis) qFatal("%s", diagnosis.error().message().c_str());
  if (test::sanitized) return;
  const std::string words = inWords(*diagnosis);
  QVERIFY2(diagnosis->verdict == Verdict::nothingMissing, words.c_str());
  // What the windows err by leaves no room for more.
  const double coulomb = *diagnosis->base.baseValue("coulomb_Nm");
  QVERIFY2(diagnosis->wander.rms < 0.02 * coulomb, words.c_str());
  const auto says = [&](const char* part) {
    return std::any_of(diagnosis->remarks.begin(), diagnosis->remarks.end(),
                       [part](const std::string& one) { return one.find(part) != std::string::npos; });
  };
  QVERIFY2(!says("of the rows stand at exactly"), words.c_str());
}

/// How late the winding is after a step must not be taken for torque.
void TestSoundLogs::drivenInSteps_wandersAsItDoes() {
  if (test::sanitized) QSKIP(test::likeOthers);
  const test::PlainMotorLog log = test::plainMotorLog(27, test::LogKind::imperfect);
  const auto diagnosis = diagnose(log.bench, {test::partToFit(log.recording)}, {}, {});
  if (!diagnosis) qFatal("%s", diagnosis.error().message().c_str());
  if (test::sanitized) return;
  const std::string words = log.words + "\n" + inWords(*diagnosis);
  QVERIFY2(diagnosis->verdict == Verdict::nothingMissing, words.c_str());
  const double share = diagnosis->wander.rms / *diagnosis->base.baseValue("coulomb_Nm");
  QVERIFY2(share > 0.7 * log.faults.wander && share < 1.3 * log.faults.wander, words.c_str());
}

/// A current that runs on between its readings is no late sensor.
void TestSoundLogs::measuredCurrent_wasReadAtItsInstant() {
  // Slow enough that it matters.
  std::uint64_t seed = 1;
  test::PlainMotorLog log = test::plainMotorLog(seed, test::LogKind::measured);
  while (log.recording.medianStep_s() < 0.009) log = test::plainMotorLog(++seed, test::LogKind::measured);
  const auto diagnosis = diagnose(log.bench, {test::partToFit(log.recording)}, {}, {});
  if (!diagnosis) qFatal("%s", diagnosis.error().message().c_str());
  if (test::sanitized) return;
  const std::string words = log.words + "\n" + inWords(*diagnosis);
  QVERIFY2(diagnosis->verdict == Verdict::nothingMissing, words.c_str());
  const double rows = *diagnosis->base.baseValue("drive_late_s") / log.recording.medianStep_s();
  QVERIFY2(rows > 0.4 && rows < 0.6, words.c_str());
}

QTEST_APPLESS_MAIN(TestSoundLogs)
#include "tst_sound_logs.moc"
