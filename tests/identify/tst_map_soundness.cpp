#include <QTest>
#include <cmath>

#include "base/random.h"
#include "identify/map_soundness.h"

using namespace breakaway;

class TestMapSoundness : public QObject {
  Q_OBJECT
 private slots:
  void soundMap_isOne();
  void breakawayBelowCoulomb_isNone();
  void movingFrictionThatMayBeNothing_isNone();
  void turnsThatDontRepeat_areNone();
  void noiseAroundAnEvenCurve_isOne();
  void binsWithoutBreakaways_areSaid();
  void binsBesideBreakaways_areACoarseEncodersOwn();
};

namespace {

/// Breakaways of 21 mNm that vary by `shared` alike in both turns, and by `own` in each for itself.
FrictionMap mapOf(double shared, double own, double coulomb_Nm = 0.017) {
  FrictionMap map;
  map.turns = 2;
  map.bins.resize(90);
  map.coulombAverage_Nm = {coulomb_Nm, 1e-4};
  Noise noise(5);
  for (size_t w = 0; w < 2; ++w) {
    map.turnStatic_Nm[w].assign(2, std::vector<double>(90));
    double ab = 0.0, aa = 0.0, bb = 0.0;
    for (size_t k = 0; k < 90; ++k) {
      const double common = shared * std::sin(0.2 * static_cast<double>(k));
      const double a = common + own * noise.normal(), b = common + own * noise.normal();
      map.turnStatic_Nm[w][0][k] = 0.021 * (1.0 + a), map.turnStatic_Nm[w][1][k] = 0.021 * (1.0 + b);
      map.bins[k].way[w].static_Nm = {0.021 * (1.0 + 0.5 * (a + b)), 2e-4};
      map.bins[k].way[w].samples = 2;
      ab += a * b, aa += a * a, bb += b * b;
    }
    map.repeatability[w].correlation = ab / std::sqrt(aa * bb);
  }
  return map;
}

}  // namespace

void TestMapSoundness::soundMap_isOne() {
  QVERIFY(unsoundness(mapOf(0.2, 0.01)).empty());
  QVERIFY(unsoundness(FrictionMap{}).empty());
}

void TestMapSoundness::breakawayBelowCoulomb_isNone() {
  const auto why = unsoundness(mapOf(0.2, 0.01, 0.025));
  QCOMPARE(why.size(), size_t{1});
  QVERIFY2(why[0].starts_with("what starts motion (21.1 mNm) is less than what keeps it up (25 mNm): "),
           why[0].c_str());
}

/// A load that came and went while one speed was run makes the line through all of them meet zero speed anywhere. What
/// the data leave open, or a rotor that rolls a third as hard as it starts, is no contradiction.
void TestMapSoundness::movingFrictionThatMayBeNothing_isNone() {
  FrictionMap map = mapOf(0.2, 0.01, 0.0003);
  map.coulombAverage_Nm.standardError = 0.0015;
  const auto why = unsoundness(map);
  QCOMPARE(why.size(), size_t{1});
  QVERIFY2(why[0].starts_with("what keeps motion up (0.3, -2.64 to 3.24 mNm) may be nothing"), why[0].c_str());
  map.coulombAverage_Nm = {0.004, 0.003};
  QVERIFY(unsoundness(map).empty());
  map.coulombAverage_Nm = {0.007, 1e-4};
  QVERIFY(unsoundness(map).empty());
}

void TestMapSoundness::turnsThatDontRepeat_areNone() {
  const auto why = unsoundness(mapOf(0.02, 0.2));
  QCOMPARE(why.size(), size_t{2});
  QVERIFY2(why[0].starts_with("clockwise turns correlate by "), why[0].c_str());
}

void TestMapSoundness::noiseAroundAnEvenCurve_isOne() {
  QVERIFY(unsoundness(mapOf(0.0, 0.03)).empty());
}

void TestMapSoundness::binsWithoutBreakaways_areSaid() {
  FrictionMap map = mapOf(0.2, 0.01);
  for (size_t k = 0; k < 25; ++k) map.bins[3 * k].way[1].samples = 0;
  const auto why = unsoundness(map);
  QCOMPARE(why.size(), size_t{1});
  QVERIFY2(why[0].starts_with("25 of 90 bins counter-clockwise have no breakaway"), why[0].c_str());
}

void TestMapSoundness::binsBesideBreakaways_areACoarseEncodersOwn() {
  FrictionMap map = mapOf(0.2, 0.01);
  for (size_t k = 0; k < 30; ++k) map.bins[3 * k].way[1].samples = map.bins[3 * k + 1].way[1].samples = 0;
  QCOMPARE(unsoundness(map).size(), size_t{1});
  QVERIFY(unsoundness(map, 1).empty());
  for (size_t k = 30; k < 60; ++k) map.bins[k].way[1].samples = 0;
  QCOMPARE(unsoundness(map, 1).size(), size_t{1});
}

QTEST_APPLESS_MAIN(TestMapSoundness)
#include "tst_map_soundness.moc"
