#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "cli/command.h"
#include "cli/inputs.h"
#include "friction/map_export.h"

namespace breakaway::cli {

namespace {

struct Options {
  std::string map, format, out;
};

Result<Answer> exported(const Options& options) {
  if (auto good = checkOutput(options.out, {options.map}); !good) return good.error();
  const auto map = readMap(options.map);
  if (!map) return map.error();
  if (auto done = exportMap(*map, options.format, options.out); !done) {
    const bool ofMap = done.error().place.starts_with("bin ");
    return ofMap ? Error{options.map + ", " + done.error().place, done.error().fact} : done.error();
  }
  const nlohmann::ordered_json json{{"out", options.out}, {"bins", map->bins.size()}};
  return Answer{options.out + ": " + std::to_string(map->bins.size()) + " bins\n", asText(json)};
}

}  // namespace

void addExport(CLI::App& app, Job& chosen) {
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand("export", "Write a friction map in the form that another program reads");
  command->add_option("--map", options->map, "map to read, map.json; - is standard input")->required();
  command->add_option("--as", options->format, "the form")
      ->required()
      ->check(CLI::IsMember({"csv", "json", "c-header", "mat"}));
  command->add_option("--out", options->out, "file to write; - is standard output")->required();
  command->footer(
      "Examples:\n"
      "  breakaway export --map c/map.json --as c-header --out friction_map.h\n"
      "  breakaway export --map c/map.json --as csv --out - | head");
  command->callback([options, &chosen] { chosen = [options]() -> Outcome { return exported(*options); }; });
}

}  // namespace breakaway::cli
