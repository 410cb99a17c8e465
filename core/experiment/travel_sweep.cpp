#include "experiment/travel_sweep.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace breakaway {

namespace {
constexpr double leastHalfSpan_s = 0.001, mostHalfSpan_s = 0.005;
constexpr double keepEvery_s = 0.25;  // what the run under way has crossed
}  // namespace

TravelSweep::TravelSweep(TravelSweepOptions options, const std::vector<TravelRun>& earlier)
    : options_(std::move(options)),
      zeroing_(options_.zeroing_s),
      watch_(options_.travel, options_.index_m, options_.indexTolerance_m) {
  const auto good = [](double speed) { return speed > 0.0; };
  if (options_.speeds_m_per_s.size() < 2 ||
      !std::all_of(options_.speeds_m_per_s.begin(), options_.speeds_m_per_s.end(), good))
    fail(message("at least two speeds are needed"));
  if (!(options_.acceleration_m_per_s2 > 0.0) || options_.bins.count < 8)
    fail(message("an acceleration and at least 8 bins are needed"));
  for (const double speed : options_.speeds_m_per_s) {
    for (const TravelRun& run : earlier) {
      if (run.isAt(speed) && run.bins[0].size() == options_.bins.count && !isDone(speed)) runs_.push_back(run);
    }
  }
  skipDone();
  if (number_ >= options_.speeds_m_per_s.size()) finish();
}

bool TravelSweep::isDone(double speed_m_per_s) const {
  return std::any_of(runs_.begin(), runs_.end(),
                     [&](const TravelRun& run) { return !run.brokenOff && run.isAt(speed_m_per_s); });
}

void TravelSweep::skipDone() {
  while (number_ < options_.speeds_m_per_s.size() && isDone(speed())) ++number_;
}

/// Of the next run, without what was measured before it was broken off.
double TravelSweep::left_s() const {
  double left_s = options_.run_s;
  for (const TravelRun& run : runs_) {
    if (run.isAt(speed())) left_s -= run.duration_s;
  }
  return left_s;
}

/// Wide enough against the encoder's rounding, short against the time in a bin.
double TravelSweep::halfSpan_s() const {
  const double least_s = std::max(leastHalfSpan_s, 2.0 * tick_s());
  return std::max(least_s, std::min(0.25 * options_.bins.width_m() / speed(), mostHalfSpan_s));
}

void TravelSweep::enter(Stage stage, const Sample& sample) {
  stage_ = stage;
  stageStart_s_ = moved_s_ = sample.time_s;
  moved_m_ = sample.angle_rad;
  trace_.clear();
  trace_.tick_s = tick_s();
  trace_.windingTime_s = options_.windingTime_s;
  trace_.reachesFar = reachesFar(now_.halfSpan_s, speed(), options_.bins);
}

Command TravelSweep::run(const Sample& sample) {
  zeroing_.see(sample);
  if (isFirst()) enter(Stage::zero, sample);
  if (const Message wrong = watch_.step(sample); !wrong.empty()) fail(wrong);
  return stage_ == Stage::zero ? zero(sample) : stroke(sample);
}

Command TravelSweep::zero(const Sample& sample) {
  bool done = false;
  const Command command = zeroing_.step(sample, stageStart_s_, done);
  if (!done) return command;
  if (const Message moved = zeroing_.moved(options_.mostDrift_A); !moved.empty()) fail(moved);
  if (number_ >= options_.speeds_m_per_s.size()) {
    finish();
    return command;
  }
  now_ = {};
  now_.target_m_per_s = speed();
  now_.zero_A = zeroing_.zero_A();
  now_.halfSpan_s = halfSpan_s();
  for (auto& way : now_.bins) way.resize(options_.bins.count);
  thisRun_s_ = left_s();
  glide_ = Glide(speed(), options_.acceleration_m_per_s2);
  enter(Stage::approach, sample);
  return command;
}

/// Within the margin, so that the outermost bins are crossed as well.
double TravelSweep::farEnd_m() const {
  const double half_m = 0.5 * options_.travel.margin_m;
  return stage_ == Stage::forth ? options_.travel.last_m() + half_m : options_.travel.first_m() - half_m;
}

bool TravelSweep::stalled(const Sample& sample) {
  if (std::abs(sample.angle_rad - moved_m_) > 0.02 * options_.bins.width_m()) {
    moved_m_ = sample.angle_rad;
    moved_s_ = sample.time_s;
  }
  return sample.time_s - moved_s_ > options_.stall_s;
}

Command TravelSweep::stroke(const Sample& sample) {
  const double target_m = farEnd_m();
  if (stage_ != Stage::approach) {
    trace_.position_m.push_back(sample.angle_rad);
    trace_.current_A.push_back(sample.current_A);
    keepCrossed(sample);
  }
  if (stalled(sample)) {
    fail(message("the axis does not move at {:.3g} m/s; is it held, or the current limit too low?", speed()));
  }
  if (std::abs(sample.angle_rad - target_m) < 0.05 * options_.bins.width_m()) endStroke(sample);
  if (stage_ == Stage::zero) return {};
  return {Command::Mode::velocity, glide_.next(sample.angle_rad, farEnd_m(), tick_s()), 0.0, false};
}

/// Now and then: a slow stroke takes half a minute.
void TravelSweep::keepCrossed(const Sample& sample) {
  if (sample.time_s - kept_s_ < keepEvery_s) return;
  kept_s_ = sample.time_s;
  TravelRun crossed = now_;
  addStroke(trace_, options_.bins, crossed.halfSpan_s, options_.steadiness, crossed.bins);
  const auto any = [](const std::vector<TravelBinSums>& way) {
    return std::any_of(way.begin(), way.end(), [](const TravelBinSums& sum) { return sum.samples > 0; });
  };
  if (!any(crossed.bins[0]) && !any(crossed.bins[1])) return;
  crossed.duration_s = sample.time_s - runStart_s_;
  crossed.middle_s = runStart_s_ + 0.5 * crossed.duration_s;
  crossed.brokenOff = true;
  underWay_ = std::move(crossed);
}

void TravelSweep::endStroke(const Sample& sample) {
  if (stage_ == Stage::approach) {
    runStart_s_ = kept_s_ = sample.time_s;
    enter(Stage::forth, sample);
    return;
  }
  addStroke(trace_, options_.bins, now_.halfSpan_s, options_.steadiness, now_.bins);
  if (stage_ == Stage::forth) {
    enter(Stage::back, sample);
    return;
  }
  const double ran_s = sample.time_s - runStart_s_, pair_s = sample.time_s - stageStart_s_;
  if (ran_s + pair_s < thisRun_s_) {
    enter(Stage::forth, sample);
    return;
  }
  now_.duration_s = ran_s;
  now_.middle_s = runStart_s_ + 0.5 * ran_s;
  runs_.push_back(std::move(now_));
  underWay_.reset();
  skipDone();
  glide_.rest();
  enter(Stage::zero, sample);
}

TimedProcedure::Progress TravelSweep::progress() const {
  const size_t all = options_.speeds_m_per_s.size();
  double left_s = 0.0;
  for (size_t k = number_; k < all; ++k)
    left_s +=
        options_.zeroing_s + std::max(options_.run_s, 2.0 * options_.travel.usable_m() / options_.speeds_m_per_s[k]);
  return {std::min(1.0, static_cast<double>(number_) / static_cast<double>(all)), left_s,
          stage_ == Stage::zero ? zeroingText : message("going to and fro at {:.3g} m/s", speed())};
}

}  // namespace breakaway
