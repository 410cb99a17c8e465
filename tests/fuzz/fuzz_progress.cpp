#include <algorithm>
#include <array>
#include <filesystem>

#include "base/atomic_file.h"
#include "commission/commission_progress.h"
#include "fuzz/fuzzed.h"

using namespace breakaway;
using namespace breakaway::test;

/// The files of an interrupted job, parted by lines of "%": state, breakaways, the first run.
static const Fuzzed progress("progress", [](std::string_view bytes) {
  const std::string folder = std::filesystem::path(fileWith("", "progress.mark")).parent_path().string() + "/job";
  require(makeFolder(folder + "/progress").ok(), "the job's folder can be made");
  for (const char* name : {"state.json", "breakaways.json", "run-01.json"}) {
    const size_t end = std::min(bytes.find("\n%\n"), bytes.size());
    require(writeFile(folder + "/progress/" + name, bytes.substr(0, end)).ok(), "a file of the job can be written");
    bytes.remove_prefix(std::min(end + 3, bytes.size()));
  }
  const auto read = readProgress(folder);
  if (!read) return requireOneLine(read.error().message());
  for (const BreakawayEvent& event : read->breakaways) require(event.bin < read->sweeps.bins, "an event has its bin");
});
