#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <unistd.h>

#include "base/atomic_file.h"
#include "fuzz/fuzzed.h"

namespace breakaway::test {

std::map<std::string, FuzzedReader>& fuzzedReaders() {
  static std::map<std::string, FuzzedReader> readers;
  return readers;
}

void require(bool holds, const char* fact) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", fact);
  std::abort();
}

void requireOneLine(const std::string& message) {
  require(!message.empty(), "an error says something");
  require(message.find('\n') == std::string::npos, "an error is one line");
}

std::string fileWith(std::string_view bytes, const std::string& name) {
  static const std::string folder =
      (std::filesystem::temp_directory_path() / ("breakaway_fuzz_" + std::to_string(::getpid()))).string();
  require(makeFolder(folder).ok(), "the folder for inputs can be made");
  require(writeFile(folder + "/" + name, bytes).ok(), "the input can be written");
  return folder + "/" + name;
}

}  // namespace breakaway::test
