// What all commands' lines have in common: help, version, --json, --quiet, and what is said of a line that is wrong.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"

namespace CLI {
class App;
}

namespace breakaway::cli {

/// How a command answers.
struct Manner {
  bool json = false;   ///< the answer as one JSON object
  bool quiet = false;  ///< no words and no progress
};

/// Adds `--json` and `--quiet` to every command of `app`, and `--version` and the command `help` to `app`. `version`
/// and `manner` outlive it.
void addCommon(CLI::App& app, const std::string& version, Manner& manner);

/// The help that `words` (without the program) ask for by `help [COMMAND]`; nothing where they ask for something else.
/// Error: no such command.
std::optional<Result<std::string>> helpAskedFor(const CLI::App& app, const std::vector<std::string>& words);

/// One line on what is wrong with `words`, and whose help tells more; `why` is what the parser says.
std::string complaint(const CLI::App& app, const std::vector<std::string>& words, const std::string& why);

/// What no single option can check. Error: standard input is to be read twice, `--json` where the output itself goes to
/// standard output.
Result<void> checkTogether(const CLI::App& command, const Manner& manner);

/// The seed that a command was given, or its default; nothing for a command without one.
std::optional<std::uint64_t> seedOf(const CLI::App& command);

/// Whether a command's output itself goes to standard output.
bool writesToStandardOutput(const CLI::App& command);

}  // namespace breakaway::cli
