// Identifiers and times that a run, or what it leaves, is told apart by.
#pragma once

#include <string>

namespace breakaway {

/// A random UUID (RFC 4122, version 4).
std::string freshUuid();

/// Now: UTC, ISO 8601, to the second.
std::string utcNow();

}  // namespace breakaway
