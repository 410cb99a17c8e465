#include "experiment/travel_strokes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numbers.h"

namespace breakaway {

namespace {
constexpr double caution = 1.1;          // times the way to stop that the last strokes needed
constexpr double golden = 0.6180339887;  // of a stretch, by which each stroke's places lie elsewhere
constexpr double motion_m = 2e-4;        // less travel is no motion
constexpr double useful = 0.9;           // of the travel between the margins, that strokes use
}  // namespace

TravelStrokes::TravelStrokes(TravelStrokesOptions options)
    : options_(std::move(options)), means_(options_.block_s, true) {
  if (options_.voltages_V.empty() || options_.strokes == 0) fail(message("no voltage is asked for"));
}

Command TravelStrokes::run(const Sample& sample) {
  if (isFirst()) {
    phase_s_ = sample.time_s;
    furthest_m_ = sample.angle_rad;
    way_ = sample.angle_rad > options_.travel.middle_m() ? -1.0 : 1.0;
  }
  return resting_ ? rest(sample) : stroke(sample);
}

Command TravelStrokes::rest(const Sample& sample) {
  const double inRest_s = sample.time_s - phase_s_;
  // It coasts into the last rest.
  if (inRest_s > 0.05) open_A_.take(sample);
  if (inRest_s < options_.rest_s) return {};
  if (const Message moved = open_A_.moved(options_.mostDrift_A); !moved.empty()) fail(moved);
  if (done_ >= all()) {
    finish();
    return {};
  }
  resting_ = false;
  way_ = -way_;
  turnRound(sample);
  return stroke(sample);
}

/// The next stroke begins where this one has stopped.
void TravelStrokes::turnRound(const Sample& sample) {
  way_ = -way_;
  braking_ = false;
  start_m_ = furthest_m_ = moved_m_ = sample.angle_rad;
  moved_s_ = sample.time_s;
  const Travel& travel = options_.travel;
  const double half_m = 0.5 * useful * travel.usable_m();
  const double far_m = travel.middle_m() + way_ * half_m;
  switch_m_ = start_m_ + (far_m - start_m_) / (1.0 + caution * stopShare_);
}

Command TravelStrokes::stroke(const Sample& sample) {
  if (const auto block = means_.add(sample, tick_s())) blocks_.push_back(*block);
  if (std::abs(sample.angle_rad - moved_m_) > motion_m) {
    moved_m_ = sample.angle_rad;
    moved_s_ = sample.time_s;
  }
  if (sample.time_s - moved_s_ > options_.stall_s)
    fail(message("the axis does not move {} by voltage; is it held, or the current limit too low?",
                 wayText(way_ > 0.0, Axis::linear)));
  const bool fast = options_.highest_m_per_s > 0.0 && way_ * sample.velocity_rad_per_s > options_.highest_m_per_s;
  if (!braking_ && (fast || way_ * (sample.angle_rad - switch_m_) >= 0.0)) {
    braking_ = true;
    switch_m_ = sample.angle_rad;
  }
  furthest_m_ = way_ > 0.0 ? std::max(furthest_m_, sample.angle_rad) : std::min(furthest_m_, sample.angle_rad);
  if (braking_ && way_ * sample.velocity_rad_per_s <= 0.0) {
    const double sped_m = std::abs(switch_m_ - start_m_), stopped_m = std::abs(furthest_m_ - switch_m_);
    if (sped_m > 0.0) stopShare_ = std::clamp(stopped_m / sped_m, 0.05, 1.0);
    if (++done_ % options_.strokes == 0) stopShare_ = 1.0;
    if (done_ >= all()) {
      resting_ = true;
      phase_s_ = sample.time_s;
      return {};
    }
    turnRound(sample);
  }
  if (braking_) return towards(-way_ * voltage_V());
  const double stretches = way_ * (sample.angle_rad - start_m_) / (options_.stretch * options_.travel.usable_m()) +
                           golden * static_cast<double>(done_);
  // From rest it takes the whole voltage.
  const bool goes =
      way_ * (sample.angle_rad - start_m_) > motion_m && sample.time_s - moved_s_ < 0.1 * options_.stall_s;
  const double wave = goes ? 0.5 * options_.depth * (1.0 - std::cos(turn_rad * stretches)) : 0.0;
  return towards(way_ * std::max(std::min(options_.least_V, voltage_V()), voltage_V() * (1.0 - wave)));
}

/// No jumps: blocks in which the current has only begun to follow would tell of the windings wrongly.
Command TravelStrokes::towards(double wanted_V) {
  const double step = voltage_V() / options_.rise_s * tick_s();
  now_V_ = std::clamp(wanted_V, now_V_ - step, now_V_ + step);
  return {Command::Mode::voltage, now_V_, 0.0, false};
}

TimedProcedure::Progress TravelStrokes::progress() const {
  constexpr double usual_s = 0.5;
  return {static_cast<double>(done_) / static_cast<double>(std::max<size_t>(1, all())),
          usual_s * static_cast<double>(all() - std::min(all(), done_)), message("going to and fro by voltage")};
}

}  // namespace breakaway
