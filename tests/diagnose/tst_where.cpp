#include <QTest>
#include <algorithm>
#include <cmath>

#include "base/statistics.h"
#include "diagnose/effects/catalogue.h"
#include "diagnose/fit/preparation.h"
#include "diagnose/verdict/block_maps.h"
#include "diagnose/verdict/explained.h"
#include "diagnose/verdict/foretelling.h"
#include "diagnose/verdict/next_experiment.h"
#include "diagnose/verdict/proof.h"
#include "diagnose/verdict/where.h"
#include "diagnose/verdict/worth_saying.h"
#include "support/known_servo.h"
#include "support/recorded_rig.h"
#include "support/temporary.h"
#include "support/within.h"

using namespace breakaway;
using namespace breakaway::test;

namespace {

constexpr double degree = 3.14159265358979 / 180.0;

/// Sums of unit noise over 8 cells and 40 blocks, with `shift` in one cell.
BlockMap noisyMap(unsigned seed, double shift) {
  Random random(seed);
  BlockMap map{std::vector<std::vector<double>>(8, std::vector<double>(40)), std::vector<double>(8, 40.0)};
  for (auto& cell : map.sums) {
    for (double& sum : cell) sum = random.normal() + (&cell == &map.sums[3] ? shift : 0.0);
  }
  return map;
}

/// Friction that is `mNm` higher between 40° and 95° than elsewhere.
ResidualMap frictionOverAngle(double mNm) {
  ResidualMap map;
  map.axis = "angle";
  map.unit = "rad";
  map.shows = Unknown::friction;
  map.share = 0.6;
  map.pValue = 0.002;
  for (int cell = 0; cell < 72; ++cell) {
    const double torque = cell >= 8 && cell < 19 ? 1e-3 * mNm : 0.0;
    map.centre.push_back((5.0 * cell + 2.5) * degree);
    map.width.push_back(5.0 * degree);
    for (auto* values : {&map.mean, &map.rising, &map.falling}) values->push_back(torque);
    map.error.push_back(1e-5);
    map.count.push_back(100.0);
  }
  return map;
}

Excitation rotaryMotion() {
  Excitation seen;
  seen.electrical = seen.bothWays = true;
  seen.step_s = 1e-3;
  seen.duration_s = 30.0;
  seen.lowSpeed = 1.0;
  seen.highSpeed = 20.0;
  seen.travel = seen.highest = 30.0;
  seen.count = 1e-3;
  seen.peakTorque = 0.1;
  seen.peakCurrent = 1.0;
  seen.peakInput = 12.0;
  seen.starts = seen.reversals = 30;
  seen.longestRest_s = 2.0;
  seen.inertia = 1e-4;
  seen.coulomb = 0.01;
  return seen;
}

/// Between the points beside it.
double valueAt(const Course& course, double place) {
  const auto next = std::lower_bound(course.at.begin(), course.at.end(), place);
  if (next == course.at.begin() || next == course.at.end()) return std::nan("");
  const auto k = static_cast<size_t>(next - course.at.begin());
  const double part = (place - course.at[k - 1]) / (course.at[k] - course.at[k - 1]);
  return course.value[k - 1] + part * (course.value[k] - course.value[k - 1]);
}

}  // namespace

class TestWhere : public QObject {
  Q_OBJECT
 private slots:
  void shiftInOneCell_isSignificant_noiseIsNot();
  void whatLasts_isOneEvent();
  void higherFrictionOverAStretch_isSaidInDegreesBothWays();
  void stretchOverZero_isOnePlace();
  void insignificantMap_isNoPlace();
  void strongerMapByChance_givesWayToASureOne();
  void mapOfWhatComesAgain_foretellsIt();
  void mapOfChance_foretellsNothing();
  void frictionWhileBraking_isTheSameBothWays();
  void frictionAlongTheMotion_isSaidAsWhatTheMotorOrTheSpeedDoes();
  void whatItsIntervalsRefute_isNotWorthSaying();
  void whiteSeries_isWhite_andADriftIsNot();
  void rivals_getOneExperimentThatTellsThemApart();
  void nothingMissing_namesWhatThisRecordingCouldNotShow();
  void outsideCatalogue_looksCloserAtThePlace();
  void whatFindingsSay_isTheirLawOverTheMap();
};

void TestWhere::shiftInOneCell_isSignificant_noiseIsNot() {
  int falseAlarms = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const std::vector<BlockMap> maps{noisyMap(seed, 0.0), noisyMap(seed + 1000, 0.0)};
    const auto found = significances(maps, 40, seed);
    falseAlarms += found[0].pValue <= 0.05 || found[1].pValue <= 0.05 ? 1 : 0;
  }
  QVERIFY2(falseAlarms <= 6, qPrintable(QString::number(falseAlarms)));  // 5 % of 40, and three deviations
  const auto found = significances({noisyMap(1, 0.0), noisyMap(2, 2.0)}, 40, 1);
  QVERIFY(found[1].pValue <= 0.01);
  QVERIFY(found[0].pValue > 0.05);
  QVERIFY2(found[1].energy > 100.0 && found[1].energy < 250.0, qPrintable(QString::number(found[1].energy)));
}

/// A residual that lasts for four blocks comes into its cell four times by one chance.
void TestWhere::whatLasts_isOneEvent() {
  const auto falseAlarms = [](size_t together) {
    int count = 0;
    for (unsigned seed = 1; seed <= 40; ++seed) {
      BlockMap map = noisyMap(seed, 0.0);
      for (auto& cell : map.sums) {
        for (size_t block = 0; block < cell.size(); ++block) cell[block] = cell[block - block % 4];
      }
      count += significances({map}, 40, seed, together)[0].pValue <= 0.05 ? 1 : 0;
    }
    return count;
  };
  QVERIFY2(falseAlarms(1) > 10, qPrintable(QString::number(falseAlarms(1))));
  QVERIFY2(falseAlarms(4) <= 6, qPrintable(QString::number(falseAlarms(4))));
}

void TestWhere::higherFrictionOverAStretch_isSaidInDegreesBothWays() {
  const auto found = places({frictionOverAngle(1.8)}, Model{});
  QCOMPARE(found.size(), size_t(1));
  QCOMPARE(found.front().sentence,
           std::string("The axis needs 1.8 mNm more than the model between 40° and 95°, both ways."));
  QVERIFY(std::abs(found.front().from - 40.0 * degree) < 1e-9 && std::abs(found.front().to - 95.0 * degree) < 1e-9);
  QVERIFY(std::abs(found.front().share - 0.6) < 1e-9);
  QVERIFY(std::abs(found.front().size - 1.8e-3) < 1e-9);
  QVERIFY(found.front().shows == Unknown::friction && !found.front().ofSomeSpeeds);
  const auto lower = places({frictionOverAngle(-1.8)}, Model{});
  QCOMPARE(lower.front().sentence,
           std::string("The axis needs 1.8 mNm less than the model between 40° and 95°, both ways."));
}

void TestWhere::stretchOverZero_isOnePlace() {
  ResidualMap map = frictionOverAngle(1.8);
  for (auto* values : {&map.mean, &map.rising, &map.falling})
    std::rotate(values->begin(), values->begin() + 13, values->end());
  map.orders = {{1, 4e-4}, {2, 4e-4}, {3, 3e-4}};
  const auto found = places({map}, Model{});
  QCOMPARE(found.front().sentence,
           std::string("The axis needs 1.8 mNm more than the model between −25° and 30°, both ways."));
}

void TestWhere::insignificantMap_isNoPlace() {
  ResidualMap map = frictionOverAngle(1.8);
  map.pValue = 0.2;
  QVERIFY(places({map}, Model{}).empty());
}

void TestWhere::strongerMapByChance_givesWayToASureOne() {
  ResidualMap chance = frictionOverAngle(5.0), sure = frictionOverAngle(1.8);
  chance.pValue = 0.2;
  sure.shows = Unknown::torque;
  sure.share = 0.3;
  const auto found = places({chance, sure}, Model{});
  QCOMPARE(found.size(), size_t(1));
  QVERIFY(found.front().shows == Unknown::torque);  // which a picture of the place draws
  QVERIFY(std::abs(found.front().size - 1.8e-3) < 1e-9);
}

/// Twenty seconds of turns at 3 rad/s, with friction that is `shift` Nm higher between 40° and 95°, and noise.
Instants turnsWith(double shift, double noise, unsigned seed) {
  Random random(seed);
  Instants instants;
  for (size_t k = 0; k < 2000; ++k) {
    const double time = 0.01 * static_cast<double>(k), angle = std::fmod(3.0 * time, 360.0 * degree);
    const double torque = angle >= 40.0 * degree && angle < 95.0 * degree ? shift : 0.0;
    instants.value.push_back(torque + noise * random.normal());
    instants.way.push_back(1.0);
    instants.block.push_back(k / 100);
    for (auto& along : instants.along) along.push_back(0.0);
    instants.along[byAngle].back() = angle;
    instants.along[byVelocity].back() = 3.0;
  }
  return instants;
}

void TestWhere::mapOfWhatComesAgain_foretellsIt() {
  const Foretold found = foretold(frictionOverAngle(1.8), byAngle, turnsWith(1.8e-3, 5e-4, 1), 1);
  QVERIFY2(found.low95 > 0.3 && found.value < 0.9, qPrintable(QString::number(found.value)));
  QVERIFY(found.low95 <= found.value && found.value <= found.high95);
}

void TestWhere::mapOfChance_foretellsNothing() {
  for (const unsigned seed : {1u, 2u, 3u}) {
    const Foretold found = foretold(frictionOverAngle(0.3), byAngle, turnsWith(0.0, 1e-3, seed), seed);
    QVERIFY2(found.low95 <= 0.0, qPrintable(QString::number(found.low95)));
  }
  QCOMPARE(foretold(frictionOverAngle(1.8), byAngle, {}, 1).high95, 0.0);  // nothing was held out
}

/// Friction that is 2 mNm higher while the motor brakes, over the drive's torque along the motion.
ResidualMap frictionWhileBraking() {
  ResidualMap map = frictionOverAngle(0.0);
  map.axis = "current";
  map.unit = "Nm";
  map.along = byTorque;
  for (size_t cell = 0; cell < map.centre.size(); ++cell) {
    map.width[cell] = 1e-3;
    map.centre[cell] = 1e-3 * (static_cast<double>(cell) - 35.5);
    if (map.centre[cell] > 0.0) continue;
    for (auto* values : {&map.mean, &map.rising, &map.falling}) (*values)[cell] = 2e-3;
  }
  return map;
}

void TestWhere::frictionWhileBraking_isTheSameBothWays() {
  Instants instants;
  for (size_t k = 0; k < 2000; ++k) {
    const double way = k / 150 % 2 == 0 ? 1.0 : -1.0, torque = k / 70 % 2 == 0 ? 0.02 : -0.02;
    instants.value.push_back(way * torque < 0.0 ? way * 2e-3 : 0.0);
    instants.way.push_back(way);
    instants.block.push_back(k / 100);
    for (auto& along : instants.along) along.push_back(0.0);
    instants.along[byTorque].back() = torque;
  }
  QVERIFY(foretold(frictionWhileBraking(), byTorque, instants, 1).low95 > 0.99);
}

void TestWhere::frictionAlongTheMotion_isSaidAsWhatTheMotorOrTheSpeedDoes() {
  const auto said = [](const ResidualMap& map) {
    return QString::fromStdString(places({map}, Model{}).front().sentence.english());
  };
  ResidualMap map = frictionWhileBraking();
  QCOMPARE(said(map), "While the motor brakes with 0 Nm to 36 mNm the axis needs 2 mNm more than the model.");
  map.axis = "acceleration";
  map.along = bySpeedingUp;
  QVERIFY2(said(map).startsWith("While it slows down by 0 rad/s² to 0.036 rad/s²"), qPrintable(said(map)));
}

void TestWhere::whatItsIntervalsRefute_isNotWorthSaying() {
  Model model = servoModel(DriveInput::torque);
  Excitation seen = rotaryMotion();
  seen.peakInput = 0.1;
  seen.duration_s = 60.0;
  const TorqueNoise none, quick{.time_s = 0.1, .rms = 3e-4}, slow{.time_s = 10.0, .rms = 3e-4};
  const auto load = [](double value, double low, double high) {
    return EffectTerm{.effect = "constant_load", .parameters = {{"load_Nm", value, low, high}}};
  };
  QVERIFY(worthSaying(load(1e-3, 8e-4, 1.2e-3), model, seen, none));
  QVERIFY(!worthSaying(load(1e-3, -8e-4, 3e-3), model, seen, none));  // may be zero
  // Over a minute a quick wander averages out, a slow one may well look like that.
  QVERIFY(worthSaying(load(4e-4, 3e-4, 5e-4), model, seen, quick));
  QVERIFY(!worthSaying(load(4e-4, 3e-4, 5e-4), model, seen, slow));
  QVERIFY(!worthSaying(load(0.2, 0.19, 0.21), model, seen, none));  // the drive gives 0.1 Nm
  // A limit between nothing and anything, alone and beside a slope that is known.
  EffectTerm clipped{.effect = "command_saturation",
                     .parameters = {{"limit", 3.4, 0.003, 3e3}, {"slew_per_s", 3.2, 3.2, 3.2}}};
  QVERIFY(!worthSaying(clipped, model, seen, none));
  clipped.parameters[1] = {"slew_per_s", 3.2, 2.3, 4.5};
  QVERIFY(worthSaying(clipped, model, seen, none) && !isKnown(clipped, 0, model.axis) &&
          isKnown(clipped, 1, model.axis));
}

void TestWhere::whiteSeries_isWhite_andADriftIsNot() {
  Random random(7);
  std::vector<double> white, drifting;
  double state = 0.0;
  for (int k = 0; k < 200; ++k) {
    white.push_back(random.normal());
    drifting.push_back(state = 0.8 * state + random.normal());
  }
  QVERIFY2(whitenessOf(white).pValue > 0.01, qPrintable(QString::number(whitenessOf(white).pValue)));
  QVERIFY(whitenessOf(drifting).pValue < 1e-6);
  QVERIFY(std::abs(whitenessOf(white).lag1) < 0.25);
  QVERIFY(whitenessOf(drifting).lag1 > 0.6 && whitenessOf(drifting).lag1 < 0.95);
  QCOMPARE(whitenessOf({1.0, 2.0}).pValue, 1.0);
}

void TestWhere::rivals_getOneExperimentThatTellsThemApart() {
  const std::vector<Finding> findings{
      {.effect = "stribeck", .ambiguousWith = {"presliding"}, .parameters = {}, .sentence = {}}};
  Bench bench;
  bench.controller.currentLimit_A = 4.0;
  const NextExperiment next = nextExperiment(Verdict::ambiguous, findings, {}, bench, rotaryMotion());
  QCOMPARE(next.separates, (std::vector<std::string>{"stribeck", "presliding"}));
  const QString sentence = QString::fromStdString(next.sentence);
  QVERIFY2(sentence.startsWith("To tell stribeck from presliding: "), qPrintable(sentence));
  QVERIFY2(sentence.contains("What follows the speed is stribeck; what shows right after each reversal is presliding."),
           qPrintable(sentence));
  QVERIFY2(sentence.endsWith("Stay within 4 A."), qPrintable(sentence));
}

void TestWhere::nothingMissing_namesWhatThisRecordingCouldNotShow() {
  Excitation seen = rotaryMotion();
  seen.currentSeen = true;
  QVERIFY(unseenEffects(seen).empty());
  QVERIFY(nextExperiment(Verdict::nothingMissing, {}, {}, {}, seen).sentence.empty());
  seen.bothWays = false;
  seen.reversals = seen.starts = 0;
  const auto unseen = unseenEffects(seen);
  QVERIFY(std::find(unseen.begin(), unseen.end(), "constant_load") != unseen.end());
  const QString sentence = QString::fromStdString(nextExperiment(Verdict::nothingMissing, {}, {}, {}, seen).sentence);
  QVERIFY2(sentence.contains("constant_load") && sentence.contains("Reverse at least twenty times"),
           qPrintable(sentence));
}

void TestWhere::outsideCatalogue_looksCloserAtThePlace() {
  const std::vector<Place> where{
      {.axis = "angle", .from = 40.0 * degree, .to = 95.0 * degree, .unit = "rad", .sentence = {}, .sizeUnit = {}}};
  const QString sentence =
      QString::fromStdString(nextExperiment(Verdict::outsideCatalogue, {}, where, {}, rotaryMotion()).sentence);
  QVERIFY2(sentence.startsWith("Move to and fro between 40° and 95°, slowly at 6 rad/s and again at 20 rad/s"),
           qPrintable(sentence));
}

/// Of a constant load a base model takes up a part as friction, which is the same to both ways: the mean of both ways
/// is the load. More viscous friction it takes up by itself, and nothing is left of it. Where a map knows nothing,
/// neither does the law.
void TestWhere::whatFindingsSay_isTheirLawOverTheMap() {
  constexpr double load_Nm = 0.005, more = 1e-4;
  const auto rig = recordRig({.seconds = 12.0});
  const auto prepared = prepare(rig.bench, {rig.recording}, {}, 0.5);
  VERIFY_OK(prepared);
  const Model base = servoModel(DriveInput::voltage);
  const auto maps = residualMaps(base, prepared->training, 1);
  const auto over = std::find_if(maps.begin(), maps.end(), [](const ResidualMap& map) {
    return map.axis == "velocity" && map.shows == Unknown::torque;
  });
  QVERIFY(over != maps.end());
  ResidualMap map = *over;
  const size_t unknown = map.mean.size() / 4;
  map.mean[unknown] = std::nan("");
  Model loaded = base, viscous = base;
  loaded.effects.push_back(effectTerm(*findEffect("constant_load"), {load_Nm}));
  for (Parameter& one : viscous.base) one.value += one.name == "viscous_Nm_s_per_rad" ? more : 0.0;
  const Course law = explainedOver(map, base, loaded, prepared->training);
  const Course none = explainedOver(map, base, viscous, prepared->training);
  QVERIFY2(law.at.size() > map.centre.size(), qPrintable(QString::number(law.at.size())));
  QCOMPARE(none.at, law.at);
  const double from = map.centre[unknown] - 0.5 * map.width[unknown], to = from + map.width[unknown];
  bool gap = false;
  for (size_t k = 0; k < law.at.size(); ++k) {
    const bool inside = law.at[k] > from && law.at[k] < to;
    QCOMPARE(std::isfinite(law.value[k]), !inside);
    gap = gap || inside;
    if (!inside) QVERIFY(std::abs(none.value[k]) < 0.02 * more * map.centre.back());
  }
  QVERIFY(gap);
  const double most = std::min(-law.at.front(), law.at.back());
  for (const double part : {0.5, 0.6, 0.7, 0.8}) {
    const double there = valueAt(law, part * most), back = valueAt(law, -part * most);
    const QString where = QString("%1 and %2 at %3").arg(there).arg(back).arg(part * most);
    QVERIFY2(within(0.5 * (there + back), load_Nm, 0.02), qPrintable(where));
  }
}

QTEST_APPLESS_MAIN(TestWhere)
#include "tst_where.moc"
