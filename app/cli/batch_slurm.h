// A batch as an array job of Slurm.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace breakaway::cli {

struct SlurmJob {
  std::string manifest, out, reports;  ///< as given to batch
  size_t entries = 0;
  size_t tasks = 0;  ///< 0: a task for each entriesPerTask, at most as many as Slurm's usual limit allows
  size_t jobs = 1;   ///< of each task, a core each
};

inline constexpr size_t entriesPerTask = 20, mostTasks = 1000;

/// How many tasks it has.
size_t tasksOf(const SlurmJob& job);
/// The file of results of one task, "1" or a pattern for all.
std::string resultsOf(const SlurmJob& job, const std::string& task);
/// The script for sbatch: each task does one shard into results of its own, whatever it had done before it was killed.
std::string slurmScript(const SlurmJob& job);

}  // namespace breakaway::cli
