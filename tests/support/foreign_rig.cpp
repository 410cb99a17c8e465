#include "support/foreign_rig.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "support/foreign_draw.h"
#include "support/foreign_families.h"
#include "support/foreign_motor.h"
#include "support/foreign_moves.h"
#include "support/foreign_plant.h"

namespace breakaway::test {

namespace {

Sensors sensorsFrom(Draw& draw, const Motor& m) {
  Sensors s;
  s.lineError = !m.linear && draw.chance(0.5) ? draw.evenly(0.1, 0.6) * m.count() : 0.0;
  s.wander = draw.chance(0.8) ? draw.evenly(0.005, 0.04) : 0.0;
  s.wander_s = draw.evenly(0.005, 8.0);
  s.noise_A = draw.evenly(0.001, 0.015) * m.most_A;
  s.step_A = 3.0 * m.most_A / std::pow(2.0, draw.whole(10, 14));
  s.missing = draw.chance(0.3) ? draw.evenly(5e-4, 0.01) : 0.0;
  s.pull = draw.chance(0.5) ? draw.between(-0.006, 0.006) * m.coulomb : 0.0;
  const int trifles = draw.whole(0, 3);
  for (int k = 0; k < trifles; ++k)
    s.trifles.push_back({draw.evenly(0.001, 0.006) * m.coulomb, draw.whole(1, 24), draw.between(0.0, turn)});
  return s;
}

Bench benchFor(const Motor& m, const Driven& driven, Draw& draw) {
  Bench bench;
  bench.name = m.make;
  bench.axis = m.linear ? Axis::linear : Axis::rotary;
  bench.input = driven.input;
  bench.countsPerUnit = m.counts;
  if (driven.input == DriveInput::duty || draw.chance(0.5)) bench.supply_V = m.supply_V;
  const auto roughly = [&](double value) { return value * draw.evenly(0.85, 1.18); };
  const bool exact = draw.chance(0.5), little = draw.chance(0.3);
  if (driven.input != DriveInput::torque) bench.motor.torqueConstant = exact ? m.constant : roughly(m.constant);
  if (driven.volts()) {
    bench.motor.backEmfConstant = bench.motor.torqueConstant;
    bench.motor.resistance_ohm = roughly(m.resistance);
    if (!little) bench.motor.inductance_H = roughly(m.inductance);
  }
  if (draw.chance(0.85)) bench.motor.inertia = roughly(m.inertia);
  if (!little) bench.motor.coulomb = roughly(m.coulomb);
  if (exact && driven.input != DriveInput::torque)
    bench.trusted = {m.linear ? "force_constant_N_per_A" : "torque_constant_Nm_per_A"};
  return bench;
}

Recording logOf(const Rows& rows, const Bench& bench, const Motor& m, const Driven& driven, double missing,
                size_t number, Draw& draw) {
  std::vector<double> time, shown, drive, current;
  for (size_t k = 0; k < rows.time.size(); ++k) {
    if (k > 3 && missing > 0.0 && draw.chance(missing)) continue;
    const double asked = rows.drive[k];
    time.push_back(rows.time[k]);
    shown.push_back(rows.shown[k]);
    drive.push_back(driven.input == DriveInput::duty     ? asked / m.supply_V
                    : driven.input == DriveInput::torque ? asked * m.constant
                    : driven.measured                    ? rows.current[k]
                                                         : asked);
    current.push_back(rows.current[k]);
  }
  std::vector<Channel> channels{{"time_s", time}, {bench.positionChannel(), shown}, {bench.inputChannel(), drive}};
  if (driven.beside) channels.push_back({"current_A", current});
  return *Recording::seal(fmt::format("log {}", number + 1), std::move(channels));
}

}  // namespace

const std::vector<ForeignFamily>& foreignFamilies() {
  static const std::vector<ForeignFamily> all = [] {
    std::vector<ForeignFamily> some;
    for (const Family& family : families()) some.push_back(family.known);
    return some;
  }();
  return all;
}

ForeignRig foreignRig(const std::string& name, std::uint64_t seed) {
  const auto& all = families();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Family& one) { return one.known.name == name; });
  const Family& family = *found;
  Draw draw(name, seed), byChance(name + " by chance", seed);
  const Motor motor = motorFrom(draw, family.rotary);
  Driven driven = draw.oneOf(drives);
  // A delay ahead of a current that is read doesn't show.
  while ((family.volts && !driven.volts()) || (name == "transport_delay" && driven.measured))
    driven = draw.oneOf(drives);
  const double rate_Hz = family.quick ? draw.oneOf(std::array{500.0, 1000.0, 2000.0})
                                      : draw.oneOf(std::array{100.0, 200.0, 250.0, 500.0, 1000.0, 2000.0});
  const size_t logs = name == "external_disturbance" ? 1 : static_cast<size_t>(draw.whole(1, 3));
  const double length_s = std::clamp(15000.0 / rate_Hz / static_cast<double>(logs), 6.0, draw.between(20.0, 40.0));
  const Sensors sensors = sensorsFrom(draw, motor);
  Concealed hidden;
  const std::string size = family.conceal ? family.conceal(hidden, motor, draw, length_s, rate_Hz) : "nothing";
  const Bench bench = benchFor(motor, driven, draw);
  ForeignRig rig{bench, {}, fmt::format("{}, {}, {:.0f} Hz, {:.0f} s:", motor.make, driven.words, rate_Hz, length_s)};
  for (size_t k = 0; k < logs; ++k) {
    Moves moves = movesFrom(family.travels, motor, hidden, driven.volts(), length_s, rate_Hz, draw);
    const auto ran = [&](const Concealed& conceals) {
      return rowsOf(motor, driven, conceals, sensors, moves, length_s, rate_Hz, byChance);
    };
    // Nobody logs an axis that hardly moves.
    constexpr double least = 300.0;  // counts
    for (int tries = 0; tries < 20; ++tries) {
      const Rows rows = ran(hidden);
      if (rows.highest - rows.lowest > least * motor.count()) break;
      moves = movesFrom(family.travels, motor, hidden, driven.volts(), length_s, rate_Hz, draw);
    }
    if (hidden.stopStiffness > 0.0 && k == 0) {  // where it comes to
      Concealed without = hidden;
      without.stopStiffness = without.stopDamping = 0.0;
      const Rows freely = ran(without);
      hidden.high = freely.highest - draw.between(0.04, 0.15) * (freely.highest - freely.lowest);
    }
    const Rows rows = ran(hidden);
    rig.recordings.push_back(logOf(rows, bench, motor, driven, sensors.missing, k, draw));
    rig.words += fmt::format(" {},", moves.words);
  }
  rig.words += fmt::format(" wander {:.1f} %; {}", 100.0 * sensors.wander, size);
  return rig;
}

}  // namespace breakaway::test
