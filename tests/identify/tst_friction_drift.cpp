#include <QTest>
#include <cmath>

#include "base/random.h"
#include "identify/friction_drift.h"

using namespace breakaway;

class TestFrictionDrift : public QObject {
  Q_OBJECT
 private slots:
  void frictionThatFalls_isSaidWithHowMuch();
  void frictionThatRises_isSaidAsThat();
  void frictionThatStays_isNotSpokenOf();
  void loadThatGrows_isNoFriction();
  void oneTurn_showsNone();
};

namespace {

constexpr double friction_Nm = 0.012;

struct Sweep {
  double drift = 0.0;  ///< part of the friction that comes or goes from the first breakaway to the last
  double load = 0.0;   ///< the same of a load that comes
  size_t turns = 2;
  unsigned seed = 1;
};

/// Both ways around the turn, the one after the other, in 5 s steps; torque that varies with the angle, and scatters.
std::vector<BreakawayEvent> swept(const Sweep& sweep) {
  constexpr size_t bins = 36;
  const auto all = static_cast<double>(2 * sweep.turns * bins - 1);
  Random random(sweep.seed);
  std::vector<BreakawayEvent> events;
  for (size_t turn = 0; turn < sweep.turns; ++turn) {
    for (const Way way : {Way::cw, Way::ccw}) {
      for (size_t k = 0; k < bins; ++k) {
        const double part = static_cast<double>(events.size()) / all, sign = way == Way::cw ? -1.0 : 1.0;
        BreakawayEvent event;
        event.bin = k;
        event.angle_rad = turn_rad * (static_cast<double>(k) + 0.5) / static_cast<double>(bins);
        event.way = way;
        event.turn = turn;
        event.time_s = 40.0 + 5.0 * static_cast<double>(events.size());
        event.torque_Nm = friction_Nm * (1.0 + sweep.drift * (part - 0.5) + 0.2 * std::sin(2.0 * event.angle_rad) +
                                         sign * sweep.load * part + 0.03 * random.normal());
        events.push_back(event);
      }
    }
  }
  return events;
}

}  // namespace

void TestFrictionDrift::frictionThatFalls_isSaidWithHowMuch() {
  size_t held = 0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    const auto drift = frictionDrift(swept({.drift = -0.2, .seed = seed}));
    QVERIFY(drift);
    held += drift->part.low95() < -0.2 && drift->part.high95() > -0.2 ? 1 : 0;
    const auto words = wordsOf(*drift);
    QVERIFY(words);
    QVERIFY2(
        words->english().find("fell by") != std::string::npos && words->english().find("715 s") != std::string::npos,
        words->english().c_str());
  }
  QVERIFY2(held >= 88, qPrintable(QString::number(held)));
}

void TestFrictionDrift::frictionThatRises_isSaidAsThat() {
  const auto drift = frictionDrift(swept({.drift = 0.3}));
  QVERIFY(drift && wordsOf(*drift));
  QVERIFY(wordsOf(*drift)->english().find("rose by") != std::string::npos);
}

void TestFrictionDrift::frictionThatStays_isNotSpokenOf() {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    for (const double usual : {0.0, 0.03}) {
      const auto drift = frictionDrift(swept({.drift = usual, .seed = seed}));
      QVERIFY(drift && !wordsOf(*drift));
    }
  }
}

void TestFrictionDrift::loadThatGrows_isNoFriction() {
  const auto drift = frictionDrift(swept({.load = 0.5}));
  QVERIFY(drift && !wordsOf(*drift));
}

void TestFrictionDrift::oneTurn_showsNone() {
  QVERIFY(!frictionDrift(swept({.drift = -0.2, .turns = 1})));
  QVERIFY(!frictionDrift({}));
}

QTEST_APPLESS_MAIN(TestFrictionDrift)
#include "tst_friction_drift.moc"
