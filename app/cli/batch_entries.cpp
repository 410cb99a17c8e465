#include "cli/batch_entries.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>

#include "base/made.h"
#include "base/output_folder.h"
#include "base/parallel.h"
#include "base/sha256.h"
#include "cli/inputs.h"
#include "cli/thrown.h"
#include "diagnose/diagnosis.h"
#include "report/diagnosis_report.h"

namespace breakaway::cli {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

/// The file's SHA-256; empty where it can't be read.
std::string hashOf(const std::string& path) {
  const auto hash = sha256OfFile(path);
  return hash ? *hash : std::string();
}

std::vector<std::string> hashesOf(const BatchEntry& entry, std::map<std::string, std::string>& known) {
  const std::vector<std::string> files = entry.files();
  std::vector<std::string> hashes;
  hashes.reserve(files.size());
  for (const std::string& path : files) {
    const auto it = known.find(path);
    hashes.push_back(it != known.end() ? it->second : known.emplace(path, hashOf(path)).first->second);
  }
  return hashes;
}

struct Diagnosed {
  DiagnosisInputs in;
  Diagnosis diagnosis;
};

Result<Diagnosed> diagnoseEntry(const BatchEntry& entry) {
  try {
    auto in = readDiagnosisInputs(entry.bench, entry.recordings, entry.heldout);
    if (!in) return in.error();
    auto diagnosis = diagnose(in->bench, in->recordings, in->heldout, {});
    if (!diagnosis) return diagnosis.error();
    return Diagnosed{std::move(*in), std::move(*diagnosis)};
  } catch (const std::exception& exception) {
    return thrown(exception);
  }
}

Result<void> writeReport(const Diagnosed& of, const BatchEntry& entry, const std::string& folder) {
  auto out = OutputFolder::open({folder,
                                 "diagnose",
                                 {"base_model.json", "model.json", "report.html", "figures", "diagnosis.json"},
                                 entry.files()});
  if (!out) return out.error();
  return out->fill([&](const std::string& stage) {
    return writeDiagnosisFolder(of.diagnosis, of.in.bench, of.in.recordings, of.in.heldout, stage);
  });
}

/// Where it comes from, with all files of the entry, so that it can be told whether one of them has changed.
std::string madeOfError(const BatchEntry& entry) {
  std::map<std::string, std::string> known;
  const std::vector<std::string> files = entry.files(), hashes = hashesOf(entry, known);
  Json made = Json::parse(madeJson());
  made["inputs"] = Json::array();
  for (size_t k = 0; k < files.size(); ++k)
    made["inputs"].push_back({{"path", files[k]}, {"sha256", hashes[k].empty() ? Json() : Json(hashes[k])}});
  return asLine(made);
}

/// The way from the folder of the results to a report.
std::string wayTo(const std::string& report, const std::string& out) {
  std::error_code code;
  const fs::path from = fs::absolute(out, code).lexically_normal().parent_path();
  return fs::absolute(report, code).lexically_normal().lexically_relative(from).string();
}

/// What the entry's line carries of the manifest; a report that is written is named in place of one that was there.
std::string furtherIn(const BatchEntry& entry, const BatchPlan& plan) {
  std::string text;
  for (const auto& [name, value] : entry.further) {
    if (name != "report" || plan.reports.empty()) text += "," + asLine(Json(name)) + ":" + value;
  }
  return text;
}

/// The entry's line of results, an error of the entry included. Error: its report can't be written.
Result<std::string> resultLine(const BatchEntry& entry, const BatchPlan& plan) {
  const OwnInputs ownInputs;
  const auto done = diagnoseEntry(entry);
  std::string line = "{\"id\":" + entry.id + furtherIn(entry, plan);
  if (!done)
    return line + ",\"error\":" + asLine(Json(done.error().message())) + ",\"made\":" + madeOfError(entry) + "}";
  if (!plan.reports.empty()) {
    const std::string folder = plan.reports + "/" + reportFolderOf(entry.id);
    if (auto written = writeReport(*done, entry, folder); !written) return written.error();
    line += ",\"report\":" + asLine(Json(wayTo(folder + "/report.html", plan.out)));
  }
  return line + ",\"diagnosis\":" + withMade(diagnosisJson(done->diagnosis, true)) + "}";
}

}  // namespace

Result<EarlierResults> checkEarlier(const std::vector<std::string>& lines, const std::string& path,
                                    const std::vector<const BatchEntry*>& entries) {
  const auto results = readBatchResults(lines, path);
  if (!results) return results.error();
  std::map<std::string, const BatchEntry*> byId;
  for (const BatchEntry* entry : entries) byId[entry->id] = entry;
  EarlierResults earlier;
  std::map<std::string, std::string> known;
  std::set<std::string> done;
  for (size_t k = 0; k < results->size(); ++k) {
    const BatchResult& result = (*results)[k];
    const auto entry = byId.find(result.id);
    const std::vector<std::string> today =
        entry == byId.end() ? std::vector<std::string>() : hashesOf(*entry->second, known);
    if (entry != byId.end() && result.isStale(today)) {
      ++earlier.stale;
      continue;
    }
    if (result.restsOnGone(today)) ++earlier.unchecked;
    done.insert(result.id);
    earlier.kept.push_back(lines[k]);
  }
  for (const BatchEntry* entry : entries) {
    if (!done.contains(entry->id)) earlier.todo.push_back(entry);
  }
  return earlier;
}

Result<void> doEntries(const BatchPlan& plan, const OwnLineLog& results) {
  std::mutex mutex;  // of what is below, and of the results
  size_t next = 0, done = 0;
  Result<void> end;
  const auto work = [&] {
    for (;;) {
      const BatchEntry* entry = nullptr;
      {
        const std::scoped_lock lock(mutex);
        if (next == plan.todo.size() || !end) return;
        entry = plan.todo[next++];
        if (progressIsWatched())
          std::fprintf(stderr, "\r\033[K%zu of %zu  %s", done + 1, plan.todo.size(), entry->id.c_str());
      }
      const auto line = resultLine(*entry, plan);
      const std::scoped_lock lock(mutex);
      ++done;
      if (end) end = line ? results.append(*line) : Result<void>(line.error());
    }
  };
  onThreads(plan.jobs, work);
  if (progressIsWatched()) std::fprintf(stderr, "\r\033[K");
  return end;
}

std::string reportFolderOf(const std::string& id) {
  constexpr size_t longest = 60;
  const Json json = Json::parse(id);
  const std::string name = json.is_string() ? json.get<std::string>() : id;
  std::string plain;
  for (const char c : name.substr(0, longest)) {
    const bool good = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
                      c == '_' || (c == '.' && !plain.empty());
    plain += good ? c : '_';
  }
  return plain == name && !plain.empty() && json.is_string() ? plain : plain + "-" + sha256Of(id).substr(0, 8);
}

}  // namespace breakaway::cli
