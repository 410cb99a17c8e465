// The serial ports of this machine, by the names of what is plugged in.
#pragma once

#include <string>
#include <vector>

namespace breakaway {

struct SerialPort {
  std::string device;   ///< "/dev/ttyACM0"
  std::string lasting;  ///< a name that stays when it is plugged in again, below /dev/serial/by-id; else the device
  std::string product;  ///< what the device says it is; empty when it says nothing
  std::string maker;
  std::string serialNumber;
  bool usb = false;

  /// Product and device, for a list: "ChibiOS/RT Virtual COM Port (ttyACM0)".
  std::string words() const;
};

/// Those on USB first, then by device, as the kernel's folder tells.
std::vector<SerialPort> serialPorts(const std::string& kernel = "/sys");

}  // namespace breakaway
