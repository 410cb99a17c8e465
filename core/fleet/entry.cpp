#include "fleet/entry.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "base/forms.h"
#include "base/json_text.h"

namespace breakaway {

namespace {

using Json = nlohmann::ordered_json;

/// Reads fields of one line and keeps the first fault.
class Line {
 public:
  explicit Line(std::string place) : place_(std::move(place)) {}

  const Json* field(const Json& object, const char* name, const std::string& where) {
    const auto it = object.is_object() ? object.find(name) : object.end();
    if (object.is_object() && it != object.end()) return &*it;
    fail(where.empty() ? name : where + "." + name, "is missing");
    return nullptr;
  }
  std::string text(const Json& object, const char* name, const std::string& where) {
    const Json* json = field(object, name, where);
    if (json != nullptr && json->is_string()) return json->get<std::string>();
    if (json != nullptr) fail(where + "." + name, "expected a text");
    return {};
  }
  double number(const Json* json, const std::string& where) {
    if (json != nullptr && json->is_number()) return json->get<double>();
    if (json != nullptr) fail(where, "expected a number");
    return 0.0;
  }
  std::pair<double, double> interval(const Json* json, const std::string& where) {
    if (json == nullptr) return {};
    if (!json->is_array() || json->size() != 2) {
      fail(where, "expected two numbers, the interval");
      return {};
    }
    return {number(&(*json)[0], where), number(&(*json)[1], where)};
  }
  FleetParameters parameters(const Json& object, const char* name, const std::string& where) {
    FleetParameters read;
    const Json* json = field(object, name, where);
    if (json == nullptr) return read;
    const std::string at = where + "." + name;
    if (!json->is_object()) fail(at, "expected an object");
    for (const auto& [parameter, value] : json->items()) {
      const std::string here = at + "." + parameter;
      FleetValue one;
      one.value = number(field(value, "value", here), here + ".value");
      std::tie(one.low95, one.high95) = interval(field(value, "ci95", here), here + ".ci95");
      read.emplace_back(parameter, one);
    }
    return read;
  }
  void fail(const std::string& name, const std::string& fact) {
    if (!fault) fault = Error{place_ + ", field " + name, fact};
  }

  std::optional<Error> fault;

 private:
  std::string place_;
};

std::string asQuoted(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string asWords(const Json& json) {
  return json.is_string() ? json.get<std::string>() : asQuoted(json);
}

FleetFit fitOf(Line& line, const Json& diagnosis) {
  FleetFit fit;
  const Json* json = line.field(diagnosis, "fit", "diagnosis");
  const Json* heldout = json == nullptr ? nullptr : line.field(*json, "heldout", "diagnosis.fit");
  if (heldout == nullptr) return fit;
  const std::string at = "diagnosis.fit.heldout";
  fit.channel = line.text(*json, "channel", "diagnosis.fit");
  fit.floor = line.number(line.field(*json, "floor", "diagnosis.fit"), "diagnosis.fit.floor");
  fit.before = line.number(line.field(*heldout, "before", at), at + ".before");
  fit.after = line.number(line.field(*heldout, "after", at), at + ".after");
  fit.gain.value = fit.before > 0.0 ? 1.0 - fit.after / fit.before : 0.0;
  std::tie(fit.gain.low95, fit.gain.high95) =
      line.interval(line.field(*heldout, "improvement_ci95", at), at + ".improvement_ci95");
  return fit;
}

/// `rms_Nm` or `rms_N`, without an interval; earlier results have none.
void addWander(Line& line, const Json& diagnosis, FleetParameters& parameters) {
  const auto wander = diagnosis.find("wander");
  if (wander == diagnosis.end() || !wander->is_object()) return;
  for (const char* name : {"rms_Nm", "rms_N"}) {
    if (!wander->contains(name)) continue;
    const double rms = line.number(&(*wander)[name], std::string("diagnosis.wander.") + name);
    parameters.emplace_back(std::string("wander_") + name, FleetValue{rms, rms, rms});
  }
}

void readDiagnosis(Line& line, const Json& diagnosis, FleetEntry& entry) {
  static const std::set<std::string> verdicts{"nothing_missing", "named", "ambiguous", "outside_catalogue",
                                              "undecided"};
  if (!diagnosis.is_object()) return line.fail("diagnosis", "expected an object");
  if (const Json form = diagnosis.value("schema", Json(diagnosisForm)); form != diagnosisForm)
    line.fail("diagnosis.schema", "is " + asQuoted(form) + ", expected " + asQuoted(diagnosisForm));
  entry.verdict = line.text(diagnosis, "verdict", "diagnosis");
  if (!verdicts.contains(entry.verdict))
    line.fail(
        "diagnosis.verdict",
        "expected nothing_missing, named, ambiguous, outside_catalogue or undecided, found \"" + entry.verdict + "\"");
  entry.parameters = line.parameters(diagnosis, "base", "diagnosis");
  addWander(line, diagnosis, entry.parameters);
  const Json* findings = line.field(diagnosis, "findings", "diagnosis");
  if (findings != nullptr && !findings->is_array()) line.fail("diagnosis.findings", "expected a list");
  for (size_t k = 0; findings != nullptr && findings->is_array() && k < findings->size(); ++k) {
    const std::string at = "diagnosis.findings[" + std::to_string(k) + "]";
    FleetFinding finding;
    finding.effect = line.text((*findings)[k], "effect", at);
    finding.parameters = line.parameters((*findings)[k], "parameters", at);
    entry.findings.push_back(std::move(finding));
  }
  entry.fit = fitOf(line, diagnosis);
}

/// When it was made, and by which run, where it says so.
void readMade(const Json& object, FleetEntry& entry) {
  const auto made = object.find("made");
  if (made == object.end() || !made->is_object()) return;
  const auto text = [&made](const char* name) {
    const auto it = made->find(name);
    return it != made->end() && it->is_string() ? it->get<std::string>() : std::string();
  };
  entry.at = text("at");
  entry.run = text("run");
}

std::string reportFrom(const std::string& report, const std::string& folder) {
  const bool address = report.starts_with("http://") || report.starts_with("https://");
  if (report.empty() || address) return report;
  return (std::filesystem::path(folder) / report).lexically_normal().string();
}

Result<FleetEntry> readEntry(std::string_view text, const std::string& place, const std::string& reportsFrom) {
  if (auto fault = jsonFault(text, place)) return Error{place, fault->fact};
  const Json json = Json::parse(text);
  if (!json.is_object()) return Error{place, "expected a JSON object"};
  Line line(place);
  FleetEntry entry;
  const Json* id = line.field(json, "id", "");
  if (id != nullptr && !id->is_string() && !id->is_number()) line.fail("id", "expected a text or a number");
  if (id != nullptr) entry.id = asWords(*id);
  if (json.contains("diagnosis")) {
    readDiagnosis(line, json["diagnosis"], entry);
    if (json["diagnosis"].is_object()) readMade(json["diagnosis"], entry);
  } else if (json.contains("error")) {
    entry.verdict = "error";
    readMade(json, entry);
    if (!json["error"].is_string()) line.fail("error", "expected a text");
    if (json["error"].is_string()) entry.error = json["error"].get<std::string>();
  } else {
    return Error{place, "is no result: it has neither diagnosis nor error"};
  }
  for (const auto& [name, value] : json.items()) {
    if (name == "id" || name == "diagnosis" || name == "error" || name == "made") continue;
    if (name == "report" && value.is_string()) {
      entry.report = reportFrom(value.get<std::string>(), reportsFrom);
      continue;
    }
    entry.further.emplace_back(name, asWords(value));
    if (name == "date" && daysOf(entry.further.back().second)) entry.at = entry.further.back().second;
  }
  if (line.fault) return *line.fault;
  return entry;
}

}  // namespace

std::string FleetEntry::names() const {
  std::string all;
  for (const FleetFinding& finding : findings) all += (all.empty() ? "" : " ") + finding.effect;
  return all;
}

Result<FleetText> readFleet(std::string_view text, const std::string& path, const std::string& reportsFrom) {
  FleetText fleet;
  size_t from = 0;
  for (size_t index = 1, end = text.find('\n'); end != std::string_view::npos; end = text.find('\n', from), ++index) {
    auto entry = readEntry(text.substr(from, end - from), path + ", line " + std::to_string(index), reportsFrom);
    if (!entry) return entry.error();
    fleet.entries.push_back(std::move(*entry));
    from = end + 1;
  }
  fleet.cutShort = from < text.size();
  return fleet;
}

size_t leaveOutRepeated(std::vector<FleetEntry>& entries) {
  std::set<std::pair<std::string, std::string>> there;
  return std::erase_if(entries, [&there](const FleetEntry& entry) {
    return !entry.run.empty() && !there.emplace(entry.id, entry.run).second;
  });
}

size_t idsWithSeveral(const std::vector<FleetEntry>& entries) {
  std::set<std::string> there, several;
  for (const FleetEntry& entry : entries) {
    if (!there.insert(entry.id).second) several.insert(entry.id);
  }
  return several.size();
}

std::optional<double> daysOf(const std::string& at) {
  int year = 0, used = 0, hour = 0, minute = 0;
  unsigned month = 0, day = 0;
  double second = 0.0;
  if (std::sscanf(at.c_str(), "%4d-%2u-%2u%n", &year, &month, &day, &used) != 3 || used != 10) return {};
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(month), std::chrono::day(day)};
  if (!date.ok()) return {};
  const auto whole = static_cast<double>(std::chrono::sys_days(date).time_since_epoch().count());
  if (at.size() == 10) return whole;
  if ((at[10] != 'T' && at[10] != ' ') || std::sscanf(at.c_str() + 11, "%2d:%2d:%lf", &hour, &minute, &second) < 2 ||
      !std::isfinite(second))
    return {};
  return whole + (hour + (minute + second / 60.0) / 60.0) / 24.0;
}

}  // namespace breakaway
