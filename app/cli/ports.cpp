#include "firmware_link/transport/serial_ports.h"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "cli/command.h"

namespace breakaway::cli {

void addPorts(CLI::App& app, Job& chosen) {
  auto* command = app.add_subcommand("ports", "List the serial ports by the names of what is plugged in");
  command->callback([&chosen] {
    chosen = []() -> Result<void> {
      const auto ports = serialPorts();
      for (const SerialPort& one : ports) std::printf("serial:%s  %s\n", one.lasting.c_str(), one.words().c_str());
      if (ports.empty()) std::printf("no serial port is plugged in\n");
      return {};
    };
  });
}

}  // namespace breakaway::cli
