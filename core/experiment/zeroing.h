// Zeroing the current sensor in the middle of a sweep, and remembering what each zeroing found.
#pragma once

#include <string>
#include <vector>

#include "base/code_counts.h"
#include "experiment/drive.h"
#include "experiment/open_current.h"
#include "friction/measurements.h"

namespace breakaway {

/// What a procedure says that it does meanwhile.
inline const Message zeroingText = message("zeroing the current sensor");

/// Opens the windings, waits until their current has died, and has the board take a new zero; what the samples show
/// meanwhile is how far the zero has moved since the one before.
class Zeroing {
 public:
  explicit Zeroing(double duration_s) : duration_s_(duration_s) {}

  /// Every sample of the sweep: powered ones, whose zero stays, show the converter's step.
  void see(const Sample& sample) {
    if (!sample.enabled) return steps_.interrupt();
    steps_.add(sample.current_A);
  }

  /// One tick of a zeroing that began at `start_s`. `done` tells whether this was the last one.
  Command step(const Sample& sample, double start_s, bool& done) {
    constexpr double dying_s = 0.05;
    done = sample.time_s - start_s > dying_s + duration_s_;
    if (asked_) shown_.add(sample.current_A);
    if (done) take(sample);
    asked_ = !done && sample.time_s - start_s > dying_s;
    Command command;
    command.zeroCurrentSensor = asked_;
    return command;
  }

  /// zeroMoved() from the last zeroing but one to the last.
  Message moved(double most_A) const {
    if (readings_.size() < 2) return {};
    const ZeroReading &before = readings_[readings_.size() - 2], &last = readings_.back();
    return zeroMoved(last.zero_A - before.zero_A, last.time_s - before.time_s, most_A);
  }

  const std::vector<ZeroReading>& readings() const { return readings_; }
  /// What the board subtracts now, counted from what it subtracted before the first zeroing.
  double zero_A() const { return readings_.empty() ? 0.0 : readings_.back().zero_A; }

 private:
  void take(const Sample& sample) {
    if (const size_t count = shown_.samples(); count > 0) {
      const Estimate beyond = shown_.beyondMean(steps_.step());
      readings_.push_back({sample.time_s - 0.5 * duration_s_, zero_A() + shown_.shownMean(), count, beyond.value,
                           beyond.standardError});
    }
    shown_ = {};
  }

  double duration_s_;
  CodeCounts shown_;
  SmallestStep steps_;
  bool asked_ = false;
  std::vector<ZeroReading> readings_;
};

}  // namespace breakaway
