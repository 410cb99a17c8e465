// What settings would make of the motor as it is known, before anything is sent to the board.
#pragma once

#include <QString>
#include <vector>

#include "experiment/velocity_step.h"
#include "session/board_tuning.h"
#include "session/run.h"
#include "stability/loop_noise.h"
#include "stability/margins.h"
#include "stability/root_locus.h"

namespace breakaway {

struct TuningPreview {
  QString trouble;  ///< why nothing can be foretold; all else is empty then
  LoopMargins margins;
  double alphaGT = 0.0;
  ObserverNoise observerNoise;  ///< empty where the loop is unstable
  double currentNoise_A = 0.0;  ///< rms of the current reference; 0 where the loop is unstable
  /// Empty where the loop is unstable. Of the position loop its "velocity" is the angle in rad, or the position in m.
  StepCurve step;
  StepFigures figures;
  LoopResponse response;
  RootLocus locus;  ///< in the z plane, over the cutoff
  double tick_s = 0.0;
  double ruleOfThumb_rad_per_s = 0.0;  ///< cutoff where αgT is 0.3
};

struct PreviewQuestion {
  Identity identity;
  ControllerSettings settings;
  KnownMotor motor;
  double coulomb_Nm = 0.0;
  VelocityStepOptions step;
  ServoMode mode = ServoMode::velocity;  ///< or position
  double to_rad = 0.0;                   ///< the step in position mode
  double static_Nm = 0.0;                ///< at which the standing shaft breaks loose
};

/// Some milliseconds of computing; a pure function.
TuningPreview previewOf(const PreviewQuestion& question);

/// Where the friction that a step has to overcome is known from, the best first.
enum class FrictionSource { identification, step, benchFile, wiring, none };
struct KnownFriction {
  double coulomb_Nm = 0.0;  ///< N on a linear axis
  double static_Nm = 0.0;   ///< at which a standing shaft breaks loose; as much at least
  FrictionSource source = FrictionSource::none;
};

/// By sweep or identification; else by what the newest measured velocity step of `steps` took at its end; else by the
/// bench file; else by the currents at which the wiring check saw the shaft break loose, mean of both ways. Currents
/// are taken by the torque constant of `motor`, those of a step less its viscous part. What a standing shaft bears is
/// the map's, else what the wiring check saw, else the same.
KnownFriction knownFriction(const std::optional<Bench>& bench, const Commission& known,
                            const std::vector<StepResult>& steps, const LoopMotor& motor);

/// How a figure stands against what is asked of it.
enum class Grade { good, warning, trouble };
/// 45° or more is good, 30° or more still holds.
Grade gradeOfPhase(const LoopMargins& margins);
/// 2.5 or more is good, 2 or more still holds.
Grade gradeOfGain(const LoopMargins& margins);
/// Up to 0.3 is the rule of thumb; from 1 on the observer follows faster than the tick allows.
Grade gradeOfAlphaGT(double alphaGT);
/// The largest noise that is good: 2 % of the current limit.
double goodNoise_A(double limit_A);
/// Up to goodNoise_A() is good, up to 2.5 times that still holds.
Grade gradeOfNoise(double noise_A, double limit_A);

}  // namespace breakaway
