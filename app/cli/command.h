// The seam of the headless program: each command is one file that adds itself to the parser.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"

namespace CLI {
class App;
}

namespace breakaway::cli {

/// What a command says on standard output when it is done.
struct Answer {
  std::string words;  ///< for people; its last line says where the result is
  std::string json;   ///< the same as a JSON object, for --json
};

/// How a command ended: its exit status, what it answers, and one line where it isn't 0.
struct Outcome {
  int status =
      0;  ///< 0: done; 1: the bench failed on the way; 2: the input is wrong; 130: interrupted from the keyboard
  std::string line;  ///< empty where the status is 0
  Answer answer;

  Outcome(const Result<Answer>& done)
      : status(done ? 0 : 2), line(done ? std::string() : done.error().message()), answer(done ? *done : Answer()) {}
  Outcome(const Error& error) : Outcome(2, error.message()) {}
  Outcome(int wrongStatus, std::string why) : status(wrongStatus), line(std::move(why)) {}
};

/// What a command does once the line is parsed.
using Job = std::function<Outcome()>;

/// Adds one subcommand to `app`; `chosen` is set to the job when that subcommand was named.
using AddCommand = void (*)(CLI::App& app, Job& chosen);

void addFit(CLI::App& app, Job& chosen);
void addSimulate(CLI::App& app, Job& chosen);
void addDiagnose(CLI::App& app, Job& chosen);
void addCheck(CLI::App& app, Job& chosen);
void addBatch(CLI::App& app, Job& chosen);
void addSummary(CLI::App& app, Job& chosen);
void addTrial(CLI::App& app, Job& chosen);
void addImport(CLI::App& app, Job& chosen);
void addExport(CLI::App& app, Job& chosen);
void addCommission(CLI::App& app, Job& chosen);
void addTune(CLI::App& app, Job& chosen);
void addProfile(CLI::App& app, Job& chosen);
void addPorts(CLI::App& app, Job& chosen);
void addBurst(CLI::App& app, Job& chosen);
void addFigures(CLI::App& app, Job& chosen);
void addList(CLI::App& app, Job& chosen);
void addProject(CLI::App& app, Job& chosen);

}  // namespace breakaway::cli
