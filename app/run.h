// A procedure as the window sees it: which one, how far, and a copy of what it has measured so far.
#pragma once

#include <QMetaType>
#include <functional>
#include <memory>
#include <variant>
#include <vector>

#include "base/estimate.h"
#include "experiment/drive.h"
#include "experiment/velocity_step.h"
#include "friction/measurements.h"

namespace breakaway {

enum class RunKind { none, turning, homing, step, breakaway, velocitySweep };

struct HomingResult {
  size_t passes = 0;   ///< over the index's edge so far
  Estimate index_rad;  ///< in the board's angle; valid once finished
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
};

struct VelocitySweepResult {
  std::vector<VelocityRun> runs;
};

using RunResult = std::variant<std::monostate, HomingResult, StepResult, BreakawayResult, VelocitySweepResult>;

struct RunSnapshot {
  RunKind kind = RunKind::none;
  Procedure::Status status;
  RunResult result;

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
