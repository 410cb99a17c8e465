#include "firmware_link/transport/serial_ports.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/inputs.h"

namespace breakaway::cli {

namespace {

Answer answerOf(const std::vector<SerialPort>& ports) {
  nlohmann::ordered_json json{{"ports", nlohmann::ordered_json::array()}};
  std::string words;
  for (const SerialPort& one : ports) {
    words += "serial:" + one.lasting + "  " + one.words() + "\n";
    json["ports"].push_back({{"uri", "serial:" + one.lasting},
                             {"device", one.device},
                             {"product", one.product},
                             {"maker", one.maker},
                             {"serial_number", one.serialNumber}});
  }
  return {words.empty() ? "no serial port is plugged in\n" : words, asText(json)};
}

}  // namespace

void addPorts(CLI::App& app, Job& chosen) {
  auto* command = app.add_subcommand("ports", "List the serial ports by the names of what is plugged in");
  command->footer("Example:\n  breakaway ports --json");
  command->callback([&chosen] { chosen = []() -> Outcome { return Result<Answer>(answerOf(serialPorts())); }; });
}

}  // namespace breakaway::cli
