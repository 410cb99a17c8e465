#include "experiment/velocity_sweep.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numbers.h"

namespace breakaway {

namespace {
constexpr double spanAngle_rad = 1.0 / 40.0;      // half the span of a speed; order 45 is then shown by sin(1.1)/1.1
constexpr double fastSpanAngle_rad = 1.0 / 12.0;  // where the inertia hides the finest harmonics anyway
constexpr double smoothing_s = 0.15;
constexpr double sampleEvery_s = 0.25;  // whole turns of the run under way
constexpr double leastPart = 0.1;       // of a run, that is made of what was broken off near its end
constexpr double slowPart = 0.5;  // of the highest speed, below which friction that falls may be why it isn't held
constexpr double leastMean = 0.5, mostMean = 2.0;  // of a speed that is met on average
constexpr size_t fewestSpeeds = 3;                 // that must be left each way
constexpr double ofBin = 1e-6;  // a count that begins with its bin belongs to it, whatever rounding makes of both

}  // namespace

double beyondBins_rad(double countsPerRev, size_t bins, double indexAngle_rad) {
  if (!(countsPerRev > 0.0) || bins == 0 || std::fmod(countsPerRev, static_cast<double>(bins)) != 0.0) return 0.0;
  const double count_rad = turn_rad / countsPerRev;
  const double first = -indexAngle_rad / count_rad + ofBin * countsPerRev / static_cast<double>(bins);
  return (first - std::floor(first) - 0.5) * count_rad;
}

VelocitySweep::VelocitySweep(VelocitySweepOptions options, const std::vector<VelocityRun>& earlier)
    : options_(std::move(options)),
      zeroing_(options_.zeroing_s),
      index_(options_.indexAngle_rad, options_.indexTolerance_rad) {
  if (options_.speeds_rad_per_s.empty() || options_.bins == 0) {
    fail(message("no speed or no bin is asked for"));
    return;
  }
  for (size_t k = 0; k < 2 * options_.speeds_rad_per_s.size(); ++k) {
    const auto same = [&](const VelocityRun& run) { return run.isAt(targetOf(k)) && run.bins.size() == options_.bins; };
    if (isDone(targetOf(k))) continue;
    for (const VelocityRun& run : earlier) {
      if (same(run) && !isDone(targetOf(k))) runs_.push_back(run);
    }
  }
  skipDone();
  if (next_ >= 2 * options_.speeds_rad_per_s.size()) finish();
}

bool VelocitySweep::isDone(double target_rad_per_s) const {
  return std::any_of(runs_.begin(), runs_.end(),
                     [&](const VelocityRun& run) { return !run.brokenOff && run.isAt(target_rad_per_s); }) ||
         std::any_of(leftOut_rad_per_s_.begin(), leftOut_rad_per_s_.end(),
                     [&](double one) { return isSameSpeed(one, target_rad_per_s); });
}

/// Whether it goes on average as fast as it shall, though never steadily: below the speed over which friction falls, a
/// loop that isn't quick enough lets the rotor stick and slip.
bool VelocitySweep::slips(const Sample& sample) const {
  const auto& speeds = options_.speeds_rad_per_s;
  const auto sameWay = [&](double one) { return (one > 0.0) == (target() > 0.0); };
  // Where a second one slips, so does a part of the turn at those above it, and they would make a wrong map.
  if (std::any_of(leftOut_rad_per_s_.begin(), leftOut_rad_per_s_.end(), sameWay)) return false;
  if (speeds.size() <= fewestSpeeds) return false;
  if (std::abs(target()) > slowPart * *std::max_element(speeds.begin(), speeds.end())) return false;
  const double mean = (sample.angle_rad - legStart_rad_) / (sample.time_s - legStart_s_) / target();
  return mean > leastMean && mean < mostMean;
}

/// Of the run at the next speed, without what was measured before it was broken off.
double VelocitySweep::left_s() const {
  double left_s = options_.run_s;
  for (const VelocityRun& run : runs_) {
    if (run.isAt(target())) left_s -= run.duration_s;
  }
  return std::max(left_s, leastPart * options_.run_s);
}

void VelocitySweep::skipDone() {
  while (next_ < 2 * options_.speeds_rad_per_s.size() && isDone(targetOf(next_))) ++next_;
}

double VelocitySweep::targetOf(size_t number) const {
  const double speed = options_.speeds_rad_per_s[std::min(number / 2, options_.speeds_rad_per_s.size() - 1)];
  return number % 2 == 0 ? speed : -speed;
}

double VelocitySweep::target() const {
  return targetOf(next_);
}

double VelocitySweep::wobbleAt(double time_s) const {
  const double phase = (time_s - runStart_s_) / thisRun_s_;
  return options_.wobble * triangle(phase - std::floor(phase));
}

void VelocitySweep::enter(Stage stage, const Sample& sample) {
  stage_ = stage;
  stageStart_s_ = sample.time_s;
  legStart_s_ = sample.time_s;
  legStart_rad_ = sample.angle_rad;
  if (stage == Stage::speed && next_ < 2 * options_.speeds_rad_per_s.size()) begin();
}

void VelocitySweep::begin() {
  thisRun_s_ = left_s();
  SpeedPlan<double> plan;
  plan.target_rad_per_s = target();
  plan.wobble = options_.wobble;
  plan.settle_s = options_.settle_s;
  plan.run_s = thisRun_s_;
  plan.leastTurns = static_cast<std::uint16_t>(std::min<size_t>(options_.leastTurns, 60'000));
  seen_ = notBegun;
  beginLeg({plan, 0.0, options_.current_limit_A}, options_.countsPerRev);
}

Command VelocitySweep::run(const Sample& sample) {
  now_s_ = sample.time_s;
  zeroing_.see(sample);
  if (isFirst()) enter(options_.zeroing_s > 0.0 ? Stage::zero : Stage::speed, sample);
  mean_rad_per_s_ += (sample.velocity_rad_per_s - mean_rad_per_s_) * std::min(1.0, tick_s() / smoothing_s);
  if (const Message wrong = index_.step(sample); !wrong.empty()) fail(wrong);
  if (stage_ == Stage::zero) return zero(sample);
  follow(sample);
  return {};
}

/// Takes a run's sums as the leg goes through its stages.
void VelocitySweep::follow(const Sample& sample) {
  const LegPhase before = std::exchange(seen_, legPhase());
  switch (seen_) {
    case Machine::hold:
      if (before != Machine::hold) {
        beginRun(sample);
      } else {
        sum(sample);
      }
      return;
    case Machine::done:
      endLeg();
      sum(sample);
      endRun(sample);
      return;
    case Machine::notReached:
      if (slips(sample)) {
        endLeg();
        leftOut_rad_per_s_.push_back(target());
        return goOn(sample);
      }
      return fail(message("the speed {:.1f} rad/s was not reached, only {:.1f} rad/s", target(), mean_rad_per_s_));
    case Machine::lost:
      return fail(message(
          "the speed {:.1f} rad/s was lost at {}, only {:.1f} rad/s are left; is the shaft held, or the limit too low?",
          target(), degreesText(sample.angle_rad - options_.indexAngle_rad), mean_rad_per_s_));
    default:
      return;
  }
}

Command VelocitySweep::zero(const Sample& sample) {
  bool done = false;
  const Command command = zeroing_.step(sample, stageStart_s_, done);
  if (!done) return command;
  if (const Message moved = zeroing_.moved(options_.mostDrift_A); !moved.empty()) fail(moved);
  if (next_ >= 2 * options_.speeds_rad_per_s.size()) {
    finish();
  } else {
    enter(Stage::speed, sample);
  }
  return command;
}

void VelocitySweep::beginRun(const Sample& sample) {
  runStart_s_ = kept_s_ = sample.time_s;
  startAngle_rad_ = sample.angle_rad;
  // As long a span as the finest harmonics allow: it divides the encoder's rounding.
  const double slowest = *std::min_element(options_.speeds_rad_per_s.begin(), options_.speeds_rad_per_s.end());
  const double span_rad = std::abs(target()) > 4.0 * slowest ? fastSpanAngle_rad : spanAngle_rad;
  span_ = static_cast<size_t>(std::max(1.0, std::floor(span_rad / (std::abs(target()) * tick_s()))));
  taken_ = 0;
  angles_rad_.assign(2 * span_ + 1, 0.0);
  currents_A_.assign(2 * span_ + 1, 0.0);
  open_ = {};
  open_.target_rad_per_s = target();
  open_.zero_A = zeroing_.zero_A();
  open_.start_rad = sample.angle_rad - options_.indexAngle_rad;
  turnSpeeds_rad_per_s_.clear();
  turnEnds_s_ = {sample.time_s};
  turnAngle_rad_ = sample.angle_rad;
  turnStart_s_ = sample.time_s;
  open_.halfSpan_s = static_cast<double>(span_) * tick_s();
  const size_t perBin = cellsPerBin(options_.countsPerRev, options_.bins, thisRun_s_ / tick_s());
  cells_ = AngleCells(options_.bins, perBin);
  blockCells_.clear();
  perBin_ = perBin;
  // Blocks are of whole turns, so that what differs between them is no part of the rotor's own variation.
  const double expected = std::abs(target()) * options_.run_s / turn_rad / static_cast<double>(options_.blocks);
  turnsPerBlock_ = static_cast<size_t>(std::max(1.0, std::floor(expected)));
}

void VelocitySweep::sum(const Sample& sample) {
  // A whole turn is a whole number of counts, which rounding must not miss.
  const double turns = std::abs(sample.angle_rad - startAngle_rad_) / turn_rad + 1e-9;
  if (std::floor(turns) > static_cast<double>(open_.turns)) {
    open_.turns = static_cast<size_t>(std::floor(turns));
    turnSpeeds_rad_per_s_.push_back((sample.angle_rad - turnAngle_rad_) / (sample.time_s - turnStart_s_));
    turnEnds_s_.push_back(sample.time_s);
    turnAngle_rad_ = sample.angle_rad;
    turnStart_s_ = sample.time_s;
    if (seen_ == Machine::done) return;
    keepTurns(sample.time_s);
  }
  const size_t size = angles_rad_.size(), newest = taken_ % size;
  angles_rad_[newest] = sample.angle_rad;
  currents_A_[newest] = sample.current_A;
  if (++taken_ < size) return;
  const size_t oldest = (newest + 1) % size, middle = (newest + size - span_) % size;
  // Freed of the wobble, which each bin meets at other moments; the swing of an eccentric encoder goes with the speed.
  const double velocity = (sample.angle_rad - angles_rad_[oldest]) / (2.0 * open_.halfSpan_s) /
                          (1.0 + wobbleAt(sample.time_s - open_.halfSpan_s));
  const double place = (angles_rad_[middle] - options_.indexAngle_rad) / turn_rad;
  const double inBins = (place - std::floor(place)) * static_cast<double>(options_.bins) + ofBin;
  const auto bin = static_cast<size_t>(inBins) % options_.bins;
  const size_t block = open_.turns / turnsPerBlock_;
  if (block >= blockCells_.size()) blockCells_.emplace_back(options_.bins, perBin_);
  cells_.add(bin, inBins, currents_A_[middle], velocity);
  blockCells_.back().add(bin, inBins, currents_A_[middle], velocity);
}

/// Between two turns the speed is the mean of theirs; before the first and after the last it goes on as it did.
void VelocitySweep::dateBlocks(VelocityRun& run) const {
  const auto& speeds = turnSpeeds_rad_per_s_;
  const auto between = [&speeds](size_t after) {
    if (speeds.size() < 2) return speeds[0];
    if (after == 0) return 1.5 * speeds[0] - 0.5 * speeds[1];
    if (after >= speeds.size()) return 1.5 * speeds.back() - 0.5 * speeds[speeds.size() - 2];
    return 0.5 * (speeds[after - 1] + speeds[after]);
  };
  for (size_t k = 0; k < run.blocks.size(); ++k) {
    RunBlock& block = run.blocks[k];
    const size_t first = k * turnsPerBlock_, end = k + 1 < run.blocks.size() ? first + turnsPerBlock_ : run.turns;
    block.turns = end - first;
    block.startSpeed_rad_per_s = between(first);
    block.endSpeed_rad_per_s = between(end);
    block.startWobble_rad_per_s = target() * wobbleAt(turnEnds_s_[first]);
    block.endWobble_rad_per_s = target() * wobbleAt(turnEnds_s_[end]);
  }
}

/// The open run, of the turns that are complete at this time.
VelocityRun VelocitySweep::closed(double time_s) const {
  VelocityRun run = open_;
  run.bins = cells_.bins(cells_);
  for (const AngleCells& block : blockCells_) {
    run.blocks.emplace_back();
    run.blocks.back().bins = block.bins(cells_);
  }
  run.duration_s = time_s - runStart_s_;
  run.middle_s = 0.5 * (time_s + runStart_s_);
  // What is left over after the last whole block goes into it.
  if (run.blocks.size() > 2 && run.turns % turnsPerBlock_ != 0) {
    const auto rest = std::move(run.blocks.back());
    run.blocks.pop_back();
    for (size_t k = 0; k < rest.bins.size(); ++k) run.blocks.back().bins[k].add(rest.bins[k]);
  }
  dateBlocks(run);
  return run;
}

/// Now and then: a fast run has many turns a second.
void VelocitySweep::keepTurns(double time_s) {
  if (blockCells_.empty() || time_s - kept_s_ < sampleEvery_s) return;
  kept_s_ = time_s;
  underWay_ = closed(time_s);
  underWay_->brokenOff = true;
}

void VelocitySweep::endRun(const Sample& sample) {
  runs_.push_back(closed(sample.time_s));
  underWay_.reset();
  goOn(sample);
}

void VelocitySweep::goOn(const Sample& sample) {
  skipDone();
  if (next_ >= 2 * options_.speeds_rad_per_s.size() && options_.zeroing_s <= 0.0) finish();
  enter(options_.zeroing_s > 0.0 ? Stage::zero : Stage::speed, sample);
}

TimedProcedure::Progress VelocitySweep::progress() const {
  const double all = 2.0 * static_cast<double>(options_.speeds_rad_per_s.size()), done = static_cast<double>(next_);
  const bool holds = seen_ == Machine::hold;
  const double running = holds ? std::min(1.0, (now_s_ - runStart_s_) / thisRun_s_) : 0.0;
  const double part = done >= all ? 1.0 : (done + running) / all;
  return {part, (1.0 - part) * all * (options_.settle_s + options_.zeroing_s + options_.run_s),
          stage_ == Stage::zero ? zeroingText
                                : message("{} {} at {:.1f} rad/s", holds ? message("measuring") : message("settling"),
                                          wayText(target() > 0.0), std::abs(target()))};
}

}  // namespace breakaway
