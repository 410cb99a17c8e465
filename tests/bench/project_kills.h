// What kills and full disks leave of a project: while runs are put in, and while a recording grows.
#pragma once

#include <optional>
#include <random>
#include <string>
#include <vector>

#include "project/project.h"

namespace breakaway::test {

struct ProjectKills {
  int kills = 0;
  int opened = 0;         ///< the project opens
  int whole = 0;          ///< and its check finds nothing but recordings that ended early
  int cut = 0, said = 0;  ///< recordings that were cut short, and of these said at the next start
  double worst_s = 0.0;   ///< from a recording's last row to the kill, by the same clock
  std::vector<std::string> faults;

  bool good() const { return opened == kills && whole == kills && said == cut && worst_s < 1.0; }
};

/// Opens the project and looks at every file; nothing where it can't be opened.
std::optional<Project> lookedAt(const std::string& folder, ProjectKills& kills);
/// Counts a recording that the kill at `at_s` has cut short, by the clock of its rows.
void countCut(const Project& project, const ProjectRun& run, double at_s, ProjectKills& kills);

/// Kills a process at random moments while it puts one run after the other into one project.
ProjectKills killsWhileAdding(const std::string& folder, int kills, std::mt19937& random);

/// The same while it records 10 kHz × 12 channels, a run each.
ProjectKills killsWhileRecording(const std::string& folder, int kills, std::mt19937& random);

/// Records the same on that many disks of growing size (support/small_disk.h) until they are full, and opens the
/// project on the full disk, and once more when there is room again.
ProjectKills fullDisksWhileRecording(const std::string& folder, int disks);

}  // namespace breakaway::test
