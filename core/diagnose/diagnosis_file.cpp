// The diagnosis in words and as JSON, contracts section 4.
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "diagnose/catalogue.h"
#include "diagnose/diagnosis.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

std::string sizeText(double value, Axis axis) {
  if (axis == Axis::linear) return lengthText(value);
  char text[48];
  std::snprintf(text, sizeof text, value < 1.0 ? "%.3g mrad" : "%.3g rad", value < 1.0 ? value * 1e3 : value);
  return text;
}

}  // namespace

std::string nameOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::nothingMissing:
      return "nothing_missing";
    case Verdict::named:
      return "named";
    case Verdict::ambiguous:
      return "ambiguous";
    case Verdict::outsideCatalogue:
      return "outside_catalogue";
  }
  return {};
}

std::string inWords(const Diagnosis& d) {
  const Axis axis = d.model.axis;
  std::string out;
  switch (d.verdict) {
    case Verdict::nothingMissing:
      out += "Nothing is missing: the base model explains the recording as far as its sensors can tell.\n";
      break;
    case Verdict::named:
      out += "Missing physics found and named:\n";
      break;
    case Verdict::ambiguous:
      out += "Physics is missing, but the data can't tell rivals apart:\n";
      break;
    case Verdict::outsideCatalogue:
      out += "Something is missing that has no name in the catalogue:\n";
      break;
  }
  for (const Finding& finding : d.findings) {
    char line[96];
    std::snprintf(line, sizeof line, " (%.0f %% of the excess error, p = %.3g)", 100.0 * finding.share, finding.pValue);
    out += "- " + finding.effect + line + ": " + finding.sentence + "\n";
    for (const Parameter& one : finding.parameters) {
      char text[160];
      std::snprintf(text, sizeof text, "    %s = %.4g  [%.4g, %.4g]\n", one.name.c_str(), one.value, one.low95,
                    one.high95);
      out += text;
    }
    std::string rivals;
    for (const std::string& rival : finding.ambiguousWith) rivals += (rivals.empty() ? "" : ", ") + rival;
    if (!rivals.empty()) out += "    can't be told from: " + rivals + "\n";
  }
  if (!d.where.empty()) out += "Where: " + d.where.front().sentence + "\n";
  char text[320];
  std::snprintf(
      text, sizeof text,
      "Error over %.3g s windows: held-out %s before, %s after (%.0f %% less, 95 %% interval %.0f to %.0f %%); "
      "training %s before, %s after; a perfect model would show %s.\n",
      d.fit.window_s, sizeText(d.fit.heldoutBefore, axis).c_str(), sizeText(d.fit.heldoutAfter, axis).c_str(),
      100.0 * (1.0 - d.fit.heldoutAfter / std::max(d.fit.heldoutBefore, 1e-300)), 100.0 * d.fit.improvementLow95,
      100.0 * d.fit.improvementHigh95, sizeText(d.fit.trainBefore, axis).c_str(),
      sizeText(d.fit.trainAfter, axis).c_str(), sizeText(d.fit.floor, axis).c_str());
  out += text;
  out += d.fit.separateRecording
             ? "Held out: separate recordings.\n"
             : "Held out: parts of the recordings themselves, at least 1 s away from any training sample.\n";
  if (!d.nextSentence.empty()) out += "Next: " + d.nextSentence + "\n";
  for (const std::string& remark : d.remarks) out += "Note: " + remark + ".\n";
  return out;
}

std::string diagnosisJson(const Diagnosis& d, bool oneLine) {
  using Json = nlohmann::ordered_json;
  Json json{{"schema", "breakaway.diagnosis/1"}, {"verdict", nameOf(d.verdict)}};
  json["findings"] = Json::array();
  for (const Finding& finding : d.findings) {
    Json parameters = Json::object();
    for (const Parameter& one : finding.parameters)
      parameters[one.name] = {{"value", one.value}, {"ci95", {one.low95, one.high95}}};
    json["findings"].push_back({{"effect", finding.effect},
                                {"share", finding.share},
                                {"p_value", finding.pValue},
                                {"ambiguous_with", finding.ambiguousWith},
                                {"parameters", parameters},
                                {"sentence", finding.sentence}});
  }
  json["where"] = Json::array();
  for (const Place& place : d.where) {
    json["where"].push_back({{"axis", place.axis},
                             {"from", place.from},
                             {"to", place.to},
                             {"unit", place.unit},
                             {"share", place.share},
                             {"p_value", place.pValue},
                             {"sentence", place.sentence}});
  }
  json["fit"] = {{"channel", d.fit.channel},
                 {"metric", "rmse"},
                 {"window_s", d.fit.window_s},
                 {"train", {{"before", d.fit.trainBefore}, {"after", d.fit.trainAfter}}},
                 {"heldout",
                  {{"before", d.fit.heldoutBefore},
                   {"after", d.fit.heldoutAfter},
                   {"improvement_ci95", {d.fit.improvementLow95, d.fit.improvementHigh95}},
                   {"separate_recording", d.fit.separateRecording}}},
                 {"floor", d.fit.floor},
                 {"achieved", d.proof.achieved},
                 {"whiteness", {{"lag1", d.proof.lag1}, {"p_value", d.proof.whitenessPValue}}},
                 {"worst_block",
                  {{"recording", d.proof.worst.recording},
                   {"start_s", d.proof.worst.start_s},
                   {"before", d.proof.worst.before},
                   {"after", d.proof.worst.after}}}};
  json["unexplained"] = {{"share", d.unexplainedShare}, {"p_value", d.unexplainedPValue}};
  json["next_experiment"] = {{"sentence", d.nextSentence}, {"separates", d.nextSeparates}};
  json["remarks"] = d.remarks;
  json["named_s"] = d.named_s;
  json["elapsed_s"] = d.elapsed_s;
  return json.dump(oneLine ? -1 : 2, ' ', false, Json::error_handler_t::replace);
}

Result<void> writeDiagnosis(const Diagnosis& diagnosis, const std::string& path) {
  return writeFile(path, diagnosisJson(diagnosis, false) + "\n");
}

}  // namespace breakaway
