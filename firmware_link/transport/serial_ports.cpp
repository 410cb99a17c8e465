#include "firmware_link/transport/serial_ports.h"

#include <QSerialPortInfo>
#include <algorithm>
#include <filesystem>

namespace breakaway {

namespace {

namespace fs = std::filesystem;

/// The link below /dev/serial/by-id that leads to `device`; the device itself when there is none.
std::string lastingName(const std::string& device) {
  std::error_code code;
  for (const auto& link : fs::directory_iterator("/dev/serial/by-id", code)) {
    std::error_code broken;
    if (fs::canonical(link.path(), broken) == fs::path(device) && !broken) return link.path().string();
  }
  return device;
}

}  // namespace

std::string SerialPort::words() const {
  const std::string name = fs::path(device).filename().string();
  return product.empty() ? name : product + " (" + name + ")";
}

std::vector<SerialPort> serialPorts() {
  std::vector<SerialPort> ports;
  for (const QSerialPortInfo& one : QSerialPortInfo::availablePorts()) {
    SerialPort port;
    port.device = one.systemLocation().toStdString();
    port.lasting = lastingName(port.device);
    port.product = one.description().toStdString();
    port.maker = one.manufacturer().toStdString();
    port.serialNumber = one.serialNumber().toStdString();
    port.usb = one.hasVendorIdentifier();
    ports.push_back(std::move(port));
  }
  std::sort(ports.begin(), ports.end(),
            [](const SerialPort& a, const SerialPort& b) { return a.usb != b.usb ? a.usb : a.device < b.device; });
  return ports;
}

}  // namespace breakaway
