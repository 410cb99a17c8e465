#include "house/include_rules.h"

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>

#include "base/atomic_file.h"

namespace breakaway::test {

namespace {

/// The rooms of core, each of which may include itself and those before it.
const std::vector<std::string> rooms{"base",     "dense",      "friction", "recording", "motor",
                                     "plant",    "observer",   "control",  "stability", "experiment",
                                     "identify", "commission", "diagnose", "export",    "trial",
                                     "draw",     "fleet",      "project",  "report",    "figures"};
/// The steps of diagnose, from the lowest: each may include itself and those before it. The catalogue is the top of
/// effects/, and what lies in no folder is the top of all.
const std::vector<std::string> steps{"model",  "effects", "catalogue", "simulate", "fit",
                                     "screen", "search",  "verdict",   "check",    "diagnosis"};
/// What the link stands on.
const std::set<std::string> belowLink{"base",     "friction", "recording", "control",
                                      "observer", "motor",    "plant",     "experiment"};

/// Whoever knows it can move a motor.
const std::string drivePort = "core/experiment/drive.h";

/// The compiler's own headers that a board without an operating system has too.
const std::set<std::string> freestanding{"array", "bit", "cstddef", "cstdint", "limits", "span", "type_traits"};

/// What trials stand on: they know the plant, but not the search.
const std::set<std::string> belowTrial{"base", "dense", "friction", "recording", "plant", "trial"};

/// Of the link, the simulated boards: they alone know the plant.
const std::vector<std::string> simulatedBoards{"firmware_link/simulated_", "firmware_link/board_faults.",
                                               "firmware_link/board/cortex_m3/host/"};

struct Include {
  std::string what;
  bool angled = false;
};

std::vector<Include> includesOf(const std::string& text) {
  static const std::regex pattern(R"re((?:^|\n)[ \t]*#[ \t]*include[ \t]*([<"])([^">\n]+)[">])re");
  std::vector<Include> includes;
  for (auto it = std::sregex_iterator(text.begin(), text.end(), pattern); it != std::sregex_iterator(); ++it) {
    includes.push_back({(*it)[2], (*it)[1] == "<"});
  }
  return includes;
}

std::string firstPart(const std::string& path) {
  return path.substr(0, path.find('/'));
}

size_t rankOf(const std::string& one, const std::vector<std::string>& order = rooms) {
  return static_cast<size_t>(std::find(order.begin(), order.end(), one) - order.begin());
}

/// The step of diagnose that a path from core/ lies on.
std::string stepOf(const std::string& path) {
  const std::string below = path.substr(std::string("diagnose/").size());
  if (below.find('/') == std::string::npos) return "diagnosis";
  return below.starts_with("effects/catalogue.") ? "catalogue" : firstPart(below);
}

std::string whyNotOnStair(const std::string& from, const std::string& what) {
  const std::string step = stepOf(from), other = stepOf(what);
  for (const std::string& one : {step, other}) {
    if (rankOf(one, steps) == steps.size()) return one + " is no step of diagnose";
  }
  return rankOf(other, steps) > rankOf(step, steps) ? step + " stands below " + other : std::string();
}

bool isQt(const std::string& what) {
  return (what.size() > 1 && what[0] == 'Q' && what[1] >= 'A' && what[1] <= 'Z') || what.starts_with("Qt") ||
         what.starts_with("qcustomplot");
}

bool isPlant(const std::string& path) {
  return path.starts_with("core/plant/") || path.starts_with("core/trial/");
}

/// The rooms of core that may use the plant; of what the search draws in, all files are looked at.
bool knowsPlant(const std::string& room) {
  return room == "plant" || room == "trial" || room == "diagnose";
}

/// The repository's file that an include in `from` names, or "".
std::string resolve(const Sources& sources, const std::string& from, const std::string& what) {
  for (const std::string& folder :
       {std::string("core/"), std::string(), std::string("app/"), from.substr(0, from.rfind('/') + 1)}) {
    if (sources.contains(folder + what)) return folder + what;
  }
  return {};
}

/// All files that `from` draws in, directly or not, and through which include of its own.
std::map<std::string, std::string> closure(const Sources& sources, const std::string& from) {
  std::map<std::string, std::string> reached;
  std::vector<std::pair<std::string, std::string>> open;
  for (const Include& one : includesOf(sources.at(from))) open.emplace_back(resolve(sources, from, one.what), one.what);
  while (!open.empty()) {
    const auto [file, through] = open.back();
    open.pop_back();
    if (file.empty() || !reached.emplace(file, through).second) continue;
    for (const Include& one : includesOf(sources.at(file)))
      open.emplace_back(resolve(sources, file, one.what), through);
  }
  return reached;
}

/// What belongs to one kind of system only.
bool isPosix(const Include& one) {
  static const std::set<std::string> headers{"dirent.h", "dlfcn.h", "fcntl.h",   "glob.h",  "grp.h", "langinfo.h",
                                             "netdb.h",  "poll.h",  "pthread.h", "pty.h",   "pwd.h", "sched.h",
                                             "signal.h", "spawn.h", "termios.h", "unistd.h"};
  if (!one.angled) return false;
  return one.what.starts_with("sys/") || one.what.starts_with("netinet/") || one.what.starts_with("arpa/") ||
         one.what.starts_with("linux/") || headers.contains(one.what);
}

/// Core and commands know the system by headers that name nothing of it.
bool isForEverySystem(const std::string& path) {
  const bool ours = path.starts_with("core/") || path.starts_with("app/cli/") || path.starts_with("app/line/") ||
                    path == "app/cli_main.cpp";
  return ours && !path.ends_with("_posix.cpp");
}

std::string whyNotInCore(const std::string& path, const Include& one) {
  if (isQt(one.what)) return "core knows no Qt";
  const bool jsonReader = path.starts_with("core/recording/import/json_");  // whose own headers speak of JSON
  if (path.ends_with(".h") && one.what.starts_with("nlohmann/") && !jsonReader)
    return "JSON stays inside readers and writers";
  const bool insideReader = one.what.starts_with("recording/import/json_") && one.what != "recording/import/json_log.h";
  if (insideReader && !jsonReader) return "JSON stays inside readers and writers";
  if (one.angled) return {};
  const std::string room = firstPart(path.substr(5)), other = firstPart(one.what);
  if (one.what.find('/') == std::string::npos) return "includes are written from the layer's folder";
  if (rankOf(room) == rooms.size()) return room + " is no room of the plan";
  if (rankOf(other) == rooms.size()) return "core stands on itself only";
  if (room == "diagnose" && other == room) return whyNotOnStair(path.substr(5), one.what);
  if (room == "trial" && !belowTrial.contains(other) && one.what != "motor/bench.h")
    return "trials know only base, dense systems, friction, recordings, the plant and the bench file";
  if (room == "draw" && other != "draw" && other != "base") return "drawing knows only base";
  if (room == "report" && other == "experiment") return "a report draws and writes, it moves nothing";
  if (other == "plant" && rankOf(room) > rankOf(other) && !knowsPlant(room))
    return "above the drive port nobody sees the plant";
  return rankOf(other) > rankOf(room) ? room + " stands below " + other : std::string();
}

/// What a board's own processor compiles too, its ports apart.
std::string whyNotOnBoard(const std::string& path, const Include& one) {
  if (one.angled) return freestanding.contains(one.what) ? "" : "a board has no <" + one.what + ">";
  if (one.what.starts_with("firmware_link/wire/")) return {};
  if (path.starts_with("firmware_link/wire/")) return "the wire stands on itself only";
  const std::string other = firstPart(one.what);
  const bool fine = other == "control" || other == "observer" || one.what.starts_with("firmware_link/board/");
  return fine ? std::string() : "a board stands on wire, control and observers only";
}

std::string whyNotInLink(const std::string& path, const Include& one) {
  const bool portable =
      path.starts_with("firmware_link/board/") && path.rfind('/') == std::string("firmware_link/board").size();
  if (portable || path.starts_with("firmware_link/wire/")) return whyNotOnBoard(path, one);
  const bool transport = path.starts_with("firmware_link/transport/");
  if (isQt(one.what)) return "the link knows no Qt";
  if (!transport && one.what.starts_with("firmware_link/transport/")) return "transports stand above the link";
  const std::string other = firstPart(one.what);
  const bool written = path.starts_with("firmware_link/board/cortex_m3/") && one.what == "emulated_rig_data.h";
  const bool simulated = std::any_of(simulatedBoards.begin(), simulatedBoards.end(),
                                     [&path](const std::string& start) { return path.starts_with(start); });
  if (other == "plant" && !simulated) return "of the link, only simulated boards see the plant";
  const bool fine = written || one.angled || other == "firmware_link" || belowLink.contains(other);
  return fine ? std::string() : "the link stands beside " + other;
}

std::string whyNotInApp(const std::string& path, const Include& one) {
  const bool session = path.starts_with("app/session/"), widget = path.starts_with("app/widgets/");
  const bool shown = widget || path.starts_with("app/pages/");
  const bool cli = path.starts_with("app/cli/") || path == "app/cli_main.cpp";
  const bool window = one.what == "main_window.h" || one.what == "screenshots.h" || one.what == "tour.h";
  if (cli && (isQt(one.what) || one.what.starts_with("widgets/") || one.what.starts_with("pages/") || window))
    return "commands see no window";
  if (session && (one.what.starts_with("widgets/") || one.what.starts_with("pages/") || window))
    return "the session knows no window";
  if (widget && one.what.starts_with("pages/")) return "widgets stand below pages";
  if (shown && window) return "pages and widgets stand below the window";
  if ((session || shown) && one.what.starts_with("cli/")) return "pages know no commands";
  if ((session || shown) && one.what == "session/session.h") return "whoever is given a part doesn't ask for the whole";
  if (shown && (one.what == "firmware_link/simulated_board.h" || one.what == "firmware_link/transport/open_board.h"))
    return "pages reach a board through the session";
  const bool trial = cli && one.what == "trial/sealed_trial.h";
  if (!trial && isPlant("core/" + one.what)) return "above the drive port nobody sees the plant";
  if (path.ends_with(".h") && one.what.starts_with("nlohmann/")) return "JSON stays inside readers and writers";
  return {};
}

}  // namespace

Sources readSources(const std::string& root) {
  Sources sources;
  for (const char* layer : {"core", "firmware_link", "app"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root + "/" + layer)) {
      const std::string path = entry.path().string();
      if (!path.ends_with(".h") && !path.ends_with(".cpp")) continue;
      if (const auto text = readFile(path)) sources[path.substr(root.size() + 1)] = *text;
    }
  }
  return sources;
}

std::vector<std::string> breaches(const Sources& sources) {
  std::vector<std::string> found;
  for (const auto& [path, text] : sources) {
    const std::string layer = firstPart(path);
    for (const Include& one : includesOf(text)) {
      const std::string why = isForEverySystem(path) && isPosix(one) ? "the system's own stands in *_posix.cpp"
                              : layer == "core"                      ? whyNotInCore(path, one)
                              : layer == "app"                       ? whyNotInApp(path, one)
                                                                     : whyNotInLink(path, one);
      if (!why.empty()) found.push_back(path + " includes " + one.what + ": " + why);
    }
    const bool search = path.starts_with("core/diagnose/"), report = path.starts_with("core/report/");
    if (!search && !report) continue;
    for (const auto& [file, through] : closure(sources, path)) {
      if (search && isPlant(file))
        found.push_back(path + " includes " + through + ": the search must not know " + file);
      if (report && file == drivePort && !through.starts_with("experiment/"))
        found.push_back(path + " includes " + through + ": a report draws and writes, it must not know " + file);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<std::string> namedEffects(const Sources& sources, const std::vector<std::string>& effects) {
  static const std::regex comment(R"(//[^\n]*)");
  std::vector<std::string> found;
  for (const auto& source : sources) {
    const std::string& path = source.first;
    const auto in = [&path](const char* folder) { return path.starts_with(folder); };
    const bool asks = in("core/diagnose/") || in("core/report/") || in("app/");
    if (!asks || in("core/diagnose/effects/")) continue;
    const std::string code = std::regex_replace(source.second, comment, "");
    for (const std::string& effect : effects) {
      if (code.find('"' + effect + '"') != std::string::npos) found.push_back(path + " names " + effect);
    }
  }
  return found;
}

}  // namespace breakaway::test
