#include "cli/batch_slurm.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "base/made.h"

namespace breakaway::cli {

namespace {

namespace fs = std::filesystem;

/// As a shell takes it, from whatever folder.
std::string fromAnywhere(const std::string& path) {
  std::error_code code;
  return asCommand({fs::absolute(path, code).lexically_normal().string()});
}

/// The program that runs now; a node has it in the same place, or BREAKAWAY says where.
std::string ownProgram() {
  std::error_code code;
  const fs::path self = fs::read_symlink("/proc/self/exe", code);
  return asCommand({code ? "breakaway" : self.string()});
}

}  // namespace

size_t tasksOf(const SlurmJob& job) {
  const size_t wanted = job.tasks > 0 ? job.tasks : (job.entries + entriesPerTask - 1) / entriesPerTask;
  return std::clamp<size_t>(wanted, 1, std::max<size_t>(1, std::min(job.entries, mostTasks)));
}

std::string resultsOf(const SlurmJob& job, const std::string& task) {
  const bool named = job.out.ends_with(".jsonl");
  return (named ? job.out.substr(0, job.out.size() - 6) : job.out) + "." + task + "-of-" +
         std::to_string(tasksOf(job)) + ".jsonl";
}

std::string slurmScript(const SlurmJob& job) {
  const size_t tasks = tasksOf(job);
  const std::string results = resultsOf(job, "TASK");
  std::string script = "#!/bin/sh\n#SBATCH --job-name=breakaway\n";
  script += fmt::format("#SBATCH --array=1-{}\n#SBATCH --cpus-per-task={}\n", tasks, job.jobs);
  script += "#SBATCH --requeue\n#SBATCH --open-mode=append\n";
  script += fmt::format(
      "# {} entries in {} tasks. A task that is killed, or whose node fails, is queued again and goes on where it was; "
      "the\n# whole script may be submitted again, too: what is done is not done again. Options for time, memory and "
      "partition can\n# be given to sbatch. On nodes that have the program elsewhere, BREAKAWAY says where.\n",
      job.entries, tasks);
  script += "set -eu\ntask=${SLURM_ARRAY_TASK_ID:?expected sbatch to say which task this is}\n";
  script += "program=" + ownProgram() + "\n";
  const size_t at = results.rfind("TASK");
  script += "results=" + fromAnywhere(results.substr(0, at)) + "\"$task\"" + asCommand({results.substr(at + 4)}) + "\n";
  script += "exec \"${BREAKAWAY:-$program}\" batch " + fromAnywhere(job.manifest) +
            fmt::format(" --out \"$results\" --shard \"$task/{}\" --jobs {}", tasks, job.jobs);
  if (!job.reports.empty()) script += " --reports " + fromAnywhere(job.reports);
  return script + "\n";
}

}  // namespace breakaway::cli
