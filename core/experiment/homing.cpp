#include "experiment/homing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiment/index_watch.h"

namespace breakaway {

namespace {
constexpr double turn = 2.0 * std::numbers::pi;
}

Command Homing::move(double velocity_rad_per_s) const {
  return {Command::Mode::velocity, velocity_rad_per_s, options_.current_limit_A, false};
}

void Homing::enter(Stage stage, const Sample& sample) {
  stage_ = stage;
  stageAngle_rad_ = movedAngle_rad_ = sample.angle_rad;
  movedTime_s_ = sample.time_s;
}

bool Homing::stalled(const Sample& sample) {
  if (std::abs(sample.angle_rad - movedAngle_rad_) > 0.02) {
    movedAngle_rad_ = sample.angle_rad;
    movedTime_s_ = sample.time_s;
  }
  return sample.time_s - movedTime_s_ > options_.stall_s;
}

Command Homing::run(const Sample& sample) {
  if (!begun_) {
    begun_ = true;
    lastAngle_rad_ = sample.angle_rad;
    enter(Stage::search, sample);
    return move(options_.searchSpeed_rad_per_s);
  }
  elapsed_s_ = elapsed_s(sample);
  const double before = lastAngle_rad_;
  lastAngle_rad_ = sample.angle_rad;
  if (stalled(sample)) fail("the rotor does not move; is the current limit too low, or the shaft held?");
  if (elapsed_s_ > options_.timeout_s)
    fail("not done after " + std::to_string(static_cast<int>(options_.timeout_s)) + " s");
  switch (stage_) {
    case Stage::search:
      search(sample, before);
      return move(options_.searchSpeed_rad_per_s);
    case Stage::verify:
      verify(sample);
      return move(options_.searchSpeed_rad_per_s);
    case Stage::backOff:
      if (sample.angle_rad < stageAngle_rad_ - options_.backOff_rad) enter(Stage::approach, sample);
      return move(-options_.searchSpeed_rad_per_s);
    case Stage::approach:
      approach(sample, before);
      return move(options_.approachSpeed_rad_per_s);
  }
  return {};
}

double Homing::tolerance_rad() const {
  return std::max(options_.indexTolerance_rad, breakaway::indexTolerance_rad(options_.countsPerRev));
}

void Homing::search(const Sample& sample, double before_rad) {
  // Coasting from what ran before it, a rotor passes degrees within a tick.
  if (std::abs(sample.velocity_rad_per_s) > 3.0 * options_.searchSpeed_rad_per_s) {
    stageAngle_rad_ = sample.angle_rad;
    return;
  }
  travelled_rad_ = sample.angle_rad - stageAngle_rad_;
  if (sample.index && sample.angle_rad > before_rad - 1e-12) {
    enter(Stage::verify, sample);
  } else if (travelled_rad_ > options_.mostTurns * turn) {
    fail("no index within " + std::to_string(options_.mostTurns).substr(0, 3) +
         " turns; check the encoder's index wire");
  }
}

/// A sound index comes once in a turn; anywhere else it is a disturbed wire or a lost count.
void Homing::verify(const Sample& sample) {
  const double since_rad = sample.angle_rad - stageAngle_rad_;
  if (since_rad > turn + tolerance_rad()) {
    fail("the index was seen once, but not again after a whole turn; check the encoder's index wire");
  } else if (sample.index && since_rad > 0.0) {
    if (since_rad > turn - tolerance_rad()) {
      enter(Stage::backOff, sample);
    } else {
      fail("the index was seen twice within a turn, " + degreesText(since_rad) +
           " apart; check the encoder's index wire and shield");
    }
  }
}

void Homing::approach(const Sample& sample, double before_rad) {
  const double since_rad = sample.angle_rad - stageAngle_rad_;
  if (since_rad > 4.0 * options_.backOff_rad)
    fail("the index was seen once, but not again; check the encoder's index wire");
  if (!sample.index || sample.angle_rad < before_rad || since_rad <= 0.2 * options_.backOff_rad) return;
  const double edge_rad = 0.5 * (before_rad + sample.angle_rad);
  if (!edges_.empty() && std::abs(edge_rad - edges_.front()) > tolerance_rad()) {
    fail("the index was seen at two places, " + degreesText(std::abs(edge_rad - edges_.front())) +
         " apart; check the encoder's index wire and shield");
    return;
  }
  edges_.push_back(edge_rad);
  if (edges_.size() >= options_.approaches) finish();
  enter(Stage::backOff, sample);
}

Estimate Homing::indexAngle_rad() const {
  if (edges_.empty()) return {};
  const auto n = static_cast<double>(edges_.size());
  double sum = 0.0, squares = 0.0;
  for (const double edge : edges_) sum += edge;
  for (const double edge : edges_) squares += (edge - sum / n) * (edge - sum / n);
  const double rounding = options_.countsPerRev > 0.0 ? turn / options_.countsPerRev / std::sqrt(12.0) : 0.0;
  return {sum / n, std::hypot(rounding, n > 1.0 ? std::sqrt(squares / (n - 1.0) / n) : 0.0)};
}

double Homing::progress() const {
  const double found = stage_ == Stage::search && edges_.empty() ? 0.0 : 0.5;
  const double searched = std::clamp(travelled_rad_ / turn, 0.0, 1.0) * 0.5;
  return std::max(found, searched) +
         0.5 * static_cast<double>(edges_.size()) / static_cast<double>(options_.approaches);
}

double Homing::remaining_s() const {
  const double pass = options_.backOff_rad / options_.approachSpeed_rad_per_s + 0.5;
  const double turns_rad = stage_ == Stage::search   ? 2.0 * turn - travelled_rad_
                           : stage_ == Stage::verify ? turn - (lastAngle_rad_ - stageAngle_rad_)
                                                     : 0.0;
  const double search = turns_rad / options_.searchSpeed_rad_per_s;
  return std::max(0.0, search) +
         pass * static_cast<double>(options_.approaches - std::min(options_.approaches, edges_.size()));
}

std::string Homing::activity() const {
  switch (stage_) {
    case Stage::search:
      return "searching the index counter-clockwise";
    case Stage::verify:
      return "turning once more to the index";
    case Stage::backOff:
      return "backing off";
    case Stage::approach:
      return "passing the index slowly, pass " + std::to_string(edges_.size() + 1);
  }
  return {};
}

}  // namespace breakaway
