#include "bench/project_kills.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <thread>

#include "base/atomic_file.h"
#include "project/project.h"
#include "recording/sample_recording.h"
#include "session/recorder.h"
#include "support/small_disk.h"

namespace breakaway::test {

namespace {

using namespace std::chrono_literals;

constexpr double rate_Hz = 10000.0;

/// One clock for all processes.
double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Does `work` in a process of its own and kills it after `after`; when that was.
double killed(const std::function<void()>& work, std::chrono::milliseconds after) {
  const pid_t child = ::fork();
  if (child == 0) {
    work();
    ::_exit(1);
  }
  std::this_thread::sleep_for(after);
  const double at_s = now_s();
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  return at_s;
}

[[noreturn]] void addForEver(const std::string& folder) {
  auto project = Project::open(folder, Project::Missing::isMade);
  if (!project) ::_exit(1);
  for (;;) {
    NewRun run;
    run.write = [](const std::string& stage) -> Result<void> {
      for (const char* name : {"/a.txt", "/b.txt", "/c.txt"})
        if (auto written = writeFile(stage + name, std::string(20000, 'x')); !written) return written;
      return {};
    };
    if (!project->add(run)) ::_exit(1);
  }
}

[[noreturn]] void recordForEver(const std::string& folder) {
  auto project = Project::open(folder, Project::Missing::isMade);
  if (!project) ::_exit(1);
  std::optional<BlockWriter> blocks;
  if (!project->beginRecording({}, {sampleColumns(Axis::rotary), {}}, blocks)) ::_exit(1);
  Recorder recorder(std::move(*blocks), {});
  for (double time_s = now_s();;) {
    std::this_thread::sleep_for(5ms);
    std::vector<Sample> samples;
    for (const double until_s = now_s(); time_s < until_s; time_s += 1.0 / rate_Hz) {
      samples.emplace_back();
      samples.back().time_s = time_s;
    }
    recorder.append(samples, 0);
  }
}

constexpr std::uint64_t ballast_bytes = 64U << 10U;  // what somebody deletes when the disk is full
constexpr std::uint64_t smallestDisk_bytes = 160U << 10U, largerBy_bytes = 60U << 10U;

/// Records until the disk ends that; the time of the last sample that was handed over, or nothing where none could.
std::optional<double> recordUntilFull(const std::string& folder, ProjectKills& kills) {
  const auto fail = [&](const std::string& why) {
    kills.faults.push_back(why);
    return std::nullopt;
  };
  if (!writeFile(folder + "/ballast", std::string(ballast_bytes, 'x'))) return fail("no ballast");
  auto project = Project::open(folder + "/p", Project::Missing::isMade);
  if (!project) return fail(project.error().message());
  std::optional<BlockWriter> blocks;
  const auto run = project->beginRecording({}, {sampleColumns(Axis::rotary), {}}, blocks);
  if (!run) return fail(run.error().message());
  std::atomic<bool> ended{false};
  RecorderOptions options;
  options.reserve_bytes = 0;
  Recorder recorder(std::move(*blocks), {[&](const RecordingEnd&) { ended = true; }, {}}, options);
  double time_s = now_s();
  const double begun_s = time_s;
  while (!ended && now_s() < begun_s + 20.0) {
    std::this_thread::sleep_for(5ms);
    std::vector<Sample> samples;
    for (const double until_s = now_s(); time_s < until_s; time_s += 1.0 / rate_Hz) {
      samples.emplace_back();
      samples.back().time_s = time_s;
    }
    recorder.append(samples, 0);
  }
  recorder.finish("the disk never got full");
  recorder.wait();
  if (recorder.end().why.find("No space left") == std::string::npos) return fail(recorder.end().why);
  static_cast<void>(project->endRecording(*run, recorder.end().why));  // may not be possible any more
  return time_s;
}

bool saysOf(const Project& project, const std::string& run) {
  return std::any_of(project.said().begin(), project.said().end(),
                     [&](const Message& line) { return line.find(run) != std::string::npos; });
}

}  // namespace

std::optional<Project> lookedAt(const std::string& folder, ProjectKills& kills) {
  ++kills.kills;
  auto project = Project::open(folder, Project::Missing::isMade);
  if (!project) {
    kills.faults.push_back(project.error().message());
    return std::nullopt;
  }
  ++kills.opened;
  const auto faults = project->check();
  bool whole = faults.ok();
  if (!faults) kills.faults.push_back(faults.error().message());
  for (const std::string& line : faults ? faults->lines : std::vector<std::string>()) {
    if (line.find("ended early") != std::string::npos) continue;
    whole = false;
    kills.faults.push_back(line);
  }
  kills.whole += whole ? 1 : 0;
  return std::move(*project);
}

void countCut(const Project& project, const ProjectRun& run, double at_s, ProjectKills& kills) {
  ++kills.cut;
  if (run.state == RunState::cut && saysOf(project, run.at)) ++kills.said;
  const auto survey = surveyBlocks(project.pathOf(run, recordingFile));
  if (survey && survey->rows > 0) kills.worst_s = std::max(kills.worst_s, at_s - survey->last_s);
}

ProjectKills killsWhileAdding(const std::string& folder, int kills, std::mt19937& random) {
  ProjectKills all;
  std::uniform_int_distribution<int> moment_ms(1, 150);
  for (int k = 0; k < kills; ++k) {
    killed([&folder] { addForEver(folder); }, std::chrono::milliseconds(moment_ms(random)));
    lookedAt(folder, all);
  }
  return all;
}

ProjectKills killsWhileRecording(const std::string& folder, int kills, std::mt19937& random) {
  ProjectKills all;
  std::uniform_int_distribution<int> moment_ms(1, 1500);
  std::set<std::string> known;
  for (int k = 0; k < kills; ++k) {
    const double at_s = killed([&folder] { recordForEver(folder); }, std::chrono::milliseconds(moment_ms(random)));
    const auto project = lookedAt(folder, all);
    const auto runs = project ? project->index().list({.kind = "recording"}) : Result<std::vector<ProjectRun>>(Error{});
    for (const ProjectRun& run : runs ? *runs : std::vector<ProjectRun>()) {
      if (known.insert(run.id).second) countCut(*project, run, at_s, all);
    }
  }
  return all;
}

ProjectKills fullDisksWhileRecording(const std::string& folder, int disks) {
  ProjectKills all;
  for (int k = 0; k < disks; ++k) {
    const std::string place = folder + "/disk-" + std::to_string(k);
    static_cast<void>(makeFolder(place));
    const SmallDisk disk(place, smallestDisk_bytes + ballast_bytes + static_cast<size_t>(k) * largerBy_bytes);
    const auto last_s = disk.mounted() ? recordUntilFull(place, all) : std::nullopt;
    // While it is full, and when there is room again.
    const auto full = Project::open(place + "/p");
    if (!full || full->index().list({})->size() != 1) all.faults.push_back(place + ": not listed while full");
    static_cast<void>(std::filesystem::remove(place + "/ballast"));
    const auto project = lookedAt(place + "/p", all);
    const auto run = project ? project->index().find("last") : Result<ProjectRun>(Error{});
    if (!last_s || !run) continue;
    ++all.cut;
    if (run->state == RunState::cut && run->verdict.find("ended by: ") != std::string::npos) ++all.said;
    const auto survey = surveyBlocks(project->pathOf(*run, recordingFile));
    if (!survey || survey->rows == 0) all.faults.push_back(place + ": holds no sample");
    if (survey) all.worst_s = std::max(all.worst_s, *last_s - survey->last_s);
  }
  return all;
}

}  // namespace breakaway::test
