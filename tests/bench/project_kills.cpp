#include "bench/project_kills.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <set>
#include <thread>

#include "base/atomic_file.h"
#include "project/project.h"
#include "recording/sample_recording.h"
#include "session/recorder.h"

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

}  // namespace breakaway::test
