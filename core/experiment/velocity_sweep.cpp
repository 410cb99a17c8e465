#include "experiment/velocity_sweep.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace breakaway {

namespace {
constexpr double turn = 2.0 * std::numbers::pi;
}

VelocitySweep::VelocitySweep(VelocitySweepOptions options) : options_(std::move(options)) {
  if (options_.speeds_rad_per_s.empty() || options_.bins == 0) fail("no speed or no bin is asked for");
}

double VelocitySweep::target() const {
  const double speed = options_.speeds_rad_per_s[std::min(next_ / 2, options_.speeds_rad_per_s.size() - 1)];
  return next_ % 2 == 0 ? speed : -speed;
}

void VelocitySweep::enter(Stage stage, const Sample& sample) {
  stage_ = stage;
  stageStart_s_ = sample.time_s;
}

Command VelocitySweep::run(const Sample& sample) {
  now_s_ = sample.time_s;
  if (!begun_) {
    begun_ = true;
    enter(options_.zeroing_s > 0.0 ? Stage::zero : Stage::settle, sample);
  }
  const double inStage_s = sample.time_s - stageStart_s_;
  switch (stage_) {
    case Stage::zero: {
      if (inStage_s > 0.05 + options_.zeroing_s) {
        enter(Stage::settle, sample);
        return {};
      }
      Command command;
      command.zeroCurrentSensor = inStage_s > 0.05;
      return command;
    }
    case Stage::settle: {
      const bool near = std::abs(sample.velocity_rad_per_s - target()) < 0.1 * std::abs(target()) + 0.3;
      if (inStage_s > options_.settle_s && near) {
        enter(Stage::sum, sample);
        runStart_s_ = sample.time_s;
        startAngle_rad_ = sample.angle_rad;
        open_ = {target(), 0, 0.0, tick_s(), std::vector<AngleBinSums>(options_.bins), {}};
        open_.blocks.assign(std::max<size_t>(2, options_.blocks), open_.bins);
        held_ = 0;
      } else if (inStage_s > options_.settle_s + 5.0) {
        char text[96];
        std::snprintf(text, sizeof text, "the speed %.1f rad/s was not reached, only %.1f rad/s", target(),
                      sample.velocity_rad_per_s);
        fail(text);
      }
      return drive();
    }
    case Stage::sum:
      sum(sample);
      return drive();
  }
  return {};
}

void VelocitySweep::sum(const Sample& sample) {
  const double turns = std::abs(sample.angle_rad - startAngle_rad_) / turn;
  const bool enough =
      sample.time_s - runStart_s_ >= options_.run_s && turns >= static_cast<double>(options_.leastTurns);
  if (enough && std::floor(turns) > static_cast<double>(open_.turns)) {
    open_.turns = static_cast<size_t>(std::floor(turns));
    endRun(sample);
    return;
  }
  open_.turns = static_cast<size_t>(std::floor(turns));
  if (held_ >= 2) {
    const double velocity = (sample.angle_rad - angles_rad_[1]) / (2.0 * tick_s());
    const double place = (angles_rad_[0] - options_.indexAngle_rad) / turn;
    const auto bin =
        static_cast<size_t>((place - std::floor(place)) * static_cast<double>(options_.bins)) % options_.bins;
    const double part = (sample.time_s - runStart_s_) / options_.run_s;
    const auto block = static_cast<size_t>(std::clamp(part, 0.0, 1.0) * static_cast<double>(open_.blocks.size()));
    open_.bins[bin].add(current_A_, velocity);
    open_.blocks[std::min(block, open_.blocks.size() - 1)][bin].add(current_A_, velocity);
  } else {
    ++held_;
  }
  angles_rad_[1] = angles_rad_[0];
  angles_rad_[0] = sample.angle_rad;
  current_A_ = sample.current_A;
}

void VelocitySweep::endRun(const Sample& sample) {
  open_.duration_s = sample.time_s - runStart_s_;
  runs_.push_back(open_);
  ++next_;
  if (next_ >= 2 * options_.speeds_rad_per_s.size()) finish();
  enter(options_.zeroing_s > 0.0 ? Stage::zero : Stage::settle, sample);
}

double VelocitySweep::progress() const {
  const double part = stage_ == Stage::sum ? std::min(1.0, (now_s_ - runStart_s_) / options_.run_s) : 0.0;
  return (static_cast<double>(next_) + part) / (2.0 * static_cast<double>(options_.speeds_rad_per_s.size()));
}

double VelocitySweep::remaining_s() const {
  const double one = options_.settle_s + options_.zeroing_s + options_.run_s;
  return (1.0 - progress()) * one * 2.0 * static_cast<double>(options_.speeds_rad_per_s.size());
}

std::string VelocitySweep::activity() const {
  char text[96];
  std::snprintf(text, sizeof text, "%s %s at %.1f rad/s", stage_ == Stage::sum ? "measuring" : "settling",
                wayText(target() > 0.0).c_str(), std::abs(target()));
  return stage_ == Stage::zero ? "zeroing the current sensor" : text;
}

}  // namespace breakaway
