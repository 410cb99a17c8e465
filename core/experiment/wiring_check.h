// Whether motor, encoder and current sensor belong together, by a few small pulses.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/estimate.h"
#include "experiment/free_swing.h"
#include "experiment/timed_procedure.h"

namespace breakaway {

struct WiringCheckOptions {
  double coast_s = 0.0;  ///< at least, before the first pulse: until what turns has come to rest with open windings
  double start_V = 0.02;
  double growth = 1.19;  ///< of the voltage, from one pair of pulses to the next
  double pulse_s = 0.06, settle_s = 0.02, rest_s = 0.04;
  double longestPulse_s = 0.6;  ///< where none of the usual length moves a heavy rotor by what is motion
  double motion_rad = 0.01;     ///< travel that counts as motion
  double kick_rad = 0.12;       ///< of a kick; friction and the shorted winding end it within a tenth of a turn
  double kick_s = 0.5;          ///< at most
  double kickRatio = 2.0;       ///< of its voltage to the one that broke the shaft loose
  double most_A = 0.0;          ///< that the current is limited to; a kick takes less. 0: unknown
  double brakePart = 0.7;       ///< of the voltage that breaks it loose the other way, which brakes a kick
  double brake_s = 0.25;        ///< what slows down, moves less in it than in the one before
  double own_rad = 0.05;        ///< likewise, travel with the windings open
  double oneSided = 6.0;        ///< what moves one way and not the other at so many times the voltage stands at a stop
  double seenPart = 0.25;       ///< of the supply; a current that isn't seen there doesn't flow
  double count_rad = 0.0;       ///< of the encoder
  double noise_A = 0.0;         ///< rms, of the current sensor
  Axis axis = Axis::rotary;
};

/// Pulses of growing voltage, alternately both ways with the windings open between them, until the shaft has broken
/// loose each way; then kicks, which end as soon as the shaft has moved far enough. Whatever moved is braked by the
/// shorted winding. Where nothing moves, it begins again with longer pulses: a heavy rotor needs time. Fails in words
/// where the evidence is beyond doubt: motion or current against the voltage, a current that falls as if the shaft
/// turned while the encoder stands, no current, no motion, a load heavier than friction, play through which the encoder
/// swings to and fro, an index that is seen everywhere. What the pulses can't tell they leave open.
class WiringCheck : public TimedProcedure {
 public:
  /// Of a kick, from its first tick on.
  struct Moment {
    double time_s = 0.0, current_A = 0.0, angle_rad = 0.0;
  };
  struct Kick {
    double voltage_V = 0.0;
    bool far = true;     ///< it moved as far as it was to within its time
    bool steady = true;  ///< the current limit took nothing off the voltage
    std::vector<Moment> moments;
  };
  /// A steady voltage that the standing shaft bore, and what flowed.
  struct Level {
    double voltage_V = 0.0, current_A = 0.0, error_A = 0.0;
  };

  explicit WiringCheck(const WiringCheckOptions& options = {}) : options_(options), swing_(options.axis) {}

  /// The highest that each way stood at, by way.
  const std::array<std::optional<Level>, 2>& standing() const { return standing_; }
  /// Current that broke it loose, by way, positive in it; none when it moved one way only.
  const std::array<std::optional<Estimate>, 2>& breakaway_A() const { return breakaway_A_; }
  const std::vector<Kick>& kicks() const { return kicks_; }
  /// Whether a current was seen that goes with the voltage.
  bool currentSeen() const { return currentSign() > 0; }
  /// Whether what it failed with says which wire it is; not so where nothing moves and the current goes with the
  /// voltage.
  bool names() const { return state() == State::failed && !held_; }
  /// What all pulses together tell when the board's watch, which sees 20 ms, ends the check, in words; empty where they
  /// leave it open: a sensor that has read one number all the time, what is beyond doubt, or no current but noise.
  Message evidence() const;
  /// Mean of the supply's reading, windings open.
  double supply_V() const;
  const WiringCheckOptions& options() const { return options_; }
  /// By how far it moved in coast_s though it had stood: what it was held up against let go of it. 0: not at all.
  double fell_rad() const { return fell_rad_; }

 protected:
  Command run(const Sample& sample) override;
  Progress progress() const override;

 private:
  static constexpr double sure = 8.0;          ///< standard errors, beyond which a sign is no noise
  static constexpr double fine_rad = 0.01;     ///< a count that any such pulse shows
  static constexpr size_t kicksEachWay = 2;    ///< the second one of twice the voltage where no current was seen
  static constexpr size_t fewestSamples = 10;  ///< of a mean

  enum class Stage { coast, rest, pulse, kick, brake, swing };
  size_t side() const { return way_ > 0.0 ? 1 : 0; }
  Command coast(const Sample& sample);
  Command rest(const Sample& sample);
  Command pulse(const Sample& sample);
  Command kick(const Sample& sample);
  Command brake(const Sample& sample);
  Command swing(const Sample& sample);
  bool gainsSpeed(const Sample& sample);
  bool slows(const Sample& sample);
  double kickVoltage(double supply_V) const;
  double brakeVoltage(const Sample& sample);
  Command drive() const { return {Command::Mode::voltage, way_ * level_V_, 0.0, false}; }
  void begin(Stage stage, const Sample& sample);
  void watchIndex(const Sample& sample);
  void weigh(const Sample& sample);
  void takeStanding();
  Estimate looseCurrent() const;
  void moved(double by_rad);
  void endKick(double by_rad);
  bool chooseNext(double supply_V);
  bool chooseKick(double supply_V);
  bool beginLonger();
  double stillFor_s() const;
  Message neverChanged() const;
  Message nothingSeen(double most_V) const;
  double currentSurely() const;
  bool encoderStands() const;
  int currentSign() const;
  bool hasDied() const;
  Message standstill(double supply_V);
  Message contradiction() const;
  Message deadWhileMoving() const;

  WiringCheckOptions options_;
  Stage stage_ = Stage::rest;
  double way_ = 1.0, level_V_ = 0.0;
  std::array<std::optional<Level>, 2> standing_;
  std::array<std::optional<Estimate>, 2> breakaway_A_;
  std::array<std::optional<double>, 2> loose_V_;
  std::array<size_t, 2> kicked_{};
  std::vector<Kick> kicks_;
  double stageStart_s_ = 0.0, anchor_rad_ = 0.0, anchor_s_ = 0.0, last_s_ = 0.0;
  FreeSwing swing_;                    ///< of what moves on once the motor has let go
  std::optional<double> energised_s_;  ///< when the winding was first seen to be driven in this stage
  double supplySum_V_ = 0.0, mostSupply_V_ = 0.0;
  size_t supplyCount_ = 0;
  struct Sum {
    double voltage_V = 0.0, current_A = 0.0;
    size_t count = 0;
    double meanCurrent_A() const { return count > 0 ? current_A / static_cast<double>(count) : 0.0; }
  };
  std::array<Sum, 3> thirds_;  ///< of the pulse after settling
  bool held_ = false;          ///< it doesn't move, and nothing says why
  bool limited_ = false;       ///< the last pulse got less voltage than it asked for
  double bridgeStep_V_ = 0.0;  ///< the smallest voltage of a driven tick; 0: none but zero
  double lastTravel_rad_ = 0.0, windowStart_rad_ = 0.0, windowStart_s_ = 0.0, kickSum_V_ = 0.0;
  double brakeStart_rad_ = 0.0, furthest_rad_ = 0.0;  ///< of what is braked, in its way
  bool turnedRound_ = false;
  size_t stretches_ = 0;
  double steady_rad_ = 0.0;  ///< travel in the last that was compared
  double coastStart_rad_ = 0.0, coastStartSpeed_rad_per_s_ = 0.0, fell_rad_ = 0.0;
  size_t faster_ = 0;    ///< brake_s in a row in which what coasted moved further than before
  size_t unslowed_ = 0;  ///< brake_s in a row in which what was braked moved no less than before
  size_t falls_ = 0;     ///< pulses whose current fell while the encoder stood
  double firstFall_V_ = 0.0;
  size_t along_ = 0, against_ = 0;
  struct Moments {
    double power_W = 0.0, square_V2 = 0.0, voltage_V = 0.0, current_A = 0.0, count = 0.0;
  };
  Moments sums_;                      ///< over all driven ticks: v·i, v², v, i
  std::optional<double> constant_A_;  ///< the current's only reading while driven
  /// What it reads by now without a change, and the voltages of those driven ticks.
  struct Unchanged {
    double shown_A = 0.0, low_V = 0.0, high_V = 0.0;
  };
  Unchanged unchanged_;
  bool changes_ = false;
  size_t indexSeen_ = 0, ticks_ = 0;
  std::optional<double> indexLow_rad_, indexHigh_rad_;
};

}  // namespace breakaway
