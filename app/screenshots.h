// Every page in each of its main states as pictures, without a display: what the manual shows and what a designer
// judges.
#pragma once

#include <QString>

#include "base/result.h"

namespace breakaway {

/// Renders PAGE-STATE-light.png and PAGE-STATE-dark.png at 1366×768 into `folder`, on the simulated board at a fast
/// pace.
Result<void> takeScreenshots(const QString& folder);

}  // namespace breakaway
