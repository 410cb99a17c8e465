// A board without hardware: the reference firmware and a simulated rig, at the far end of a serial line or a TCP port.
#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "firmware_link/board_server.h"
#include "firmware_link/far_end.h"
#include "firmware_link/presets.h"
#include "firmware_link/simulated_firmware.h"
#include "firmware_link/wire/messages.h"
#include "line/help_as.h"
#include "version.h"

namespace {

using namespace breakaway;

struct BoardLine {
  std::string rig = "servo", pace = "real", serial;
  unsigned seed = 1;
  int port = -1;
};

int fail(const std::string& line) {
  std::fprintf(stderr, "breakaway-board: %s\n", line.c_str());
  return 2;
}

volatile std::sig_atomic_t endAsked = 0;

Result<void> serve(const BoardLine& line) {
  const auto file = rigFileOf("simulated:" + line.rig);
  if (!file) return file.error();
  const auto rig = readRig(*file);
  if (!rig) return rig.error();
  if (rig->axis != Axis::rotary)
    return Error{*file + ", field axis", "is linear, expected rotary: this board turns a rotor"};
  auto end = line.port < 0 ? FarEnd::pseudoTerminal() : FarEnd::loopback(static_cast<std::uint16_t>(line.port));
  if (!end) return end.error();
  const board::Pace pace = line.pace == "granted" ? board::Pace::granted : board::Pace::real;
  SimulatedFirmware firmware(*rig, line.seed, pace, static_cast<std::uint16_t>(std::random_device{}()), line.serial);
  BoardServer server(firmware, *end, pace);
  std::printf("%s\n", end->uri().c_str());
  std::fflush(stdout);
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { endAsked = 1; });
  while (endAsked == 0) server.turn();
  if (server.late_s() > 0.0) {
    std::fprintf(stderr, "breakaway-board: this machine was %.1f s too slow for the board's clock\n", server.late_s());
  }
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  BoardLine asked;
  CLI::App app{
      "A board without hardware: the reference firmware with a simulated rig, behind a serial line or a TCP port. "
      "Prints "
      "what breakaway takes as --board, and runs until it is interrupted.",
      "breakaway-board"};
  app.add_option("--rig", asked.rig, "preset, or FILE.rig.json")->capture_default_str();
  app.add_option("--seed", asked.seed, "seed of the rig's noise")->capture_default_str();
  app.add_option("--serial", asked.serial,
                 "serial number that the board tells, at most 40 bytes; without it none, as boards that have none")
      ->check([](const std::string& text) {
        return text.size() <= wire::SerialNumber::length ? std::string() : "is longer than a board can tell";
      });
  app.add_option("--pace", asked.pace,
                 "real: the board's clock is this machine's, and its lease runs out in 0.25 s; granted: the clock runs "
                 "as far as the host grants, as fast as it can be computed")
      ->capture_default_str()
      ->check(CLI::IsMember({"real", "granted"}));
  app.add_option("--tcp", asked.port,
                 "listen on this port of the loopback, 0: any that is free; without it on a pseudo terminal")
      ->check(CLI::Range(0, 65535));
  const std::string program = "breakaway-board " + std::string(breakaway::versionText());
  app.set_version_flag("--version", program);
  app.footer(
      "Examples:\n"
      "  breakaway-board --rig geared\n"
      "  breakaway-board --tcp 5000 --pace granted --serial 0042");
  if (const auto help = line::helpAs(app, program, {argv + 1, argv + argc})) {
    if (!*help) return fail(help->error().message());
    std::fputs((*help)->c_str(), stdout);
    return 0;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& done) {
    return app.exit(done);
  } catch (const CLI::ParseError& error) {
    return fail(std::string(error.what()) + "; see breakaway-board --help");
  }
  const auto done = serve(asked);
  return done ? 0 : fail(done.error().message());
}
