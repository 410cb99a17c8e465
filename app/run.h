// A procedure as the window sees it: which one, how far, and a copy of what it has measured so far.
#pragma once

#include <QMetaType>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "base/estimate.h"
#include "experiment/drive.h"
#include "experiment/travel.h"
#include "experiment/velocity_step.h"
#include "friction/measurements.h"
#include "identify/motor_identification.h"

namespace breakaway {

enum class RunKind { none, turning, identification, homing, step, breakaway, velocitySweep };

/// The motor from the bench's own tests, and what the sweeps need beside it.
struct Identification {
  IdentifiedMotor motor;
  double noiseRms_A = 0.0;             ///< of the current sensor, per sample
  std::array<double, 2> expected_A{};  ///< first look at the breakaway current, by Way
  double shownResistance_ohm = 0.0;    ///< of a linear axis, with the current as the sensor shows it
};

struct IdentificationResult {
  std::optional<Identification> found;
};

struct HomingResult {
  size_t passes = 0;                               ///< over the index's edge so far
  Estimate index_rad{};                            ///< in the board's angle; valid once finished
  std::optional<Travel> travel{};                  ///< of a linear axis, as the encoder counts it
  std::optional<Identification> identification{};  ///< of a linear axis: its motor is identified on the way
};

/// A measured step with the settings it was measured with.
struct StepResult {
  StepCurve curve;
  StepFigures figures;
  VelocityStepOptions options;
  ControllerSettings settings;
};

struct BreakawayResult {
  std::vector<BreakawayEvent> events;
  size_t bins = 0;
  size_t turns = 0;
  size_t missed = 0;
  std::optional<Identification> identification;
  double zeroError_A = 0.0;                                ///< of a linear axis' sweep
  std::vector<std::pair<std::string, double>> settings{};  ///< likewise: how it was measured
};

struct VelocitySweepResult {
  std::vector<VelocityRun> runs;
  std::optional<Identification> identification;
};

/// Of a linear axis.
struct StrokesResult {
  std::vector<TravelRun> strokes;
  size_t bins = 0;
  double zeroError_A = 0.0;  ///< standard error of the current sensor's zero
};

using RunResult = std::variant<std::monostate, IdentificationResult, HomingResult, StepResult, BreakawayResult,
                               VelocitySweepResult, StrokesResult>;

struct RunSnapshot {
  RunKind kind = RunKind::none;
  Procedure::Status status;
  RunResult result;
  bool endedByBoard = false;  ///< neither a person nor the window stopped it

  bool running() const { return kind != RunKind::none && status.state == Procedure::State::running; }
};

/// What the I/O thread runs: `read` copies the partial result and is called in the I/O thread.
struct Run {
  RunKind kind = RunKind::none;
  std::shared_ptr<Procedure> procedure;
  std::function<RunResult()> read;
};

}  // namespace breakaway

Q_DECLARE_METATYPE(breakaway::RunSnapshot)
