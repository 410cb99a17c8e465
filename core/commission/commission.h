// The whole bench job on a drive: identify, home, sweeps, map. Sees the drive port only.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "commission/commission_progress.h"
#include "commission/motor_file.h"
#include "experiment/drive.h"
#include "experiment/velocity_sweep.h"
#include "friction/friction_map.h"
#include "friction/measurements.h"
#include "identify/motor_identification.h"
#include "identify/velocity_friction.h"
#include "motor/bench.h"
#include "recording/recording.h"

namespace breakaway {

struct CommissionOptions {
  std::string rig;  ///< what the map calls it
  std::optional<Bench>
      bench;  ///< the technician's belief; its trusted torque constant is taken, nothing else is needed
  Estimate addedInertia_kg_m2;         ///< of a disc of known inertia that is mounted, with its tolerance; 0: none
  std::optional<MotorRecord> against;  ///< the motor identified before with another added inertia, for the scale
  bool motorOnly = false;              ///< ends once the motor is identified
  size_t bins = 180;
  size_t turns = 2;
  double speedRun_s = 25.0;          ///< of each constant speed
  double recordingRate_Hz = 1000.0;  ///< steps that are longer than shortStep_s are decimated to about this rate
  double shortStep_s = 20.0;
  size_t mostRows = 150000;  ///< of one recording, by further decimation
  bool keepRecordings = true;
  std::function<void(double progress, const std::string& activity)>
      progress;  ///< called about every half second of rig time

  /// What an interrupted job had: its motor is taken, its runs and breakaways are not measured again. The current
  /// sensor is zeroed and the rotor homed anew, because the board may have been without power.
  std::optional<CommissionProgress> earlier;
  /// Called when a step has ended, however it ended, and about every half minute of rig time within a sweep.
  std::function<Result<void>(const CommissionProgress&)> keepProgress;
  /// Takes each step's recording, that of an interrupted step too; without it they are gathered in the result.
  std::function<Result<void>(const std::string& step, const Recording&)> keepRecording;
  std::function<bool()> interrupted;  ///< asked often; true stops the motor and ends the job
};

/// Velocity errors, rms, of the same course without and with the map's friction compensated.
struct CompensatedRun {
  double amplitude_rad_per_s = 0.0,
         period_s = 0.0;  ///< m/s on a linear axis, as all speeds here; of the reference, a sine of speed
  double without_rad_per_s = 0.0, with_rad_per_s = 0.0;
};

struct Commission {
  Identity identity;
  IdentifiedMotor motor;
  Estimate addedInertia_kg_m2;  ///< part of the motor's inertia
  ControllerSettings settings;  ///< the tuning that the board is left with
  bool tunedForUse = false;     ///< to medium stiffness; else as it was for the measurements
  double noiseRms_A = 0.0;
  Estimate sensorZero_A;
  Estimate indexAngle_rad;
  std::vector<VelocityRun> runs;
  std::array<MovingFriction, 2> moving;
  std::vector<TravelRun> strokes;  ///< of a linear axis, instead of runs
  std::optional<Travel> travel;    ///< of a linear axis, as the encoder counts it
  std::vector<BreakawayEvent> events;
  size_t missed = 0;
  double zeroing_s = 0.0;  ///< of the current sensor, before each speed and now and then in the breakaway sweep
  size_t zeroings = 0;     ///< in the breakaway sweep
  FrictionMap map;
  std::optional<CompensatedRun> compensatedRun;               ///< none when the board or the rotor wouldn't
  Bench bench;                                                ///< the identified motor, ready for diagnosing
  std::vector<std::pair<std::string, Recording>> recordings;  ///< by step, in order
  std::vector<std::string> remarks;
  double rigTime_s = 0.0;
};

/// Runs everything in order: current sensor's zero, winding test, spin test, tuning from what was identified, homing,
/// velocity sweep, breakaway sweep, map, slow turns, tuning of medium stiffness, a run with and without the map; a
/// linear axis in strokes between its ends instead of turns. An
/// error names the step and why it failed in words; the motor is off then, and what was measured went to
/// options.keepProgress. Goes on from options.earlier, unless that was begun on another board or with other bins, turns
/// or trusted torque constant.
Result<Commission> commission(Drive& drive, const CommissionOptions& options);

}  // namespace breakaway
