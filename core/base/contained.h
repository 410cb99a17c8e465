// Work with a library that may print, abort or crash on bad input, kept in a process of its own.
#pragma once

#include <functional>
#include <string>

#include "base/result.h"

namespace breakaway {

/// Runs `work` in a child process whose standard output and error lead nowhere and hands back the bytes it returned.
/// The error, at `place`, says that the work ended early, whatever ended it: an exception, a signal, or more than
/// `limit_s` of computing. `work` sees a copy of this process's memory; what it changes stays there.
Result<std::string> runContained(const std::function<std::string()>& work, const std::string& place,
                                 unsigned limit_s = 120);

}  // namespace breakaway
