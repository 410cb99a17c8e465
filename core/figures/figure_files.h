// The figures as files: pictures, numbers, and an index of both.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "figures/bench_figure.h"

namespace breakaway {

/// Writes NAME.svg, NAME.png and NAME.csv of each figure into `folder`, figures.json (`breakaway.figures/1`: title,
/// what it says, key numbers, file names), and index.html to read them in. Each file appears whole or not at all.
/// Errors: a figure whose columns differ in length or hold what isn't finite, and the files'.
Result<void> writeFigures(const std::vector<BenchFigure>& figures, const std::string& folder);

}  // namespace breakaway
