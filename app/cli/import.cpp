#include "recording/import/import.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "cli/command.h"
#include "cli/inputs.h"
#include "recording/block_file.h"
#include "recording/csv.h"
#include "recording/stretch.h"

namespace breakaway::cli {

namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string in, out, map;
  bool explain = false;
  std::optional<double> from_s, to_s;

  bool trims() const { return from_s || to_s; }
};

constexpr size_t rowsShown = 5;
constexpr size_t columnsShown = 8;

std::string firstRows(const Recording& recording) {
  std::string words;
  const auto& channels = recording.channels();
  const size_t columns = std::min(channels.size(), columnsShown);
  for (size_t c = 0; c < columns; ++c) words += fmt::format("{}{:.24}", c == 0 ? "" : "\t", channels[c].name);
  words += columns < channels.size() ? "\t…\n" : "\n";
  for (size_t k = 0; k < std::min(recording.rows(), rowsShown); ++k) {
    for (size_t c = 0; c < columns; ++c) {
      const double value = channels[c].values[k];
      words += (c == 0 ? "" : "\t") + (std::isnan(value) ? std::string() : fmt::format("{:.9g}", value));
    }
    words += "\n";
  }
  return words;
}

/// What of it is asked for.
Result<Recording> trimmed(const Recording& recording, const Options& options) {
  if (!options.trims()) return recording;
  if (recording.rows() == 0) return recording;
  return stretchOf(recording, options.from_s.value_or(recording.time().front()),
                   options.to_s.value_or(recording.time().back()));
}

/// "log.csv" and "3" make "log.3.csv".
std::string partPath(const std::string& out, std::string part) {
  // Texts of a log become a file's name here, and may hold what no name should.
  for (char& c : part) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || c == '.' ||
                       static_cast<unsigned char>(c) >= 0x80U;
    if (!plain) c = '_';
  }
  const size_t dot = out.find_last_of('.');
  const size_t slash = out.find_last_of('/');
  const bool extension = dot != std::string::npos && (slash == std::string::npos || dot > slash);
  return extension ? out.substr(0, dot) + "." + part + out.substr(dot) : out + "." + part;
}

std::string fates(const Imported& imported) {
  std::string words;
  for (const ColumnFate& column : imported.columns) words += column.inWords() + "\n";
  for (const auto& remark : imported.remarks) words += remark + "\n";
  return words;
}

Json jsonOf(const Imported& imported) {
  Json json{{"rows", imported.recording.rows()}, {"columns", Json::array()}, {"remarks", imported.remarks}};
  for (const ColumnFate& one : imported.columns) {
    const bool leftOut = one.kind == ColumnFate::Kind::leftOut;
    json["columns"].push_back({{"from", one.from},
                               {"to", leftOut ? Json() : Json(one.to)},
                               {"unit", one.unit},
                               {"scale", one.scale},
                               {"offset", one.offset},
                               {"why", one.why},
                               {"guessed", one.guessed},
                               {"doubt", one.doubt.empty() ? Json() : Json(one.doubt)}});
  }
  return json;
}

/// Where a part goes: into the file that was named, or beside it.
std::string outOf(const Imported& part, const Options& options, const ImportMap& map) {
  return map.split.empty() ? options.out : partPath(options.out, part.recording.notes().rbegin()[1].second);
}

/// Before anything is written.
Result<void> checkOutputs(const std::vector<Imported>& parts, const Options& options, const ImportMap& map) {
  if (!map.split.empty() && isStandardOutput(options.out))
    return Error{options.map, "splits into several files, expected --out to name a file"};
  std::set<std::string> names;
  for (const Imported& part : parts) {
    if (!names.insert(outOf(part, options, map)).second)
      return Error{options.map, "splits into two files of the same name, " + outOf(part, options, map)};
    if (auto good = checkOutput(outOf(part, options, map), {options.in, options.map}); !good) return good;
  }
  return {};
}

/// A recording of ours that was kept in blocks.
Result<Answer> importBlocks(const Options& options) {
  const auto survey = surveyBlocks(options.in);
  if (!survey) return survey.error();
  std::string words = fmt::format("{}: {} rows, {} columns, {} samples lost in {} gaps\n", options.in, survey->rows,
                                  survey->head.columns.size(), survey->lost(), survey->gaps.size());
  if (survey->unreadable() > 0)
    words += fmt::format("{} bytes of the file are damaged, in {} places: what they held is missing.\n",
                         survey->unreadable(), survey->holes.size());
  if (!survey->ended) words += "It ended by a kill or a loss of power: the last second may be missing.\n";
  const Json json{{"rows", survey->rows},
                  {"lost", survey->lost()},
                  {"gaps", survey->gaps.size()},
                  {"damaged_bytes", survey->unreadable()},
                  {"out", options.explain ? Json() : Json(options.out)}};
  if (options.explain) return Answer{words, asText(json)};
  if (!options.trims()) {
    if (auto written = writeBlocksAsCsv(options.in, options.out); !written) return written.error();
    return Answer{words + options.out + "\n", asText(json)};
  }
  const auto whole = readBlocks(options.in);
  if (!whole) return whole.error();
  const auto part = trimmed(*whole, options);
  if (!part) return part.error();
  if (auto written = writeCsv(*part, options.out); !written) return written.error();
  words += fmt::format("{} of them are taken\n", part->rows());
  return Answer{words + options.out + "\n", asText(json)};
}

Result<Answer> import(const Options& options) {
  if (!options.explain) {
    if (auto good = checkOutput(options.out, {options.in, options.map}); !good) return good.error();
  }
  if (isBlockFile(options.in)) return importBlocks(options);
  ImportMap map;
  if (!options.map.empty()) {
    auto read = readImportMap(options.map);
    if (!read) return read.error();
    map = std::move(*read);
  }
  auto parts = importRecordings(options.in, map);
  if (!parts) return parts.error();
  if (!options.explain) {
    if (auto good = checkOutputs(*parts, options, map); !good) return good.error();
  }
  std::vector<std::string> outs;  // a part's name stands in its last notes
  for (Imported& part : *parts) {
    outs.push_back(outOf(part, options, map));
    auto taken = trimmed(part.recording, options);
    if (!taken) return taken.error();
    part.recording = std::move(*taken);
  }
  std::string words;
  Json json{{"recordings", Json::array()}};
  for (size_t k = 0; k < parts->size(); ++k) {
    const Imported& part = (*parts)[k];
    words += fates(part);
    json["recordings"].push_back(jsonOf(part));
    if (options.explain) {
      words += firstRows(part.recording);
      continue;
    }
    const std::string& out = outs[k];
    if (const auto done = writeCsv(part.recording, out); !done) return done.error();
    words += fmt::format("{}: {} rows, {} columns\n", out, part.recording.rows(), part.recording.channels().size());
    json["recordings"].back()["out"] = out;
  }
  return Answer{words, asText(json)};
}

}  // namespace

void addImport(CLI::App& app, Job& chosen) {
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand("import", "Turn a log of another tool into a recording");
  command
      ->add_option("IN", options->in,
                   "log: a table of text, .xlsx, .mat, .npy, .npz, HDF5, JSON, .wpilog, .lvm, also packed (.gz); - is "
                   "standard input")
      ->required();
  auto* out = command->add_option("--out", options->out, "recording to write, CSV; - is standard output");
  command->add_option("--map", options->map,
                      "JSON that says what the file doesn't: {\"columns\": {\"OLD\": {\"to\": \"NEW\", \"unit\": "
                      "\"deg\"}}, \"pole_pairs\": 7}");
  command->add_option("--from", options->from_s, "s of the recording's time: only rows from there on");
  command->add_option("--to", options->to_s, "s of the recording's time: only rows until there, included");
  command->add_flag("--explain", options->explain, "say what is understood, show the first rows, write nothing");
  command->footer(
      "Columns are understood by their names and units; what became of each is printed. The manual's page import.md "
      "tells more.\n"
      "Examples:\n"
      "  breakaway import log.csv --explain\n"
      "  breakaway import log.csv --from 2 --to 4 --out part.csv\n"
      "  breakaway import vesc.csv --map vesc.map.json --out r.csv\n"
      "  zcat log.gz | breakaway import - --out r.csv");
  command->callback([options, out, &chosen] {
    if (out->empty() && !options->explain) throw CLI::RequiredError("--out");
    chosen = [options] { return import(*options); };
  });
}

}  // namespace breakaway::cli
