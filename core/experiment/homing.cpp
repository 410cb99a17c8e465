#include "experiment/homing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numbers.h"
#include "experiment/index_watch.h"

namespace breakaway {

namespace {
constexpr double sameWayPart = 0.05;  // of the way from one index to the next, that two of them may differ by
}

double Homing::tolerance_rad() const {
  return std::max(options_.indexTolerance_rad, breakaway::indexTolerance_rad(options_.countsPerRev));
}

Leg Homing::plan() const {
  HomingPlan<double> plan;
  plan.searchSpeed_rad_per_s = options_.searchSpeed_rad_per_s;
  plan.approachSpeed_rad_per_s = options_.approachSpeed_rad_per_s;
  plan.backOff_rad = options_.backOff_rad;
  plan.tolerance_rad = tolerance_rad();
  plan.mostTurns = options_.mostTurns;
  plan.timeout_s = options_.timeout_s;
  plan.stall_s = options_.stall_s;
  plan.approaches = static_cast<std::uint8_t>(std::clamp<size_t>(options_.approaches, 1, 255));
  return {plan, 0.0, options_.current_limit_A};
}

Command Homing::run(const Sample& sample) {
  if (isFirst()) {
    lastAngle_rad_ = stageAngle_rad_ = sample.angle_rad;
    beginLeg(plan(), options_.countsPerRev);
  } else {
    follow(sample);
  }
  return {};
}

/// The leg's stages say what the samples mean; after a gap in them an edge can't be told to the count.
void Homing::follow(const Sample& sample) {
  ++rows_;
  indexRows_ += sample.index ? 1 : 0;
  const LegPhase before = std::exchange(stage_, legPhase());
  const double beforeAngle_rad = std::exchange(lastAngle_rad_, sample.angle_rad);
  const double since_rad = sample.angle_rad - stageAngle_rad_;
  leastTick_s_ = leastTick_s_ > 0.0 ? std::min(leastTick_s_, tick_s()) : tick_s();
  if (before == Machine::verify && sample.index) sights_rad_.push_back(since_rad);
  if (stage_ == before) return;
  stageAngle_rad_ = sample.angle_rad;
  const bool passed = before == Machine::approach && (stage_ == Machine::backOff || stage_ == Machine::done);
  if (passed && sample.index && tick_s() < 1.5 * leastTick_s_)
    edges_.push_back(0.5 * (beforeAngle_rad + sample.angle_rad));
  if (!legHasEnded(stage_)) return;
  endLeg();
  if (stage_ != Machine::done) fail(failureOf(stage_, since_rad));
  if (edges_.empty()) fail(message("the samples in which the index came were lost on the way; home again"));
  finish();
}

/// The counts per turn that the board was told of, in words.
Message Homing::declared() const {
  if (!(options_.countsPerRev > 0.0)) return {};
  return message(", and whether a turn has {:.0f} counts", options_.countsPerRev);
}

/// Lines for edges, one channel for two, or a disc that isn't the one declared: the index comes once in a true turn,
/// and as far from the second sight to the third as from the first to the second. One that is seen in between does not.
Message Homing::seenElsewhere(double since_rad) const {
  if (2 * indexRows_ > rows_) return invertedIndexText;
  const double first_rad = sights_rad_.empty() ? since_rad : sights_rad_.front();
  const bool again = sights_rad_.size() > 1;
  if (again && options_.countsPerRev > 0.0 &&
      std::abs(sights_rad_[1] - 2.0 * first_rad) < std::min(tolerance_rad(), sameWayPart * first_rad)) {
    const double apart_rad = 0.5 * sights_rad_[1];
    return message(
        "the index comes every {:.0f}°: a turn has {:.0f} counts, not {:.0f}; check the counts per turn that the board "
        "was told, and, if they are right, the index wire's shield",
        360.0 * apart_rad / turn_rad, apart_rad / turn_rad * options_.countsPerRev, options_.countsPerRev);
  }
  if (!again && first_rad > turn_rad) return notAgain();
  return message("the index was seen twice within a turn, {} apart; check the encoder's index wire and shield",
                 degreesText(std::min(first_rad, again ? sights_rad_[1] - first_rad : first_rad)));
}

Message Homing::notAgain() const {
  return message("the index was seen once, but not again after a whole turn; check the encoder's index wire{}",
                 declared());
}

Message Homing::failureOf(LegPhase phase, double since_rad) const {
  switch (phase) {
    case Machine::still:
      return message("the rotor does not move; is the current limit too low, or the shaft held?");
    case Machine::timedOut:
      return message("not done after {} s", static_cast<int>(options_.timeout_s));
    case Machine::noIndex:
      return message("no index within {} turns; check the encoder's index wire{}",
                     std::to_string(options_.mostTurns).substr(0, 3), declared());
    case Machine::notAgain:
      return notAgain();
    case Machine::twice:
      return seenElsewhere(since_rad);
    case Machine::lost:
      return message("the index was seen once, but not again; check the encoder's index wire");
    default: {
      if (edges_.empty()) return message("the index was seen at two places; check the encoder's index wire and shield");
      return message("the index was seen at two places, {} apart; check the encoder's index wire and shield",
                     degreesText(std::abs(lastAngle_rad_ - edges_.front())));
    }
  }
}

Estimate Homing::indexAngle_rad() const {
  if (edges_.empty()) return {};
  const auto n = static_cast<double>(edges_.size());
  double sum = 0.0, squares = 0.0;
  for (const double edge : edges_) sum += edge;
  for (const double edge : edges_) squares += (edge - sum / n) * (edge - sum / n);
  const double rounding = options_.countsPerRev > 0.0 ? turn_rad / options_.countsPerRev / std::sqrt(12.0) : 0.0;
  return {sum / n, std::hypot(rounding, n > 1.0 ? std::sqrt(squares / (n - 1.0) / n) : 0.0)};
}

TimedProcedure::Progress Homing::progress() const {
  const bool searches = stage_ <= Machine::search;
  const double since_rad = lastAngle_rad_ - stageAngle_rad_;
  const double found = searches ? std::clamp(since_rad / turn_rad, 0.0, 1.0) : 1.0;
  const auto all = static_cast<double>(options_.approaches), done = static_cast<double>(edges_.size());
  const double pass_s = options_.backOff_rad / options_.approachSpeed_rad_per_s + 0.5;
  const double turns_rad = searches                    ? 2.0 * turn_rad - since_rad
                           : stage_ == Machine::verify ? turn_rad - since_rad
                                                       : 0.0;
  return {0.5 * found + 0.5 * done / all,
          std::max(0.0, turns_rad / options_.searchSpeed_rad_per_s) + pass_s * std::max(0.0, all - done), activity()};
}

Message Homing::activity() const {
  switch (stage_) {
    case Machine::verify:
      return message("turning once more to the index");
    case Machine::backOff:
      return message("backing off");
    case Machine::approach:
      return message("passing the index slowly, pass {}", edges_.size() + 1);
    default:
      return searching();
  }
}

}  // namespace breakaway
