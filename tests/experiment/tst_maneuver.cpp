// What an experiment makes an axis do, and how a board's limits and an axis' travel hold it.
#include <QTest>
#include <algorithm>
#include <cmath>
#include <functional>

#include "experiment/maneuver_run.h"
#include "motor/maneuver.h"

using namespace breakaway;

class TestManeuver : public QObject {
  Q_OBJECT
 private slots:
  void speeds_goBothWaysAndEndAtRest();
  void pulses_bringTheSpeedBack();
  void chirp_growsInFrequency();
  void limits_holdSpeedAndCurrent();
  void margins_turnTheWay();
  void fastAxis_brakesBeforeItsMargins();
  void axisThatDoesNotMove_isSaid();
  void nothingToDo_isAnError();
};

namespace {

constexpr double tick_s = 1e-3;

/// An axis that follows speeds at once, and currents as accelerations; what it was told to do, each tick.
std::vector<Command> driven(ManeuverRun& run, const std::function<void(const Sample&)>& see = {}, bool moves = true) {
  std::vector<Command> commands;
  Sample sample;
  while (run.state() == Procedure::State::running && commands.size() < 1'000'000) {
    const Command command = run.step(sample);
    if (see) see(sample);
    commands.push_back(command);
    sample.time_s += tick_s;
    if (!moves) continue;
    if (command.mode == Command::Mode::velocity) sample.velocity_rad_per_s = command.target;
    if (command.mode == Command::Mode::current) sample.velocity_rad_per_s += 100.0 * command.target * tick_s;
    sample.angle_rad += sample.velocity_rad_per_s * tick_s;
  }
  return commands;
}

double sum(const Maneuver& maneuver, ManeuverStretch::Of of) {
  double total = 0.0;
  for (const ManeuverStretch& one : maneuver)
    if (one.of == of) total += 0.5 * (one.from + one.to) * one.duration_s;
  return total;
}

}  // namespace

void TestManeuver::speeds_goBothWaysAndEndAtRest() {
  const Maneuver maneuver = speedsBothWays({2.0, 0.0, 5.0}, 4.0 * 3.14159);
  QVERIFY(std::abs(sum(maneuver, ManeuverStretch::Of::speed)) < 2.0);
  QCOMPARE(maneuver.back().to, 0.0);
  const auto [least, most] =
      std::minmax_element(maneuver.begin(), maneuver.end(), [](const auto& a, const auto& b) { return a.to < b.to; });
  QCOMPARE(least->to, -5.0);
  QCOMPARE(most->to, 5.0);
  ManeuverRun run(maneuver, {}, true, Axis::rotary);
  double lowest = 0.0, highest = 0.0;
  driven(run,
         [&](const Sample& s) { lowest = std::min(lowest, s.angle_rad), highest = std::max(highest, s.angle_rad); });
  QCOMPARE(run.state(), Procedure::State::finished);
  QVERIFY2(highest - lowest > 12.0 && highest - lowest < 16.0, qPrintable(QString::number(highest - lowest)));
}

void TestManeuver::pulses_bringTheSpeedBack() {
  const Maneuver maneuver = currentPulses({0.5, 1.0}, 0.05, 0.2);
  QVERIFY(std::abs(sum(maneuver, ManeuverStretch::Of::current)) < 1e-12);
  ManeuverRun run(maneuver, {}, false, Axis::rotary);
  double last = 1.0;
  driven(run, [&](const Sample& s) { last = s.velocity_rad_per_s; });
  QVERIFY(std::abs(last) < 0.5);
}

void TestManeuver::chirp_growsInFrequency() {
  const Maneuver maneuver = currentChirp(1.0, 2.0, 20.0, 10.0);
  const auto crossings = [&](double from_s, double to_s) {
    int count = 0;
    for (double t = from_s; t < to_s; t += 1e-3)
      count += (maneuver[0].at(t) < 0.0) != (maneuver[0].at(t + 1e-3) < 0.0) ? 1 : 0;
    return count;
  };
  QVERIFY(std::abs(crossings(0.0, 1.0) - 6) <= 2);    // 2 to 3.8 Hz
  QVERIFY(std::abs(crossings(9.0, 10.0) - 38) <= 2);  // 18.2 to 20 Hz
}

void TestManeuver::limits_holdSpeedAndCurrent() {
  ManeuverRun fast(reversals(50.0, 4, 0.5), {10.0, 0.0, {}}, false, Axis::rotary);
  for (const Command& command : driven(fast)) QVERIFY(std::abs(command.target) <= 9.0 + 1e-9);
  // A steady current would drive it ever faster.
  ManeuverRun pushed(currentRamps(2.0, 1, 4.0), {10.0, 1.0, {}}, false, Axis::rotary);
  double fastest = 0.0, most = 0.0;
  for (const Command& command :
       driven(pushed, [&](const Sample& s) { fastest = std::max(fastest, std::abs(s.velocity_rad_per_s)); }))
    most = std::max(most, std::abs(command.target));
  QVERIFY(most <= 1.0 && fastest < 9.2);
}

void TestManeuver::margins_turnTheWay() {
  const Travel travel{-0.1, 0.1, 0.02};
  ManeuverRun run(speedsBothWays({0.05}, 1.0), {0.0, 0.0, travel}, false, Axis::linear);
  double lowest = 0.0, highest = 0.0;
  driven(run,
         [&](const Sample& s) { lowest = std::min(lowest, s.angle_rad), highest = std::max(highest, s.angle_rad); });
  QCOMPARE(run.state(), Procedure::State::finished);
  QVERIFY2(lowest > -0.0805 && highest < 0.0805 && highest > 0.075, qPrintable(QString::number(highest)));
}

/// An axis that speeds up and brakes by 4 m/s² at most; currents push it by 3.
void TestManeuver::fastAxis_brakesBeforeItsMargins() {
  const Travel travel{-0.1, 0.1, 0.02};
  for (const Maneuver& maneuver : {speedsBothWays({0.5}, 1.0), currentRamps(1.0, 6, 2.0)}) {
    ManeuverRun run(maneuver, {0.6, 0.0, travel, 2.0}, false, Axis::linear);
    Sample sample;
    double farthest = 0.0;
    while (run.state() == Procedure::State::running) {
      const Command command = run.step(sample);
      const double most = 4.0 * tick_s;
      sample.velocity_rad_per_s += command.mode == Command::Mode::current
                                       ? 3.0 * command.target * tick_s
                                       : std::clamp(command.target - sample.velocity_rad_per_s, -most, most);
      sample.angle_rad += sample.velocity_rad_per_s * tick_s;
      sample.time_s += tick_s;
      farthest = std::max(farthest, std::abs(sample.angle_rad));
    }
    QCOMPARE(run.state(), Procedure::State::finished);
    QVERIFY2(farthest > 0.05 && farthest < 0.09, qPrintable(QString::number(farthest)));
  }
}

void TestManeuver::axisThatDoesNotMove_isSaid() {
  ManeuverRun run(reversals(5.0, 4, 5.0), {}, false, Axis::rotary);
  driven(run, {}, false);
  QCOMPARE(run.state(), Procedure::State::failed);
  QVERIFY(run.status().failure.find("does not move") != std::string::npos);
}

void TestManeuver::nothingToDo_isAnError() {
  const ManeuverRun run({}, {}, true, Axis::rotary);
  QCOMPARE(run.state(), Procedure::State::failed);
}

QTEST_APPLESS_MAIN(TestManeuver)
#include "tst_maneuver.moc"
