#include <CLI/CLI.hpp>
#include <cstdio>

#include "cli/command.h"

int main(int argc, char** argv) {
  using namespace breakaway;
  CLI::App app{"Breakaway: the bench instrument for a servo motor's friction", "breakaway"};
  app.require_subcommand(1);
  cli::Job job;
  for (const cli::AddCommand add : {
           cli::addFit,
           cli::addSimulate,
           cli::addDiagnose,
           cli::addImport,
           cli::addCommission,
       }) {
    add(app, job);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "breakaway: %s; see breakaway --help\n", error.what());
    return 2;
  }
  if (const auto done = job(); !done) {
    std::fprintf(stderr, "breakaway: %s\n", done.error().message().c_str());
    return 2;
  }
  return 0;
}
