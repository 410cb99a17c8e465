// The whole bench job on a drive: identify, home, sweeps, map, tuning, and the map tried out.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "base/result.h"
#include "commission/known.h"
#include "commission/motor_file.h"
#include "experiment/drive.h"
#include "motor/bench.h"

namespace breakaway {

struct CommissionOptions {
  std::string rig;  ///< what the map calls it
  std::optional<Bench>
      bench;  ///< the technician's belief; its trusted torque constant is taken, nothing else is needed
  Estimate addedInertia_kg_m2;         ///< of a disc of known inertia that is mounted, with its tolerance; 0: none
  std::optional<MotorRecord> against;  ///< the motor identified before with another added inertia, for the scale
  bool wiringOnly = false;             ///< ends after the wiring check
  bool motorOnly = false;              ///< ends once the motor is identified
  SweepSettings sweeps;
  double recordingRate_Hz = 1000.0;  ///< steps that are longer than shortStep_s are decimated to about this rate
  double shortStep_s = 20.0;
  size_t mostRows = 150000;  ///< of one recording, by further decimation
  bool keepRecordings = true;
  /// Beliefs that contradict what is measured end the job (held_beliefs.h), unless it goes on anyway and says so.
  bool anyway = false;
  /// What doesn't fit to what is asked or found now is measured anew, with a remark; else it is an error.
  bool measuresAnew = false;
  /// The controller is given back as it was found, unless it is tuned for use.
  bool givesGainsBack = false;
  std::function<void(double progress, const std::string& activity)>
      progress;  ///< called about every half second of rig time

  /// What an interrupted job had: its motor is taken, its runs and breakaways are not measured again. The current
  /// sensor is zeroed and the rotor homed anew, because the board may have been without power.
  std::optional<Commission> earlier;
  /// Called when a step has ended, however it ended, and within a sweep every keepEvery_s in which it measured
  /// something.
  std::function<Result<void>(const Commission&)> keepProgress;
  double keepEvery_s = 0.4;  ///< by the wall's clock: a simulated board's is faster
  /// Takes each step's recording, that of an interrupted step too; without it they are gathered in the result.
  std::function<Result<void>(const std::string& step, const Recording&)> keepRecording;
  std::function<bool()> interrupted;  ///< asked often; true stops the motor and ends the job
};

/// The torque or force constant that the bench trusts.
std::optional<double> trustedConstant(const CommissionOptions& options);

/// Runs every step that the axis has, in order (steps.h), or those that the motor takes; a linear axis in strokes
/// between its ends instead of turns. An error names the step and why it failed in words; the motor is off then, and
/// what was measured went to options.keepProgress. Goes on from options.earlier, unless that was begun on another board
/// or with other sweeps or another trusted torque constant.
Result<Commission> commission(Drive& drive, const CommissionOptions& options);

}  // namespace breakaway
