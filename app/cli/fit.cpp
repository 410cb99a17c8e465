#include <CLI/CLI.hpp>

#include "cli/command.h"

namespace breakaway::cli {

void addFit(CLI::App& app, Job& chosen) {
  auto* command = app.add_subcommand("fit", "Fit the base model to recordings");
  command->callback([&chosen] { chosen = [] { return Result<void>{}; }; });
}

}  // namespace breakaway::cli
