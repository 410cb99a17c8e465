// Where the real recordings lie, when they are there; they are not part of this repository.
#pragma once

#include <QByteArray>
#include <filesystem>
#include <string>

namespace breakaway::test {

/// The folder of real recordings: BREAKAWAY_RECORDINGS, or ../shared/data beside the checkout; empty when there is
/// none.
inline std::string realRecordings() {
  std::string folder = qgetenv("BREAKAWAY_RECORDINGS").toStdString();
  if (folder.empty()) folder = qgetenv("BREAKAWAY_SOURCE_DIR").toStdString() + "/../shared/data";
  return std::filesystem::is_directory(folder) ? folder : std::string();
}

}  // namespace breakaway::test

/// Skips the test function by name when the real recordings are not there.
#define NEEDS_REAL_RECORDINGS() \
  if (breakaway::test::realRecordings().empty()) QSKIP("all real recordings are missing")
