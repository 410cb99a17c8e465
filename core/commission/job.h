// The bench job while it runs: one step after the other, slice by slice, on whatever thread has the drive.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "commission/cause_search.h"
#include "commission/commission.h"
#include "commission/step_recorder.h"
#include "commission/steps.h"
#include "experiment/drive.h"

namespace breakaway {

/// A command drives it in a plain loop, the window between two turns of its I/O thread; both come to the same, because
/// the job itself goes on every 0.25 s of the board's time only.
class Job {
 public:
  /// `wanted`: all steps that these take, as far as `known` doesn't hold them, are made. `known`: from earlier jobs on
  /// the same board, whose state it still describes; options.earlier in its place is of a board that was without power.
  Job(CommissionOptions options, const Facts& wanted, Commission known = {});

  /// Plans the steps and begins the first.
  void begin(Drive& drive);
  /// What came of Drive::advance(): `passed_s` of the board's time with its samples, and how many were lost.
  void take(Drive& drive, double passed_s, const std::vector<Sample>& samples, size_t lost);
  /// Ends it; what was measured is kept. The drive must have been stopped.
  void stop(Drive& drive, const Saying& reason);

  Procedure::Status status() const;
  bool running() const { return state_ == Procedure::State::running; }
  /// Whether a step has ended early, and it makes sure whether a wire is the cause.
  bool seeksCause() const { return cause_.has_value(); }
  /// Why it ended early, with the step's name.
  const Error& failure() const { return failure_; }
  /// What is known so far, from a sweep under way too.
  const Commission& known();
  /// Another number whenever known() is another.
  unsigned revision();

 private:
  Result<void> prepare(Drive& drive);
  Result<void> goOn(const Commission& earlier);
  void next(Drive& drive);
  bool start(Drive& drive);
  void record();
  void concludeRun(Drive& drive);
  void endEarly(Drive& drive, const EarlyEnd& how);
  void concludeCause(Drive& drive);
  Result<void> keepRun(Drive& drive);
  Result<void> keepNow();
  Result<void> keep();
  void end(Drive& drive, Procedure::State state, const Error& failure);
  void giveBack(Drive& drive);
  size_t decimation(double expected_s) const;
  double expected_s(size_t from, size_t to) const;

  CommissionOptions options_;
  Facts wanted_;
  Commission known_;
  std::vector<StepPtr> steps_;
  size_t at_ = 0;  ///< the step that runs
  StepRun run_;
  std::optional<CauseSearch> cause_;
  std::optional<StepRecorder> recorder_;
  std::optional<ControllerSettings> found_;
  double slice_s_ = 0.0, told_s_ = 0.0;
  std::chrono::steady_clock::time_point kept_;
  size_t lost_ = 0;  ///< samples, in the procedure that runs
  unsigned revision_ = 0;
  Procedure::State state_ = Procedure::State::running;
  Error failure_;
};

}  // namespace breakaway
