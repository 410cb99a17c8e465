// A fleet at a glance, from the results of batch (resources/help/commands.md#summary).
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "cli/command.h"
#include "cli/inputs.h"
#include "fleet/fleet_map.h"
#include "fleet/spread.h"
#include "fleet/summary_csv.h"
#include "fleet/summary_page.h"
#include "friction/map_export.h"

namespace breakaway::cli {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

struct SummaryLine {
  std::vector<std::string> results;
  std::string out, form, maps;
};

struct Fleet {
  std::vector<FleetEntry> entries;
  std::vector<std::string> cutShort;  ///< files whose last line was being written
  size_t repeated = 0;                ///< results that stood there twice, and count once
};

Result<std::string> formOf(const SummaryLine& line) {
  if (!line.form.empty()) return line.form;
  if (line.out == "-") return std::string("csv");
  for (const char* form : {"html", "csv"}) {
    if (line.out.ends_with(std::string(".") + form)) return std::string(form);
  }
  return Error{line.out, "expected a name that ends in .html or .csv, or --as"};
}

/// The way from the folder of the summary to that of a file of results.
std::string wayBetween(const std::string& out, const std::string& results) {
  std::error_code code;
  const fs::path here = fs::absolute(out == "-" ? "." : out, code).lexically_normal();
  const fs::path there = fs::absolute(results == "-" ? "./-" : results, code).lexically_normal();
  return there.parent_path().lexically_relative(out == "-" ? here : here.parent_path()).string();
}

/// The friction map that each entry's field `field` names, a path from the folder of its results; entries without one
/// have none.
Result<void> readMaps(std::vector<FleetEntry>& entries, const std::string& field, const std::string& results) {
  const fs::path folder = results == "-" ? fs::path() : fs::path(results).parent_path();
  for (FleetEntry& entry : entries) {
    const auto path = std::find_if(entry.further.begin(), entry.further.end(),
                                   [&field](const auto& one) { return one.first == field; });
    if (path == entry.further.end() || path->second.empty()) continue;
    const auto map = readMap((folder / path->second).string());
    if (!map) return Error{results + ", entry " + entry.id + ": " + map.error().place, map.error().fact};
    addMap(entry, *map);
  }
  return {};
}

Result<Fleet> readAll(const SummaryLine& line) {
  Fleet fleet;
  for (const std::string& path : line.results) {
    const auto text = readFile(path);
    if (!text) return text.error();
    auto read = readFleet(*text, path, wayBetween(line.out, path));
    if (!read) return read.error();
    if (!line.maps.empty()) {
      if (auto maps = readMaps(read->entries, line.maps, path); !maps) return maps.error();
    }
    if (read->cutShort) fleet.cutShort.push_back(path);
    std::move(read->entries.begin(), read->entries.end(), std::back_inserter(fleet.entries));
  }
  fleet.repeated = leaveOutRepeated(fleet.entries);
  return fleet;
}

Answer answerOf(const SummaryLine& line, const Fleet& fleet) {
  const std::vector<StandsOut> order = outliersFirst(fleet.entries, baseColumns(fleet.entries));
  std::map<std::string, size_t> verdicts;
  for (const FleetEntry& entry : fleet.entries) ++verdicts[entry.verdict];
  Json json{{"out", line.out}, {"entries", fleet.entries.size()}, {"verdicts", verdicts}, {"stand_out", Json::array()}};
  for (const StandsOut& one : order) {
    if (std::abs(one.distance) < standsOutFrom) break;
    json["stand_out"].push_back(
        {{"id", fleet.entries[one.entry].id}, {"parameter", one.parameter}, {"deviations", one.distance}});
  }
  json["cut_short"] = fleet.cutShort;
  json["repeated"] = fleet.repeated;
  const size_t several = idsWithSeveral(fleet.entries);
  json["ids_with_several"] = several;
  std::string words;
  for (const std::string& path : fleet.cutShort)
    words += path + ": its last line has no end, and is left out; batch does that entry again\n";
  if (fleet.repeated > 0)
    words += fmt::format("Results that stand there more than once, and count once: {}\n", fleet.repeated);
  if (several > 0)
    words += fmt::format("Ids with several results, of different runs, all of which count: {}\n", several);
  const size_t apart = json["stand_out"].size();
  if (apart > 0)
    words += fmt::format("Furthest from the others: {}, {} by {:.1f} robust deviations\n",
                         fleet.entries[order[0].entry].id, order[0].parameter, order[0].distance);
  words += fmt::format("{}: {} entries, {} stand out, {} ended in an error\n", line.out, fleet.entries.size(), apart,
                       verdicts["error"]);
  return {words, asText(json)};
}

Result<Answer> summarise(const SummaryLine& line) {
  const auto form = formOf(line);
  if (!form) return form.error();
  if (auto good = checkOutput(line.out, line.results); !good) return good.error();
  const auto fleet = readAll(line);
  if (!fleet) return fleet.error();
  const std::string text = *form == "csv" ? summaryCsv(fleet->entries) : summaryPage(fleet->entries);
  if (auto done = writeFile(line.out, text); !done) return done.error();
  return answerOf(line, *fleet);
}

}  // namespace

void addSummary(CLI::App& app, Job& chosen) {
  auto line = std::make_shared<SummaryLine>();
  auto* command = app.add_subcommand(
      "summary", "A fleet at a glance from the results of batch: a page to sort and filter, or a table");
  command
      ->add_option("results", line->results, "one or more files of results, as batch writes them; - is standard input")
      ->required();
  command->add_option("--out", line->out, "file to write, NAME.html or NAME.csv; - is standard output")->required();
  command->add_option("--as", line->form, "the form, where the name of the file doesn't say it; csv to standard output")
      ->check(CLI::IsMember({"html", "csv"}));
  command->add_option(
      "--maps", line->maps,
      "field of the list's entries that names their friction maps, map.json, as paths from the folder of "
      "the results: how these lie over the fleet");
  command->footer(
      "Examples:\n"
      "  breakaway summary results.jsonl --out fleet.html\n"
      "  breakaway summary results.jsonl --maps map --out fleet.html\n"
      "  breakaway summary results-1.jsonl results-2.jsonl --out fleet.csv\n"
      "  breakaway summary results.jsonl --out - | head");
  command->callback([line, &chosen] { chosen = [line]() -> Outcome { return summarise(*line); }; });
}

}  // namespace breakaway::cli
