#include "procedure_sequence.h"

namespace breakaway {

ProcedureSequence::ProcedureSequence(std::vector<Stage> stages) : stages_(std::move(stages)) {
}

Command ProcedureSequence::step(const Sample& sample) {
  if (state_ != State::running) return {};
  if (!current_) {
    current_ = stages_[next_].begin();
    if (legsElsewhere_) current_->leaveLegsToDrive();
  }
  const Command command = current_->step(sample);
  switch (current_->state()) {
    case State::running:
      return command;
    case State::finished:
      endStage();
      break;
    case State::failed:
    case State::stopped:
      fail(current_->status().failure);
      break;
  }
  return {};
}

void ProcedureSequence::endStage() {
  if (const auto ended = stages_[next_].end(); !ended) {
    fail(ended.error().message());
    return;
  }
  legsBefore_ += current_->legNumber();
  current_.reset();
  if (++next_ == stages_.size()) state_ = State::finished;
}

void ProcedureSequence::fail(const std::string& reason) {
  state_ = State::failed;
  failure_ = reason;
}

void ProcedureSequence::leaveLegsToDrive() {
  legsElsewhere_ = true;
  if (current_) current_->leaveLegsToDrive();
}

Procedure::Status ProcedureSequence::status() const {
  Status whole{state_, 0.0, 0.0, "", failure_};
  const Status now = current_ ? current_->status() : Status{};
  double past_s = 0.0, ahead_s = 0.0;
  for (size_t k = 0; k < stages_.size(); ++k) {
    if (k < next_) past_s += stages_[k].duration_s;
    if (k > next_) ahead_s += stages_[k].duration_s;
  }
  if (next_ < stages_.size()) {
    // A stage knows its own length best once it runs.
    const double length_s =
        now.progress > 0.02 ? now.remaining_s / std::max(1e-9, 1.0 - now.progress) : stages_[next_].duration_s;
    past_s += now.progress * length_s;
    whole.remaining_s = (1.0 - now.progress) * length_s + ahead_s;
  }
  whole.progress = state_ == State::finished ? 1.0 : past_s / std::max(1e-9, past_s + whole.remaining_s);
  whole.activity = now.activity;
  return whole;
}

void ProcedureSequence::stop(const std::string& reason) {
  if (state_ != State::running) return;
  if (current_) current_->stop(reason);
  state_ = State::stopped;
  failure_ = reason;
}

}  // namespace breakaway
