// What libraries throw, as the errors that end a command.
#pragma once

#include <exception>

#include "base/result.h"

namespace breakaway::cli {

/// The fact in an exception, without a place: there is not enough memory, or the library's own words.
Error thrown(const std::exception& exception);

}  // namespace breakaway::cli
