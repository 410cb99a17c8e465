// Opens any board by its URI: a simulated one, or whatever answers on a port.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "base/result.h"
#include "experiment/drive.h"

namespace breakaway {

struct BoardRequest {
  std::string uri;
  unsigned seed = 1;  ///< of a simulated board's noise
  // What a board may not know of its motor. Options behind the address win.
  std::optional<double> polePairs{};
  std::optional<double> countsPerRev{};
  std::optional<double> currentLimit_A{};
};

/// `simulated…` as openDrive() takes it; else `[vesc:]serial:PORT[@BAUD]` or `[vesc:]tcp:HOST:PORT`, with options
/// behind it: `?pole_pairs=N&counts_per_rev=N&current_limit_A=A`. What answers is found by asking; `vesc:` asks for
/// nothing else. Takes up to about four seconds. The motor is released, whatever it did before. Errors are one line.
Result<std::unique_ptr<Drive>> openBoard(const BoardRequest& request);

}  // namespace breakaway
