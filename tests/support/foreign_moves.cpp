#include "support/foreign_moves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace breakaway::test {

namespace {

enum class Kind { steps, chirp, sines, speeds, slowTurns, places };

/// What a loop needs that is to be about so quick.
void closeLoop(Moves& moves, const Motor& m, const Concealed& c, bool volts, double rate_Hz, Draw& draw) {
  const double inertia = m.inertia + c.loadInertia;
  double quick = turn * std::min(draw.evenly(4.0, 15.0), rate_Hz / 40.0);
  if (c.late_s > 0.0) quick = std::min(quick, 0.35 / c.late_s);
  if (c.loadInertia > 0.0) quick = std::min(quick, 0.15 * std::sqrt(c.stiffness / c.loadInertia));
  const double gain = volts ? m.constant / m.resistance : m.constant;
  if (!moves.place) {
    moves.kp = inertia * quick / gain;
    moves.ki = 0.5 * quick * moves.kp;
    return;
  }
  const double braked = volts ? m.constant * m.constant / m.resistance : 0.0;
  moves.kp = inertia * quick * quick / gain;
  moves.kd = std::max(0.0, (1.6 * quick * inertia - braked) / gain);
  moves.ki = draw.chance(0.6) ? 0.2 * quick * moves.kp : 0.0;
}

Moves openMoves(Kind kind, const Motor& m, double inertia, bool volts, double length_s, double rate_Hz, Draw& draw) {
  Moves moves;
  const double moving = m.coulomb / m.constant * (volts ? m.resistance : 1.0);
  const double most = volts ? 0.9 * m.supply_V : std::min(m.most_A, 5.0 * moving);
  const double amplitude = std::min(most, 1.3 * moving + draw.evenly(0.15, 0.7) * std::max(0.0, most - 1.3 * moving));
  if (kind == Kind::steps) {
    moves.words = "steps";
    const double settles_s = inertia * m.fastest / (amplitude * (volts ? m.constant / m.resistance : m.constant));
    const double hold_s = volts ? std::clamp(draw.evenly(0.08, 0.5), 10.0 / rate_Hz, 0.6)
                                : std::clamp(0.6 * settles_s, 5.0 / rate_Hz, 0.4);
    std::vector<double> levels;
    for (double t = 0.0; t < length_s + hold_s; t += hold_s) {
      const bool back = levels.size() % 2 == 1;
      levels.push_back(back ? -levels.back() : draw.sign() * amplitude * draw.between(volts ? 0.1 : 0.5, 1.0));
    }
    moves.drive = [levels, hold_s](double t) {
      return levels[std::min(static_cast<size_t>(t / hold_s), levels.size() - 1)];
    };
  } else if (kind == Kind::chirp) {
    moves.words = "chirp";
    const double first_Hz = 0.3, ratio = std::min(rate_Hz / 8.0, draw.evenly(15.0, 120.0)) / first_Hz;
    moves.drive = [=](double t) {
      return amplitude * std::sin(turn * first_Hz * length_s / std::log(ratio) * (std::pow(ratio, t / length_s) - 1.0));
    };
  } else {
    moves.words = "sines";
    std::vector<std::pair<double, double>> lines;
    const int count = draw.whole(8, 25);
    lines.reserve(static_cast<size_t>(count));
    for (int k = 0; k < count; ++k)
      lines.emplace_back(draw.evenly(0.3, std::min(60.0, rate_Hz / 8.0)), draw.between(0.0, turn));
    moves.drive = [=](double t) {
      double sum = 0.0;
      for (const auto& [Hz, phase] : lines) sum += std::sin(turn * Hz * t + phase);
      return std::clamp(1.6 * amplitude * sum / std::sqrt(static_cast<double>(lines.size())), -most, most);
    };
  }
  return moves;
}

/// From place to place and back, each time at rest, by a course of the fifth order.
Moves placesFrom(const Motor& m, bool ends, double span, double length_s, Draw& draw) {
  struct Leg {
    double from_s, length_s, from, to;
  };
  std::vector<Leg> legs;
  const double fast = 0.5 * m.fastest * draw.evenly(0.2, 0.8), hard = m.peak() / m.inertia * draw.evenly(0.1, 0.5);
  double at_s = 0.0, place = 0.0;
  while (at_s < length_s) {
    const double next = ends ? (place > 0.5 * span ? 0.0 : span) : draw.between(0.0, span),
                 way = std::abs(next - place);
    const double goes_s = std::max({0.05, 1.9 * way / fast, std::sqrt(5.8 * way / hard)});
    legs.push_back({at_s, goes_s, place, next});
    at_s += goes_s + draw.evenly(0.05, 0.5);
    place = next;
  }
  Moves moves;
  moves.words = "places";
  moves.place = true;
  moves.reference = [legs](double t) {
    const auto after = std::find_if(legs.begin(), legs.end(), [t](const Leg& leg) { return leg.from_s > t; });
    const Leg& leg = after == legs.begin() ? *after : *(after - 1);
    const double part = std::clamp((t - leg.from_s) / leg.length_s, 0.0, 1.0);
    return leg.from + (leg.to - leg.from) * part * part * part * (10.0 + part * (6.0 * part - 15.0));
  };
  return moves;
}

}  // namespace

Moves movesFrom(bool travels, const Motor& m, const Concealed& c, bool volts, double length_s, double rate_Hz,
                Draw& draw) {
  auto kind = static_cast<Kind>(draw.whole(0, 5));
  const bool closed = m.linear || travels;
  if (closed && kind <= Kind::sines) kind = draw.oneOf(std::array{Kind::speeds, Kind::slowTurns, Kind::places});
  if (c.stopStiffness > 0.0 || (m.linear && kind == Kind::slowTurns)) kind = Kind::places;
  if (kind <= Kind::sines) return openMoves(kind, m, m.inertia + c.loadInertia, volts, length_s, rate_Hz, draw);
  Moves moves;
  if (kind == Kind::places) {
    const double span = m.linear ? draw.between(0.05, 0.3) : travels ? draw.between(6.0, 14.0) : draw.between(0.5, 6.0);
    moves = placesFrom(m, c.stopStiffness > 0.0 || draw.chance(0.3), span, length_s, draw);
  } else {
    const bool slow = kind == Kind::slowTurns;
    moves.words = slow ? "slow turns" : "speeds";
    double speed = slow ? draw.between(0.8, 4.0) : 0.5 * m.fastest * draw.evenly(0.1, 0.8);
    double period_s = draw.evenly(1.0, 5.0);
    if (m.linear) speed = std::min(speed, 1.0 / period_s);
    if (slow && travels) period_s = std::min(length_s, 34.0 / speed);
    moves.reference = [=](double t) {
      const double at = std::fmod(t / period_s, 1.0);
      return speed * (at < 0.25 ? 4.0 * at : at < 0.75 ? 2.0 - 4.0 * at : 4.0 * at - 4.0);
    };
  }
  closeLoop(moves, m, c, volts, rate_Hz, draw);
  return moves;
}

}  // namespace breakaway::test
