#include "experiment/travel_homing.h"

#include <algorithm>
#include <cmath>

#include "experiment/index_watch.h"

namespace breakaway {

void TravelHoming::enter(Stage stage, const Sample& sample) {
  stage_ = stage;
  stageStart_m_ = moved_m_ = sample.angle_rad;
  moved_s_ = sample.time_s;
  glide_.rest();
}

bool TravelHoming::stalled(const Sample& sample) {
  if (std::abs(sample.angle_rad - moved_m_) > 4.0 * options_.count_m) {
    moved_m_ = sample.angle_rad;
    moved_s_ = sample.time_s;
  }
  return sample.time_s - moved_s_ > options_.stall_s;
}

void TravelHoming::see(const Sample& sample, double before_m) {
  ++rows_;
  if (!sample.index) return;
  // It was passed anywhere since the last tick, here as at the first sight.
  const double here_m = 0.5 * (before_m + sample.angle_rad), room_m = 0.5 * std::abs(sample.angle_rad - before_m);
  if (sights_m_.empty()) firstRoom_m_ = room_m;
  const double tolerance_m = indexTolerance_m(options_.count_m) + room_m + firstRoom_m_;
  if (!sights_m_.empty() && std::abs(here_m - sights_m_.front()) > tolerance_m) {
    fail(2 * sights_m_.size() > rows_
             ? invertedIndexText
             : message("the index was seen at two places, {} apart; check the encoder's index wire and shield",
                       millimetresText(std::abs(here_m - sights_m_.front()))));
  }
  sights_m_.push_back(here_m);
}

Command TravelHoming::glideTo(double target_m, const Sample& sample, Stage next) {
  const double near_m = std::max(8.0 * options_.count_m, 0.1 * options_.backOff_m);
  const bool there = std::abs(sample.angle_rad - target_m) < near_m;
  if (there) enter(next, sample);
  return {Command::Mode::velocity, there ? 0.0 : glide_.next(sample.angle_rad, target_m, tick_s()), 0.0, false};
}

Command TravelHoming::run(const Sample& sample) {
  if (isFirst()) {
    before_m_ = sample.angle_rad;
    enter(Stage::lower, sample);
  }
  const double before_m = before_m_;
  before_m_ = sample.angle_rad;
  see(sample, before_m);
  if (stalled(sample)) fail(message("the axis does not move; is the current limit too low, or is it held?"));
  const Travel& travel = options_.travel;
  switch (stage_) {
    case Stage::lower:
      return glideTo(travel.first_m(), sample, Stage::search);
    case Stage::search: {
      const Command command = glideTo(travel.last_m(), sample, Stage::down);
      if (stage_ == Stage::down && sights_m_.empty())
        fail(
            message("no index within the {} between the ends that were felt; if the axis reaches further, a stop is in "
                    "its way, else check the encoder's index wire",
                    millimetresText(travel.high_m - travel.low_m)));
      return command;
    }
    case Stage::down:
    case Stage::backOff:
      return glideTo(std::max(travel.low_m + 0.5 * travel.margin_m, sights_m_.front() - options_.backOff_m), sample,
                     Stage::approach);
    case Stage::approach:
      return approach(sample, before_m);
  }
  return {};
}

Command TravelHoming::approach(const Sample& sample, double before_m) {
  if (sample.angle_rad - stageStart_m_ > 4.0 * options_.backOff_m)
    fail(message("the index was seen once, but not again; check the encoder's index wire"));
  if (sample.index && sample.angle_rad >= before_m) {
    edges_m_.push_back(0.5 * (before_m + sample.angle_rad));
    if (edges_m_.size() >= options_.approaches) finish();
    enter(Stage::backOff, sample);
  }
  return {Command::Mode::velocity, options_.approachSpeed_m_per_s, 0.0, false};
}

Estimate TravelHoming::index_m() const {
  if (edges_m_.empty()) return {};
  const auto n = static_cast<double>(edges_m_.size());
  double sum = 0.0, squares = 0.0;
  for (const double edge : edges_m_) sum += edge;
  for (const double edge : edges_m_) squares += (edge - sum / n) * (edge - sum / n);
  return {sum / n, std::hypot(options_.count_m / std::sqrt(12.0), n > 1.0 ? std::sqrt(squares / (n - 1.0) / n) : 0.0)};
}

TimedProcedure::Progress TravelHoming::progress() const {
  const std::pair<double, Message> stages[] = {
      {0.0, message("going to the lower end")},
      {0.2, message("searching the index over the travel")},
      {0.6, message("backing off")},
      {0.8, message("backing off")},
      {0.8, message("passing the index slowly, pass {}", edges_m_.size() + 1)}};
  const auto& [done, activity] = stages[static_cast<size_t>(stage_)];
  const double passes = static_cast<double>(edges_m_.size()) / static_cast<double>(options_.approaches);
  const double part = std::min(1.0, done + 0.2 * passes);
  return {part, (1.0 - part) * 2.0 * options_.travel.usable_m() / options_.searchSpeed_m_per_s, activity};
}

}  // namespace breakaway
