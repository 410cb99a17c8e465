#include <QTest>
#include <algorithm>
#include <cmath>
#include <set>

#include "recording/csv.h"
#include "support/sanitized.h"
#include "support/temporary.h"
#include "trial/sealed_trial.h"
#include "trial/trial_effects.h"
#include "trial/trial_recorder.h"
#include "trial/trial_sizing.h"

using namespace breakaway;
using namespace breakaway::test;

class TestTrial : public QObject {
  Q_OBJECT
 private slots:
  void families_areTheCatalogueAndNineMore();
  void everyFamily_isRecordedMovesAndIsReadBack_data();
  void everyFamily_isRecordedMovesAndIsReadBack();
  void sameSeed_givesTheSameBytes();
  void anotherSeed_givesAnotherRig();
  void drawnFamilies_coverAll();
  void bench_isNearTheTruthAndSaysNothingOfTheSecret();
  void plainRig_costsNothingToLeaveOut();
  void loadLeftOut_costsMuch();
  void truth_isOfTheFamily();
};

namespace {

std::string bytesOf(const SealedTrial& trial, const TemporaryFolder& folder) {
  if (!writeTrial(trial, folder.path())) return {};
  std::string all;
  for (const QString& name : folder.names()) all += readFile(folder.path(name.toStdString())).value();
  return all;
}

/// A rig and course without anything concealed.
std::pair<TrialRig, TrialCourse> plainRig(std::uint64_t seed) {
  Random random(seed);
  TrialRig rig = drawTrialRig({}, random);
  TrialCourse course = drawCourse(rig, {TrialMove::multisine, TrialMove::turns}, 20.0, random);
  return {rig, std::move(course)};
}

}  // namespace

void TestTrial::families_areTheCatalogueAndNineMore() {
  const auto families = trialFamilies();
  QCOMPARE(catalogueEffects().size(), size_t(27));
  QCOMPARE(families.size(), size_t(36));
  QCOMPARE(std::set(families.begin(), families.end()).size(), families.size());
  for (const TrialEffect& outside : outsideEffects())
    QVERIFY(!std::count(families.begin(), families.end(), outside.name));
}

void TestTrial::everyFamily_isRecordedMovesAndIsReadBack_data() {
  QTest::addColumn<QString>("family");
  size_t rows = 0;
  for (const std::string& family : trialFamilies())
    if (test::alsoRun(rows++, 6)) QTest::newRow(family.c_str()) << QString::fromStdString(family);
}

void TestTrial::everyFamily_isRecordedMovesAndIsReadBack() {
  QFETCH(QString, family);
  const SealedTrial trial = makeTrial(family.toStdString(), 7);
  const TemporaryFolder folder;
  VERIFY_OK(writeTrial(trial, folder.path()));
  const auto bench = readBench(folder.path("bench.json"));
  VERIFY_OK(bench);
  QVERIFY(!trial.recordings.empty());
  for (const Recording& made : trial.recordings) {
    const auto recording = readCsv(folder.path(made.name()));
    VERIFY_OK(recording);
    QVERIFY(recording->channels() == made.channels());
    QVERIFY(recording->has(bench->inputChannel()));
    const auto position = recording->channel(bench->positionChannel());
    const auto time = recording->time();
    const bool repeat = &made != &trial.recordings.front();
    QVERIFY(time.back() - time.front() > (repeat ? 19.0 : 29.0) && time.back() - time.front() < 61.0);
    double travel = 0.0;
    for (size_t k = 1; k < position.size(); ++k) {
      QVERIFY(std::isfinite(position[k]));
      travel += std::abs(position[k] - position[k - 1]);
    }
    QVERIFY2(travel > (bench->axis == Axis::rotary ? 12.0 : 0.5) && travel < 1e4, qPrintable(QString::number(travel)));
    QVERIFY(travel / bench->count() > 3000.0);
  }
}

void TestTrial::sameSeed_givesTheSameBytes() {
  for (const char* family : {"stribeck", "combination", "outside"}) {
    const TemporaryFolder one, two;
    const std::string first = bytesOf(makeTrial(family, 11), one);
    QVERIFY(first.size() > 100000 && first == bytesOf(makeTrial(family, 11), two));
  }
}

void TestTrial::anotherSeed_givesAnotherRig() {
  const SealedTrial one = makeTrial("cogging", 1), two = makeTrial("cogging", 2);
  QVERIFY(one.truth.front().parameters != two.truth.front().parameters);
  QVERIFY(one.recordings.front().channels() != two.recordings.front().channels());
}

void TestTrial::drawnFamilies_coverAll() {
  std::set<std::string> drawnOnes;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) drawnOnes.insert(familyOf(seed));
  QCOMPARE(drawnOnes.size(), trialFamilies().size());
}

void TestTrial::bench_isNearTheTruthAndSaysNothingOfTheSecret() {
  Random random(5);
  for (int k = 0; k < 200; ++k) {
    const TrialRig rig = drawTrialRig({}, random);
    const Bench bench = believedBench(rig, random);
    const PlantPhysics& p = rig.physics;
    double own = p.totalInertia();
    if (const auto& hung = rig.pendulum) {
      own -= hung->mass_kg * hung->length_m * hung->length_m;
      QCOMPARE(hung->mass_kg * 9.81 * hung->length_m, p.position.front().amplitude);
      QVERIFY(bench.pendulum && std::abs(bench.pendulum->downAngle_rad - hung->downAngle_rad) <= 0.2);
    }
    if (bench.motor.inertia) QVERIFY(std::abs(*bench.motor.inertia / own - 1.0) <= 0.3);
    if (bench.motor.coulomb) QVERIFY(std::abs(std::log(*bench.motor.coulomb / rig.coulomb())) <= std::log(2.01));
    if (bench.motor.torqueConstant) QCOMPARE(*bench.motor.torqueConstant, p.torqueConstant);
    const double share = rig.coulomb() / rig.peakTorque;
    QVERIFY(share >= 0.0199 && share <= 0.2001);
    QCOMPARE(bench.count(), rig.sensors.count);
  }
}

void TestTrial::plainRig_costsNothingToLeaveOut() {
  for (std::uint64_t seed = 1; seed < 6; ++seed) {
    const auto [rig, course] = plainRig(seed);
    TrialTrace trace;
    const Recording recording = recordTrial(rig, course, "plain", seed, &trace);
    QCOMPARE(recording.rows(), trace.position.size());
    const double cost = costOfLeavingOut(rig, trace);
    QVERIFY2(cost < 1.0, qPrintable(QString::number(cost)));
  }
}

void TestTrial::loadLeftOut_costsMuch() {
  auto [rig, course] = plainRig(3);
  rig.physics.load = -0.5 * rig.coulomb();
  TrialTrace trace;
  (void)recordTrial(rig, course, "loaded", 3, &trace);
  const double cost = costOfLeavingOut(rig, trace);
  QVERIFY2(cost > 5.0 && cost < 1e5, qPrintable(QString::number(cost)));
}

void TestTrial::truth_isOfTheFamily() {
  QCOMPARE(makeTrial("backlash", 3).truth.front().effect, std::string("backlash"));
  QVERIFY(makeTrial("clean", 3).truth.empty());
  const SealedTrial outside = makeTrial("outside", 3);
  QCOMPARE(outside.truth.size(), size_t(1));
  QCOMPARE(outside.truth.front().effect, outside.outside);
  QVERIFY(makeTrial("combination", 3).truth.size() >= 2);
  QCOMPARE(makeTrial("masked", 3).truth.size(), size_t(1));
}

QTEST_APPLESS_MAIN(TestTrial)
#include "tst_trial.moc"
