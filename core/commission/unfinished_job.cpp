#include "commission/unfinished_job.h"

#include <fmt/chrono.h>
#include <fmt/core.h>
#include <algorithm>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "base/uuid.h"
#include "commission/commission_progress.h"

namespace breakaway {

namespace {

namespace fs = std::filesystem;

std::string lockOf(const std::string& folder) {
  return folder + "/held";
}

/// Whether this is a run that was under way and has gone on.
bool grown(const VelocityRun& was, const VelocityRun& is) {
  return was.brokenOff && was.isAt(is.target_rad_per_s) && was.duration_s <= is.duration_s;
}
bool grown(const TravelRun& was, const TravelRun& is) {
  return was.brokenOff && was.isAt(is.target_m_per_s) && was.duration_s <= is.duration_s;
}

/// Runs don't change, but for the one under way, so what is written of them stays; anything else is another job's.
bool goesOn(const Commission& before, const Commission& now) {
  const auto begins = [](const auto& was, const auto& is) {
    return was.size() <= is.size() && std::equal(was.begin(), was.end(), is.begin(), [](const auto& a, const auto& b) {
             return (a.duration_s == b.duration_s && a.middle_s == b.middle_s && a.zero_A == b.zero_A) || grown(a, b);
           });
  };
  return mayBeSame(before.identity, now.identity) && before.sweeps == now.sweeps && begins(before.runs, now.runs) &&
         begins(before.strokes, now.strokes) && before.breakaways.size() <= now.breakaways.size();
}

double secondsSince1970(const fs::file_time_type& time) {
  const auto system = std::chrono::file_clock::to_sys(time);
  return std::chrono::duration<double>(system.time_since_epoch()).count();
}

struct Candidate {
  std::string folder;
  fs::file_time_type written;
};

/// The newest first.
std::vector<Candidate> candidatesIn(const std::string& place) {
  std::vector<Candidate> all;
  std::error_code code;
  for (const auto& one : fs::directory_iterator(place, code)) {
    const auto written = fs::last_write_time(one.path() / "progress" / "state.json", code);
    if (!code) all.push_back({one.path().string(), written});
  }
  std::sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) { return a.written > b.written; });
  return all;
}

}  // namespace

bool isUnfinished(const Commission& known) {
  return !known.knows(Known::map) && !(known.runs.empty() && known.strokes.empty() && known.breakaways.empty());
}

std::vector<UnfinishedEntry> unfinishedIn(const std::string& place) {
  std::vector<UnfinishedEntry> all;
  for (const Candidate& one : candidatesIn(place)) {
    const OpenFile lock(lockOf(one.folder), OpenFile::Purpose::reading);
    const auto at = static_cast<std::time_t>(secondsSince1970(one.written));
    all.push_back({one.folder, fmt::format("{:%FT%TZ}", fmt::gmtime(at)), lock.good() && lock.isLocked(),
                   readProgress(one.folder)});
  }
  return all;
}

size_t speedsBrokenOff(const Commission& known) {
  const auto broken = [](const auto& run) { return run.brokenOff; };
  return static_cast<size_t>(std::count_if(known.runs.begin(), known.runs.end(), broken) +
                             std::count_if(known.strokes.begin(), known.strokes.end(), broken));
}

Message howFar(const Commission& known) {
  const size_t speeds = known.runs.size() + known.strokes.size();
  const size_t broken = speedsBrokenOff(known);
  const Message of = broken > 0 ? message(", {} of them broken off,", broken) : Message();
  return message("{}{} and {} of {} breakaways", speeds == 1 ? message("1 speed") : message("{} speeds", speeds), of,
                 known.breakaways.size(), 2 * known.sweeps.bins * known.sweeps.turns);
}

std::string unfinishedPlace(const std::string& projectFolder) {
  return projectFolder + "/unfinished";
}

UnfinishedJob::UnfinishedJob(std::string place) : place_(std::move(place)) {
}

std::optional<UnfinishedJob> UnfinishedJob::find(const std::string& place, const Identity& board) {
  for (const Candidate& one : candidatesIn(place)) {
    auto held = std::make_unique<OpenFile>(lockOf(one.folder), OpenFile::Purpose::mending);
    if (!held->good() || held->lock() != 0) continue;
    auto known = readProgress(one.folder);
    if (!known || !mayBeSame(known->identity, board)) continue;
    UnfinishedJob job(place);
    job.folder_ = one.folder;
    job.held_ = std::move(held);
    job.known_ = std::move(*known);
    job.since_s_ = secondsSince1970(one.written);
    return job;
  }
  return std::nullopt;
}

/// A folder of its own, held.
Result<void> UnfinishedJob::begin() {
  folder_ = place_ + "/" + freshUuid();
  if (auto made = makeFolder(folder_); !made) return made;
  held_ = std::make_unique<OpenFile>(lockOf(folder_), OpenFile::Purpose::making);
  if (!held_->good()) return Error{folder_, message("can't be written into")};
  held_->lock();
  return {};
}

Result<void> UnfinishedJob::keep(const Commission& known) {
  std::string before;
  std::unique_ptr<OpenFile> heldBefore;
  if (folder_.empty() || !goesOn(known_, known)) {
    before = folder_;
    heldBefore = std::move(held_);
    if (auto begun = begin(); !begun) return begun;
  }
  if (auto written = writeProgress(known, folder_); !written) return written;
  known_ = known;
  std::error_code code;
  if (!before.empty()) fs::remove_all(before, code);
  return {};
}

void UnfinishedJob::remove() {
  std::error_code code;
  if (!folder_.empty()) fs::remove_all(folder_, code);
  folder_.clear();
  held_.reset();
  known_ = {};
}

}  // namespace breakaway
