#include <asm/ioctls.h>
#include <asm/termbits.h>
#include <sys/ioctl.h>

#include <cstdlib>

#include "firmware_link/transport/serial_line.h"

// Apart from the rest, because the kernel's own names, which alone know any baud rate, clash with <termios.h>.

namespace breakaway {

Result<void> setLine(int descriptor, unsigned baud, const std::string& place) {
  termios2 line{};
  if (::ioctl(descriptor, TCGETS2, &line) != 0) return Error{place, message("doesn't tell its settings")};
  line.c_iflag = 0;
  line.c_oflag = 0;
  line.c_lflag = 0;
  line.c_cflag = CS8 | CREAD | CLOCAL | BOTHER | (BOTHER << IBSHIFT);
  line.c_cc[VMIN] = 1;  // so that a read of nothing means that the other end is gone
  line.c_cc[VTIME] = 0;
  line.c_ispeed = line.c_ospeed = baud;
  if (::ioctl(descriptor, TCSETS2, &line) != 0 || ::ioctl(descriptor, TCGETS2, &line) != 0)
    return Error{place, message("does not take {} baud", baud)};
  const long apart = std::labs(static_cast<long>(line.c_ospeed) - static_cast<long>(baud));
  if (apart * 50 > static_cast<long>(baud)) {  // 2 %: as much as 8N1 bears
    return Error{place, message("does not take {} baud, it would run at {}; expected a rate that the port can do", baud,
                                line.c_ospeed)};
  }
  ::ioctl(descriptor, TCFLSH, TCIFLUSH);  // what came for an earlier program
  return {};
}

}  // namespace breakaway
