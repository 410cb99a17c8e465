// Opens any board by its URI: a simulated one, or what answers on a port.
#pragma once

#include <memory>
#include <string>

#include "base/result.h"
#include "experiment/drive.h"

namespace breakaway {

struct BoardRequest {
  std::string uri;
  unsigned seed = 1;  ///< of a simulated board's noise
};

/// `simulated…` as openDrive() takes it; else `serial:PORT[@BAUD]` or `tcp:HOST:PORT`. The motor is off. Errors are one
/// line.
Result<std::unique_ptr<Drive>> openBoard(const BoardRequest& request);

}  // namespace breakaway
