// What counts as a breakaway: on a rotor whose breaking away is known exactly.
#include <QTest>
#include <cmath>
#include <numbers>

#include "experiment/breakaway_sweep.h"

using namespace breakaway;

class TestBreakawayEvents : public QObject {
  Q_OBJECT
 private slots:
  void breakaway_isDatedBackToTheLastStandingSample();
  void presliding_isNoMotion();
  void strongSpot_isMarkedAsOutlier();
  void heldRotor_endsTheSweepInWords();
};

namespace {

constexpr double turn = 2.0 * std::numbers::pi, countsPerRev = 4096.0, tick_s = 1e-3, resistance_ohm = 2.0;
constexpr size_t bins = 16;

/// Goes at once where it is told, and under a voltage stands until its breakaway current; then it runs away with a
/// constant acceleration.
struct Rotor {
  double breakaway_A = 0.2;
  double strongFrom_rad = 10.0, strongTo_rad = 10.0, strong_A = 0.45;  ///< a spot with another breakaway
  double presliding_rad = 0.0;  ///< elastic travel at breakaway, jumped into at 80 % of it, with speed
  double angle_rad = 0.0, velocity = 0.0, stood_rad = 0.0, gaveWay_A = 0.0;
  bool slides = false, preslid = false;

  double limit() const {
    const double place = angle_rad - turn * std::floor(angle_rad / turn);
    return place >= strongFrom_rad && place < strongTo_rad ? strong_A : breakaway_A;
  }
  Sample step(const Command& command, double time_s) {
    const double current_A = command.mode == Command::Mode::voltage ? command.target / resistance_ohm : 0.0;
    velocity = 0.0;
    if (command.mode == Command::Mode::position) angle_rad = command.target, slides = preslid = false;
    if (command.mode == Command::Mode::off) slides = preslid = false;
    if (command.mode == Command::Mode::voltage) push(current_A);
    Sample sample;
    sample.time_s = time_s;
    sample.angle_rad = std::floor(angle_rad / turn * countsPerRev) * turn / countsPerRev;
    sample.velocity_rad_per_s = velocity;
    sample.current_A = current_A;
    sample.supply_V = 24.0;
    sample.enabled = command.mode != Command::Mode::off;
    return sample;
  }
  void push(double current_A) {
    const double sign = current_A < 0.0 ? -1.0 : 1.0;
    if (!slides && !preslid && presliding_rad > 0.0 && std::abs(current_A) > 0.8 * limit()) {
      preslid = true;
      angle_rad += sign * presliding_rad;
      velocity = sign * 1.0;  // what an observer makes of a jump
    }
    if (!slides && std::abs(current_A) > limit()) slides = true, since_s = 0.0, gaveWay_A = std::abs(current_A);
    if (!slides) return;
    since_s += tick_s;
    velocity = sign * 100.0 * since_s;
    angle_rad += velocity * tick_s;
  }
  double since_s = 0.0;
};

BreakawaySweepOptions options() {
  BreakawaySweepOptions options;
  options.bins = bins;
  options.turns = 1;
  options.torqueConstant_Nm_per_A = 0.1;
  options.resistance_ohm = resistance_ohm;
  options.expected_A = {0.2, 0.2};
  options.zeroing_s = 0.1;
  options.countsPerRev = countsPerRev;
  return options;
}

BreakawaySweep swept(Rotor rotor) {
  BreakawaySweep sweep(options());
  Command command;
  for (int k = 0; k < 400'000 && sweep.state() == Procedure::State::running; ++k)
    command = sweep.step(rotor.step(command, k * tick_s));
  return sweep;
}

}  // namespace

void TestBreakawayEvents::breakaway_isDatedBackToTheLastStandingSample() {
  const BreakawaySweep sweep = swept({});
  QCOMPARE(sweep.state(), Procedure::State::finished);
  QCOMPARE(sweep.events().size(), 2 * bins);
  // The ramp rises by 0.3·0.2 A in 0.45 s; a count of travel needs 6 ms, four counts and the speed 11 ms.
  const double perTick_A = 0.3 * 0.2 / 0.45 * tick_s;
  for (const BreakawayEvent& event : sweep.events()) {
    const double ticksLate = (event.current_A - 0.2) / perTick_A;
    QVERIFY2(ticksLate > -1.5 && ticksLate < 7.5, qPrintable(QString::number(ticksLate)));
    QVERIFY(!event.outlier);
  }
}

void TestBreakawayEvents::presliding_isNoMotion() {
  Rotor rotor;
  rotor.presliding_rad = 2.2 * turn / countsPerRev;
  const BreakawaySweep sweep = swept(rotor);
  QCOMPARE(sweep.events().size(), 2 * bins);
  for (const BreakawayEvent& event : sweep.events()) {
    // The elastic travel comes at 0.16 A, the motion at 0.2 A.
    QVERIFY2(event.current_A > 0.1995 && event.current_A < 0.2015, qPrintable(QString::number(event.current_A)));
  }
}

void TestBreakawayEvents::strongSpot_isMarkedAsOutlier() {
  Rotor rotor;
  rotor.strongFrom_rad = 10.0 * turn / bins;
  rotor.strongTo_rad = 11.0 * turn / bins;
  const BreakawaySweep sweep = swept(rotor);
  QCOMPARE(sweep.events().size(), 2 * bins);
  size_t marked = 0;
  for (const BreakawayEvent& event : sweep.events()) {
    if (event.outlier) ++marked;
    if (event.outlier) QCOMPARE(event.bin, size_t{10});
  }
  QVERIFY2(marked >= 1 && marked <= 2, qPrintable(QString::number(marked)));
}

void TestBreakawayEvents::heldRotor_endsTheSweepInWords() {
  Rotor rotor;
  rotor.breakaway_A = 100.0;
  const BreakawaySweep sweep = swept(rotor);
  QCOMPARE(sweep.state(), Procedure::State::failed);
  QVERIFY2(sweep.status().failure.find("does not break away counter-clockwise at up to 0.80 A") != std::string::npos,
           sweep.status().failure.c_str());
  QVERIFY(sweep.events().empty());
}

QTEST_APPLESS_MAIN(TestBreakawayEvents)
#include "tst_breakaway_events.moc"
