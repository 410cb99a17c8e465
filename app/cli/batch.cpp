// Many diagnoses from one list, resumable and in shards (resources/help/commands.md).
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <thread>

#include "base/atomic_file.h"
#include "base/json_text.h"
#include "base/line_log.h"
#include "base/made.h"
#include "base/shard.h"
#include "cli/command.h"
#include "cli/inputs.h"
#include "cli/thrown.h"
#include "diagnose/diagnosis.h"

namespace breakaway::cli {

namespace {

using Json = nlohmann::ordered_json;

struct BatchLine {
  std::string manifest, out;
  std::string shard = "1/1";
  size_t jobs = 1;
};

struct Entry {
  Json id;
  std::string bench;
  std::vector<std::string> recordings, heldout;
};

std::string textOf(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string lineOf(const std::string& path, size_t index) {
  return path + ", line " + std::to_string(index + 1);
}

/// The object in a line with its id, a text or a number.
Result<Json> parseLine(const std::string& text, const std::string& place) {
  if (auto fault = jsonFault(text, place)) return Error{place, fault->fact};
  Json json = Json::parse(text);
  if (!json.is_object()) return Error{place, "expected a JSON object"};
  if (!json.contains("id")) return Error{place, "has no field id"};
  if (!json["id"].is_string() && !json["id"].is_number())
    return Error{place + ", field id", "expected a text or a number"};
  return json;
}

/// Paths in a field that is a list of texts, relative ones from `folder`.
Result<std::vector<std::string>> pathsIn(const Json& json, const char* field, bool required, const std::string& place,
                                         const std::filesystem::path& folder) {
  std::vector<std::string> paths;
  if (!json.contains(field) && !required) return paths;
  const Json list = json.value(field, Json());
  bool good = list.is_array() && !(required && list.empty());
  for (const Json& one : list) {
    good = good && one.is_string();
    if (good) paths.push_back((folder / one.get<std::string>()).string());
  }
  if (!good) return Error{place + ", field " + field, "expected a list of file names"};
  return paths;
}

Result<std::vector<Entry>> readManifest(const std::string& path) {
  const auto text = readFile(path);
  if (!text) return text.error();
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::istringstream in(*text);
  std::vector<Entry> entries;
  std::set<std::string> ids;
  std::string line;
  for (size_t index = 0; std::getline(in, line); ++index) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const std::string place = lineOf(path, index);
    const auto json = parseLine(line, place);
    if (!json) return json.error();
    Entry entry;
    entry.id = (*json)["id"];
    if (!ids.insert(textOf(entry.id)).second) return Error{place, "has the id " + textOf(entry.id) + " once more"};
    if (!json->contains("bench") || !(*json)["bench"].is_string())
      return Error{place + ", field bench", "expected the name of a bench file"};
    entry.bench = (folder / (*json)["bench"].get<std::string>()).string();
    auto recordings = pathsIn(*json, "recordings", true, place, folder);
    if (!recordings) return recordings.error();
    auto heldout = pathsIn(*json, "heldout", false, place, folder);
    if (!heldout) return heldout.error();
    entry.recordings = std::move(*recordings);
    entry.heldout = std::move(*heldout);
    entries.push_back(std::move(entry));
  }
  return entries;
}

/// The ids that RESULTS answers already, with a diagnosis or an error.
Result<std::set<std::string>> finishedIds(const std::string& path) {
  const auto lines = readWholeLines(path);
  if (!lines) return lines.error();
  std::set<std::string> ids;
  for (size_t index = 0; index < lines->size(); ++index) {
    const auto json = parseLine((*lines)[index], lineOf(path, index));
    if (!json) return json.error();
    if (!json->contains("diagnosis") && !json->contains("error"))
      return Error{lineOf(path, index), "is no result: it has neither diagnosis nor error"};
    ids.insert(textOf((*json)["id"]));
  }
  return ids;
}

Result<Diagnosis> diagnoseEntry(const Entry& entry) {
  try {
    const auto in = readDiagnosisInputs(entry.bench, entry.recordings, entry.heldout);
    if (!in) return in.error();
    return diagnose(in->bench, in->recordings, in->heldout, {});
  } catch (const std::exception& exception) {
    return thrown(exception);
  }
}

/// The entry's line of RESULTS.
std::string resultLine(const Entry& entry) {
  const OwnInputs ownInputs;
  const auto diagnosis = diagnoseEntry(entry);
  const std::string result = diagnosis ? "\"diagnosis\":" + withMade(diagnosisJson(*diagnosis, true))
                                       : "\"error\":" + textOf(Json(diagnosis.error().message()));
  return "{\"id\":" + textOf(entry.id) + "," + result + "}";
}

/// Does `todo` with `jobs` threads, each entry's line appended when it is done. Error: of RESULTS, which ends it.
Result<void> doEntries(const std::vector<const Entry*>& todo, const std::string& out, size_t jobs) {
  std::mutex mutex;  // of what is below, and of RESULTS
  size_t next = 0, done = 0;
  Result<void> end;
  const auto work = [&] {
    for (;;) {
      const Entry* entry = nullptr;
      {
        const std::scoped_lock lock(mutex);
        if (next == todo.size() || !end) return;
        entry = todo[next++];
        if (progressIsWatched())
          std::fprintf(stderr, "\r\033[K%zu of %zu  %s", done + 1, todo.size(), textOf(entry->id).c_str());
      }
      const std::string line = resultLine(*entry);
      const std::scoped_lock lock(mutex);
      ++done;
      if (end) end = appendLine(out, line);
    }
  };
  {
    std::vector<std::jthread> further;
    for (size_t k = 1; k < std::min(jobs, todo.size()); ++k) further.emplace_back(work);
    work();
  }
  if (progressIsWatched()) std::fprintf(stderr, "\r\033[K");
  return end;
}

std::vector<std::string> inputsOf(const BatchLine& line, const std::vector<Entry>& entries) {
  std::vector<std::string> inputs{line.manifest};
  for (const Entry& entry : entries) {
    inputs.push_back(entry.bench);
    inputs.insert(inputs.end(), entry.recordings.begin(), entry.recordings.end());
    inputs.insert(inputs.end(), entry.heldout.begin(), entry.heldout.end());
  }
  return inputs;
}

Result<Answer> runBatch(const BatchLine& line) {
  const auto shard = parseShard(line.shard);
  if (!shard) return shard.error();
  const auto entries = readManifest(line.manifest);
  if (!entries) return entries.error();
  if (auto good = checkOutput(line.out, inputsOf(line, *entries)); !good) return good.error();
  const auto finished = finishedIds(line.out);
  if (!finished) return finished.error();
  std::vector<const Entry*> todo;
  size_t held = 0;
  for (size_t k = 0; k < entries->size(); ++k) {
    if (!shard->holds(k)) continue;
    ++held;
    if (!finished->contains(textOf((*entries)[k].id))) todo.push_back(&(*entries)[k]);
  }
  if (auto done = doEntries(todo, line.out, line.jobs); !done) return done.error();
  // A shard that holds no entry leaves its results, too: none.
  if (line.out != "-" && !std::ofstream(line.out, std::ios::app)) return Error{line.out, "cannot be written"};
  const Json json{{"out", line.out}, {"entries", held}, {"done_now", todo.size()}, {"done_before", held - todo.size()}};
  return Answer{line.out + ": " + std::to_string(held) + " entries, " + std::to_string(todo.size()) + " done now\n",
                asText(json)};
}

}  // namespace

void addBatch(CLI::App& app, Job& chosen) {
  auto line = std::make_shared<BatchLine>();
  auto* command = app.add_subcommand(
      "batch", "Diagnose every entry of a list, one line of JSON each; finished entries are not done again");
  command
      ->add_option("manifest", line->manifest,
                   "one JSON object per line: {\"id\", \"bench\", \"recordings\": [...], \"heldout\": [...]}; heldout "
                   "may be missing; paths are relative to this file's folder")
      ->required();
  command
      ->add_option("--out", line->out,
                   "file that results are appended to, one per line: {\"id\", \"diagnosis\"} or {\"id\", \"error\"}")
      ->required();
  command->add_option("--shard", line->shard, "I/N: only every N-th entry, beginning with the I-th");
  command->add_option("--jobs", line->jobs, "entries that are done at the same time, each on a core of its own")
      ->capture_default_str()
      ->check(CLI::Range(1, 256));
  command->footer(
      "Examples:\n"
      "  breakaway batch list.jsonl --out results.jsonl --jobs 4\n"
      "  breakaway batch list.jsonl --out results.jsonl --shard 2/3\n"
      "  find . -name '*.csv' | my-list | breakaway batch - --out results.jsonl");
  command->callback([line, &chosen] { chosen = [line] { return runBatch(*line); }; });
}

}  // namespace breakaway::cli
