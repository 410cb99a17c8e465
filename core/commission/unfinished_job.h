// What a job has measured, on disk until it is complete: what a killed program leaves, and goes on from.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/open_file.h"
#include "base/result.h"
#include "commission/known.h"
#include "experiment/identity.h"

namespace breakaway {

/// One folder below `place`, held by this process: nobody else's is touched.
class UnfinishedJob {
 public:
  explicit UnfinishedJob(std::string place);
  /// Of a board that may be this one, the newest that no process holds. Nothing: there is none that can be read.
  static std::optional<UnfinishedJob> find(const std::string& place, const Identity& board);

  /// What was written last, or found.
  const Commission& known() const { return known_; }
  /// When that was found on disk: s since 1970, UTC.
  double since_s() const { return since_s_; }
  /// Writes what is known. Where that isn't what was written before and more, into another folder; the one before goes
  /// when that is whole.
  Result<void> keep(const Commission& known);
  /// It is complete, or not wanted any more.
  void remove();

 private:
  Result<void> begin();

  std::string place_, folder_;
  std::unique_ptr<OpenFile> held_;
  Commission known_;
  double since_s_ = 0.0;
};

/// What one of them has, for people.
struct UnfinishedEntry {
  std::string folder;
  std::string at;     ///< when it was written last: UTC, ISO 8601, to the second
  bool held = false;  ///< by a program that is at work on it
  Result<Commission> known = Error{};
};

/// Of speeds that are counted in a job, those that were broken off or are under way.
size_t speedsBrokenOff(const Commission& known);

/// All below `place`, the newest first. Nothing is held meanwhile, nor changed.
std::vector<UnfinishedEntry> unfinishedIn(const std::string& place);
/// "3 speeds, 1 of them broken off, and 12 of 720 breakaways".
Message howFar(const Commission& known);

/// Where a project keeps them.
std::string unfinishedPlace(const std::string& projectFolder);

/// Whether sweeps have measured what is no map yet.
bool isUnfinished(const Commission& known);

}  // namespace breakaway
