#include "firmware_link/transport/serial_ports.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace breakaway {

namespace {

namespace fs = std::filesystem;

/// The first line of one of the kernel's small files; empty where there is none.
std::string lineOf(const fs::path& file) {
  std::string line;
  std::getline(std::ifstream(file), line);
  return line;
}

/// The link below /dev/serial/by-id that leads to `device`; the device itself when there is none.
std::string lastingName(const std::string& device) {
  std::error_code code;
  for (const auto& link : fs::directory_iterator("/dev/serial/by-id", code)) {
    std::error_code broken;
    if (fs::canonical(link.path(), broken) == fs::path(device) && !broken) return link.path().string();
  }
  return device;
}

/// The folder of the USB device that `interface` belongs to: the nearest one above with a vendor. Empty: none.
fs::path usbDevice(fs::path interface) {
  std::error_code code;
  for (; interface.has_relative_path(); interface = interface.parent_path()) {
    if (fs::exists(interface / "idVendor", code)) return interface;
  }
  return {};
}

}  // namespace

std::string SerialPort::words() const {
  const std::string name = fs::path(device).filename().string();
  return product.empty() ? name : product + " (" + name + ")";
}

std::vector<SerialPort> serialPorts(const std::string& kernel) {
  std::vector<SerialPort> ports;
  std::error_code code;
  for (const auto& terminal : fs::directory_iterator(fs::path(kernel) / "class" / "tty", code)) {
    std::error_code none;
    const fs::path hardware = fs::canonical(terminal.path() / "device", none);
    if (none) continue;                                     // a console or a pseudo terminal
    if (lineOf(terminal.path() / "type") == "0") continue;  // a socket on the mainboard that no chip answers from
    SerialPort port;
    port.device = "/dev/" + terminal.path().filename().string();
    port.lasting = lastingName(port.device);
    if (const fs::path usb = usbDevice(hardware); !usb.empty()) {
      port.product = lineOf(usb / "product");
      port.maker = lineOf(usb / "manufacturer");
      port.serialNumber = lineOf(usb / "serial");
      port.usb = true;
    }
    ports.push_back(std::move(port));
  }
  std::sort(ports.begin(), ports.end(),
            [](const SerialPort& a, const SerialPort& b) { return a.usb != b.usb ? a.usb : a.device < b.device; });
  return ports;
}

}  // namespace breakaway
