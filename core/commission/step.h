// One step of the bench job: what it needs, what it leaves, and how it is made.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "base/result.h"
#include "commission/commission.h"
#include "commission/facts.h"
#include "experiment/drive.h"

namespace breakaway {

/// What a step works with: the board, what is asked, and what is known, to which it adds.
struct OnBench {
  Drive& drive;
  const CommissionOptions& options;
  Commission& known;
};

/// A procedure that a step wants to be run, and the name of its recording. None: the step moves nothing.
struct StepRun {
  std::string name;
  std::shared_ptr<Procedure> procedure;
};

enum class StepEnd { over, again };

class Step {
 public:
  Step(MessageText<0> words, const Facts& needs, const Facts& leaves)
      : words_(message(words)), needs_(needs), leaves_(leaves) {}
  virtual ~Step() = default;
  Step(const Step&) = delete;
  Step& operator=(const Step&) = delete;

  /// What it is, for people: "velocity sweep".
  const Message& words() const { return words_; }
  const Facts& needs() const { return needs_; }
  const Facts& leaves() const { return leaves_; }
  /// First look at how long it takes.
  virtual double expected_s(const SweepSettings&) const { return 0.0; }

  /// Lays out the next procedure from what is known.
  virtual Result<StepRun> begin(OnBench&) { return StepRun{}; }
  /// Puts what the procedure has measured so far into what is known, wherever it is; returns whether there is more.
  virtual bool gather(Commission&) { return false; }
  /// Takes back what it has put on the board for the procedure, however that ended.
  virtual Result<void> leave(Drive&) { return {}; }
  /// What the procedure knows better of the cause of a trip than the board's watch; empty: nothing.
  virtual Message causeOf(Trip) const { return {}; }
  /// Takes the procedure's result; `ran` is why it failed. A step that wants another procedure is begun again.
  virtual Result<StepEnd> end(OnBench& on, const Result<void>& ran) = 0;

 private:
  Message words_;
  Facts needs_, leaves_;
};

}  // namespace breakaway
