#include "cli/into_project.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/inputs.h"
#include "project/run_contents.h"

namespace breakaway::cli {

void addProjectOption(CLI::App& command, std::string& folder) {
  command.add_option(
      "--project", folder,
      "put what is written into this project, too, whole or not at all; a new or empty folder becomes one");
}

Result<std::optional<Project>> openAskedProject(const std::string& folder) {
  if (folder.empty()) return std::optional<Project>();
  auto project = Project::open(folder, Project::Missing::isMade);
  if (!project) return project.error();
  return std::optional<Project>(std::move(*project));
}

Result<Answer> intoProject(std::optional<Project>& project, const NewRun& run, const Result<Answer>& answer) {
  if (!project || !answer) return answer;
  const auto put = project->add(run);
  if (!put) return put.error();
  auto json = nlohmann::ordered_json::parse(answer->json);
  json["project"] = {{"folder", project->folder()}, {"run", put->id}};
  return Answer{saidBy(*project) + answer->words + "Project: " + project->folder() + ", run " + put->id + "\n",
                asText(json)};
}

std::string motorOf(const std::string& benchFile) {
  return motorSerialIn(benchFile);
}

std::string saidBy(const Project& project) {
  std::string words;
  for (const Message& line : project.said()) words += line.english() + "\n";
  return words;
}

}  // namespace breakaway::cli
