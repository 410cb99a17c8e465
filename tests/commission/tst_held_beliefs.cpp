// A bench file that is wrong is told with its factor, or does no harm; an honest one is never refused.
#include <QTest>
#include <cmath>

#include "base/atomic_file.h"
#include "commission/held_beliefs.h"
#include "commission/job.h"
#include "commission/measured_bench.h"
#include "support/misled_bench.h"
#include "support/random_rig.h"
#include "support/sanitized.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

class TestHeldBeliefs : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void fieldOffByAFactor_isFoundOrHarmless_data();
  void fieldOffByAFactor_isFoundOrHarmless();
  void declarations_areHeldBeforeAnythingMoves();
  void constantThatContradicts_mayBeTheCounts_data();
  void constantThatContradicts_mayBeTheCounts();
  void contradiction_isGoneOnWithAndStaysInTheFiles();
  void trustThatWasMeasuredAnew_isWithdrawn();
  void mapThatDoesntRepeat_isNone();
  void honestBeliefs_areNeverRefused_data();
  void honestBeliefs_areNeverRefused();

 private:
  std::string preset(const char* name) const { return folder_ + "/resources/presets/" + name; }
  Bench bench(const char* name) const;
  std::string folder_;
};

namespace {

constexpr double Ke = 0.07, R = 1.2, J = 6e-5;  // of the preset servo

bool within(double value, double truth, double part) {
  return std::abs(value / truth - 1.0) < part;
}

/// The number before "times as much".
double factorIn(const std::string& words) {
  const size_t end = words.find(" times as much");
  if (end == std::string::npos) return 0.0;
  const size_t begin = words.rfind(' ', end - 1);
  return std::stod(words.substr(begin + 1, end - begin - 1));
}

}  // namespace

void TestHeldBeliefs::initTestCase() {
  folder_ = qgetenv("BREAKAWAY_SOURCE_DIR").toStdString();
  qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

Bench TestHeldBeliefs::bench(const char* name) const {
  auto read = readBench(preset(name) + ".bench.json");
  if (!read) qFatal("%s", read.error().message().c_str());
  return *read;
}

void TestHeldBeliefs::fieldOffByAFactor_isFoundOrHarmless_data() {
  QTest::addColumn<int>("field");
  QTest::addColumn<double>("factor");
  size_t rows = 0;
  for (size_t field = 0; field < believedFields.size(); ++field) {
    for (const double factor : mistakenFactors)
      if (test::alsoRun(rows++, 5))
        QTest::addRow("%s by %g", believedFields[field].name, factor) << static_cast<int>(field) << factor;
  }
}

void TestHeldBeliefs::fieldOffByAFactor_isFoundOrHarmless() {
  QFETCH(int, field);
  QFETCH(double, factor);
  Bench wrong = bench("servo");
  *believedFields[static_cast<size_t>(field)].value(wrong) *= factor;
  const auto done = identifiedWith("simulated:servo", wrong);
  if (!done) {
    QCOMPARE(done.error().place, std::string(contradictionPlace));
    QVERIFY2(within(factorIn(done.error().fact), factor, 0.03), done.error().fact.c_str());
    return;
  }
  const IdentifiedMotor& motor = done->motor;
  QVERIFY(within(motor.backEmfConstant_V_s_per_rad.value, Ke, 0.02) && within(motor.inertia_kg_m2.value, J, 0.05) &&
          within(motor.resistance_ohm.value, R, 0.05) && within(motor.torqueConstant_Nm_per_A.value, Ke, 0.02));
}

void TestHeldBeliefs::declarations_areHeldBeforeAnythingMoves() {
  Bench wrong = bench("servo");
  wrong.countsPerUnit = 3600.0;
  wrong.supply_V = 48.0;
  auto drive = openDrive("simulated:servo", 3);
  VERIFY_OK(drive);
  CommissionOptions options;
  options.bench = wrong;
  Job job(options, Facts{Known::motor});
  job.begin(**drive);
  QVERIFY(!job.running());
  const std::string words = job.failure().message();
  QVERIFY2(words.find("counts_per_rev is 3600, but the board says 14400") != std::string::npos &&
               words.find("supply_V is 48, but the board says 24") != std::string::npos,
           words.c_str());
}

void TestHeldBeliefs::constantThatContradicts_mayBeTheCounts_data() {
  QTest::addColumn<double>("measuredPart");
  QTest::addColumn<double>("resistancePart");
  QTest::addColumn<QString>("words");
  const QString counts = "a turn has about %1 counts, not 14400";
  QTest::newRow("counts x1.5") << 1.0 / 1.5 << 1.0 << counts.arg(21600);
  QTest::newRow("counts x1.6, near a phase for two leads") << 1.0 / 1.6 << 1.0 << counts.arg(23040);
  QTest::newRow("counts x4, which the suggestion names") << 0.25 << 1.0 << "four edges";
  QTest::newRow("resistance, too: another motor") << 1.0 / 1.5 << 0.1 << "";
  QTest::newRow("a unit") << 1e-3 << 1.0 << "";
}

void TestHeldBeliefs::constantThatContradicts_mayBeTheCounts() {
  QFETCH(double, measuredPart);
  QFETCH(double, resistancePart);
  QFETCH(QString, words);
  CommissionOptions options;
  options.bench = bench("servo");
  Commission known;
  known.identity.countsPerRev = 14400.0;
  known.identity.supply_V = 24.0;
  known.wiring = WiringFit{};
  known.wiring->supply_V = 24.0;
  known.wiring->resistance_ohm = {resistancePart * R, 0.01 * R};
  known.wiring->backEmf_V_s_per_rad = {measuredPart * Ke, 0.001 * Ke * measuredPart};
  const auto held = holdWiring(options, known);
  QVERIFY(!held);
  const QString said = QString::fromStdString(held.error().message());
  QVERIFY2(said.contains("times as much") && said.contains(words), qPrintable(said));
  QCOMPARE(said.contains("a turn has about"), words.startsWith("a turn has"));
}

void TestHeldBeliefs::contradiction_isGoneOnWithAndStaysInTheFiles() {
  Bench wrong = bench("servo");
  wrong.motor.resistance_ohm = 5.0;
  wrong.trusted.insert("resistance_ohm");
  const auto refused = identifiedWith("simulated:servo", wrong);
  QVERIFY(!refused && refused.error().place == contradictionPlace);
  const auto done = identifiedWith("simulated:servo", wrong, 3, true);
  VERIFY_OK(done);
  QVERIFY(!done->contradictions.empty());
  QCOMPARE(done->bench.remarks, std::vector<std::string>(done->contradictions.begin(), done->contradictions.end()));
  TemporaryFolder folder;
  VERIFY_OK(writeBench(done->bench, folder.path("b.json")));
  const auto read = readBench(folder.path("b.json"));
  VERIFY_OK(read);
  QCOMPARE(read->remarks, std::vector<std::string>(done->contradictions.begin(), done->contradictions.end()));
}

void TestHeldBeliefs::trustThatWasMeasuredAnew_isWithdrawn() {
  Bench trusting = bench("servo");
  trusting.trusted = {"torque_constant_Nm_per_A", "resistance_ohm"};
  const auto done = identifiedWith("simulated:servo", trusting);
  VERIFY_OK(done);
  QCOMPARE(done->bench.trusted, std::set<std::string>{"torque_constant_Nm_per_A"});
  QVERIFY(within(*done->bench.motor.resistance_ohm, R, 0.05));
}

/// Each breakaway differs from the next by more than half.
void TestHeldBeliefs::mapThatDoesntRepeat_isNone() {
  auto rig = readFile(preset("servo") + ".rig.json");
  VERIFY_OK(rig);
  const std::string scatter = "\"scatter_rms\": ";
  const size_t at = rig->find(scatter);
  QVERIFY(at != std::string::npos);
  rig->replace(at, rig->find_first_of(",}", at) - at, scatter + "0.3");
  TemporaryFolder folder;
  const std::string uri = "simulated:" + folder.write("servo.rig.json", *rig);
  for (const bool anyway : {false, true}) {
    auto drive = openDrive(uri, 3);
    VERIFY_OK(drive);
    CommissionOptions options;
    options.sweeps.bins = 24;
    options.sweeps.speedRun_s = 3.0;
    options.keepRecordings = false;
    options.anyway = anyway;
    Job job(options, Facts{Known::map});
    std::vector<Sample> samples;
    job.begin(**drive);
    while (job.running()) {
      samples.clear();
      const auto lost = (*drive)->advance(0.25, samples);
      VERIFY_OK(lost);
      job.take(**drive, 0.25, samples, *lost);
    }
    if (anyway) {
      QVERIFY2(job.failure().fact.empty() && !job.known().map.remarks.empty(), job.failure().message().c_str());
    } else {
      QVERIFY2(job.failure().fact.find("this is no friction map: ") != std::string::npos &&
                   job.failure().fact.find("correlate by") != std::string::npos,
               job.failure().message().c_str());
      QVERIFY(!job.known().knows(Known::map) && !job.known().breakaways.empty());
    }
  }
}

void TestHeldBeliefs::honestBeliefs_areNeverRefused_data() {
  QTest::addColumn<int>("seed");
  QTest::addColumn<bool>("honest");
  for (int seed = 1; seed <= static_cast<int>(test::seedsToTry(24)); ++seed)
    QTest::addRow("random rig %d", seed) << seed << (seed % 2 == 0);
}

/// The rig's own values, each up to 30 % off.
void TestHeldBeliefs::honestBeliefs_areNeverRefused() {
  QFETCH(int, seed);
  QFETCH(bool, honest);
  TemporaryFolder folder;
  const std::string uri =
      "simulated:" + folder.write("r.rig.json", RandomRig(static_cast<unsigned>(seed)).text(honest));
  const auto known = identifiedWith(uri, {}, static_cast<unsigned>(seed));
  VERIFY_OK(known);
  Bench belief = known->bench;
  belief.trusted.clear();
  Random chance(static_cast<unsigned>(seed));
  for (std::optional<double>* one : {&belief.motor.torqueConstant, &belief.motor.resistance_ohm,
                                     &belief.motor.inductance_H, &belief.motor.inertia}) {
    if (*one) **one *= std::pow(1.3, 2.0 * chance.uniform() - 1.0);
  }
  belief.motor.backEmfConstant = belief.motor.torqueConstant;
  const auto done = identifiedWith(uri, belief, static_cast<unsigned>(seed));
  VERIFY_OK(done);
  QVERIFY(done->contradictions.empty());
}

QTEST_GUILESS_MAIN(TestHeldBeliefs)
#include "tst_held_beliefs.moc"
