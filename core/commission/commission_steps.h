// Runs a commissioning's procedures one by one, and keeps what each of them leaves.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "base/result.h"
#include "commission/commission.h"
#include "commission/step_recorder.h"
#include "experiment/drive.h"

namespace breakaway {

class CommissionSteps {
 public:
  /// Puts what a sweep has measured so far into the progress.
  using Gather = std::function<void()>;

  /// All four outlive it; `done` takes rig time, remarks and recordings, `kept` is what options.keepProgress gets.
  CommissionSteps(Drive& drive, const CommissionOptions& options, Commission& done, CommissionProgress& kept)
      : drive_(drive), options_(options), done_(done), kept_(kept) {}

  /// Runs `procedure` to its end, `share` of the whole job; one that has finished already is not started. Errors: what
  /// ended it early, with the step's name; what it has measured is kept all the same.
  Result<void> run(const std::string& step, const std::shared_ptr<Procedure>& procedure, double share,
                   const Gather& gather = {});
  /// Hands the progress to options.keepProgress, after `gather`.
  Result<void> keep(const Gather& gather);

 private:
  Result<void> runToEnd(Procedure& procedure, StepRecorder& recorder, double share, const Gather& gather);
  Result<void> keepRecording(const StepRecorder& recorder, const std::string& step);
  size_t decimation(double expected_s) const;
  void tell(const Procedure& procedure, double share) const;

  Drive& drive_;
  const CommissionOptions& options_;
  Commission& done_;
  CommissionProgress& kept_;
  double progress_ = 0.0;
  size_t lost_ = 0;  ///< samples, in the step that runs
};

}  // namespace breakaway
