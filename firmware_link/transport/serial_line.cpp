#include "firmware_link/transport/serial_line.h"

#include <fcntl.h>
#include <grp.h>
#include <pwd.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace breakaway {

namespace {

Error denied(const std::string& device, const std::string& place) {
  struct stat kind {};
  std::string groupName = "dialout", user = "your user";
  if (::stat(device.c_str(), &kind) == 0) {
    if (const group* owner = ::getgrgid(kind.st_gid); owner != nullptr) groupName = owner->gr_name;
  }
  if (const passwd* self = ::getpwuid(::geteuid()); self != nullptr) user = self->pw_name;
  return {place,
          message("may not be opened by {}; it belongs to the group {}: run \"sudo adduser {} {}\", then log out "
                  "and in again",
                  user, groupName, user, groupName)};
}

Error notOpened(const std::string& device, const std::string& place, int reason) {
  switch (reason) {
    case EACCES:
    case EPERM:
      return denied(device, place);
    case EBUSY:
      return {place, message("is in use by another program; close it, and ModemManager too if it runs")};
    case ENOENT:
    case ENODEV:
    case ENXIO:
      return {place, message("there is no such port")};
    default:
      return {place, message("cannot be opened: {}", std::strerror(reason))};
  }
}

}  // namespace

Result<Descriptor> openSerialLine(const std::string& device, unsigned baud) {
  const std::string place = "serial port " + device;
  Descriptor line(::open(device.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (!line.open()) return notOpened(device, place, errno);
  if (::isatty(line.number()) == 0) return Error{place, message("is no serial port")};
  // The lock keeps out a second one of us even where exclusive mode doesn't: for root.
  if (::flock(line.number(), LOCK_EX | LOCK_NB) != 0 || ::ioctl(line.number(), TIOCEXCL) != 0)
    return notOpened(device, place, EBUSY);
  if (auto set = setLine(line.number(), baud, place); !set) return set.error();
  return line;
}

}  // namespace breakaway
