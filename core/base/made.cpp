#include "base/made.h"

#include <algorithm>
#include <mutex>
#include <nlohmann/json.hpp>

#include "base/made_input.h"
#include "base/sha256.h"
#include "base/uuid.h"

namespace breakaway {

namespace {

/// The one run of this process: what is made is made by it, whatever room writes it.
struct Run {
  std::mutex mutex;
  bool begun = false;
  Made made;
  std::string folder, folderName;  ///< of nameFolder()
};

Run& theRun() {
  static Run run;
  static const bool made = [] {
    run.made.at = utcNow();
    run.made.by = "breakaway";
    run.made.run = freshUuid();
    return true;
  }();
  static_cast<void>(made);
  return run;
}

thread_local std::vector<InputFile>* ownInputs = nullptr;

nlohmann::ordered_json textOrNull(const std::string& text) {
  return text.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(text);
}

/// Text between tags: what would end an element is spelled out.
std::string inElement(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '&') {
      out += "&amp;";
    } else {
      out += c;
    }
  }
  return out;
}

bool isPlain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("-_./:=,@%+").find(c) != std::string_view::npos;
}

}  // namespace

void beginRun(std::string by, std::string command, std::optional<std::uint64_t> seed) {
  Run& run = theRun();
  const std::scoped_lock lock(run.mutex);
  run.made = {utcNow(), std::move(by), std::move(command), seed, {}, {}, {}, freshUuid()};
  run.begun = true;
}

Made thisRun() {
  Run& run = theRun();
  const std::scoped_lock lock(run.mutex);
  Made made = run.made;
  if (ownInputs != nullptr) made.inputs = *ownInputs;
  return made;
}

void noteInput(const std::string& path, std::string_view content) {
  Run& run = theRun();
  {
    const std::scoped_lock lock(run.mutex);
    if (!run.begun) return;
  }
  noteInputFile({path, sha256Of(content)});
}

void noteInputFile(InputFile input) {
  Run& run = theRun();
  const std::scoped_lock lock(run.mutex);
  if (!run.begun) return;
  const std::string path = input.path;
  if (!run.folder.empty() && path.starts_with(run.folder + "/"))
    input.path = run.folderName + path.substr(run.folder.size());
  std::vector<InputFile>& inputs = ownInputs != nullptr ? *ownInputs : run.made.inputs;
  if (std::find(inputs.begin(), inputs.end(), input) == inputs.end()) inputs.push_back(std::move(input));
}

void nameFolder(const std::string& folder, const std::string& name) {
  Run& run = theRun();
  const std::scoped_lock lock(run.mutex);
  run.folder = folder;
  run.folderName = name;
}

void noteDevice(std::optional<MadeOn> device) {
  Run& run = theRun();
  const std::scoped_lock lock(run.mutex);
  if (run.begun) run.made.device = std::move(device);
}

void noteRigTime(double time_s) {
  Run& run = theRun();
  const std::scoped_lock lock(run.mutex);
  if (run.begun) run.made.rigTime_s = time_s;
}

OwnInputs::OwnInputs() : before_(ownInputs) {
  ownInputs = &inputs_;
}

OwnInputs::~OwnInputs() {
  ownInputs = before_;
}

std::string sha256Of(std::string_view content) {
  Sha256 hash;
  hash.add(content);
  return hash.text();
}

std::string madeJson() {
  using Json = nlohmann::ordered_json;
  const Made made = thisRun();
  Json inputs = Json::array();
  for (const InputFile& one : made.inputs) inputs.push_back({{"path", one.path}, {"sha256", one.sha256}});
  Json device;
  if (made.device) {
    device = {{"model", textOrNull(made.device->model)},
              {"serial_number", textOrNull(made.device->serialNumber)},
              {"firmware", textOrNull(made.device->firmware)}};
  }
  const Json json{{"at", made.at},
                  {"by", made.by},
                  {"command", textOrNull(made.command)},
                  {"seed", made.seed ? Json(*made.seed) : Json()},
                  {"inputs", inputs},
                  {"device", device},
                  {"rig_time_s", made.rigTime_s ? Json(*made.rigTime_s) : Json()},
                  {"run", made.run}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string withMade(std::string text) {
  const size_t brace = text.find_last_of('}');
  if (brace == std::string::npos || brace == 0) return text;
  const size_t last = text.find_last_not_of(" \t\r\n", brace - 1);
  const bool spread = text.find('\n', last) < brace;
  const std::string comma = last != std::string::npos && text[last] == '{' ? "" : ",";
  const std::string field = comma + (spread ? "\n  \"made\": " : "\"made\":") + madeJson() + (spread ? "\n" : "");
  text.replace(last + 1, brace - last - 1, field);
  return text;
}

std::string svgWithMade(std::string svg) {
  const size_t end = svg.rfind("</svg>");
  return end == std::string::npos ? svg : svg.insert(end, "<metadata>" + inElement(madeJson()) + "</metadata>\n");
}

std::string htmlOfMade() {
  const Made made = thisRun();
  std::string words = "Made " + made.at + " by " + made.by;
  if (!made.command.empty()) words += ": " + made.command;
  return "<details class=\"made\"><summary>" + inElement(words) + "</summary><pre id=\"made\">" +
         inElement(madeJson()) + "</pre></details>\n";
}

std::string asCommand(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) {
    if (!line.empty()) line += ' ';
    if (!word.empty() && std::all_of(word.begin(), word.end(), isPlain)) {
      line += word;
      continue;
    }
    line += '\'';
    for (const char c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
    line += '\'';
  }
  return line;
}

}  // namespace breakaway
