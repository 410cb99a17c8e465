#include "recording/import.h"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "cli/command.h"
#include "recording/csv.h"

namespace breakaway::cli {

namespace {

Result<void> import(const std::string& in, const std::string& out, const std::string& mapPath) {
  ImportMap map;
  if (!mapPath.empty()) {
    auto read = readImportMap(mapPath);
    if (!read) return read.error();
    map = std::move(*read);
  }
  const auto imported = importRecording(in, map);
  if (!imported) return imported.error();
  if (const auto done = writeCsv(imported->recording, out); !done) return done.error();
  for (const auto& remark : imported->remarks) std::printf("%s\n", remark.c_str());
  std::printf("%s: %zu rows, %zu columns\n", out.c_str(), imported->recording.rows(),
              imported->recording.channels().size());
  return {};
}

}  // namespace

void addImport(CLI::App& app, Job& chosen) {
  struct Options {
    std::string in, out, map;
  };
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand("import", "Turn a log of another tool into a recording");
  command->add_option("IN", options->in, "table of text (comma, semicolon, tab or blank separated), .mat, or JSON log")
      ->required();
  command->add_option("--out", options->out, "recording to write, CSV")->required();
  command->add_option(
      "--map", options->map,
      "JSON that says what columns mean: {\"columns\": {\"OLD\": {\"to\": \"NEW\", \"scale\": 1, \"offset\": 0}}}");
  command->footer(
      "Columns are understood by their names and units; what was understood is printed. The manual's page import.md "
      "tells more.");
  command->callback(
      [options, &chosen] { chosen = [options] { return import(options->in, options->out, options->map); }; });
}

}  // namespace breakaway::cli
