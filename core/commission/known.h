// What a commissioning knows so far: what each of its steps adds to, and what is left in the end.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/estimate.h"
#include "commission/facts.h"
#include "experiment/identity.h"
#include "experiment/travel.h"
#include "friction/friction_map.h"
#include "friction/measurements.h"
#include "identify/motor_identification.h"
#include "identify/velocity_friction.h"
#include "identify/wiring_fit.h"
#include "motor/bench.h"
#include "recording/recording.h"

namespace breakaway {

struct MotorTests;

/// How the sweeps are to be made. What was measured one way is not gone on with another way.
struct SweepSettings {
  size_t bins = 180;               ///< around the rotor, or over a linear axis' travel
  size_t turns = 2;                ///< of the breakaway sweep each way, or passes
  double speedRun_s = 25.0;        ///< at each constant speed, at least
  size_t speeds = 0;               ///< of the velocity sweep; 0: the job's own
  double highest_rad_per_s = 0.0;  ///< of them; 0: what the supply allows
  bool operator==(const SweepSettings&) const = default;
  bool sameSpeeds(const SweepSettings& other) const {
    return speedRun_s == other.speedRun_s && speeds == other.speeds && highest_rad_per_s == other.highest_rad_per_s;
  }
};

/// Velocity errors, rms, of the same course without and with the map's friction compensated.
struct CompensatedRun {
  double amplitude_rad_per_s = 0.0,
         period_s = 0.0;  ///< m/s on a linear axis, as all speeds here; of the reference, a sine of speed
  double without_rad_per_s = 0.0, with_rad_per_s = 0.0;
};

/// The highest that a linear axis' strokes are run with.
struct TravelPace {
  double speed_m_per_s = 0.0, acceleration_m_per_s2 = 0.0;
};

struct Commission {
  Identity identity;
  Facts facts;  ///< which of the following is known
  SweepSettings sweeps;
  std::optional<double> trustedTorqueConstant_Nm_per_A;  ///< the bench's
  Estimate addedInertia_kg_m2;                           ///< part of the motor's inertia
  size_t part = 1;                                       ///< 1 for the first start, one more for each resumption
  double rigTime_s = 0.0;
  std::vector<Message> remarks;
  std::vector<Message> contradictions;  ///< of beliefs and measurements, that the job went on in spite of
  std::vector<std::pair<std::string, Recording>> recordings;  ///< by step, in order, where nobody else took them

  // The motor.
  double noiseRms_A = 0.0;  ///< of the current sensor, per sample
  Estimate sensorZero_A;
  std::optional<WiringFit> wiring;     ///< by its check
  std::array<double, 2> expected_A{};  ///< first look at the breakaway current, by Way
  std::shared_ptr<MotorTests> tests;   ///< that it was identified from, here
  IdentifiedMotor identified;          ///< as its own tests leave it
  IdentifiedMotor motor;               ///< with what the sweeps tell of it
  double shownResistance_ohm = 0.0;    ///< with the current as the sensor shows it
  bool linearised = false;             ///< the board takes its voltages through the inverse of the bridge's curve
  ControllerSettings settings;         ///< that the job has set last

  // Where things are.
  Travel counted;  ///< of a linear axis, as the encoder counts it since power-up: between the ends that were felt; once
                   ///< homed, what the bins lie over
  std::optional<Travel> travel;  ///< that the bins lie over, from the index on
  Estimate indexAngle_rad;       ///< as the encoder counts it; the lower end of a linear axis without one
  TravelPace pace;

  // Friction. Angles and positions count from the index.
  std::vector<VelocityRun> runs;   ///< in the order they were run; the last one may still be under way
  std::vector<TravelRun> strokes;  ///< of a linear axis, instead of runs; the last too
  double runsZeroError_A = 0.0;    ///< standard error of the current sensor's zero over them
  std::array<MovingFriction, 2> moving;
  std::vector<BreakawayEvent> breakaways;  ///< as they were measured
  std::vector<BreakawayEvent> events;      ///< the same, calibrated for the map
  double eventsZeroError_A = 0.0;
  size_t missed = 0;
  double zeroing_s = 0.0;  ///< of the current sensor, before each speed and now and then in the breakaway sweep
  size_t zeroings = 0;     ///< in the breakaway sweep
  std::vector<std::pair<std::string, double>> howMeasured;  ///< the breakaways, for the map's file
  FrictionMap map;

  // At work.
  bool tunedForUse = false;                      ///< to medium stiffness; else as it was for the measurements
  std::optional<CompensatedRun> compensatedRun;  ///< none when the board or the rotor wouldn't
  Bench bench;                                   ///< the identified motor, ready for diagnosing

  bool knows(Known fact) const { return facts.has(fact); }
  bool linear() const { return identity.axis == Axis::linear; }
  /// Of true amperes, what the current as it is shown makes.
  double torquePerAmpere_Nm() const { return motor.torquePerShownAmpere_Nm(); }
  /// Coulomb and viscous friction as the mean of both ways, once there are runs.
  std::optional<Estimate> coulombAverage_Nm() const;
  std::optional<Estimate> viscousAverage_Nm_s_per_rad() const;

  /// What the person at the bench should hear, once.
  void remark(const Message& text);
  /// The same of a contradiction that the job goes on in spite of.
  void contradict(const Message& text);

  /// These are no longer known, nor what is computed from them; measurements stay unless they are named.
  void forget(const Facts& facts);
  /// What was measured with other settings than these.
  Facts otherThan(const SweepSettings& asked) const;
  /// Forgets that; from now on these are the sweeps'.
  void forgetOtherThan(const SweepSettings& asked);
  /// The board was without power or is set by others: what was known of its state is not.
  void forgetBoard();
};

/// These, and what is computed from them.
Facts withComputed(Facts facts);

}  // namespace breakaway
