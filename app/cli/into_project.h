// --project DIR of commands that leave files: what they wrote is put into the project, whole or not at all.
#pragma once

#include <optional>
#include <string>

#include "base/result.h"
#include "cli/command.h"
#include "project/project.h"

namespace CLI {
class App;
}

namespace breakaway::cli {

/// Adds `--project` to a command; `folder` outlives the parser.
void addProjectOption(CLI::App& command, std::string& folder);

/// Opens the project before the work, making a new one where there is none; nothing for an empty name.
Result<std::optional<Project>> openAskedProject(const std::string& folder);

/// Puts the run in and says so in the answer. Without a project the answer is as it was. Error: it couldn't be put in;
/// what was written elsewhere stays there.
Result<Answer> intoProject(std::optional<Project>& project, const NewRun& run, const Result<Answer>& answer);

/// The motor's serial number in a bench file; empty where there is none, or the file can't be read.
std::string motorOf(const std::string& benchFile);

/// What was found and set right when the project was opened, a line each.
std::string saidBy(const Project& project);

}  // namespace breakaway::cli
