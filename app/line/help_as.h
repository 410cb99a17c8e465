// The help of a program in forms that systems keep: as a man page, as completions. Packages are made with it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"

namespace CLI {
class App;
}

namespace breakaway::line {

/// What `--help-as man|bash|zsh|fish` asks for where `words` (without the program) begin with it; nothing where they
/// don't. `version` is the program's with its name. Error: another form, or none.
std::optional<Result<std::string>> helpAs(const CLI::App& app, const std::string& version,
                                          const std::vector<std::string>& words);

}  // namespace breakaway::line
