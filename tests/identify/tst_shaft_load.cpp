#include <QTest>
#include <cmath>

#include "identify/shaft_load.h"

using namespace breakaway;

class TestShaftLoad : public QObject {
  Q_OBJECT
 private slots:
  void hangingWeight_isSaidWithItsSizeAndWay();
  void arm_isSaidWithItsSizeAndWhereItHangs();
  void frictionThatDiffersFromWayToWay_isNoLoad();
  void curvesThatDisagree_areNoArm();
  void hoist_pullsTheAxisBackwards();
};

namespace {

/// Friction of 17 mNm moving, 21 standing, with a constant load and an arm; differs by `apart` from way to way.
FrictionMap mapOf(double load_Nm, double arm_Nm, double down_rad, double apart = 0.0, bool movingToo = true) {
  FrictionMap map;
  map.bins.resize(90);
  map.coulombAverage_Nm = {0.017, 1e-4};
  for (size_t k = 0; k < 90; ++k) {
    const double angle = turn_rad * (static_cast<double>(k) + 0.5) / 90.0;
    const double torque = load_Nm - arm_Nm * std::sin(angle - down_rad);
    for (size_t w = 0; w < 2; ++w) {
      const double sign = w == 0 ? 1.0 : -1.0, friction = 1.0 + 0.5 * sign * apart;
      map.bins[k].way[w].static_Nm = {0.021 * friction + sign * torque, 2e-4};
      map.bins[k].way[w].coulomb_Nm = {0.017 * friction + (movingToo ? sign * torque : 0.0), 1e-4};
    }
  }
  return map;
}

}  // namespace

void TestShaftLoad::hangingWeight_isSaidWithItsSizeAndWay() {
  const ShaftLoad load = shaftLoad(mapOf(-0.008, 0.0, 0.0), 1e-4);
  QVERIFY(load.constant_Nm && !load.arm);
  QVERIFY(std::abs(load.constant_Nm->value + 0.008) < 1e-6);
  QVERIFY(load.constant_Nm->standardError > 1e-4 && load.constant_Nm->standardError < 1.1e-4);
  const auto words = wordsOf(load, Axis::rotary);
  QCOMPARE(words.size(), size_t{1});
  QVERIFY2(words[0].starts_with("A constant load of 8 (7.8 to 8.2) mNm pulls the rotor clockwise"), words[0].c_str());
}

void TestShaftLoad::arm_isSaidWithItsSizeAndWhereItHangs() {
  const ShaftLoad load = shaftLoad(mapOf(0.0, 0.020, 2.269), 1e-4, 0.01);
  QVERIFY(load.arm && !load.constant_Nm);
  QVERIFY(std::abs(load.arm->amplitude_Nm.value - 0.020) < 1e-4);
  QVERIFY2(std::abs(load.arm->down_rad - 2.269) < 1e-3, qPrintable(QString::number(load.arm->down_rad)));
  const auto words = wordsOf(load, Axis::rotary);
  QCOMPARE(words.size(), size_t{1});
  QVERIFY2(words[0].starts_with("Once per turn ±20 (19.6 to 20.4) mNm") &&
               words[0].find("hangs down at 130") != std::string::npos,
           words[0].c_str());
}

void TestShaftLoad::frictionThatDiffersFromWayToWay_isNoLoad() {
  const ShaftLoad load = shaftLoad(mapOf(0.0, 0.0, 0.0, 0.2), 1e-4);
  QVERIFY(!load.constant_Nm && !load.arm);
  QVERIFY(wordsOf(load, Axis::rotary).empty());
}

void TestShaftLoad::curvesThatDisagree_areNoArm() {
  const ShaftLoad load = shaftLoad(mapOf(0.006, 0.006, 1.0, 0.0, false), 1e-4);
  QVERIFY(!load.constant_Nm && !load.arm);
}

void TestShaftLoad::hoist_pullsTheAxisBackwards() {
  FrictionMap map = mapOf(-0.01, 0.01, 0.0);
  map.axis = Axis::linear;
  const auto words = wordsOf(shaftLoad(map, 0.0), map.axis);
  QCOMPARE(words.size(), size_t{1});
  QVERIFY2(words[0].find(" N pulls the axis backwards") != std::string::npos, words[0].c_str());
}

QTEST_APPLESS_MAIN(TestShaftLoad)
#include "tst_shaft_load.moc"
