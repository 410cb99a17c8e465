#include <QTest>
#include <cmath>

#include "base/atomic_file.h"
#include "experiment/winding_test.h"
#include "firmware_link/presets.h"
#include "firmware_link/simulated_board.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

class TestFreeSwing : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void playBetweenMotorAndEncoder_isNamed_data();
  void playBetweenMotorAndEncoder_isNamed();
  void soundRotor_hasNone_data();
  void soundRotor_hasNone();
  void swingThatDies_isNoPlay();
};

namespace {

/// The winding test's end on a rig.
std::string failureOn(const std::string& uri, unsigned seed) {
  auto drive = openDrive(uri, seed);
  if (!drive) qFatal("%s", drive.error().message().c_str());
  WindingTestOptions options;
  options.ramps = 2;
  options.square_s = 0.5;
  const auto test = std::make_shared<WindingTest>(options);
  (*drive)->start(test);
  std::vector<Sample> samples;
  while (test->state() == Procedure::State::running) {
    samples.clear();
    if (!(*drive)->advance(0.1, samples)) qFatal("no samples");
  }
  return test->status().failure;
}

std::string servoWith(const std::string& more) {
  auto text = readFile(qgetenv("BREAKAWAY_SOURCE_DIR").toStdString() + "/resources/presets/servo.rig.json");
  if (!text) qFatal("no preset");
  text->replace(text->rfind('}'), 1, ", " + more + "}");
  return *text;
}

Sample openAt(double time_s, double angle_rad) {
  Sample sample;
  sample.time_s = time_s;
  sample.angle_rad = std::floor(angle_rad / 4e-4) * 4e-4;
  return sample;
}

}  // namespace

void TestFreeSwing::initTestCase() {
  qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

void TestFreeSwing::playBetweenMotorAndEncoder_isNamed_data() {
  QTest::addColumn<double>("gap_rad");
  for (const double gap_rad : {0.002, 0.005, 0.01, 0.02}) QTest::addRow("%g rad", gap_rad) << gap_rad;
}

void TestFreeSwing::playBetweenMotorAndEncoder_isNamed() {
  QFETCH(double, gap_rad);
  const TemporaryFolder folder;
  const std::string coupling =
      "\"coupling\": {\"stiffness_Nm_per_rad\": 20, \"load_inertia_kg_m2\": 3e-5, "
      "\"damping_Nm_s_per_rad\": 0.0005, \"gap_rad\": " +
      std::to_string(gap_rad) + "}";
  const std::string words = failureOn("simulated:" + folder.write("loose.rig.json", servoWith(coupling)), 1);
  QVERIFY2(words.find("play") != std::string::npos, words.c_str());
  const double degrees = std::atof(words.substr(words.find(" by ") + 4).c_str());
  QVERIFY2(degrees > 0.9 * gap_rad * 57.3 && degrees < 1.15 * gap_rad * 57.3 + 0.06, words.c_str());
}

void TestFreeSwing::soundRotor_hasNone_data() {
  QTest::addColumn<QString>("uri");
  for (const char* preset : {"servo", "geared", "uneven", "published-0134"})
    QTest::newRow(preset) << QString("simulated:") + preset;
}

void TestFreeSwing::soundRotor_hasNone() {
  QFETCH(QString, uri);
  for (const unsigned seed : {1u, 2u}) QCOMPARE(failureOn(uri.toStdString(), seed), std::string());
}

void TestFreeSwing::swingThatDies_isNoPlay() {
  for (const bool dies : {true, false}) {
    FreeSwing swing(Axis::rotary);
    swing.begin();
    for (int k = 0; k < 2000; ++k) {
      const double t = 2e-4 * k;
      swing.take(openAt(t, 0.01 * std::sin(100.0 * t) * (dies ? std::exp(-6.0 * t) : 1.0)));
    }
    QCOMPARE(swing.words().empty(), dies);
  }
}

QTEST_GUILESS_MAIN(TestFreeSwing)
#include "tst_free_swing.moc"
