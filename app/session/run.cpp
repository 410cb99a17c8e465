#include "session/run.h"

#include <utility>

namespace breakaway {

Run runOf(RunKind kind, std::shared_ptr<Job> job) {
  const auto read = [job, copy = KnownPtr(), copied = 0U]() mutable -> RunResult {
    if (const unsigned now = job->revision(); !copy || now != copied) {
      copy = std::make_shared<const Commission>(job->known());
      copied = now;
    }
    return copy;
  };
  return {kind, nullptr, read, std::move(job)};
}

}  // namespace breakaway
