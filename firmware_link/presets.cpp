#include "firmware_link/presets.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "base/json_object.h"

namespace breakaway {

namespace fs = std::filesystem;

namespace {

constexpr const char* scheme = "simulated";
constexpr const char* rigEnding = ".rig.json";
constexpr const char* benchEnding = ".bench.json";

bool endsWith(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() && text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

}  // namespace

std::string resourcesFolder() {
  std::error_code code;
  if (const char* named = std::getenv("BREAKAWAY_RESOURCES"); named != nullptr && *named != '\0') return named;
  std::vector<fs::path> places;
  const fs::path program = fs::read_symlink("/proc/self/exe", code);
  if (!code) {
    places.push_back(program.parent_path() / ".." / "resources");
    places.push_back(program.parent_path() / ".." / ".." / ".." / "resources");
    places.push_back(program.parent_path() / ".." / "share" / "breakaway");
  }
  places.emplace_back("/usr/share/breakaway");
  for (const fs::path& place : places) {
    if (fs::is_directory(place / "presets", code)) return place.lexically_normal().string();
  }
  return {};
}

std::vector<std::string> presetNames() {
  std::vector<std::string> names;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(fs::path(resourcesFolder()) / "presets", code)) {
    const std::string file = entry.path().filename().string();
    if (endsWith(file, rigEnding)) names.push_back(file.substr(0, file.size() - std::string(rigEnding).size()));
  }
  std::sort(names.begin(), names.end());
  return names;
}

bool isSimulated(const std::string& uri) {
  return uri == scheme || uri.rfind(std::string(scheme) + ":", 0) == 0;
}

Result<std::string> rigFileOf(const std::string& uri) {
  if (!isSimulated(uri)) return Error{"board " + uri, message("is not a simulated board")};
  const std::string named = uri == scheme ? "servo" : uri.substr(std::string(scheme).size() + 1);
  if (named.empty())
    return Error{"board " + uri, message("names no rig, expected simulated:PRESET or simulated:FILE.rig.json")};
  std::error_code code;
  if (endsWith(named, ".json") || named.find('/') != std::string::npos) {
    if (!fs::exists(named, code)) return Error{named, message("cannot be read: no such rig file")};
    return named;
  }
  const std::vector<std::string> names = presetNames();
  if (std::find(names.begin(), names.end(), named) != names.end()) {
    return (fs::path(resourcesFolder()) / "presets" / (named + rigEnding)).string();
  }
  std::string all;
  for (const auto& name : names) all += (all.empty() ? "" : ", ") + name;
  const auto near = nearestName(named, names);
  return Error{"board " + uri, "there is no preset " + named +
                                   (near ? ", did you mean " + *near + "?"
                                         : ", expected one of: " + (all.empty() ? "none found" : all))};
}

std::string benchFileBeside(const std::string& rigFile) {
  if (!endsWith(rigFile, rigEnding)) return {};
  const std::string bench = rigFile.substr(0, rigFile.size() - std::string(rigEnding).size()) + benchEnding;
  std::error_code code;
  return fs::exists(bench, code) ? bench : std::string();
}

}  // namespace breakaway
