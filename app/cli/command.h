// The seam of the headless program: each command is one file that adds itself to the parser.
#pragma once

#include <functional>
#include <vector>

#include "base/result.h"

namespace CLI {
class App;
}

namespace breakaway::cli {

/// What a command does once the line is parsed.
using Job = std::function<Result<void>()>;

/// Adds one subcommand to `app`; `chosen` is set to the job when that subcommand was named.
using AddCommand = void (*)(CLI::App& app, Job& chosen);

void addFit(CLI::App& app, Job& chosen);
void addSimulate(CLI::App& app, Job& chosen);
void addDiagnose(CLI::App& app, Job& chosen);
void addBatch(CLI::App& app, Job& chosen);
void addTrial(CLI::App& app, Job& chosen);
void addImport(CLI::App& app, Job& chosen);
void addExport(CLI::App& app, Job& chosen);
void addCommission(CLI::App& app, Job& chosen);
void addTune(CLI::App& app, Job& chosen);
void addProfile(CLI::App& app, Job& chosen);
void addPorts(CLI::App& app, Job& chosen);
void addFigures(CLI::App& app, Job& chosen);

}  // namespace breakaway::cli
