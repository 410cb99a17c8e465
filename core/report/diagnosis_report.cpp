#include "report/diagnosis_report.h"

#include <algorithm>
#include <initializer_list>

#include "base/atomic_file.h"
#include "base/made.h"
#include "diagnose/effects/catalogue.h"
#include "diagnose/simulate/model_file.h"
#include "draw/html_report.h"
#include "report/diagnosis_figures.h"

namespace breakaway {

namespace {

std::vector<std::vector<std::string>> parameterRows(const Diagnosis& d) {
  std::vector<std::vector<std::string>> rows;
  const auto add = [&rows](const std::string& owner, const Parameter& one, const std::string& before) {
    rows.push_back({owner, one.name, before, numberText(one.value), numberText(one.low95), numberText(one.high95)});
  };
  for (const Parameter& one : d.model.base) {
    const auto before = d.base.baseValue(one.name);
    add("base", one, before ? numberText(*before) : "");
  }
  for (const EffectTerm& term : d.model.effects) {
    for (const Parameter& one : presentParameters(term, d.model.axis)) add(term.effect, one, "");
  }
  return rows;
}

std::string listOf(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "" : ", ") + name;
  return out;
}

std::string percent(double part) {
  return numberText(100.0 * part, 3) + " %";
}

/// Figures whose name begins with one of the stems.
void addFigures(HtmlReport& report, const std::vector<NamedFigure>& figures, std::initializer_list<const char*> stems) {
  for (const NamedFigure& one : figures) {
    const bool wanted =
        std::any_of(stems.begin(), stems.end(), [&one](const char* stem) { return one.name.rfind(stem, 0) == 0; });
    if (wanted) report.figure(one.figure, one.caption, 860, 320);
  }
}

void addFindings(HtmlReport& report, const Diagnosis& d, const std::vector<NamedFigure>& figures) {
  if (d.findings.empty()) return;
  report.heading("What is missing");
  for (const Finding& finding : d.findings) {
    const Effect& effect = *findEffect(finding.effect);
    report.heading(finding.effect, 3);
    report.paragraph(finding.sentence);
    addFigures(report, figures, {("term_" + finding.effect).c_str()});
    std::vector<std::vector<std::string>> rows;
    rows.reserve(finding.parameters.size());
    for (const Parameter& one : finding.parameters)
      rows.push_back({one.name, numberText(one.value), numberText(one.low95), numberText(one.high95)});
    report.table({"parameter", "value", "95 % from", "95 % to"}, rows);
    report.facts({{"Share of the excess error", percent(finding.share)},
                  {"By chance", "p = " + numberText(finding.pValue, 2)},
                  {"Can't be told from",
                   finding.ambiguousWith.empty() ? "nothing in the catalogue" : listOf(finding.ambiguousWith)}});
    report.details("How " + finding.effect + " is modelled",
                   {std::string(effect.formula()), "Source: " + std::string(effect.source()) + "."});
  }
}

void addProof(HtmlReport& report, const Diagnosis& d, const std::vector<NamedFigure>& figures,
              const std::string& unit) {
  report.heading("How much better, on data it never saw");
  report.svg(gainSvg(d), d.fit.inTorque() ? "What the model leaves of the drive along the recorded motion."
                                          : "Position error of a simulation that knows the drive alone.");
  const FitScore& fit = d.fit;
  std::vector<std::pair<std::string, std::string>> facts{
      {"Held-out error", numberText(fit.heldoutBefore) + unit + " before, " + numberText(fit.heldoutAfter) + unit +
                             " after; a perfect model would show " + numberText(fit.floor) + unit},
      {"Held out", fit.separateRecording ? "separate recordings"
                                         : "parts of the recordings, at least 1 s away from any training sample"}};
  if (!d.findings.empty()) {
    facts.insert(
        facts.begin() + 1,
        {{"Improvement, 95 % interval", percent(fit.improvementLow95) + " to " + percent(fit.improvementHigh95)},
         {"Reached of what is possible", percent(d.proof.achieved) + " of the squared error over the floor"}});
  }
  facts.push_back({"Left in common", "from window to window the errors correlate by " + numberText(d.proof.lag1, 2) +
                                         " (p = " + numberText(d.proof.whitenessPValue, 2) + ")"});
  facts.push_back({"Left unexplained", percent(d.unexplainedShare) + " of the excess squared error"});
  report.facts(facts);
  addFigures(report, figures, {"typical_", "worst_", "training_"});
}

HtmlReport buildReport(const Diagnosis& d, const Bench& bench, const std::vector<Recording>& recordings,
                       const std::vector<Recording>& heldout, const std::vector<NamedFigure>& figures) {
  HtmlReport report("Diagnosis: where simulation and recording part", bench.name);
  const std::string words = inWords(d);
  report.verdict(words.substr(0, words.find('\n')));
  if (!d.nextSentence.empty()) report.facts({{"Run next", d.nextSentence}});
  if (!d.where.empty()) {
    report.heading("Where it shows");
    std::vector<std::string> items;
    items.reserve(d.where.size());
    for (const Place& place : d.where)
      items.push_back(place.sentence + " (" + percent(place.share) +
                      " of the unexplained square, p = " + numberText(place.pValue, 2) + ")");
    report.list(items);
    addFigures(report, figures, {("where_" + d.where.front().axis).c_str()});
  }
  addFindings(report, d, figures);
  const bool rotary = bench.axis == Axis::rotary;
  addProof(report, d, figures, d.fit.inTorque() ? (rotary ? " Nm" : " N") : rotary ? " rad" : " m");
  if (d.where.size() > 1) {
    report.heading("The same, seen over other axes");
    for (const NamedFigure& one : figures) {
      const bool first = one.name.rfind("where_" + d.where.front().axis, 0) == 0;
      if (one.name.rfind("where_", 0) == 0 && !first) report.figure(one.figure, one.caption, 860, 300);
    }
  }
  report.heading("All parameters");
  report.table({"part", "parameter", "base model alone", "value", "95 % from", "95 % to"}, parameterRows(d));
  report.heading("Input");
  std::vector<std::string> inputs;
  inputs.reserve(recordings.size() + heldout.size() + d.remarks.size());
  for (const Recording& one : recordings)
    inputs.push_back("learned from " + one.name() + ", " + std::to_string(one.rows()) + " rows");
  for (const Recording& one : heldout)
    inputs.push_back("proved on " + one.name() + ", " + std::to_string(one.rows()) + " rows");
  inputs.insert(inputs.end(), d.remarks.begin(), d.remarks.end());
  report.list(inputs);
  return report;
}

}  // namespace

Result<void> writeDiagnosisFolder(const Diagnosis& d, const Bench& bench, const std::vector<Recording>& asGiven,
                                  const std::vector<Recording>& heldoutAsGiven, const std::string& folder) {
  const std::vector<Recording> recordings = mended(asGiven, d.misread), heldout = mended(heldoutAsGiven, d.misread);
  if (auto done = makeFolder(folder + "/figures"); !done) return done;
  if (auto done = writeModel(d.base, folder + "/base_model.json"); !done) return done;
  if (auto done = writeModel(d.model, folder + "/model.json"); !done) return done;
  const auto figures = diagnosisFigures(d, recordings, heldout);
  for (const NamedFigure& one : figures) {
    if (auto done = writeSvg(one.figure, folder + "/figures/" + one.name + ".svg"); !done) return done;
  }
  if (auto done = writeFile(folder + "/figures/gain.svg", svgWithMade(gainSvg(d))); !done) return done;
  if (auto done = buildReport(d, bench, recordings, heldout, figures).write(folder + "/report.html"); !done)
    return done;
  return writeDiagnosis(d, folder + "/diagnosis.json");
}

}  // namespace breakaway
