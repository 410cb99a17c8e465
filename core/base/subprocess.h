// Another program, run to its end.
#pragma once

#include <string>
#include <vector>

#include "base/memory_file.h"
#include "base/result.h"

namespace breakaway {

/// Runs the program `words[0]`, sought as a shell would, with the arguments after it: its exit status, 128 when a
/// signal ended it. What it prints goes to `out`, its messages nowhere. Error, at the program's name: it can't be run,
/// for the system's reason. Precondition: `words` isn't empty.
Result<int> runProgram(std::vector<std::string> words, const MemoryFile& out);

}  // namespace breakaway
