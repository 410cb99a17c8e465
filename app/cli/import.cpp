#include "recording/import/import.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>

#include "cli/command.h"
#include "recording/csv.h"

namespace breakaway::cli {

namespace {

struct Options {
  std::string in, out, map;
  bool explain = false;
};

constexpr size_t rowsShown = 5;
constexpr size_t columnsShown = 8;

void printFirstRows(const Recording& recording) {
  const auto& channels = recording.channels();
  const size_t columns = std::min(channels.size(), columnsShown);
  for (size_t c = 0; c < columns; ++c) std::printf("%s%.24s", c == 0 ? "" : "\t", channels[c].name.c_str());
  std::printf("%s\n", columns < channels.size() ? "\t…" : "");
  for (size_t k = 0; k < std::min(recording.rows(), rowsShown); ++k) {
    for (size_t c = 0; c < columns; ++c) {
      const double value = channels[c].values[k];
      std::printf(std::isnan(value) ? "%s" : "%s%.9g", c == 0 ? "" : "\t", value);
    }
    std::printf("\n");
  }
}

/// "log.csv" and "3" make "log.3.csv".
std::string partPath(const std::string& out, const std::string& part) {
  const size_t dot = out.find_last_of('.');
  const size_t slash = out.find_last_of('/');
  const bool extension = dot != std::string::npos && (slash == std::string::npos || dot > slash);
  return extension ? out.substr(0, dot) + "." + part + out.substr(dot) : out + "." + part;
}

void printFates(const Imported& imported) {
  for (const ColumnFate& column : imported.columns) std::printf("%s\n", column.inWords().c_str());
  for (const auto& remark : imported.remarks) std::printf("%s\n", remark.c_str());
}

Result<void> import(const Options& options) {
  ImportMap map;
  if (!options.map.empty()) {
    auto read = readImportMap(options.map);
    if (!read) return read.error();
    map = std::move(*read);
  }
  const auto parts = importRecordings(options.in, map);
  if (!parts) return parts.error();
  for (const Imported& part : *parts) {
    const std::string out =
        map.split.empty() ? options.out : partPath(options.out, part.recording.notes().rbegin()[1].second);
    if (options.explain) {
      printFates(part);
      printFirstRows(part.recording);
      continue;
    }
    if (const auto done = writeCsv(part.recording, out); !done) return done.error();
    printFates(part);
    std::printf("%s: %zu rows, %zu columns\n", out.c_str(), part.recording.rows(), part.recording.channels().size());
  }
  return {};
}

}  // namespace

void addImport(CLI::App& app, Job& chosen) {
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand("import", "Turn a log of another tool into a recording");
  command
      ->add_option("IN", options->in,
                   "log: a table of text, .xlsx, .mat, .npy, .npz, HDF5, JSON, .wpilog, .lvm, also packed (.gz)")
      ->required();
  command->add_option("--out", options->out, "recording to write, CSV");
  command->add_option("--map", options->map,
                      "JSON that says what the file doesn't: {\"columns\": {\"OLD\": {\"to\": \"NEW\", \"unit\": "
                      "\"deg\"}}, \"pole_pairs\": 7}");
  command->add_flag("--explain", options->explain, "say what is understood, show the first rows, write nothing");
  command->footer(
      "Columns are understood by their names and units; what became of each is printed. The manual's page import.md "
      "tells more.");
  command->callback([options, &chosen] {
    if (options->out.empty() && !options->explain) throw CLI::RequiredError("--out");
    chosen = [options] { return import(*options); };
  });
}

}  // namespace breakaway::cli
