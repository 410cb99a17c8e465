// What the wiring check's pulses tell, and in which words.
#include <algorithm>
#include <cmath>

#include "experiment/wiring_check.h"

namespace breakaway {

namespace {

constexpr size_t enoughFalls = 3;  // that play between motor and encoder doesn't make
// Times the voltage of the first of them, that turns a rotor by a coarse count, too.
constexpr double surelyTurns = 2.0;
constexpr double reachPart = 0.8;      // of the present voltage, over which a sensor that lives changes
constexpr double indexCounts = 20.0;   // wider is no index
constexpr double mostIndex = 0.5;      // of all ticks
constexpr double fewestTicks = 100.0;  // driven ones, that noise doesn't leave on one number
constexpr double onlyNoise = 4.0;      // standard errors, below which a current isn't seen

}  // namespace

/// The slope of current over voltage, in its standard errors; a zero that has moved, as a sensor's that died, has none.
double WiringCheck::currentSurely() const {
  const double n = std::max(1.0, sums_.count);
  const double power_W = sums_.power_W - sums_.voltage_V * sums_.current_A / n;
  const double square_V2 = sums_.square_V2 - sums_.voltage_V * sums_.voltage_V / n;
  const double error_W = options_.noise_A * std::sqrt(std::max(0.0, square_V2));
  if (!changes_ || power_W == 0.0) return 0.0;
  return error_W > 0.0 ? power_W / error_W : std::copysign(2.0 * sure, power_W);
}

int WiringCheck::currentSign() const {
  const double surely = currentSurely();
  return std::abs(surely) <= sure ? 0 : surely > 0.0 ? 1 : -1;
}

/// A sensor that went with the voltage, or seemed to, and now reads the same from as much one way as the other; or all
/// through the latest kick, where a smaller voltage of that way had been seen to drive another current.
bool WiringCheck::hasDied() const {
  if (currentSign() == 0) return false;
  const double reach_V = reachPart * level_V_;
  if (unchanged_.low_V < -reach_V && unchanged_.high_V > reach_V) return true;
  if (kicks_.empty() || kicks_.back().moments.size() < fewestSamples) return false;
  const auto& moments = kicks_.back().moments;
  const auto& before = standing_[side()];
  return before && std::abs(before->current_A - moments.front().current_A) > sure * before->error_A &&
         std::abs(before->current_A) > sure * before->error_A &&
         std::all_of(moments.begin(), moments.end(),
                     [&](const Moment& one) { return one.current_A == moments.front().current_A; });
}

Message WiringCheck::deadWhileMoving() const {
  return message(
      "the current sensor is dead, or too coarse for this motor: it reads exactly {:.3g} A while {:.1f} V move {}; "
      "check its supply and its wire",
      *constant_A_, level_V_, bodyText(options_.axis));
}

Message WiringCheck::neverChanged() const {
  if (changes_ || !constant_A_ || sums_.count < fewestTicks) return {};
  if (along_ + against_ > 0) return deadWhileMoving();
  return message(
      "the current sensor is dead: it reads exactly {:.3g} A up to {:.1f} V, and {} doesn't move; check the sensor's "
      "supply and its wire, then the motor's leads",
      *constant_A_, level_V_, bodyText(options_.axis));
}

Message WiringCheck::nothingSeen(double most_V) const {
  return message(
      "no current is seen up to {:.1f} V: a lead of the motor is off, or the current sensor's wire; check the "
      "motor's terminals",
      most_V);
}

Message WiringCheck::evidence() const {
  if (Message dead = neverChanged(); !dead.empty()) return dead;
  if (Message wrong = contradiction(); !wrong.empty()) return wrong;
  const bool none = std::abs(currentSurely()) < onlyNoise && sums_.count >= fewestTicks && along_ + against_ == 0;
  return none ? nothingSeen(level_V_) : Message();
}

/// Why nothing moves, as far as the pulses go.
Message WiringCheck::standstill(double supply_V) {
  const Message body = bodyText(options_.axis);
  const double most_V = std::min(level_V_, supply_V);
  if (const Message dead = neverChanged(); !dead.empty()) return dead;
  const int sign = currentSign();
  if (sign == 0) return nothingSeen(most_V);
  const auto& level = standing_[side()];
  const double most_A = level ? std::abs(level->current_A) : 0.0;
  if (sign < 0)
    return message(
        "the current goes against the voltage ({:.2f} A at {:.1f} V), and {} doesn't move: the current sensor or the "
        "bridge is reversed; swap the sensor's leads or the bridge's inputs",
        most_A, most_V, body);
  held_ = true;
  return message(
      "{} doesn't move at {:.2f} A: it is held (a brake, a clamp), or the encoder stands; free it, and check the "
      "encoder's cable, supply and coupling",
      body, most_A);
}

/// A coarse encoder doesn't show what a rotor turns by in a weak pulse.
bool WiringCheck::encoderStands() const {
  const bool turns = options_.count_rad < fine_rad || level_V_ > surelyTurns * firstFall_V_;
  return falls_ >= enoughFalls && turns && along_ + against_ == 0;
}

/// What is wrong beyond doubt; a load may spoil one motion, not two.
Message WiringCheck::contradiction() const {
  const Message body = bodyText(options_.axis);
  if (indexLow_rad_ && *indexHigh_rad_ - *indexLow_rad_ > indexCounts * options_.count_rad &&
      static_cast<double>(indexSeen_) > mostIndex * static_cast<double>(ticks_))
    return message(
        "the encoder's index is seen everywhere: it is inverted; swap its two wires, or the polarity in the board");
  if (encoderStands())
    return message(
        "the encoder stands, but the current falls in each pulse as it does when the motor turns ({:.1f} V); check the "
        "encoder's cable and supply, and the coupling",
        level_V_);
  if (hasDied())
    return message(
        "the current sensor has died in between: it reads exactly {:.3g} A whatever the voltage; it is dead, check its "
        "supply and its wire",
        unchanged_.shown_A);
  const int sign = currentSign();
  if (along_ + against_ < 2) return {};
  if (sign == 0 && !changes_ && kicked_[0] + kicked_[1] >= 2 * kicksEachWay) return deadWhileMoving();
  if (sign == 0 || (along_ > 0 && against_ > 0)) return {};
  const Message way = wayText(false, options_.axis);
  if (against_ > 0 && sign > 0)
    return message(
        "{} moves {} at positive voltage, with the current: the encoder counts against the motor; swap the encoder's A "
        "and B, or the motor's leads",
        body, way);
  if (against_ > 0)
    return message(
        "{} moves {} at positive voltage, and the current flows that way, too: the bridge is reversed; swap its two "
        "inputs, or the sign in the board",
        body, way);
  if (sign < 0)
    return message(
        "{} moves with the voltage, but the current falls as the voltage rises: the current sensor is reversed; swap "
        "its leads, or the sign in the board",
        body);
  return {};
}

}  // namespace breakaway
