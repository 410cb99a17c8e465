// Procedures one after another as one: each begins with what those before it have found.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "experiment/drive.h"

namespace breakaway {

class ProcedureSequence : public Procedure {
 public:
  struct Stage {
    double duration_s = 1.0;  ///< first look at its length, for the progress of the whole
    std::function<std::shared_ptr<Procedure>()> begin;
    std::function<Result<void>()> end;  ///< takes its result; an error ends the sequence
  };

  explicit ProcedureSequence(std::vector<Stage> stages);

  Command step(const Sample& sample) override;
  Status status() const override;
  State state() const override { return state_; }
  void stop(const std::string& reason) override;
  void leaveLegsToDrive() override;
  const Leg* leg() const override { return current_ && state_ == State::running ? current_->leg() : nullptr; }
  unsigned legNumber() const override { return legsBefore_ + (current_ ? current_->legNumber() : 0); }

 private:
  void endStage();
  void fail(const std::string& reason);

  std::vector<Stage> stages_;
  size_t next_ = 0;
  unsigned legsBefore_ = 0;  ///< of the stages that have ended
  bool legsElsewhere_ = false;
  std::shared_ptr<Procedure> current_;
  State state_ = State::running;
  std::string failure_;
};

}  // namespace breakaway
