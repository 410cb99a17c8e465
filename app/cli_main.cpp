#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <sstream>
#include <string>
#include <vector>

#include "base/made.h"
#include "base/process.h"
#include "cli/command.h"
#include "cli/command_line.h"
#include "cli/inputs.h"
#include "cli/thrown.h"
#include "line/help_as.h"
#include "version.h"

namespace {

using namespace breakaway;

/// What libraries throw on the way ends the command as any other bad input does.
cli::Outcome outcomeOf(const cli::Job& job) {
  try {
    return job();
  } catch (const std::exception& error) {
    return {2, cli::thrown(error).message()};
  }
}

void addCommands(CLI::App& app, cli::Job& job) {
  for (const cli::AddCommand add : {
           cli::addFit,
           cli::addSimulate,
           cli::addDiagnose,
           cli::addCheck,
           cli::addBatch,
           cli::addSummary,
           cli::addTrial,
           cli::addImport,
           cli::addExport,
           cli::addCommission,
           cli::addTune,
           cli::addPorts,
           cli::addBurst,
           cli::addProfile,
           cli::addFigures,
           cli::addList,
           cli::addProject,
       }) {
    add(app, job);
  }
}

int fail(int status, const std::string& line) {
  std::fprintf(stderr, "breakaway: %s\n", line.c_str());
  return status;
}

/// The exit status: whatever was asked for doesn't count as done if nobody can have read it.
int say(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  return written ? 0 : fail(2, "standard output: cannot be written");
}

int answer(const cli::Answer& answer, const cli::Manner& manner, bool outputIsThere) {
  if (manner.json) return say(withMade(answer.json) + "\n");
  return manner.quiet || outputIsThere ? 0 : say(answer.words);
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  const std::string program = "breakaway " + std::string(versionText());
  CLI::App app{"Breakaway: the bench instrument for a servo motor's friction", "breakaway"};
  app.require_subcommand(1);
  cli::Job job;
  cli::Manner manner;
  addCommands(app, job);
  cli::addCommon(app, program, manner);
  if (const auto help = line::helpAs(app, program, words))
    return *help ? say(**help) : fail(2, help->error().message());
  if (const auto help = cli::helpAskedFor(app, words)) return *help ? say(**help) : fail(2, help->error().fact);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    std::ostringstream text;
    app.exit(asked, text, text);
    return say(text.str());
  } catch (const CLI::ParseError& error) {
    return fail(2, cli::complaint(app, words, error.what()));
  }
  const CLI::App& command = *app.get_subcommands().front();
  if (const auto good = cli::checkTogether(command, manner); !good) return fail(2, good.error().message());
  if (manner.quiet) cli::beQuiet();
  std::vector<std::string> line{"breakaway"};
  line.insert(line.end(), words.begin(), words.end());
  beginRun(program, asCommand(line), cli::seedOf(command));
  takeSizeLimitAsError();
  const cli::Outcome outcome = outcomeOf(job);
  if (!outcome.line.empty()) fail(outcome.status, outcome.line);
  return outcome.status != 0 ? outcome.status : answer(outcome.answer, manner, cli::writesToStandardOutput(command));
}
