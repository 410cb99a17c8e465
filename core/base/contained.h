// Work with a library that may print, abort or crash on bad input, kept in a process of its own.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "base/result.h"

namespace breakaway {

/// What contained work may use up before it is ended.
struct ContainedLimits {
  unsigned computing_s = 120;  ///< of its processor; four times as long on the clock
  size_t memory_bytes =
      size_t{4} << 30;  ///< beyond what the process has already; not enforced under the address sanitizer
};

/// Runs `work` in a child process whose standard output and error lead nowhere and hands back the bytes it returned.
/// The error, at `place`, says that the work ended early, whatever ended it: an exception, a signal, or a limit.
/// `work` sees a copy of this process's memory; what it changes stays there.
Result<std::string> runContained(const std::function<std::string()>& work, const std::string& place,
                                 const ContainedLimits& limits = {});

}  // namespace breakaway
