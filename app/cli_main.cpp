#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "base/json_object.h"
#include "cli/command.h"

namespace {

/// The first word when it should be a command and is none, with the nearest one.
std::string unknownCommand(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* one : app.get_subcommands(nullptr)) names.push_back(one->get_name());
  if (word.starts_with("-") || std::find(names.begin(), names.end(), word) != names.end()) return {};
  const auto suggestion = breakaway::nearestName(word, names);
  return "knows no command " + word + (suggestion ? ", did you mean " + *suggestion + "?" : "; see breakaway --help");
}

}  // namespace

int main(int argc, char** argv) {
  using namespace breakaway;
  CLI::App app{"Breakaway: the bench instrument for a servo motor's friction", "breakaway"};
  app.require_subcommand(1);
  cli::Job job;
  for (const cli::AddCommand add : {
           cli::addFit,
           cli::addSimulate,
           cli::addDiagnose,
           cli::addBatch,
           cli::addTrial,
           cli::addImport,
           cli::addExport,
           cli::addCommission,
           cli::addTune,
           cli::addPorts,
           cli::addBurst,
           cli::addProfile,
           cli::addFigures,
       }) {
    add(app, job);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    const std::string unknown = argc > 1 ? unknownCommand(app, argv[1]) : std::string();
    if (!unknown.empty()) {
      std::fprintf(stderr, "breakaway: %s\n", unknown.c_str());
      return 2;
    }
    std::fprintf(stderr, "breakaway: %s; see breakaway --help\n", error.what());
    return 2;
  }
  const cli::Outcome outcome = job();
  if (!outcome.line.empty()) std::fprintf(stderr, "breakaway: %s\n", outcome.line.c_str());
  return outcome.status;
}
