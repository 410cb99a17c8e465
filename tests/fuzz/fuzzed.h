// The seam between a fuzzed reader and what feeds it: libFuzzer, or the replay of the corpus.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace breakaway::test {

/// Reads `bytes` and checks what must hold whatever they are; aborts when it doesn't.
using FuzzedReader = void (*)(std::string_view bytes);

/// All readers of this program by name.
std::map<std::string, FuzzedReader>& fuzzedReaders();

/// A static one of these adds a reader.
struct Fuzzed {
  Fuzzed(const char* name, FuzzedReader reader) { fuzzedReaders()[name] = reader; }
};

/// Aborts with the fact when it does not hold.
void require(bool holds, const char* fact);
/// An error must be one line that is not empty.
void requireOneLine(const std::string& message);
/// A file in a folder of this process's own, replaced on each call; returns its path.
std::string fileWith(std::string_view bytes, const std::string& name);

}  // namespace breakaway::test
