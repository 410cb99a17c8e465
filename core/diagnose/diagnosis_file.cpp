// The diagnosis in words and as JSON (resources/help/files.md).
#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/forms.h"
#include "base/made.h"
#include "diagnose/diagnosis.h"
#include "diagnose/effects/catalogue.h"
#include "diagnose/effects/wording.h"
#include "diagnose/simulate/physics.h"

namespace breakaway {

namespace {

std::string sizeText(double value, Axis axis) {
  if (axis == Axis::linear) return lengthText(value);
  return value < 1.0 ? fmt::format("{:.3g} mrad", value * 1e3) : fmt::format("{:.3g} rad", value);
}

/// An error in the channel that was scored.
std::string errorText(double value, Axis axis, const FitScore& fit) {
  if (fit.inTorque()) return torqueText(value, axis);
  return sizeText(value, axis) + (fit.channel.starts_with("velocity") ? "/s" : "");
}

/// "a", "a or b", "a, b or c".
Message joined(const std::vector<std::string>& effects) {
  std::vector<Message> names;
  names.reserve(effects.size());
  for (const std::string& one : effects) names.push_back(nameOfEffect(one));
  return listed(names, message(" or "));
}

/// Each with its interval, one a line.
std::string inLines(const std::vector<Parameter>& parameters) {
  std::string out;
  for (const Parameter& one : parameters)
    out += fmt::format("    {} = {:.4g}  [{:.4g}, {:.4g}]\n", one.name, one.value, one.low95, one.high95);
  return out;
}

nlohmann::ordered_json withInterval(double value, double low95, double high95) {
  return {{"value", value}, {"ci95", {low95, high95}}};
}

nlohmann::ordered_json rivalsJson(const Finding& finding) {
  auto json = nlohmann::ordered_json::array();
  for (const RivalScore& one : finding.rivals)
    json.push_back({{"effect", one.effect},
                    {"heldout", withInterval(one.error, one.low95, one.high95)},
                    {"over_finding", withInterval(one.ratio, one.ratioLow95, one.ratioHigh95)}});
  return json;
}

nlohmann::ordered_json parametersJson(const std::vector<Parameter>& parameters) {
  auto json = nlohmann::ordered_json::object();
  for (const Parameter& one : parameters) json[one.name] = withInterval(one.value, one.low95, one.high95);
  return json;
}

/// What held-out data says of it.
std::string proofText(const Diagnosis& d) {
  if (d.verdict == Verdict::undecided) return {};
  const Axis axis = d.model.axis;
  const FitScore& fit = d.fit;
  const std::string floor = "a perfect model would show " + errorText(fit.floor, axis, fit) +
                            ", with this rig's wander " + errorText(fit.floorWithWander, axis, fit);
  const std::string source = fit.separateRecording
                                 ? "separate recordings"
                                 : "parts of the recordings, at least 1 s away from any training sample";
  if (d.findings.empty()) {
    return "Proof: over " + digitsText(fit.window_s) + " s windows of held-out data (" + source +
           ") the base model errs by " + errorText(fit.heldoutBefore, axis, fit) + "; " + floor + ".\n";
  }
  return "Proof: over " + digitsText(fit.window_s) + " s windows of held-out data (" + source +
         ") the error falls from " + errorText(fit.heldoutBefore, axis, fit) + " to " +
         errorText(fit.heldoutAfter, axis, fit) + ", by " +
         percentText(1.0 - fit.heldoutAfter / std::max(fit.heldoutBefore, 1e-300)) + " (95 % interval " +
         percentText(fit.improvementLow95) + " to " + percentText(fit.improvementHigh95) + "); " + floor +
         ". That is " + percentText(d.proof.achieved) + " of what is possible.\n";
}

/// What others in its place err by, in a line.
std::string rivalsText(const Diagnosis& d, const Finding& finding) {
  if (finding.rivals.empty()) return {};
  std::string out;
  for (const RivalScore& one : finding.rivals)
    out += (out.empty() ? "" : ", ") + one.effect + " " + errorText(one.error, d.model.axis, d.fit) + " (" +
           digitsText(one.ratioLow95) + " to " + digitsText(one.ratioHigh95) + " times)";
  return "    in its place, on held-out data: " + out + "\n";
}

}  // namespace

Message nameOfEffect(const std::string& name) {
  const Effect* effect = findEffect(name);
  return effect != nullptr ? Message(effect->name(), {}) : Message(name);
}

Message headline(const Diagnosis& d) {
  if (d.misread) return message("Misread: {}.", d.misread->sentence);
  std::vector<Message> all;
  for (const Finding& finding : d.findings) {
    std::vector<std::string> one{finding.effect};
    if (d.verdict != Verdict::named) one.insert(one.end(), finding.ambiguousWith.begin(), finding.ambiguousWith.end());
    all.push_back(joined(one));
  }
  const Message names = listed(all, message(" and "));
  switch (d.verdict) {
    case Verdict::nothingMissing:
      if (d.fit.heldoutBefore <= d.criteria.atFloor * d.fit.floor)
        return message("Nothing is missing: the base model explains the recording as far as its sensors can tell.");
      if (d.fit.heldoutBefore <= d.criteria.atFloor * d.fit.floorWithWander)
        return d.model.axis == Axis::linear
                   ? message(
                         "Nothing is missing: what the base model leaves is force that changes at random, as on any "
                         "rig.")
                   : message(
                         "Nothing is missing: what the base model leaves is torque that changes at random, as on "
                         "any rig.");
      return message(
          "Nothing was found missing that has a place or a name, though the model errs by more than its sensors "
          "explain.");
    case Verdict::named:
      return message("The model lacks {}.", names);
    case Verdict::ambiguous:
      return message("The model lacks {}; these recordings can't tell rivals apart.", names);
    case Verdict::outsideCatalogue:
      return names.empty()
                 ? message("The model lacks something that has no name in the catalogue.")
                 : message("The model lacks {}, and something more that has no name in the catalogue.", names);
    case Verdict::undecided:
      return message("Undecided: these recordings can't tell what is missing; the base model fits what there is.");
  }
  return {};
}

std::string inWords(const Diagnosis& d) {
  std::string out = headline(d).english() + "\n";
  if (d.misread) out += "With " + d.misread->mended + ":\n";
  out += inLines(d.model.base);
  for (const Finding& finding : d.findings) {
    out += "- " + finding.effect + ": " + finding.sentence + "\n";
    out += inLines(finding.parameters);
    out += "    takes away " + percentText(finding.share) + " of the excess error (p = " + digitsText(finding.pValue) +
           ")\n";
    if (!finding.ambiguousWith.empty())
      out += "    can't be told from " + joined(finding.ambiguousWith).english() + "\n";
    out += rivalsText(d, finding);
  }
  if (!d.where.empty()) out += "Where: " + d.where.front().sentence + "\n";
  out += proofText(d);
  if (!d.nextSentence.empty()) out += "Next: " + d.nextSentence + "\n";
  for (const std::string& remark : d.remarks) {
    if (!d.misread || remark != d.misread->sentence) out += "Note: " + remark + ".\n";
  }
  return out;
}

std::string diagnosisJson(const Diagnosis& d, bool oneLine) {
  using Json = nlohmann::ordered_json;
  Json json{{"schema", diagnosisForm}, {"verdict", nameOf(d.verdict)}};
  json["findings"] = Json::array();
  for (const Finding& finding : d.findings) {
    json["findings"].push_back({{"effect", finding.effect},
                                {"share", finding.share},
                                {"p_value", finding.pValue},
                                {"ambiguous_with", finding.ambiguousWith},
                                {"rivals", rivalsJson(finding)},
                                {"parameters", parametersJson(finding.parameters)},
                                {"sentence", finding.sentence}});
  }
  json["base"] = parametersJson(d.model.base);
  const double friction = physicsOf(d.model).coulomb;
  json["wander"] = {{d.model.axis == Axis::linear ? "rms_N" : "rms_Nm", d.wander.rms},
                    {"share_of_friction", friction > 0.0 ? d.wander.rms / friction : 0.0},
                    {"correlation_s", d.wander.rms > 0.0 ? d.wander.time_s : 0.0}};
  json["where"] = Json::array();
  for (const Place& place : d.where) {
    json["where"].push_back(
        {{"axis", place.axis},
         {"from", place.from},
         {"to", place.to},
         {"unit", place.unit},
         {"share", place.share},
         {"p_value", place.pValue},
         {"foretells", {{"value", place.foretells.value}, {"ci95", {place.foretells.low95, place.foretells.high95}}}},
         {"size", place.size},
         {"size_unit", place.sizeUnit},
         {"sentence", place.sentence}});
  }
  json["fit"] = {{"channel", d.fit.channel},
                 {"metric", "rmse"},
                 {"window_s", d.fit.window_s},
                 {"train", {{"before", d.fit.trainBefore}, {"after", d.fit.trainAfter}}},
                 {"heldout",
                  {{"before", d.fit.heldoutBefore},
                   {"after", d.fit.heldoutAfter},
                   {"before_ci95", {d.fit.before95.low, d.fit.before95.high}},
                   {"after_ci95", {d.fit.after95.low, d.fit.after95.high}},
                   {"improvement_ci95", {d.fit.improvementLow95, d.fit.improvementHigh95}},
                   {"separate_recording", d.fit.separateRecording}}},
                 {"floor", d.fit.floor},
                 {"floor_with_wander", d.fit.floorWithWander},
                 {"achieved", d.proof.achieved},
                 {"whiteness", {{"lag1", d.proof.lag1}, {"p_value", d.proof.whitenessPValue}}},
                 {"worst_block",
                  {{"recording", d.proof.worst.recording},
                   {"start_s", d.proof.worst.start_s},
                   {"before", d.proof.worst.before},
                   {"after", d.proof.worst.after}}}};
  json["unexplained"] = {{"share", d.unexplainedShare}, {"p_value", d.unexplainedPValue}};
  json["next_experiment"] = {{"sentence", d.nextSentence}, {"separates", d.nextSeparates}};
  json["misread"] = d.misread ? Json{{"what", d.misread->what},
                                     {"of", d.misread->ofBench ? "bench" : "recording"},
                                     {"factor", d.misread->factor},
                                     {"sentence", d.misread->sentence},
                                     {"mended", d.misread->mended}}
                              : Json();
  json["remarks"] = d.remarks;
  json["named_s"] = d.named_s;
  json["elapsed_s"] = d.elapsed_s;
  json["cpu_s"] = d.cpu_s;
  if (d.cutShort) json["cut_short"] = true;
  return json.dump(oneLine ? -1 : 2, ' ', false, Json::error_handler_t::replace);
}

Result<void> writeDiagnosis(const Diagnosis& diagnosis, const std::string& path) {
  return writeFile(path, withMade(diagnosisJson(diagnosis, false)) + "\n");
}

}  // namespace breakaway
