// What the I/O thread runs, as the window sees it: which one, how far, and a copy of what it has measured so far.
#pragma once

#include <QMetaType>
#include <functional>
#include <memory>
#include <variant>

#include "commission/job.h"
#include "commission/known.h"
#include "experiment/drive.h"
#include "experiment/velocity_step.h"

namespace breakaway {

enum class RunKind {
  none,
  turning,
  hand,
  step,
  positionStep,
  wiring,
  identification,
  homing,
  velocitySweep,
  breakaway,
  trial,
  experiment
};

/// A measured step with the settings it was measured with.
struct StepResult {
  StepCurve curve;
  StepFigures figures;
  VelocityStepOptions options;  ///< of a step in position: in rad or m from where it stood
  ControllerSettings settings;
  RunKind kind = RunKind::step;  ///< or positionStep
};

/// Of the bench job: what it knows so far, never changed once it is handed over.
using KnownPtr = std::shared_ptr<const Commission>;

using RunResult = std::variant<std::monostate, StepResult, KnownPtr>;

struct RunSnapshot {
  RunKind kind = RunKind::none;
  Procedure::Status status;
  RunResult result;
  bool endedByBoard = false;  ///< neither a person nor the window stopped it

  bool running() const { return kind != RunKind::none && status.state == Procedure::State::running; }
};

/// One procedure, or steps of the bench job. `read` copies the partial result and is called in the I/O thread.
struct Run {
  RunKind kind = RunKind::none;
  std::shared_ptr<Procedure> procedure;
  std::function<RunResult()> read;
  std::shared_ptr<Job> job{};

  bool something() const { return procedure != nullptr || job != nullptr; }
  Procedure::Status status() const { return job ? job->status() : procedure->status(); }
};

/// The job as a run; its snapshots share what is known as long as that doesn't change.
Run runOf(RunKind kind, std::shared_ptr<Job> job);

}  // namespace breakaway

Q_DECLARE_METATYPE(breakaway::RunSnapshot)
