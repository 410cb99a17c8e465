// How a thread of this process fares: what tells one that hangs from one that gets no processor.
#pragma once

#include <optional>

namespace breakaway {

class WatchedThread {
 public:
  /// Watches the thread that makes it.
  WatchedThread();

  /// These are for any thread, and give nothing where the system doesn't tell, or the watched one has ended.
  /// Seconds that it has spent on a processor.
  std::optional<double> ran_s() const;
  /// Whether it would go on now if it had a processor, or has one: it waits for nothing else.
  std::optional<bool> ready() const;

 private:
  int thread_;
};

}  // namespace breakaway
