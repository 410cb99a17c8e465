// How long something may take.
#pragma once

#include <atomic>
#include <chrono>
#include <limits>
#include <memory>

namespace breakaway {

/// From when it was made. Copies are the same limit, and any thread may end it; without seconds nothing else does.
class TimeLimit {
 public:
  TimeLimit() = default;
  explicit TimeLimit(double seconds) : seconds_(seconds) {}
  void end() { *ended_ = true; }
  /// Whether this part of the time has gone by.
  bool over(double part = 1.0) const {
    const std::chrono::duration<double> gone = Clock::now() - begin_;
    return *ended_ || gone.count() > part * seconds_;
  }

 private:
  using Clock = std::chrono::steady_clock;
  double seconds_ = std::numeric_limits<double>::infinity();
  Clock::time_point begin_ = Clock::now();
  std::shared_ptr<std::atomic<bool>> ended_ = std::make_shared<std::atomic<bool>>(false);
};

}  // namespace breakaway
