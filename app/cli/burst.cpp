#include "experiment/identity.h"
#include "firmware_link/burst_capture.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "base/atomic_file.h"
#include "base/made.h"
#include "cli/command.h"
#include "cli/inputs.h"
#include "cli/number_range.h"
#include "firmware_link/transport/byte_address.h"
#include "firmware_link/transport/open_byte_stream.h"
#include "recording/csv.h"
#include "recording/sample_recording.h"

namespace breakaway::cli {

namespace {

using Mode = wire::MotorCommand::Mode;
const std::map<std::string, Mode> modes{
    {"voltage", Mode::voltage}, {"current", Mode::current}, {"velocity", Mode::velocity}, {"position", Mode::position}};

struct BurstLine {
  std::string board, out, mode;
  BurstRequest request;
};

Answer answerOf(const BurstLine& line, const BurstRequest& request, const CapturedBurst& burst) {
  std::string words;
  if (burst.samples.size() < request.samples)
    words +=
        fmt::format("the board has room for {} samples, {} were asked for\n", burst.samples.size(), request.samples);
  words += fmt::format("{}: {} samples, one every {} ticks\n", line.out, burst.samples.size(), request.every);
  const nlohmann::ordered_json json{{"out", line.out},
                                    {"samples", burst.samples.size()},
                                    {"asked_for", request.samples},
                                    {"every_ticks", request.every}};
  return {words, asText(json)};
}

Outcome runBurst(const BurstLine& line) {
  if (!carriesBytes(line.board))
    return Error{"board " + line.board, "takes no burst, expected serial:PORT[@BAUD] or tcp:HOST:PORT"};
  if (auto good = checkOutput(line.out); !good) return good.error();
  BurstRequest request = line.request;
  if (!line.mode.empty()) request.mode = modes.at(line.mode);
  auto stream = openByteStream(line.board);
  if (!stream) return stream.error();
  BoardLink link(std::move(*stream), "board " + line.board);
  const auto board = BoardDictionary::read(link);
  if (!board) return board.error();
  noteDevice(MadeOn{board->device(), board->serialNumber(), board->firmware()});
  const auto burst = captureBurst(link, *board, request);
  if (!burst) return burst.error();
  Identity identity;
  identity.device = board->device();
  identity.firmware = board->firmware();
  identity.serialNumber = board->serialNumber();
  const auto recording = sealSamples(line.out, burst->samples, notesOf(identity));
  if (!recording) return recording.error();
  if (auto written = writeCsv(*recording, line.out); !written) return written.error();
  if (!burst->fault.empty()) return {1, burst->fault};
  return Result<Answer>(answerOf(line, request, *burst));
}

}  // namespace

void addBurst(CLI::App& app, Job& chosen) {
  auto line = std::make_shared<BurstLine>();
  auto* command = app.add_subcommand("burst", "Record every tick on the board itself, and read it afterwards");
  command->add_option("--board", line->board, "serial:PORT[@BAUD] or tcp:HOST:PORT")->required();
  command->add_option("--out", line->out, "the recording, NAME.csv")->required();
  command->add_option("--samples", line->request.samples, "that many; a board has room for some hundreds")
      ->check(CLI::Range(1, 65535))
      ->capture_default_str();
  command->add_option("--every", line->request.every, "control ticks from one sample to the next")
      ->check(CLI::Range(1, 255))
      ->capture_default_str();
  auto* mode = command
                   ->add_option("--command", line->mode,
                                "voltage, current, velocity or position: the burst begins with this command, and the "
                                "motor is stopped at its end. Without it the burst begins at once, the motor off")
                   ->check(CLI::IsMember({"voltage", "current", "velocity", "position"}));
  auto* target = command->add_option("--target", line->request.target, "of the command, in V, A, rad/s or rad")
                     ->check(numberIn(-1e6, 1e6))
                     ->needs(mode);
  mode->needs(target);
  command->footer(
      "Examples:\n"
      "  breakaway burst --board serial:ttyACM0 --out b.csv\n"
      "  breakaway burst --board tcp:localhost:5000 --samples 400 --command voltage --target 2 --out b.csv");
  command->callback([line, &chosen] { chosen = [line] { return runBurst(*line); }; });
}

}  // namespace breakaway::cli
