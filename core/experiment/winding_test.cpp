#include "experiment/winding_test.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace breakaway {

namespace {
constexpr double rest_s = 0.4;
constexpr size_t bothWays = 2;  // ramps
constexpr double sure = 8.0;    // standard errors of a block
constexpr double raised = 1.2;  // of the voltage, at which the current of a standing motor is higher
constexpr double given = 0.9;   // of it, that the winding gets at least: less is the current limit's doing
}  // namespace

Command WindingTest::run(const Sample& sample) {
  if (isFirst()) stageStart_s_ = sample.time_s;
  if (isFirst()) restStart_rad_ = sample.angle_rad;
  now_s_ = elapsed_s(sample);
  switch (stage_) {
    case Stage::rest:
      return rest(sample);
    case Stage::ramp:
      return ramp(sample);
    case Stage::square:
      return square(sample);
  }
  return {};
}

Command WindingTest::rest(const Sample& sample) {
  const double inStage_s = sample.time_s - stageStart_s_;
  if (inStage_s > 0.05) open_A_.take(sample);
  if (!sample.enabled) swing_.take(sample);
  if (inStage_s < 0.5 * rest_s) halfway_rad_ = sample.angle_rad;
  if (inStage_s < rest_s) return {};
  // What friction alone slows down goes less far in the second half.
  const double second_rad = sample.angle_rad - halfway_rad_, first_rad = halfway_rad_ - restStart_rad_;
  const double gained_rad = second_rad > 0.0 ? second_rad - first_rad : first_rad - second_rad;
  if (std::abs(second_rad) > options_.motion_rad && gained_rad > options_.motion_rad)
    fail(heavyLoadText(second_rad > 0.0, options_.axis));
  if (const Message moved = open_A_.moved(options_.mostDrift_A); !moved.empty()) fail(moved);
  if (const Message play = swing_.words(); !play.empty()) fail(play);
  if (ramp_ == options_.ramps) {
    stage_ = Stage::square;
  } else {
    stage_ = Stage::ramp;
    target_V_ = options_.start_V;
  }
  stageStart_s_ = blockStart_s_ = still_s_ = sample.time_s;
  standing_rad_ = sample.angle_rad;
  return {};
}

void WindingTest::takePoint(const Sample& sample) {
  // A command acts until the next row, so the current measured now belongs to the voltage up to now.
  blockVoltage_ += way() * target_V_;
  blockCurrent_ += sample.current_A;
  ++blockCount_;
  if (sample.time_s - blockStart_s_ < options_.block_s) return;
  const auto n = static_cast<double>(blockCount_);
  blocks_.push_back({blockVoltage_ / n, blockCurrent_ / n});
  blockNoise_A_ = options_.noise_A / std::sqrt(n);
  const WindingPoint now{way() * blocks_.back().voltage_V, way() * blocks_.back().current_A};
  if (now.current_A > peak_.current_A) peak_ = now;
  blockTimes_s_.push_back(sample.time_s);
  blockVoltage_ = blockCurrent_ = 0.0;
  blockCount_ = 0;
  blockStart_s_ = sample.time_s;
}

void WindingTest::endRamp(const Sample& sample) {
  double highest = 0.0, standing_V = 0.0;
  for (size_t k = 0; k < blocks_.size(); ++k) {
    // From letting go to the first count takes less than half of the time from there to where it counts as motion.
    if (blockTimes_s_[k] > still_s_ - std::max(options_.dates_s, 0.4 * (sample.time_s - still_s_))) continue;
    points_.push_back(blocks_[k]);
    highest = std::max(highest, way() * blocks_[k].current_A);
    standing_V = std::max(standing_V, way() * blocks_[k].voltage_V);
  }
  breakaway_A_[way() > 0.0 ? 1 : 0].push_back(highest);
  if (const Message wrong = wrongCurrent(sample); !wrong.empty()) fail(wrong);
  if (way() * (sample.angle_rad - standing_rad_) < 0.0) ++against_;
  if (!blocks_.empty()) along_A_ += way() * blocks_.back().current_A;
  standing_V_ = ramp_ == 0 ? standing_V : std::min(standing_V_, standing_V);
  blocks_.clear();
  peak_ = {};
  blockTimes_s_.clear();
  blockVoltage_ = blockCurrent_ = 0.0;
  blockCount_ = 0;
  ++ramp_;
  swing_.begin();
  stage_ = Stage::rest;
  stageStart_s_ = sample.time_s;
  restStart_rad_ = sample.angle_rad;
  if (const Message wrong = ramp_ == bothWays ? wrongSigns() : Message(); !wrong.empty()) fail(wrong);
}

/// Open loop, the first motion each way tells the signs of encoder and current; a load may spoil one way, not both.
Message WindingTest::wrongSigns() const {
  const Message body = bodyText(options_.axis), way = wayText(false, options_.axis);
  if (against_ == bothWays && along_A_ > 0.0)
    return message("{} moves {} at positive voltage and current: swap the encoder's A and B, or the motor's leads",
                   body, way);
  if (against_ == bothWays)
    return message(
        "{} moves {} at positive voltage, and the current flows that way, too: the bridge is reversed; swap its two "
        "inputs, or the sign in the board",
        body, way);
  return {};
}

/// Whether it went against the voltage while nothing moved.
bool WindingTest::flowsAgainst() const {
  double power_W = 0.0, square_V2 = 0.0;
  for (size_t k = 0; k < blocks_.size() && blockTimes_s_[k] <= still_s_; ++k) {
    power_W += blocks_[k].voltage_V * blocks_[k].current_A;
    square_V2 += blocks_[k].voltage_V * blocks_[k].voltage_V;
  }
  return power_W < -sure * blockNoise_A_ * std::sqrt(square_V2);
}

/// A load that drives the motor faster than its voltage does turns the current round, but not before it moves.
Message WindingTest::wrongCurrent(const Sample& sample) const {
  if (blocks_.empty() || !(blockNoise_A_ > 0.0) || way() * blocks_.back().current_A > -sure * blockNoise_A_) return {};
  const bool along = way() * (sample.angle_rad - standing_rad_) > 0.0;
  if (along && !flowsAgainst()) return heavyLoadText(way() > 0.0, options_.axis);
  return along ? message(
                     "{} moves with the voltage, but the current falls as the voltage rises: the current sensor is "
                     "reversed; swap its leads, or the sign in the board",
                     bodyText(options_.axis))
               : message(
                     "{} and the current both go against the voltage: the bridge is reversed; swap its two inputs, or "
                     "the sign in the board",
                     bodyText(options_.axis));
}

/// A standing motor's current rises with the voltage; one that turns takes what friction takes.
bool WindingTest::runsUnseen() const {
  constexpr size_t enough = 3;  // blocks
  if (blocks_.size() < enough || !(blockNoise_A_ > 0.0) || peak_.current_A < 2.0 * sure * blockNoise_A_) return false;
  return std::all_of(blocks_.end() - enough, blocks_.end(), [this](const WindingPoint& one) {
    return way() * one.voltage_V > raised * peak_.voltage_V && way() * one.current_A < peak_.current_A;
  });
}

Command WindingTest::ramp(const Sample& sample) {
  takePoint(sample);
  const bool limited = way() * sample.voltage_V < given * target_V_;
  if (sample.angle_rad == standing_rad_ && !limited && runsUnseen()) {
    fail(message(
        "the encoder stands while the current says that the motor turns; check the encoder's cable and supply, and the "
        "coupling"));
    return {};
  }
  if (sample.angle_rad == standing_rad_) still_s_ = sample.time_s;
  if (std::abs(sample.angle_rad - standing_rad_) > options_.motion_rad) {
    endRamp(sample);
    return {};
  }
  if (target_V_ >= sample.supply_V) {
    fail(message("{} does not move {} at full supply within the current limit", bodyText(options_.axis),
                 wayText(way() > 0.0, options_.axis)));
    return {};
  }
  target_V_ =
      std::min(sample.supply_V, options_.start_V * std::exp2((sample.time_s - stageStart_s_) / options_.doubling_s));
  return voltage(way() * target_V_);
}

Command WindingTest::square(const Sample& sample) {
  if (squareTicks_ == 0) {
    squareTick_s_ = tick_s();
    const auto line = fitWindingLine(points_);
    onset_V_ = line ? line->deadZone_V.value : 0.0;
  }
  const auto half = static_cast<size_t>(std::max(4.0, std::round(options_.squareHalfPeriod_s / squareTick_s_)));
  if (!response_) response_.emplace(half, squareTick_s_);
  response_->take(sample);
  const size_t phase = squareTicks_++ % (2 * half);
  if (sample.time_s - stageStart_s_ >= options_.square_s) finish();
  const double level = onset_V_ + 0.6 * std::max(0.0, standing_V_ - onset_V_);
  return voltage(phase < half ? level : -level);
}

TimedProcedure::Progress WindingTest::progress() const {
  const auto ramps = static_cast<double>(options_.ramps);
  const bool squares = stage_ == Stage::square;
  const double square = squares ? static_cast<double>(squareTicks_) * squareTick_s_ / options_.square_s : 0.0;
  const double part = std::min(1.0, 0.8 * static_cast<double>(ramp_) / ramps + 0.2 * square);
  const double done = std::max(part, 0.05);
  return {part, now_s_ < 1.0 ? 6.0 * ramps + options_.square_s : now_s_ * (1.0 - done) / done,
          squares ? message("measuring the winding's time constant")
                  : message("raising the voltage {} until {} moves", wayText(way() > 0.0, options_.axis),
                            bodyText(options_.axis))};
}

}  // namespace breakaway
