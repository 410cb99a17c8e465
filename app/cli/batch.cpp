// Many diagnoses from one list, resumable and in shards (resources/help/commands.md).
#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/line_log.h"
#include "base/made.h"
#include "base/shard.h"
#include "cli/batch_entries.h"
#include "cli/batch_slurm.h"
#include "cli/command.h"
#include "cli/inputs.h"
#include "cli/into_project.h"
#include "motor/batch_list.h"

namespace breakaway::cli {

namespace {

using Json = nlohmann::ordered_json;

struct BatchLine {
  std::string manifest, out, project;
  std::string shard = "1/1";
  size_t jobs = 1;
  std::string reports, slurm;
  size_t tasks = 0;
};

std::vector<std::string> inputsOf(const BatchLine& line, const std::vector<BatchEntry>& entries) {
  std::vector<std::string> inputs{line.manifest};
  for (const BatchEntry& entry : entries) {
    inputs.push_back(entry.bench);
    inputs.insert(inputs.end(), entry.recordings.begin(), entry.recordings.end());
    inputs.insert(inputs.end(), entry.heldout.begin(), entry.heldout.end());
  }
  return inputs;
}

/// Puts every diagnosis of the results that the project lacks into it, those of a killed batch, too: a run each.
Result<size_t> putResults(Project& project, const std::string& out, const std::vector<BatchEntry>& entries) {
  const auto lines = readWholeLines(out);
  if (!lines) return lines.error();
  size_t put = 0;
  for (const std::string& line : *lines) {
    const Json result = Json::parse(line, nullptr, false);
    if (!result.is_object() || !result.contains("diagnosis") || !result.contains("id")) continue;
    const std::string text = asText(result["diagnosis"]) + "\n";
    const auto there = project.index().holds(sha256Of(text));
    if (!there) return there.error();
    if (*there) continue;
    const auto write = [&text](const std::string& folder) { return writeFile(folder + "/diagnosis.json", text); };
    const Json& id = result["id"];
    const auto entry =
        std::find_if(entries.begin(), entries.end(), [&](const BatchEntry& one) { return one.id == asLine(id); });
    const auto run = project.add({.write = write,
                                  .name = id.is_string() ? id.get<std::string>() : asLine(id),
                                  .motor = entry == entries.end() ? std::string() : motorOf(entry->bench)});
    if (!run) return run.error();
    ++put;
  }
  return put;
}

/// The entries of the line's shard.
Result<std::vector<const BatchEntry*>> heldBy(const BatchLine& line, const std::vector<BatchEntry>& entries) {
  const auto shard = parseShard(line.shard);
  if (!shard) return shard.error();
  std::vector<const BatchEntry*> held;
  for (size_t k = 0; k < entries.size(); ++k) {
    if (shard->holds(k)) held.push_back(&entries[k]);
  }
  return held;
}

/// The results of a batch with and without Slurm.
std::vector<std::string> allResultsOf(const SlurmJob& job) {
  std::vector<std::string> files{job.out};
  for (size_t task = 1; task <= tasksOf(job); ++task) files.push_back(resultsOf(job, std::to_string(task)));
  return files;
}

Result<Answer> writeSlurm(const BatchLine& line, const std::vector<BatchEntry>& entries) {
  if (line.manifest == "-" || line.out == "-" || line.shard != "1/1")
    return Error{"--slurm", "expected a manifest and results that are files, and no --shard: each task has its own"};
  const SlurmJob job{line.manifest, line.out, line.reports, entries.size(), line.tasks, line.jobs};
  if (auto good = checkOutput(line.slurm, inputsOf(line, entries)); !good) return good.error();
  if (!checkOutput(line.slurm, allResultsOf(job)))
    return Error{line.slurm, "holds results, expected another file for the script"};
  if (auto written = writeFile(line.slurm, slurmScript(job)); !written) return written.error();
  const size_t tasks = tasksOf(job);
  const Json json{{"out", line.slurm}, {"entries", entries.size()}, {"tasks", tasks}, {"results", resultsOf(job, "*")}};
  return Answer{"Submit it: " + asCommand({"sbatch", line.slurm}) + "\nResults: " + resultsOf(job, "*") + "\n" +
                    line.slurm + ": " + std::to_string(entries.size()) + " entries in " + std::to_string(tasks) +
                    " tasks\n",
                asText(json)};
}

/// What is said of earlier results; nothing where there is nothing to say.
std::string inWords(const EarlierResults& earlier, const std::string& out) {
  std::string words;
  if (earlier.stale > 0)
    words += out + ": " + std::to_string(earlier.stale) + " results done again, their inputs have changed\n";
  if (earlier.unchecked > 0)
    words += out + ": " + std::to_string(earlier.unchecked) + " results kept whose inputs can't be read any more\n";
  return words;
}

Result<Answer> runBatch(const BatchLine& line) {
  if (!line.project.empty() && line.out == "-")
    return Error{"--project", "takes what stands in a file of results, expected --out with a file"};
  if (!line.project.empty() && !line.slurm.empty())
    return Error{"--project", "has one writer, expected it without --slurm, once its results are there"};
  auto project = openAskedProject(line.project);
  if (!project) return project.error();
  const auto text = readFile(line.manifest);
  if (!text) return text.error();
  const auto entries = readBatchList(*text, line.manifest);
  if (!entries) return entries.error();
  const auto held = heldBy(line, *entries);
  if (!held) return held.error();
  if (!line.slurm.empty()) return writeSlurm(line, *entries);
  if (auto good = checkOutput(line.out, inputsOf(line, *entries)); !good) return good.error();
  auto log = OwnLineLog::open(line.out);
  if (!log) return log.error();
  const auto lines = log->lines();
  if (!lines) return lines.error();
  const auto earlier = checkEarlier(*lines, line.out, *held);
  if (!earlier) return earlier.error();
  if (earlier->stale > 0) {
    if (auto kept = log->replace(earlier->kept); !kept) return kept.error();
  }
  const size_t todo = earlier->todo.size();
  if (auto done = doEntries({earlier->todo, line.out, line.reports, line.jobs}, *log); !done) return done.error();
  Json json{{"out", line.out},
            {"entries", held->size()},
            {"done_now", todo},
            {"done_before", held->size() - todo},
            {"done_again", earlier->stale},
            {"inputs_gone", earlier->unchecked}};
  std::string words = inWords(*earlier, line.out) + line.out + ": " + std::to_string(held->size()) + " entries, " +
                      std::to_string(todo) + " done now\n";
  if (*project) {
    const auto put = putResults(**project, line.out, *entries);
    if (!put) return put.error();
    json["project"] = {{"folder", line.project}, {"put_in", *put}};
    words += line.project + ": " + std::to_string(*put) + " diagnoses put in\n";
  }
  return Answer{words, asText(json)};
}

}  // namespace

void addBatch(CLI::App& app, Job& chosen) {
  auto line = std::make_shared<BatchLine>();
  auto* command = app.add_subcommand(
      "batch", "Diagnose every entry of a list, one line of JSON each; finished entries are not done again");
  command
      ->add_option("manifest", line->manifest,
                   "one JSON object per line: {\"id\", \"bench\", \"recordings\": [...], \"heldout\": [...]}; heldout "
                   "may be missing; paths are relative to this file's folder; further fields go into the result")
      ->required();
  command
      ->add_option("--out", line->out,
                   "file that results are appended to, one per line: {\"id\", \"diagnosis\"} or {\"id\", \"error\"}")
      ->required();
  command->add_option("--shard", line->shard, "I/N: only every N-th entry, beginning with the I-th");
  addProjectOption(*command, line->project);
  command
      ->add_option(
          "--jobs", line->jobs,
          "entries that are done at the same time, each on a core of its own; the last ones have the cores of all")
      ->capture_default_str()
      ->check(CLI::Range(1, 256));
  command->add_option("--reports", line->reports,
                      "folder for a report of each entry, with models and figures, as diagnose writes it");
  command->add_option(
      "--slurm", line->slurm,
      "does nothing but write a script for sbatch: an array job, each task a shard with results of its own");
  command->add_option("--tasks", line->tasks, "tasks of --slurm; one for 20 entries, at most 1000")
      ->check(CLI::Range(1, 100000))
      ->needs("--slurm");
  command->footer(
      "Examples:\n"
      "  breakaway batch list.jsonl --out results.jsonl --jobs 4\n"
      "  breakaway batch list.jsonl --out results.jsonl --shard 2/3\n"
      "  breakaway batch list.jsonl --out results.jsonl --reports reports\n"
      "  breakaway batch list.jsonl --out results.jsonl --slurm fleet.sh --tasks 50\n"
      "  find . -name '*.csv' | my-list | breakaway batch - --out results.jsonl");
  command->callback([line, &chosen] { chosen = [line] { return runBatch(*line); }; });
}

}  // namespace breakaway::cli
