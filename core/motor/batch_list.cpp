#include "motor/batch_list.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "base/forms.h"
#include "base/json_text.h"

namespace breakaway {

namespace {

using Json = nlohmann::ordered_json;

std::string textOf(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string lineOf(const std::string& path, size_t index) {
  return path + ", line " + std::to_string(index + 1);
}

/// The object in a line with its id, a text or a number.
Result<Json> parseLine(std::string_view text, const std::string& place) {
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

/// What a result may carry: all but what it says itself.
std::vector<std::pair<std::string, std::string>> furtherOf(const Json& json) {
  static const std::set<std::string> reserved{"id", "bench", "recordings", "heldout", "diagnosis", "error", "made"};
  std::vector<std::pair<std::string, std::string>> further;
  for (const auto& [name, value] : json.items()) {
    if (!reserved.contains(name)) further.emplace_back(name, textOf(value));
  }
  return further;
}

/// The hashes of the inputs that `made` of `object` names; nothing where it names none.
std::optional<std::vector<std::string>> inputsIn(const Json& object) {
  const Json made = object.is_object() ? object.value("made", Json()) : Json();
  const Json inputs = made.is_object() ? made.value("inputs", Json()) : Json();
  if (!inputs.is_array() || inputs.empty()) return {};
  std::vector<std::string> hashes;
  hashes.reserve(inputs.size());
  for (const Json& one : inputs) {
    const Json hash = one.is_object() ? one.value("sha256", Json()) : Json();
    hashes.push_back(hash.is_string() ? hash.get<std::string>() : std::string());
  }
  return hashes;
}

Result<BatchEntry> entryIn(std::string_view line, const std::string& place, const std::filesystem::path& folder) {
  const auto json = parseLine(line, place);
  if (!json) return json.error();
  BatchEntry entry;
  entry.id = textOf((*json)["id"]);
  if (!json->contains("bench") || !(*json)["bench"].is_string())
    return Error{place + ", field bench", "expected the name of a bench file"};
  entry.bench = (folder / (*json)["bench"].get<std::string>()).string();
  auto recordings = pathsIn(*json, "recordings", true, place, folder);
  if (!recordings) return recordings.error();
  auto heldout = pathsIn(*json, "heldout", false, place, folder);
  if (!heldout) return heldout.error();
  entry.recordings = std::move(*recordings);
  entry.heldout = std::move(*heldout);
  entry.further = furtherOf(*json);
  return entry;
}

}  // namespace

Result<std::vector<BatchEntry>> readBatchList(std::string_view text, const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::vector<BatchEntry> entries;
  std::set<std::string> ids;
  for (size_t index = 0, from = 0; from < text.size(); ++index) {
    const size_t end = std::min(text.find('\n', from), text.size());
    const std::string_view line = text.substr(from, end - from);
    from = end + 1;
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    auto entry = entryIn(line, lineOf(path, index), folder);
    if (!entry) return entry.error();
    if (!ids.insert(entry->id).second) return Error{lineOf(path, index), "has the id " + entry->id + " once more"};
    entries.push_back(std::move(*entry));
  }
  return entries;
}

std::vector<std::string> BatchEntry::files() const {
  std::vector<std::string> all{bench};
  for (const auto* list : {&recordings, &heldout}) {
    for (const std::string& path : *list) {
      if (std::find(all.begin(), all.end(), path) == all.end()) all.push_back(path);
    }
  }
  return all;
}

bool BatchResult::isStale(const std::vector<std::string>& today) const {
  if (!inputs) return false;
  return inputs->size() != today.size() ||
         !std::equal(today.begin(), today.end(), inputs->begin(),
                     [](const std::string& now, const std::string& then) { return now.empty() || now == then; });
}

bool BatchResult::restsOnGone(const std::vector<std::string>& today) const {
  if (!inputs || inputs->size() != today.size()) return false;
  for (size_t k = 0; k < today.size(); ++k) {
    if (today[k].empty() && !(*inputs)[k].empty()) return true;
  }
  return false;
}

Result<std::vector<BatchResult>> readBatchResults(const std::vector<std::string>& lines, const std::string& path) {
  std::vector<BatchResult> results;
  results.reserve(lines.size());
  for (size_t index = 0; index < lines.size(); ++index) {
    const auto json = parseLine(lines[index], lineOf(path, index));
    if (!json) return json.error();
    const bool diagnosed = json->contains("diagnosis");
    if (!diagnosed && !json->contains("error"))
      return Error{lineOf(path, index), "is no result: it has neither diagnosis nor error"};
    if (diagnosed && json->at("diagnosis").is_object()) {
      const Json form = json->at("diagnosis").value("schema", Json(diagnosisForm));
      if (form != diagnosisForm)
        return Error{lineOf(path, index) + ", field diagnosis.schema",
                     "is " + textOf(form) + ", expected \"" + diagnosisForm + "\""};
    }
    results.push_back({textOf((*json)["id"]), inputsIn(diagnosed ? (*json)["diagnosis"] : *json)});
  }
  return results;
}

}  // namespace breakaway
