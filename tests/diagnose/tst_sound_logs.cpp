#include <QTest>
#include <algorithm>

#include "diagnose/diagnosis.h"
#include "motor/bench.h"
#include "recording/csv.h"

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
};

void TestSoundLogs::plainMotor_lacksNothing_data() {
  QTest::addColumn<QString>("name");
  QTest::newRow("100 Hz, steps of the duty, of 300 rad/s") << "duty_in_steps";
  QTest::newRow("50 Hz, reversals from 800 rad/s") << "fast_reversals_50_Hz";
}

void TestSoundLogs::plainMotor_lacksNothing() {
  QFETCH(QString, name);
  const auto bench = readBench(fileOf(name + ".bench.json"));
  const auto recording = readCsv(fileOf(name + ".csv"));
  if (!bench || !recording) qFatal("no data");
  const auto diagnosis = diagnose(*bench, {*recording}, {}, {});
  if (!diagnosis) qFatal("%s", diagnosis.error().message().c_str());
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

QTEST_APPLESS_MAIN(TestSoundLogs)
#include "tst_sound_logs.moc"
