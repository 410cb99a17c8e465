#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/made.h"
#include "base/output_folder.h"
#include "cli/command.h"
#include "cli/inputs.h"
#include "draw/png.h"
#include "figures/all_figures.h"
#include "figures/figure_files.h"
#include "firmware_link/simulated_board.h"
#include "firmware_link/simulated_shaft.h"

namespace breakaway::cli {

namespace {

struct FiguresLine {
  std::string board = "simulated", uneven = "simulated:uneven", out;
  AllFiguresOptions options;
};

Result<Answer> runFigures(FiguresLine& line) {
  if (auto able = pngCanBeWritten(); !able) return able.error();
  auto bench = openDrive(line.board, line.options.seed);
  if (!bench) return bench.error();
  noteDevice(MadeOn{(*bench)->identity().device, {}, (*bench)->identity().firmware});
  auto uneven = openDrive(line.uneven, line.options.seed);
  if (!uneven) return uneven.error();
  for (const auto& [name, board] : {std::pair(line.board, bench->get()), std::pair(line.uneven, uneven->get())}) {
    if (board->identity().axis != Axis::rotary)
      return Error{"board " + name, "moves a linear axis, expected a rotor: the figures are a rotor's"};
  }
  auto out = OutputFolder::open({line.out, "figures", {"figures.json", "index.html"}, {}});
  if (!out) return out.error();
  if (progressIsWatched()) {
    line.options.progress = [](double part, const std::string& activity) {
      std::fprintf(stderr, "\r\033[K%3.0f %%  %s", 100.0 * part, activity.c_str());
    };
  }
  const auto pushed = [&line](const ExternalPulse& pulse) {
    return openPushed(line.board, line.options.seed, {pulse.torque_Nm, pulse.start_s, pulse.duration_s});
  };
  const auto figures = measureFigures(std::move(*bench), std::move(*uneven), pushed, line.options);
  if (progressIsWatched()) std::fprintf(stderr, "\r\033[K");
  if (!figures) return figures.error();
  const auto written = out->fill([&](const std::string& folder) { return writeFigures(*figures, folder); });
  if (!written) return written.error();
  nlohmann::ordered_json json{{"report", line.out + "/index.html"}, {"figures", nlohmann::ordered_json::array()}};
  for (const BenchFigure& one : *figures) json["figures"].push_back(one.name);
  return Answer{out->inWords() + std::to_string(figures->size()) + " figures: " + line.out + "/index.html\n",
                asText(json)};
}

}  // namespace

void addFigures(CLI::App& app, Job& chosen) {
  auto line = std::make_shared<FiguresLine>();
  auto* command =
      app.add_subcommand("figures", "Measure every figure of the bench on simulated boards, as pictures and numbers");
  command->add_option("--out", line->out, "folder for NAME.svg, NAME.png, NAME.csv, figures.json and index.html")
      ->required();
  command->add_option("--board", line->board, "simulated, simulated:PRESET or simulated:FILE.rig.json")
      ->capture_default_str();
  command->add_option("--uneven", line->uneven, "the board for slow motion over uneven friction")
      ->capture_default_str();
  command->add_option("--seed", line->options.seed, "seed of the boards' noise")->capture_default_str();
  command->add_option("--bins", line->options.bins, "bins around the rotor")
      ->capture_default_str()
      ->check(CLI::Range(36, 1440));
  command->add_option("--turns", line->options.turns, "turns of the breakaway sweep each way")
      ->capture_default_str()
      ->check(CLI::Range(1, 20));
  command->footer(
      "Examples:\n"
      "  breakaway figures --out f\n"
      "  breakaway figures --board simulated:geared --seed 3 --out f");
  command->callback([line, &chosen] { chosen = [line] { return runFigures(*line); }; });
}

}  // namespace breakaway::cli
