#include <CLI/CLI.hpp>
#include <cstdio>

#include "cli/command.h"
#include "friction/map_export.h"

namespace breakaway::cli {

void addExport(CLI::App& app, Job& chosen) {
  struct Options {
    std::string map, format, out;
  };
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand("export", "Write a friction map in the form that another program reads");
  command->add_option("--map", options->map, "map to read, map.json")->required();
  command->add_option("--as", options->format, "csv, json, c-header or mat")->required();
  command->add_option("--out", options->out, "file to write")->required();
  command->callback([options, &chosen] {
    chosen = [options]() -> Result<void> {
      const auto map = readMap(options->map);
      if (!map) return map.error();
      if (auto done = exportMap(*map, options->format, options->out); !done) return done;
      std::printf("%s: %zu bins\n", options->out.c_str(), map->bins.size());
      return {};
    };
  });
}

}  // namespace breakaway::cli
