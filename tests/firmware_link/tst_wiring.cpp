// Benches that are wired wrongly, from the start or in the middle of a motion: the motor stops, and the words name the
// cause. A sound bench hears nothing of it.
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <memory>

#include "experiment/current_zeroing.h"
#include "experiment/dead_sensor.h"
#include "experiment/homing.h"
#include "experiment/spin_test.h"
#include "experiment/velocity_step.h"
#include "experiment/winding_test.h"
#include "firmware_link/contradiction.h"
#include "firmware_link/simulated_board.h"
#include "plant/rig_wiring.h"
#include "support/sanitized.h"

using namespace breakaway;

class TestWiring : public QObject {
  Q_OBJECT
 private slots:
  void sheared_stopsBeforeItRunsAway_data();
  void sheared_stopsBeforeItRunsAway();
  void sensorThatNeverChanges_isDead();
  void faultFromTheStart_isNamed_data();
  void faultFromTheStart_isNamed();
  void faultInMotion_stopsTheMotorSoon_data();
  void faultInMotion_stopsTheMotorSoon();
  void soundBench_isLeftAlone_data();
  void soundBench_isLeftAlone();
  void cause_isReadOffTheFigures_data();
  void cause_isReadOffTheFigures();
  void noiseOfOneTick_isNoCurrent();
  void motionThatIsBraked_tellsSensorFromBridge();
  void wrongFile_isRefused_data();
  void wrongFile_isRefused();

 private:
  QString rigWith(const QString& preset, const QString& wiring);
  QTemporaryDir folder_;
};

namespace {

constexpr double slice_s = 0.01;

struct Ran {
  QString failure;          ///< of the procedure; empty: it came to its end
  double furthest_rad = 0;  ///< of the encoder from where it was
  double lasted_s = 0;
};

Ran run(Drive& drive, const std::shared_ptr<Procedure>& procedure, double most_s) {
  drive.start(procedure);
  std::vector<Sample> samples;
  while (procedure->state() == Procedure::State::running && samples.size() * 2e-4 < most_s) {
    if (!drive.advance(slice_s, samples)) break;
  }
  Ran ran;
  ran.failure = QString::fromStdString(procedure->status().failure);
  if (samples.empty()) return ran;
  for (const Sample& one : samples)
    ran.furthest_rad = std::max(ran.furthest_rad, std::abs(one.angle_rad - samples.front().angle_rad));
  ran.lasted_s = samples.back().time_s - samples.front().time_s;
  return ran;
}

/// What a bench job begins with, until one of them fails; short ones.
QString firstFailure(Drive& drive) {
  WindingTestOptions winding;
  winding.square_s = 0.5;
  SpinTestOptions spin;
  spin.leg_s = 0.8;
  spin.cycles = 2;
  HomingOptions homing;
  homing.countsPerRev = drive.identity().countsPerRev;
  const std::shared_ptr<Procedure> job[] = {std::make_shared<CurrentZeroing>(), std::make_shared<WindingTest>(winding),
                                            std::make_shared<SpinTest>(spin), std::make_shared<Homing>(homing)};
  for (const auto& procedure : job) {
    const Ran ran = run(drive, procedure, 150.0);
    if (!ran.failure.isEmpty()) return ran.failure;
    if (const auto* test = dynamic_cast<WindingTest*>(procedure.get())) {
      const auto line = fitWindingLine(test->points());
      if (!line) return QString::fromStdString(line.error().message());
    }
  }
  return {};
}

std::unique_ptr<Drive> opened(const QString& file) {
  auto drive = openDrive("simulated:" + file.toStdString(), 1);
  if (!drive) qFatal("%s", drive.error().message().c_str());
  return std::move(*drive);
}

}  // namespace

/// The preset's rig with `wiring` in it.
QString TestWiring::rigWith(const QString& preset, const QString& wiring) {
  QFile source(QString::fromUtf8(qgetenv("BREAKAWAY_SOURCE_DIR")) + "/resources/presets/" + preset + ".rig.json");
  if (!source.open(QIODevice::ReadOnly)) qFatal("no preset");
  QByteArray text = source.readAll();
  text.replace(text.indexOf('{'), 1, "{ \"wiring\": [" + wiring.toUtf8() + "],");
  QFile file(folder_.filePath(preset + ".rig.json"));
  if (!file.open(QIODevice::WriteOnly)) qFatal("no room");
  file.write(text);
  return file.fileName();
}

void TestWiring::faultFromTheStart_isNamed_data() {
  QTest::addColumn<QString>("preset");
  QTest::addColumn<QString>("wiring");
  QTest::addColumn<QString>("words");
  const std::pair<const char*, const char*> all[] = {
      {R"({"fault": "encoder_reversed"})", "swap the encoder's A and B"},
      {R"({"fault": "encoder_dead"})", "encoder"},
      {R"({"fault": "counts_factor", "value": 4})", "about 4 times"},
      {R"({"fault": "counts_factor", "value": 2})", "about 2 times"},
      {R"({"fault": "counts_factor", "value": 0.5})", "about 0.5 times"},
      {R"({"fault": "counts_factor", "value": 0.25})", "about 0.25 times"},
      {R"({"fault": "counts_factor", "value": 0.9765625})", "a turn has"},
      {R"({"fault": "counts_factor", "value": 1.024})", "the index comes every 369°: a turn has"},
      {R"({"fault": "current_sensor_reversed"})", "reversed"},
      {R"({"fault": "current_sensor_dead"})", "sensor is dead"},
      {R"({"fault": "bridge_reversed"})", "bridge is reversed"},
      {R"({"fault": "lead_off"})", "a lead of the motor is off"},
      {R"({"fault": "supply_reading_factor", "value": 2})", "divider"},
      {R"({"fault": "index_inverted"})", "inverted"},
      {R"({"fault": "load_Nm", "value": 0.2})", "a load pulls it"},
  };
  for (const char* preset : {"servo", "geared"}) {
    size_t rows = 0;
    for (const auto& [wiring, words] : all)
      if (test::alsoRun(rows++, 4)) QTest::addRow("%s, %s", preset, wiring) << preset << wiring << words;
  }
}

void TestWiring::faultFromTheStart_isNamed() {
  QFETCH(QString, preset);
  QFETCH(QString, wiring);
  QFETCH(QString, words);
  if (test::sanitized && preset != "servo") QSKIP("takes too long under sanitizers");
  const auto drive = opened(rigWith(preset, wiring));
  const QString failure = firstFailure(*drive);
  QVERIFY2(failure.contains(words), qPrintable("said: " + failure));
}

void TestWiring::faultInMotion_stopsTheMotorSoon_data() {
  QTest::addColumn<QString>("wiring");
  QTest::addColumn<QString>("words");
  QTest::newRow("encoder") << R"({"fault": "encoder_dead", "from_s": 1})"
                           << "the encoder stands";
  QTest::newRow("sensor's sign") << R"({"fault": "current_sensor_reversed", "from_s": 1})"
                                 << "reversed";
  QTest::newRow("bridge's sign") << R"({"fault": "bridge_reversed", "from_s": 1})"
                                 << "";  // an over-current may come first
  QTest::newRow("lead") << R"({"fault": "lead_off", "from_s": 1})"
                        << "a lead of the motor is off";
  QTest::newRow("supply") << R"({"fault": "supply_reading_factor", "value": 1.5, "from_s": 1})"
                          << "divider";
}

void TestWiring::faultInMotion_stopsTheMotorSoon() {
  QFETCH(QString, wiring);
  QFETCH(QString, words);
  const auto drive = opened(rigWith("servo", wiring));
  VelocityStepOptions options;
  options.from_rad_per_s = 20.0;
  options.to_rad_per_s = 60.0;
  options.before_s = 1.0;
  const Ran ran = run(*drive, std::make_shared<VelocityStep>(options), 10.0);
  QVERIFY2(ran.failure.contains(words), qPrintable("said: " + ran.failure));
  QVERIFY2(ran.lasted_s < 1.25, qPrintable(QString::number(ran.lasted_s)));
}

void TestWiring::soundBench_isLeftAlone_data() {
  QTest::addColumn<QString>("preset");
  for (const char* preset : {"servo", "geared", "uneven", "published-0134"}) QTest::addRow("%s", preset) << preset;
}

void TestWiring::soundBench_isLeftAlone() {
  QFETCH(QString, preset);
  if (test::sanitized && preset != "servo") QSKIP("takes too long under sanitizers");
  const auto drive = opened(rigWith(preset, {}));
  QCOMPARE(firstFailure(*drive), QString());
}

void TestWiring::sheared_stopsBeforeItRunsAway_data() {
  QTest::addColumn<QString>("preset");
  QTest::addColumn<double>("target");
  size_t rows = 0;
  for (const char* preset : {"servo", "geared", "uneven", "published-0134"}) {
    for (const double target : {2.0, 5.0, 20.0})
      if (test::alsoRun(rows++, 5)) QTest::addRow("%s at %g rad/s", preset, target) << preset << target;
  }
}

/// The encoder hangs on the motor by next to nothing: a closed loop would take the whole supply.
void TestWiring::sheared_stopsBeforeItRunsAway() {
  QFETCH(QString, preset);
  QFETCH(double, target);
  const QString file = rigWith(preset, {});
  QFile rig(file);
  QVERIFY(rig.open(QIODevice::ReadOnly));
  QByteArray text = rig.readAll();
  rig.close();
  text.replace(text.indexOf('{'), 1, R"({ "coupling": { "stiffness_Nm_per_rad": 1e-6, "load_inertia_kg_m2": 1e-4 },)");
  QVERIFY(rig.open(QIODevice::WriteOnly));
  rig.write(text);
  rig.close();
  const auto drive = opened(file);
  std::vector<Sample> samples;
  drive->command({Command::Mode::velocity, target, 0.0, false});
  QVERIFY(drive->advance(1.0, samples));
  const auto lastOn = std::find_if(samples.rbegin(), samples.rend(), [](const Sample& one) { return one.enabled; });
  QVERIFY(lastOn != samples.rend());
  const double on_s = lastOn->time_s - samples.front().time_s;
  QVERIFY2(on_s < 0.5, qPrintable(QString("energised for %1 s").arg(on_s)));
}

void TestWiring::sensorThatNeverChanges_isDead() {
  const auto after_s = [](double noise_A) {
    DeadSensor watch;
    for (int k = 0; k < 100000; ++k) {
      Sample sample;
      sample.time_s = 1e-3 * k;
      sample.enabled = true;
      sample.voltage_V = 0.5 * std::sin(sample.time_s);
      sample.current_A = -0.05 + noise_A * (k % 7);
      if (!watch.step(sample).empty()) return sample.time_s;
    }
    return -1.0;
  };
  const double found_s = after_s(0.0);
  QVERIFY2(found_s > 4.9 && found_s < 6.0, qPrintable(QString::number(found_s)));
  QCOMPARE(after_s(1e-3), -1.0);
}

void TestWiring::cause_isReadOffTheFigures_data() {
  QTest::addColumn<double>("voltage");
  QTest::addColumn<double>("current");
  QTest::addColumn<double>("speed");
  QTest::addColumn<int>("cause");
  const auto row = [](const char* name, double V, double A, double w, WiringCause cause) {
    QTest::newRow(name) << V << A << w << static_cast<int>(cause);
  };
  // 1.2 ohm, 0.07 V s/rad: 5 V and 0.3 A turn it at 66 rad/s.
  row("encoder reversed", 5.0, 0.3, -66.0, WiringCause::encoderReversed);
  row("encoder stands", 5.0, 0.3, 0.0, WiringCause::encoderStands);
  row("four times the counts", 5.0, 0.3, 264.0, WiringCause::countsFactor);
  row("half the counts", 5.0, 0.3, 33.0, WiringCause::countsFactor);
  row("sensor reversed", 5.0, -0.3, 66.0, WiringCause::sensorReversed);
  row("bridge reversed", 5.0, -0.3, -66.0, WiringCause::bridgeReversed);
  row("encoder dead, estimate lagging", 5.0, 0.3, -6.0, WiringCause::encoderStands);
  row("sensor dead, speeding up", 5.0, 0.0, 40.0, WiringCause::sensorDead);
  row("lead off", 5.0, 0.0, 0.0, WiringCause::leadOff);
}

void TestWiring::cause_isReadOffTheFigures() {
  QFETCH(double, voltage);
  QFETCH(double, current);
  QFETCH(double, speed);
  QFETCH(int, cause);
  for (const double way : {1.0, -1.0}) {
    const MotorFigures motor{way * voltage, way * current, way * speed, 0.5 * way * speed, 1.2, 0.07, 12.8, {}};
    QCOMPARE(static_cast<int>(causeOf(motor)), cause);
    QVERIFY(!contradictionWords(motor).empty());
  }
}

/// A lead is off, and the sensor's range is large: its noise of a tick is a tenth of what should flow.
void TestWiring::noiseOfOneTick_isNoCurrent() {
  for (const double noise_A : {-0.04, 0.04}) {
    QVERIFY(causeOf({1.1, noise_A, 0.0, 0.0, 3.3, 0.1, 4.0, {}, 0.003}) == WiringCause::leadOff);
    QVERIFY(causeOf({-1.1, noise_A, 0.0, 0.0, 3.3, 0.1, 4.0, {}, 0.003}) == WiringCause::leadOff);
  }
  QVERIFY(causeOf({1.1, -0.04, 0.0, 0.0, 3.3, 0.1, 4.0, {}}) == WiringCause::leadOff);
  QVERIFY(causeOf({1.1, -0.3, 0.0, 0.0, 3.3, 0.1, 4.0, {}, -0.2}) == WiringCause::sensorOrBridgeReversed);
  // Its mean over 20 ms is noise, too, and much less than what should flow.
  QVERIFY(causeOf({-1.6, 0.31, 0.0, 0.0, 2.0, 0.1, 10.0, {}, 0.08}) == WiringCause::leadOff);
}

/// What turns the other way yet, when the current turns round, slows down.
void TestWiring::motionThatIsBraked_tellsSensorFromBridge() {
  const auto cause = [](double speed, double before) {
    return causeOf({5.0, -3.0, speed, before, 1.2, 0.07, 12.8, {}});
  };
  QVERIFY(cause(-29.0, -35.0) == WiringCause::sensorReversed);
  QVERIFY(cause(-29.0, -25.0) == WiringCause::bridgeReversed);
  QVERIFY(cause(29.0, 35.0) == WiringCause::bridgeReversed);
  QVERIFY(cause(29.0, 25.0) == WiringCause::sensorReversed);
  // What is too heavy to change its speed: voltage, current and back-EMF add up with the sensor turned round.
  QVERIFY(causeOf({14.7, -2.08, 0.126, 0.132, 2.89, 57.2, 10.0, {}}) == WiringCause::sensorReversed);
  QVERIFY(causeOf({14.7, -2.08, 0.126, 0.132, 2.89, 57.2, 10.0, {}, 0.8, 14.1, -0.5}) == WiringCause::sensorReversed);
  QVERIFY(causeOf({14.7, -9.0, 0.2, 0.196, 2.89, 57.2, 20.0, {}}) == WiringCause::bridgeReversed);
}

void TestWiring::wrongFile_isRefused_data() {
  QTest::addColumn<QString>("wiring");
  QTest::addColumn<QString>("words");
  QTest::newRow("unknown") << R"({"fault": "encoder_revered"})"
                           << "expected one of: encoder_reversed, encoder_dead";
  QTest::newRow("no value") << R"({"fault": "counts_factor"})"
                            << "value";
  QTest::newRow("factor 0") << R"({"fault": "counts_factor", "value": 0})"
                            << "value";
  QTest::newRow("before the start") << R"({"fault": "lead_off", "from_s": -1})"
                                    << "from_s";
  QTest::newRow("of another axis") << R"({"fault": "load_N", "value": 1})"
                                   << "load_Nm";
}

void TestWiring::wrongFile_isRefused() {
  QFETCH(QString, wiring);
  QFETCH(QString, words);
  const auto drive = openDrive("simulated:" + rigWith("servo", wiring).toStdString(), 1);
  QVERIFY(!drive);
  const QString message = QString::fromStdString(drive.error().message());
  QVERIFY2(message.contains("wiring") && message.contains(words), qPrintable(message));
}

QTEST_GUILESS_MAIN(TestWiring)
#include "tst_wiring.moc"
