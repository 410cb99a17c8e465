// The wiring check, by a few small pulses: a sound bench passes whatever motor it has, and each fault is told by its
// signature, within a tenth of a turn.
#include <QTest>
#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/numbers.h"
#include "commission/job.h"
#include "firmware_link/simulated_board.h"
#include "plant/rig.h"
#include "support/random_rig.h"
#include "support/temporary.h"
#include "support/wired_rig.h"

using namespace breakaway;
using namespace breakaway::test;

class TestWiringCheck : public QObject {
  Q_OBJECT
 private slots:
  void soundPreset_isMeasured_data();
  void soundPreset_isMeasured();
  void soundRandomRig_passes();
  void fault_isNamed_data();
  void fault_isNamed();
  void leadOffUnderMuchNoise_isNamed();
  void load_isSaidWithItsWay_data();
  void load_isSaidWithItsWay();
  void playWithALoadFreeOfFriction_isNoLoad_data();
  void playWithALoadFreeOfFriction_isNoLoad();
  void supplyMisread_isGoneOnWithOnlyAnyway();
  void anotherMotorOnResume_isTold();
  void heavyRotor_isGivenTime();
  void coarseBridge_isNoCurrentLimit_data();
  void coarseBridge_isNoCurrentLimit();
  void coarseEncoderOnAnyMotor_passes();
  void coarseEncoder_passes_data();
  void coarseEncoder_passes();
};

namespace {

constexpr double tenthOfATurn_rad = 0.628, fiftiethOfTravel_m = 0.008;

struct Checked {
  Result<Commission> done = Error{"", ""};
  double furthest = 0.0;  ///< of the encoder from where it was, once it was energised
  QString said() const {
    if (!done) return QString::fromStdString(done.error().message());
    QString words;
    for (const std::string& one :
         inWords(*done->wiring, done->sensorZero_A, done->noiseRms_A, done->identity.supply_V, done->identity.axis))
      words += QString::fromStdString(one) + "\n";
    return words;
  }
};

/// Zeroing and wiring check on a rig file's text.
Checked checked(const std::string& rig, CommissionOptions options = {}, unsigned seed = 1) {
  const TemporaryFolder folder;
  auto drive = openDrive("simulated:" + folder.write("r.rig.json", rig), seed);
  Checked all;
  if (!drive) {
    all.done = drive.error();
    return all;
  }
  options.keepRecordings = false;
  if (options.earlier) options.earlier->identity = (*drive)->identity();
  Job job(options, {Known::wiring});
  std::vector<Sample> samples;
  std::optional<double> start_rad;
  job.begin(**drive);
  while (job.running()) {
    samples.clear();
    if (!(*drive)->advance(0.25, samples)) break;
    for (const Sample& one : samples) {
      if (one.enabled && !start_rad) start_rad = one.angle_rad;
      if (start_rad) all.furthest = std::max(all.furthest, std::abs(one.angle_rad - *start_rad));
    }
    job.take(**drive, 0.25, samples, 0);
  }
  if (job.status().state == Procedure::State::finished)
    all.done = job.known();
  else
    all.done = job.failure();
  return all;
}

Rig rigOf(const std::string& text) {
  const TemporaryFolder folder;
  const auto rig = readRig(folder.write("r.rig.json", text));
  if (!rig) qFatal("%s", rig.error().message().c_str());
  return *rig;
}

constexpr const char* presets[] = {"servo", "geared", "uneven", "published-0134", "linear"};

}  // namespace

void TestWiringCheck::soundPreset_isMeasured_data() {
  QTest::addColumn<QString>("preset");
  for (const char* preset : presets) QTest::addRow("%s", preset) << preset;
}

/// And the few pulses see winding and back-EMF constant well enough for a factor of two.
void TestWiringCheck::soundPreset_isMeasured() {
  QFETCH(QString, preset);
  const std::string text = wiredRig(preset.toStdString(), "");
  const Checked all = checked(text);
  QVERIFY2(all.done.ok() && all.said().contains("count the same way") && all.said().contains("breaks loose"),
           qPrintable(all.said()));
  const Rig rig = rigOf(text);
  const bool linear = rig.axis == Axis::linear;
  const double perUnit = linear ? turn_rad / rig.travel.length_m : 1.0;
  QVERIFY2(all.furthest < (linear ? fiftiethOfTravel_m : tenthOfATurn_rad), qPrintable(QString::number(all.furthest)));
  const WiringFit& fit = *all.done->wiring;
  const double R = fit.resistance_ohm.value / rig.resistance_ohm;
  QVERIFY2(R > 0.9 && R < 1.1, qPrintable(QString::number(R)));
  const Estimate& Ke = fit.backEmf_V_s_per_rad;
  const double truth = perUnit * rig.backEmfConstant_V_s_per_rad;
  QVERIFY2(std::abs(Ke.value - truth) < 3.0 * Ke.standardError && Ke.standardError < 0.3 * truth,
           qPrintable(all.said()));
}

void TestWiringCheck::soundRandomRig_passes() {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const std::string text = RandomRig(seed).text(seed % 2 == 0);
    const Checked all = checked(text, {}, seed);
    QVERIFY2(all.done.ok(), qPrintable(QString("seed %1: ").arg(seed) + all.said()));
    QVERIFY2(all.furthest < tenthOfATurn_rad, qPrintable(QString("seed %1: %2").arg(seed).arg(all.furthest)));
    const WiringFit& fit = *all.done->wiring;
    const double R = fit.resistance_ohm.value / rigOf(text).resistance_ohm;
    QVERIFY2(R > 0.8 && R < 1.3, qPrintable(QString("seed %1: %2").arg(seed).arg(R)));
  }
}

void TestWiringCheck::fault_isNamed_data() {
  QTest::addColumn<QString>("preset");
  QTest::addColumn<QString>("wiring");
  QTest::addColumn<QString>("words");
  const std::pair<const char*, const char*> all[] = {
      {R"({"fault": "encoder_reversed"})", "swap the encoder's A and B"},
      {R"({"fault": "encoder_dead"})", "the encoder stands"},
      {R"({"fault": "current_sensor_reversed"})", "reversed"},
      {R"({"fault": "current_sensor_dead"})", "dead"},
      {R"({"fault": "bridge_reversed"})", "bridge is reversed"},
      {R"({"fault": "lead_off"})", "a lead of the motor is off"},
      {R"({"fault": "supply_reading_factor", "value": 1.1})", "divider"},
      {R"({"fault": "supply_reading_factor", "value": 0.85})", "divider"},
      {R"({"fault": "supply_reading_factor", "value": 2})", "divider"},
      {R"({"fault": "index_inverted"})", "inverted"},
  };
  for (const char* preset : presets) {
    for (const auto& [wiring, words] : all) QTest::addRow("%s, %s", preset, wiring) << preset << wiring << words;
  }
  for (const char* preset : {"servo", "geared", "uneven", "published-0134"})
    QTest::addRow("%s, hoist", preset) << preset << R"({"fault": "load_Nm", "value": 0.2})"
                                       << "a load pulls it";
  for (const auto& [preset, from] : {std::pair{"servo", "3.05"}, {"geared", "3.45"}, {"linear", "3.35"}})
    QTest::addRow("%s, a sensor that dies within the check", preset)
        << preset << QString(R"({"fault": "current_sensor_dead", "from_s": %1})").arg(from) << "dead";
  QTest::newRow("linear, hoist") << "linear"
                                 << R"({"fault": "load_N", "value": 30})"
                                 << "a load pulls it";
}

void TestWiringCheck::fault_isNamed() {
  QFETCH(QString, preset);
  QFETCH(QString, wiring);
  QFETCH(QString, words);
  const Checked all = checked(wiredRig(preset.toStdString(), wiring.toStdString()));
  QVERIFY2(!all.done.ok() && all.said().contains(words), qPrintable("said: " + all.said()));
  QVERIFY2(all.furthest < (preset == "linear" ? fiftiethOfTravel_m : tenthOfATurn_rad),
           qPrintable(QString::number(all.furthest)));
}

/// The board's watch means over 20 ms, which noise turns to either side.
void TestWiringCheck::leadOffUnderMuchNoise_isNamed() {
  const std::string rig = wiredRig("linear", R"({"fault": "lead_off"})");
  const size_t at = rig.find("\"noise_rms_A\":"), end = rig.find_first_of(",}", at);
  QVERIFY(at != std::string::npos);
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const Checked all = checked(rig.substr(0, at) + "\"noise_rms_A\": 0.4" + rig.substr(end), {}, seed);
    QVERIFY2(!all.done.ok() && all.said().contains("a lead of the motor is off"), qPrintable(all.said()));
  }
}

void TestWiringCheck::load_isSaidWithItsWay_data() {
  QTest::addColumn<QString>("preset");
  QTest::addColumn<QString>("wiring");
  QTest::addColumn<QString>("words");
  QTest::newRow("ccw") << "servo"
                       << R"({"fault": "load_Nm", "value": 0.01})"
                       << "acts counter-clockwise";
  QTest::newRow("cw") << "servo"
                      << R"({"fault": "load_Nm", "value": -0.01})"
                      << "acts clockwise";
  QTest::newRow("linear") << "linear"
                          << R"({"fault": "load_N", "value": -3})"
                          << "acts backwards";
  QTest::newRow("none") << "geared"
                        << ""
                        << "no load is seen";
  QTest::newRow("stop") << "servo"
                        << R"({"fault": "stop_at_rad", "value": 0.02})"
                        << "moves a little counter-clockwise and is stopped";
  QTest::newRow("linear stop") << "linear"
                               << R"({"fault": "stop_at_m", "value": 0.0003})"
                               << "moves a little forwards and is stopped";
}

void TestWiringCheck::load_isSaidWithItsWay() {
  QFETCH(QString, preset);
  QFETCH(QString, wiring);
  QFETCH(QString, words);
  const Checked all = checked(wiredRig(preset.toStdString(), wiring.toStdString()));
  QVERIFY2(all.done.ok() && all.said().contains(words), qPrintable("said: " + all.said()));
}

void TestWiringCheck::playWithALoadFreeOfFriction_isNoLoad_data() {
  QTest::addColumn<double>("gap_rad");
  for (const double gap_rad : {0.02, 0.06, 0.1}) QTest::addRow("%g rad", gap_rad) << gap_rad;
}

/// The encoder sits behind the gap, where nothing brakes it: once the motor has let go it goes to and fro for long.
void TestWiringCheck::playWithALoadFreeOfFriction_isNoLoad() {
  QFETCH(double, gap_rad);
  const std::string coupling =
      "{ \"coupling\": {\"stiffness_Nm_per_rad\": 5.4, \"load_inertia_kg_m2\": 6e-5, "
      "\"damping_Nm_s_per_rad\": 1.8e-3, \"gap_rad\": " +
      std::to_string(gap_rad) + "},";
  const Checked all = checked(replaced(wiredRig("servo", ""), "{", coupling));
  QVERIFY2(!all.said().contains("a load") || all.done.ok(), qPrintable(all.said()));
  QVERIFY2(all.done.ok() || all.said().contains("there is play"), qPrintable(all.said()));
  if (gap_rad > 0.05) QVERIFY2(all.said().contains("there is play"), qPrintable(all.said()));
}

void TestWiringCheck::supplyMisread_isGoneOnWithOnlyAnyway() {
  const std::string rig = wiredRig("servo", R"({"fault": "supply_reading_factor", "value": 1.1})");
  const Checked refused = checked(rig);
  QVERIFY2(!refused.done.ok() && refused.said().contains("1.1 times as much"), qPrintable(refused.said()));
  CommissionOptions options;
  options.anyway = true;
  const Checked all = checked(rig, options);
  QVERIFY2(all.done.ok() && all.done->contradictions.size() == 1, qPrintable(all.said()));
}

void TestWiringCheck::anotherMotorOnResume_isTold() {
  Commission earlier;
  earlier.facts = {Known::windingTest, Known::roughMotor, Known::reversal, Known::bridge, Known::motor};
  earlier.shownResistance_ohm = 1.2;
  earlier.identified.backEmfConstant_V_s_per_rad = {0.07, 1e-4};
  CommissionOptions options;
  options.earlier = earlier;
  const std::string rig = wiredRig("servo", "");
  const Checked same = checked(rig, options);
  QVERIFY2(same.done.ok(), qPrintable(same.said()));
  for (const char* other : {"\"resistance_ohm\": 3.6", "\"resistance_ohm\": 0.5"}) {
    const Checked all = checked(replaced(rig, "\"resistance_ohm\": 1.2", other), options);
    QVERIFY2(!all.done.ok() && all.said().contains("is another motor mounted?"), qPrintable(all.said()));
  }
}

/// Pulses of the usual length don't move it by what is motion, whatever the current.
void TestWiringCheck::heavyRotor_isGivenTime() {
  const Checked all = checked(RandomRig(302).text(true), {}, 302);
  QVERIFY2(all.done.ok() && all.said().contains("breaks loose"), qPrintable(all.said()));
  QVERIFY2(all.furthest < tenthOfATurn_rad, qPrintable(QString::number(all.furthest)));
}

/// Within a pulse a rotor may turn, and its current fall, by less than the encoder shows.
void TestWiringCheck::coarseEncoderOnAnyMotor_passes() {
  for (unsigned seed = 1; seed <= 16; ++seed) {
    auto rig = nlohmann::json::parse(RandomRig(seed).text());
    rig["encoder"]["counts_per_rev"] = seed % 2 == 0 ? 64 : 128;
    const Checked all = checked(rig.dump(), {}, seed);
    QVERIFY2(all.done.ok(), qPrintable(QString("seed %1: ").arg(seed) + all.said()));
  }
}

void TestWiringCheck::coarseBridge_isNoCurrentLimit_data() {
  QTest::addColumn<double>("pwmSteps");
  QTest::newRow("0.16 V") << 1000.0;
  QTest::newRow("0.63 V") << 256.0;
}

/// The first pulses ask for 0.02 V, of which a bridge of 160 V makes two steps or three in a pulse of thirty ticks.
void TestWiringCheck::coarseBridge_isNoCurrentLimit() {
  QFETCH(double, pwmSteps);
  auto rig = nlohmann::json::parse(wiredRig("servo", ""));
  rig["loop_rate_Hz"] = 500;
  rig["bridge"]["supply_V"] = 160.0;
  rig["bridge"]["pwm_steps"] = pwmSteps;
  const Checked all = checked(rig.dump());
  QVERIFY2(all.done.ok() && all.said().contains("breaks loose"), qPrintable(all.said()));
}

void TestWiringCheck::coarseEncoder_passes_data() {
  QTest::addColumn<int>("counts");
  for (const int counts : {64, 100, 400, 1000}) QTest::addRow("%d", counts) << counts;
}

/// Two counts of 64 are a fifth of a turn's tenth already: it moves further, but is not refused. Nor does it take the
/// encoder's rounding for another back-EMF constant.
void TestWiringCheck::coarseEncoder_passes() {
  QFETCH(int, counts);
  for (const char* preset : {"servo", "geared", "published-0134"}) {
    const bool fine = std::string(preset) == "geared";
    const std::string rig =
        replaced(wiredRig(preset, ""), fine ? "\"counts_per_rev\": 4096" : "\"counts_per_rev\": 14400",
                 "\"counts_per_rev\": " + std::to_string(counts));
    const Checked all = checked(rig);
    QVERIFY2(all.done.ok(), qPrintable(QString(preset) + ": " + all.said()));
    QVERIFY2(all.furthest < 2.0 * tenthOfATurn_rad, qPrintable(QString("%1: %2").arg(preset).arg(all.furthest)));
    const Estimate& Ke = all.done->wiring->backEmf_V_s_per_rad;
    if (!(Ke.standardError > 0.0)) continue;  // so small a motion doesn't tell it
    const double off = Ke.value / rigOf(rig).backEmfConstant_V_s_per_rad;
    QVERIFY2(off > 0.7 && off < 1.4, qPrintable(QString("%1: Ke %2 of the true one").arg(preset).arg(off)));
  }
}

QTEST_GUILESS_MAIN(TestWiringCheck)
#include "tst_wiring_check.moc"
