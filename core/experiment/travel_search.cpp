#include "experiment/travel_search.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {
constexpr double leastMotion_m = 3e-4;
constexpr double acceleration_m_per_s2 = 0.5;
constexpr double pause_s = 0.03;  // with open windings between tries, so that no board takes them for a blocked axis
}  // namespace

TravelSearch::TravelSearch(const TravelSearchOptions& options)
    : options_(options),
      glide_(options.speed_m_per_s, acceleration_m_per_s2),
      motion_m_(std::max(leastMotion_m, 8.0 * options.count_m)),
      limit_A_(options.firstLimit_A) {
  if (!(options_.firstLimit_A > 0.0) || !(options_.mostLimit_A >= options_.firstLimit_A))
    fail(message("no current limit to begin with is known"));
}

void TravelSearch::enter(Stage stage, const Sample& sample) {
  stage_ = stage;
  stageStart_m_ = anchor_m_ = sample.angle_rad;
  anchor_s_ = far_s_ = sample.time_s;
  furthest_m_ = sample.angle_rad;
  left_ = false;
}

void TravelSearch::pause(const Sample& sample) {
  anchor_s_ = pauseEnd_s_ = sample.time_s + pause_s;
}

bool TravelSearch::stalled(const Sample& sample) {
  if (std::abs(sample.angle_rad - anchor_m_) > motion_m_) {
    anchor_m_ = sample.angle_rad;
    anchor_s_ = sample.time_s;
  }
  return sample.time_s - anchor_s_ > options_.stall_s;
}

/// Against a stop it may swing to and fro, as fast as the current loop lets it.
bool TravelSearch::getsNoFurther(const Sample& sample) {
  if (way_ * (sample.angle_rad - furthest_m_) > 0.0) furthest_m_ = sample.angle_rad;
  if (way_ * (furthest_m_ - anchor_m_) > motion_m_) {
    anchor_m_ = furthest_m_;
    anchor_s_ = sample.time_s;
    left_ = true;
  }
  return sample.time_s - anchor_s_ > options_.stall_s;
}

/// Where it stands, if it does.
double TravelSearch::end_m(const Sample& sample) const {
  constexpr double springs = 0.3;  // of what is motion: the stop gives way to what hits it
  return std::abs(sample.angle_rad - furthest_m_) < springs * motion_m_ ? sample.angle_rad : furthest_m_;
}

Command TravelSearch::run(const Sample& sample) {
  if (isFirst()) enter(Stage::feel, sample);
  if (elapsed_s(sample) > options_.timeout_s)
    fail(message("no end was felt within {} s", std::lround(options_.timeout_s)));
  if (sample.time_s < pauseEnd_s_) return {};
  if (stage_ == Stage::feel) return feel(sample);
  return stage_ == Stage::middle ? toMiddle(sample) : towardsEnd(sample);
}

Command TravelSearch::feel(const Sample& sample) {
  if (std::abs(sample.angle_rad - stageStart_m_) > motion_m_) {
    way_ = sample.angle_rad > stageStart_m_ ? 1.0 : -1.0;
    moving_A_ = limit_A_;
    limit_A_ = std::min(options_.mostLimit_A, options_.overMoving * limit_A_);
    enter(Stage::onwards, sample);
    return move(way_);
  }
  if (sample.time_s - anchor_s_ > options_.try_s) {
    pause(sample);
    way_ = -way_;
    if (way_ > 0.0 && limit_A_ >= options_.mostLimit_A)
      fail(message("the axis moves neither way within the current limit; is it clamped?"));
    if (way_ > 0.0) limit_A_ = std::min(options_.mostLimit_A, options_.growth * limit_A_);
    return {};
  }
  return move(way_);
}

/// It went to the end where it is held, or hardly moved at all.
Message TravelSearch::heldWords() const {
  if (stage_ == Stage::onwards) return message("the axis doesn't leave its end again; is it clamped?");
  return message(
      "the axis went {} to its end with up to {:.3g} A, but {:.3g} A don't move it {} again: a load presses it there, "
      "or "
      "something holds it; hold or balance the load, or take it off",
      wayText(way_ < 0.0, Axis::linear), there_A_, limit_A_, wayText(way_ > 0.0, Axis::linear));
}

Command TravelSearch::towardsEnd(const Sample& sample) {
  if (!getsNoFurther(sample)) return move(way_);
  if (!left_) {
    // Friction may be higher here than where it began to move.
    if (limit_A_ >= options_.mostLimit_A) fail(heldWords());
    limit_A_ = std::min(options_.mostLimit_A, options_.growth * limit_A_);
    pause(sample);
    return {};
  }
  if (stage_ == Stage::onwards) {
    firstEnd_m_ = end_m(sample);
    there_A_ = limit_A_;
    way_ = -way_;
    enter(Stage::back, sample);
    pause(sample);
    return {};
  }
  const double low_m = std::min(firstEnd_m_, end_m(sample)), high_m = std::max(firstEnd_m_, end_m(sample));
  travel_ = {low_m, high_m, std::max(options_.margin * (high_m - low_m), 4.0 * motion_m_)};
  if (high_m - low_m < std::max(options_.leastTravel_m, 16.0 * motion_m_))
    fail(message("the axis moves by {} only; is something in its way?", millimetresText(high_m - low_m)));
  enter(Stage::middle, sample);
  return {};
}

Command TravelSearch::toMiddle(const Sample& sample) {
  constexpr double swings = 4.0;  // of a stall's time: around the middle a loop may hunt, between sticking and slipping
  const bool near = std::abs(sample.angle_rad - travel_.middle_m()) < travel_.margin_m;
  if (!near) far_s_ = sample.time_s;
  if (stalled(sample) || sample.time_s - far_s_ > swings * options_.stall_s) {
    if (near) {
      finish();
    } else {
      fail(message("the axis stopped at {} from its lower end on the way to the middle; is something in its way?",
                   millimetresText(sample.angle_rad - travel_.low_m)));
    }
  }
  return {Command::Mode::velocity, glide_.next(sample.angle_rad, travel_.middle_m(), tick_s()), options_.mostLimit_A,
          false};
}

TimedProcedure::Progress TravelSearch::progress() const {
  constexpr double usual_m = 0.5;
  const Message onwards = message("going {} to the end", wayText(way_ > 0.0, Axis::linear));
  const std::pair<double, Message> stages[] = {{0.0, message("feeling which way the axis can move")},
                                               {0.1, onwards},
                                               {0.4, onwards},
                                               {0.8, message("going to the middle")}};
  const auto& [done, activity] = stages[static_cast<size_t>(stage_)];
  return {done, (1.0 - done) * 2.5 * usual_m / options_.speed_m_per_s, activity};
}

}  // namespace breakaway
