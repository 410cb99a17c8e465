// The mean of a signal that a converter shows in steps.
#pragma once

#include <cstddef>
#include <map>

#include "base/estimate.h"

namespace breakaway {

/// How often a converter showed each of its values. Where the noise is smaller than a step, the mean of what is shown
/// isn't the signal's: most samples fall on the same step, and what lies within it isn't seen.
class CodeCounts {
 public:
  void add(double value);
  size_t samples() const { return samples_; }
  /// Plain mean of what was shown.
  double shownMean() const { return samples_ > 0 ? sum_ / static_cast<double>(samples_) : 0.0; }
  /// By how much the mean of a constant signal in normal noise of unknown size, rounded to steps of `step`, lies off
  /// what was shown, with its standard error: the posterior over mean and noise, any size of the noise being as likely
  /// as its double, from the probabilities of each value (Widrow and Kollár, "Quantization Noise", 2008, chapter 4).
  /// 0 without error where the scatter is about a step or more, and with `step` 0.
  Estimate beyondMean(double step) const;

 private:
  std::map<double, size_t> counts_;  ///< no longer kept once there are many
  double sum_ = 0.0, squares_ = 0.0;
  size_t samples_ = 0;
};

/// The smallest difference between samples that follow one another: a converter's step, once its signal has moved.
class SmallestStep {
 public:
  void add(double value);
  /// The next sample doesn't follow the last one.
  void interrupt() { begun_ = false; }
  /// 0: not seen yet.
  double step() const { return step_; }

 private:
  double before_ = 0.0, step_ = 0.0;
  bool begun_ = false;
};

}  // namespace breakaway
