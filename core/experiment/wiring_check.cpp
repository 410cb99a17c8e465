#include "experiment/wiring_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace breakaway {

namespace {

constexpr double fallen = 0.1;        // of a pulse's current, that only a turning motor takes off
constexpr double longer = 3.0;        // pulses, where none moved it
constexpr double still_s = 0.02;      // without a count is at rest
constexpr double stillPulses = 5.0;   // of a pulse, part of what is motion, that a slower rotor stays below in it
constexpr double stands_s = 0.5;      // likewise, of what coasts
constexpr double fellFar = 4.0;       // times what is its own, that only a load moves it by from standstill
constexpr double mostCoast_s = 20.0;  // a load drives what still turns
constexpr double gained = 1.1;        // of what it went before
constexpr size_t enoughFaster = 2;    // stretches in a row
constexpr size_t manyStretches = 10;
constexpr double kept = 0.98, wellCounted = 100.0;  // of a stretch's travel so long before; counts
constexpr double givenPart = 0.9;                   // of the voltage asked for: less is the current limit's doing
constexpr double roomPart = 0.7;      // of the current limit: the bridge's dead zone makes it more than in proportion
constexpr double steady = 0.98;       // of the voltage asked for, on average
constexpr size_t enoughUnslowed = 2;  // that cogging doesn't make
constexpr double surelyBraked_s = 5.0;
constexpr double windowCounts = 3.0;  // that a turning shaft passes at least, while it is watched
constexpr double usual_s = 6.0;       // that it takes
constexpr double ownPlay = 2.5;       // times own_rad, beyond which what moves by itself is pulled
constexpr double longestSwing_s = 5.0;

double perMean(double noise_A, size_t samples) {
  return noise_A / std::sqrt(static_cast<double>(std::max<size_t>(1, samples)));
}

}  // namespace

Command WiringCheck::run(const Sample& sample) {
  if (isFirst()) {
    level_V_ = options_.start_V;
    way_ = -1.0;
    begin(options_.coast_s > 0.0 ? Stage::coast : Stage::brake, sample);  // what went before may have left it turning
    coastStart_rad_ = sample.angle_rad;
    coastStartSpeed_rad_per_s_ = std::abs(sample.velocity_rad_per_s);
  }
  last_s_ = elapsed_s(sample);
  mostSupply_V_ = std::max(mostSupply_V_, sample.supply_V);
  watchIndex(sample);
  switch (stage_) {
    case Stage::coast:
      return coast(sample);
    case Stage::rest:
      return rest(sample);
    case Stage::pulse:
      return pulse(sample);
    case Stage::kick:
      return kick(sample);
    case Stage::brake:
      return brake(sample);
    case Stage::swing:
      return swing(sample);
  }
  return {};
}

void WiringCheck::begin(Stage stage, const Sample& sample) {
  stage_ = stage;
  stageStart_s_ = anchor_s_ = sample.time_s;
  anchor_rad_ = sample.angle_rad;
  thirds_ = {};
  energised_s_.reset();
  windowStart_s_ = sample.time_s;
  windowStart_rad_ = sample.angle_rad;
  lastTravel_rad_ = std::numeric_limits<double>::infinity();
  unslowed_ = 0;
  brakeStart_rad_ = sample.angle_rad;
  furthest_rad_ = 0.0;
  turnedRound_ = false;
  swing_.begin();
}

/// Seen over more of the turn than an index is wide, and in most ticks.
void WiringCheck::watchIndex(const Sample& sample) {
  ++ticks_;
  if (!sample.index) return;
  ++indexSeen_;
  indexLow_rad_ = std::min(indexLow_rad_.value_or(sample.angle_rad), sample.angle_rad);
  indexHigh_rad_ = std::max(indexHigh_rad_.value_or(sample.angle_rad), sample.angle_rad);
}

Command WiringCheck::coast(const Sample& sample) {
  const double gone_s = elapsed_s(sample);
  if (gainsSpeed(sample)) {
    fail(heavyLoadText(lastTravel_rad_ > 0.0, options_.axis));
    return {};
  }
  if (std::abs(sample.angle_rad - anchor_rad_) > 1.5 * options_.count_rad) {
    anchor_rad_ = sample.angle_rad;
    anchor_s_ = sample.time_s;
  }
  const bool over = gone_s > options_.coast_s && sample.time_s - anchor_s_ > stands_s;
  if (over || gone_s > mostCoast_s) {
    const double moved_rad = sample.angle_rad - coastStart_rad_, took_s = anchor_s_ - stageStart_s_;
    const double byItself_rad = std::max(fellFar * options_.own_rad, 2.0 * coastStartSpeed_rad_per_s_ * took_s);
    if (std::abs(moved_rad) > byItself_rad) fell_rad_ = moved_rad;
    begin(Stage::brake, sample);
  }
  return {};
}

/// With the windings open only a load makes it faster, from one stretch of brake_s to the next and once more.
bool WiringCheck::gainsSpeed(const Sample& sample) {
  if (sample.time_s - windowStart_s_ < options_.brake_s) return false;
  const double travel_rad = sample.angle_rad - windowStart_rad_;
  const bool sameWay = travel_rad * lastTravel_rad_ > 0.0;
  const double least_rad = gained * std::abs(lastTravel_rad_) + 1.5 * options_.count_rad;
  const bool gains =
      sameWay && std::isfinite(lastTravel_rad_) && std::abs(travel_rad) > std::max(least_rad, options_.own_rad);
  faster_ = gains ? faster_ + 1 : 0;
  // Nor does what friction slows down keep its speed for seconds.
  if (stretches_++ % manyStretches == 0) {
    const double before_rad = std::exchange(steady_rad_, std::abs(travel_rad));
    if (sameWay && before_rad > wellCounted * options_.count_rad && steady_rad_ > kept * before_rad)
      faster_ = enoughFaster;
  }
  lastTravel_rad_ = travel_rad;
  windowStart_rad_ = sample.angle_rad;
  windowStart_s_ = sample.time_s;
  return faster_ >= enoughFaster;
}

Command WiringCheck::rest(const Sample& sample) {
  supplySum_V_ += sample.supply_V;
  ++supplyCount_;
  if (std::abs(sample.angle_rad - anchor_rad_) > options_.own_rad) {
    begin(Stage::swing, sample);
    return {};
  }
  if (sample.time_s - stageStart_s_ < options_.rest_s) return {};
  if (const Message wrong = contradiction(); !wrong.empty()) {
    fail(wrong);
    return {};
  }
  const bool pulses = chooseNext(sample.supply_V);
  if (!pulses && state() != State::running) return {};
  if (!pulses && !chooseKick(sample.supply_V)) {
    finish();
    return {};
  }
  begin(pulses ? Stage::pulse : Stage::kick, sample);
  return drive();
}

/// The way and voltage of the next pulse; false when there is none, or none that could help.
bool WiringCheck::chooseNext(double supply_V) {
  for (const size_t next : {size_t{1}, size_t{0}}) {
    const size_t other = 1 - next;
    if (loose_V_[next]) continue;
    // Alternately, while neither is loose.
    if (!loose_V_[other] && next == side()) continue;
    const bool last = limited_ || level_V_ >= supply_V;
    if (loose_V_[other] && level_V_ > options_.oneSided * *loose_V_[other]) return false;
    if (loose_V_[other] && last && !beginLonger()) return false;
    if (next == 1 || loose_V_[other]) level_V_ = std::min(supply_V, level_V_ * options_.growth);
    const bool unseen = currentSign() == 0 && level_V_ > options_.seenPart * supply_V;
    if (next == 1 && !loose_V_[other] && (last || unseen) && !beginLonger()) {
      fail(standstill(supply_V));
      return false;
    }
    way_ = next == 1 ? 1.0 : -1.0;
    return true;
  }
  return false;
}

/// Not where something else than the rotor's weight may be why nothing moves.
bool WiringCheck::beginLonger() {
  if (currentSign() <= 0 || longer * options_.pulse_s > options_.longestPulse_s) return false;
  options_.pulse_s *= longer;
  level_V_ = options_.start_V;
  limited_ = false;
  standing_ = {};
  loose_V_ = {};
  breakaway_A_ = {};
  falls_ = 0;
  return true;
}

bool WiringCheck::chooseKick(double supply_V) {
  for (size_t round = 0; round < kicksEachWay; ++round) {
    for (const size_t next : {size_t{1}, size_t{0}}) {
      if (!loose_V_[next] || kicked_[next] > round) continue;
      ++kicked_[next];
      way_ = next == 1 ? 1.0 : -1.0;
      level_V_ = kickVoltage(supply_V) * (round > 0 && currentSign() == 0 ? options_.kickRatio : 1.0);
      return true;
    }
  }
  return false;
}

double WiringCheck::kickVoltage(double supply_V) const {
  const double loose_A = breakaway_A_[side()] ? breakaway_A_[side()]->value : 0.0;
  const double room =
      options_.most_A > 0.0 && loose_A > 0.0 ? roomPart * options_.most_A / loose_A : options_.kickRatio;
  return std::min(supply_V, std::clamp(room, 1.0, options_.kickRatio) * *loose_V_[side()]);
}

/// Of every driven tick.
void WiringCheck::weigh(const Sample& sample) {
  sums_.power_W += sample.voltage_V * sample.current_A;
  sums_.square_V2 += sample.voltage_V * sample.voltage_V;
  sums_.voltage_V += sample.voltage_V;
  sums_.current_A += sample.current_A;
  sums_.count += 1.0;
  if (!constant_A_) constant_A_ = sample.current_A;
  changes_ = changes_ || sample.current_A != *constant_A_;
  if (const double size_V = std::abs(sample.voltage_V); size_V > 0.0)
    bridgeStep_V_ = bridgeStep_V_ > 0.0 ? std::min(bridgeStep_V_, size_V) : size_V;
  if (sums_.count == 1.0 || sample.current_A != unchanged_.shown_A)
    unchanged_ = {sample.current_A, sample.voltage_V, sample.voltage_V};
  unchanged_.low_V = std::min(unchanged_.low_V, sample.voltage_V);
  unchanged_.high_V = std::max(unchanged_.high_V, sample.voltage_V);
}

Command WiringCheck::pulse(const Sample& sample) {
  if (!sample.enabled) return drive();
  if (!energised_s_) energised_s_ = sample.time_s;
  weigh(sample);
  const double by_rad = sample.angle_rad - anchor_rad_, inPulse_s = sample.time_s - *energised_s_;
  if (std::abs(by_rad) > options_.motion_rad) {
    loose_V_[side()] = level_V_;
    breakaway_A_[side()] = looseCurrent();
    moved(by_rad);
    begin(Stage::brake, sample);
    return brake(sample);
  }
  if (inPulse_s >= options_.settle_s) {
    const double part = (inPulse_s - options_.settle_s) / (options_.pulse_s - options_.settle_s);
    Sum& sum = thirds_[std::min<size_t>(2, static_cast<size_t>(3.0 * part))];
    sum.voltage_V += sample.voltage_V;
    sum.current_A += sample.current_A;
    ++sum.count;
  }
  if (inPulse_s < options_.pulse_s) return drive();
  const bool stood = std::abs(by_rad) <= 1.5 * options_.count_rad;
  if (stood) takeStanding();
  // It may turn within a coarse count.
  begin(stood && options_.count_rad < fine_rad ? Stage::rest : Stage::brake, sample);
  return {};
}

/// Before the motion that ends a pulse; where that came at once, between the last level and this one.
Estimate WiringCheck::looseCurrent() const {
  double current_A = 0.0;
  size_t count = 0;
  for (const Sum& one : thirds_) {
    current_A += one.current_A;
    count += one.count;
  }
  if (count >= fewestSamples) return {way_ * current_A / static_cast<double>(count), perMean(options_.noise_A, count)};
  const Level last = standing_[side()].value_or(Level{});
  const double step_A = (options_.growth - 1.0) * std::abs(last.current_A);
  return {way_ * last.current_A + 0.5 * step_A, std::hypot(perMean(options_.noise_A, fewestSamples), 0.5 * step_A)};
}

/// Of a pulse that the encoder stood through.
void WiringCheck::takeStanding() {
  Level all;
  size_t count = 0;
  for (const Sum& one : thirds_) {
    all.voltage_V += one.voltage_V;
    all.current_A += one.current_A;
    count += one.count;
  }
  if (count == 0) return;
  const auto n = static_cast<double>(count);
  all = {all.voltage_V / n, all.current_A / n, perMean(options_.noise_A, count)};
  standing_[side()] = all;
  // A bridge makes small voltages of a few whole steps, some more or less of them in a pulse: that limits nothing.
  const double rounding_V = bridgeStep_V_ > 0.0 ? 2.0 * bridgeStep_V_ / n : level_V_;
  limited_ = way_ * all.voltage_V < givenPart * level_V_ - 1e-3 - rounding_V;
  const double first_A = thirds_[0].meanCurrent_A(), fall_A = first_A - thirds_[2].meanCurrent_A();
  const double error_A = perMean(options_.noise_A, std::min(thirds_[0].count, thirds_[2].count)) * std::sqrt(2.0);
  if (fall_A * first_A > 0.0 && std::abs(fall_A) > std::max(sure * error_A, fallen * std::abs(first_A))) {
    if (falls_++ == 0) firstFall_V_ = level_V_;
  }
}

void WiringCheck::moved(double by_rad) {
  ++(way_ * by_rad > 0.0 ? along_ : against_);
  falls_ = 0;
}

Command WiringCheck::kick(const Sample& sample) {
  if (!sample.enabled) return drive();
  if (!energised_s_) {
    energised_s_ = sample.time_s;
    anchor_rad_ = sample.angle_rad;
    kicks_.emplace_back();
    kickSum_V_ = 0.0;
  }
  weigh(sample);
  const double by_rad = sample.angle_rad - anchor_rad_, inKick_s = sample.time_s - *energised_s_;
  kicks_.back().moments.push_back({inKick_s, sample.current_A, by_rad});
  kickSum_V_ += way_ * sample.voltage_V;
  if (std::abs(by_rad) < options_.kick_rad && inKick_s < options_.kick_s) return drive();
  endKick(by_rad);
  begin(Stage::brake, sample);
  return brake(sample);
}

void WiringCheck::endKick(double by_rad) {
  if (std::abs(by_rad) < options_.motion_rad) {
    kicks_.pop_back();
    return;
  }
  Kick& kick = kicks_.back();
  const double voltage_V = kickSum_V_ / static_cast<double>(kick.moments.size());
  kick.voltage_V = way_ * voltage_V;
  kick.far = std::abs(by_rad) >= options_.kick_rad;
  kick.steady = voltage_V > steady * level_V_;
  moved(by_rad);
}

Command WiringCheck::brake(const Sample& sample) {
  if (std::abs(sample.angle_rad - anchor_rad_) > 1.5 * options_.count_rad) {
    anchor_rad_ = sample.angle_rad;
    anchor_s_ = sample.time_s;
  }
  if (sample.time_s - anchor_s_ > stillFor_s()) {
    begin(Stage::rest, sample);
    return {};
  }
  if (!slows(sample)) {
    begin(Stage::swing, sample);
    return {};
  }
  return {Command::Mode::voltage, brakeVoltage(sample), 0.0, false};
}

/// What moves though nothing drives it, the windings open: a load pulls it ever further, what hangs behind play swings
/// to and fro between the gap's ends, and the rest comes to rest.
Command WiringCheck::swing(const Sample& sample) {
  swing_.take(sample);
  const double by_rad = sample.angle_rad - windowStart_rad_, gone_s = sample.time_s - stageStart_s_;
  if (const Message play = swing_.words(); !play.empty()) {
    fail(play);
  } else if (std::abs(by_rad) > ownPlay * options_.own_rad || gone_s > longestSwing_s) {
    fail(heavyLoadText(by_rad > 0.0, options_.axis));
  }
  if (std::abs(sample.angle_rad - anchor_rad_) > 1.5 * options_.count_rad) {
    anchor_rad_ = sample.angle_rad;
    anchor_s_ = sample.time_s;
  }
  if (sample.time_s - anchor_s_ > stands_s) begin(Stage::rest, sample);
  return {};
}

/// Without a count. What still creeps would pass for motion in the next pulse.
double WiringCheck::stillFor_s() const {
  return std::max(still_s, stillPulses * options_.pulse_s * options_.count_rad / options_.motion_rad);
}

/// Once it is known what breaks the shaft loose the other way, somewhat less brakes a kick, until it turns round.
double WiringCheck::brakeVoltage(const Sample& sample) {
  const auto& other = loose_V_[1 - side()];
  if (!loose_V_[side()] || !other) return 0.0;
  const double by_rad = way_ * (sample.angle_rad - brakeStart_rad_);
  furthest_rad_ = std::max(furthest_rad_, by_rad);
  turnedRound_ = turnedRound_ || by_rad < furthest_rad_ - 1.5 * options_.count_rad;
  return turnedRound_ ? 0.0 : -way_ * options_.brakePart * *other;
}

bool WiringCheck::slows(const Sample& sample) {
  if (sample.time_s - windowStart_s_ < options_.brake_s) return true;
  const double travel_rad = std::abs(sample.angle_rad - windowStart_rad_);
  // As far as before by a count: a heavy rotor's slowing down hides in one of a coarse encoder.
  const double more_rad = travel_rad - lastTravel_rad_, hidden_rad = 1.5 * options_.count_rad;
  const bool turns = travel_rad > windowCounts * options_.count_rad;
  const bool forLong = sample.time_s - stageStart_s_ > surelyBraked_s;
  unslowed_ = turns && (more_rad > hidden_rad || forLong) ? unslowed_ + 1 : more_rad < 0.0 || !turns ? 0 : unslowed_;
  lastTravel_rad_ = travel_rad;
  windowStart_rad_ = sample.angle_rad;
  windowStart_s_ = sample.time_s;
  return unslowed_ < enoughUnslowed;
}

double WiringCheck::supply_V() const {
  return supplyCount_ > 0 ? supplySum_V_ / static_cast<double>(supplyCount_) : 0.0;
}

WiringCheck::Progress WiringCheck::progress() const {
  const double all = std::log(std::max(2.0, mostSupply_V_ / options_.start_V));
  const double pulses = std::log(std::max(1.0, level_V_ / options_.start_V)) / all;
  return {kicks_.empty() ? std::clamp(pulses, 0.0, 0.9) : 0.9, std::max(0.5, usual_s - last_s_),
          message("checking the wiring by small pulses")};
}

}  // namespace breakaway
