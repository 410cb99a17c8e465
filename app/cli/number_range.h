// Which numbers an option takes.
#pragma once

#include <CLI/CLI.hpp>

namespace breakaway::cli {

/// A number from `low` to `high`. CLI::Range takes "nan" for one.
CLI::Validator numberIn(double low, double high);

}  // namespace breakaway::cli
