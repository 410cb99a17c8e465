#include "report/diagnosis_report.h"

#include <algorithm>
#include <initializer_list>

#include "base/atomic_file.h"
#include "base/made.h"
#include "diagnose/effects/catalogue.h"
#include "diagnose/simulate/model_file.h"
#include "draw/html_report.h"
#include "report/diagnosis_figures.h"
#include "report/error_bars.h"

namespace breakaway {

namespace {

std::vector<std::vector<Saying>> parameterRows(const Diagnosis& d) {
  std::vector<std::vector<Saying>> rows;
  const auto add = [&rows](const Message& owner, const Parameter& one, const std::string& before) {
    rows.push_back({owner, one.name, before, numberText(one.value), numberText(one.low95), numberText(one.high95)});
  };
  for (const Parameter& one : d.model.base) {
    const auto before = d.base.baseValue(one.name);
    add(message("base"), one, before ? numberText(*before) : "");
  }
  for (const EffectTerm& term : d.model.effects) {
    for (const Parameter& one : presentParameters(term, d.model.axis)) add(nameOfEffect(term.effect), one, "");
  }
  return rows;
}

Message listOf(const std::vector<std::string>& effects) {
  std::vector<Message> names;
  names.reserve(effects.size());
  for (const std::string& one : effects) names.push_back(nameOfEffect(one));
  return listed(names, Message(", "));
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

/// Why it won, or why it can't be told from others.
void addRivals(HtmlReport& report, const Diagnosis& d, const Finding& finding) {
  if (finding.rivals.empty()) return report.paragraph(rivalSentence(finding));
  report.svg(rivalsSvg(d, finding, report.language()), rivalSentence(finding));
  const Shown shown = scoredIn(d);
  std::vector<std::vector<Saying>> rows;
  rows.reserve(finding.rivals.size());
  for (const RivalScore& one : finding.rivals)
    rows.push_back({nameOfEffect(one.effect), numberText(shown.scale * one.error, 3),
                    numberText(shown.scale * one.low95, 3), numberText(shown.scale * one.high95, 3),
                    numberText(one.ratio, 3),
                    message("{} to {}", numberText(one.ratioLow95, 3), numberText(one.ratioHigh95, 3))});
  report.table({message("in its place"), message("held-out error / {}", shown.unit), message("95 % from"),
                message("95 % to"), message("times the finding's"), message("95 % interval")},
               rows);
}

void addFindings(HtmlReport& report, const Diagnosis& d, const std::vector<NamedFigure>& figures) {
  if (d.findings.empty()) return;
  report.heading(message("What is missing"));
  for (const Finding& finding : d.findings) {
    const Effect& effect = *findEffect(finding.effect);
    report.heading(nameOfEffect(finding.effect), 3);
    report.paragraph(finding.sentence);
    addFigures(report, figures, {("term_" + finding.effect).c_str()});
    std::vector<std::vector<Saying>> rows;
    rows.reserve(finding.parameters.size());
    for (const Parameter& one : finding.parameters)
      rows.push_back({one.name, numberText(one.value), numberText(one.low95), numberText(one.high95)});
    report.table({message("parameter"), message("value"), message("95 % from"), message("95 % to")}, rows);
    report.facts({{message("Share of the excess error"), percent(finding.share)},
                  {message("By chance"), "p = " + numberText(finding.pValue, 2)},
                  {message("Can't be told from"), finding.ambiguousWith.empty() ? message("nothing in the catalogue")
                                                                                : listOf(finding.ambiguousWith)}});
    addRivals(report, d, finding);
    report.details(message("How {} is modelled", nameOfEffect(finding.effect)),
                   {std::string(effect.formula()), message("Source: {}.", effect.source())});
  }
}

void addProof(HtmlReport& report, const Diagnosis& d, const std::vector<NamedFigure>& figures,
              const std::string& unit) {
  report.heading(message("How much better, on data it never saw"));
  report.svg(gainSvg(d, report.language()),
             d.fit.inTorque() ? message("What the model leaves of the drive along the recorded motion.")
                              : message("Position error of a simulation that knows the drive alone."));
  const FitScore& fit = d.fit;
  std::vector<std::pair<Saying, Saying>> facts{
      {message("Held-out error"),
       message("{} before, {} after; a perfect model would show {}", numberText(fit.heldoutBefore) + unit,
               numberText(fit.heldoutAfter) + unit, numberText(fit.floor) + unit)},
      {message("Held out"), fit.separateRecording
                                ? message("separate recordings")
                                : message("parts of the recordings, at least 1 s away from any training sample")}};
  if (!d.findings.empty()) {
    facts.insert(facts.begin() + 1,
                 {{message("Improvement, 95 % interval"),
                   message("{} to {}", percent(fit.improvementLow95), percent(fit.improvementHigh95))},
                  {message("Reached of what is possible"),
                   message("{} of the squared error over the floor", percent(d.proof.achieved))}});
  }
  facts.emplace_back(message("Left in common"),
                     message("from window to window the errors correlate by {} (p = {})", numberText(d.proof.lag1, 2),
                             numberText(d.proof.whitenessPValue, 2)));
  facts.emplace_back(message("Left unexplained"),
                     message("{} of the excess squared error", percent(d.unexplainedShare)));
  report.facts(facts);
  addFigures(report, figures, {"typical_", "worst_", "training_"});
}

HtmlReport buildReport(const Diagnosis& d, const Bench& bench, const std::vector<Recording>& recordings,
                       const std::vector<Recording>& heldout, const std::vector<NamedFigure>& figures,
                       const Catalogue& language) {
  HtmlReport report(message("Diagnosis: where simulation and recording part"), bench.name, language);
  report.verdict(headline(d));
  if (!d.nextSentence.empty()) report.facts({{message("Run next"), d.nextSentence}});
  if (!d.where.empty()) {
    report.heading(message("Where it shows"));
    std::vector<Saying> items;
    items.reserve(d.where.size());
    for (const Place& place : d.where)
      items.push_back(message("{} ({} of the unexplained square, p = {})", place.sentence, percent(place.share),
                              numberText(place.pValue, 2)));
    report.list(items);
    addFigures(report, figures, {("where_" + d.where.front().axis).c_str()});
  }
  addFindings(report, d, figures);
  const bool rotary = bench.axis == Axis::rotary;
  addProof(report, d, figures, d.fit.inTorque() ? (rotary ? " Nm" : " N") : rotary ? " rad" : " m");
  if (d.where.size() > 1) {
    report.heading(message("The same, seen over other axes"));
    for (const NamedFigure& one : figures) {
      const bool first = one.name.rfind("where_" + d.where.front().axis, 0) == 0;
      if (one.name.rfind("where_", 0) == 0 && !first) report.figure(one.figure, one.caption, 860, 300);
    }
  }
  report.heading(message("All parameters"));
  report.table({message("part"), message("parameter"), message("base model alone"), message("value"),
                message("95 % from"), message("95 % to")},
               parameterRows(d));
  report.heading(message("Input"));
  std::vector<Saying> inputs;
  inputs.reserve(recordings.size() + heldout.size() + d.remarks.size());
  for (const Recording& one : recordings) inputs.push_back(message("learned from {}, {} rows", one.name(), one.rows()));
  for (const Recording& one : heldout) inputs.push_back(message("proved on {}, {} rows", one.name(), one.rows()));
  inputs.insert(inputs.end(), d.remarks.begin(), d.remarks.end());
  report.list(inputs);
  return report;
}

}  // namespace

Result<void> writeDiagnosisFolder(const Diagnosis& d, const Bench& bench, const std::vector<Recording>& asGiven,
                                  const std::vector<Recording>& heldoutAsGiven, const std::string& folder,
                                  const Catalogue& language) {
  const std::vector<Recording> recordings = mended(asGiven, d.misread), heldout = mended(heldoutAsGiven, d.misread);
  if (auto done = makeFolder(folder + "/figures"); !done) return done;
  if (auto done = writeModel(d.base, folder + "/base_model.json"); !done) return done;
  if (auto done = writeModel(d.model, folder + "/model.json"); !done) return done;
  const auto figures = diagnosisFigures(d, recordings, heldout);
  for (const NamedFigure& one : figures) {
    if (auto done = writeSvg(inLanguage(one.figure, language), folder + "/figures/" + one.name + ".svg"); !done)
      return done;
  }
  for (const Finding& finding : d.findings) {
    if (finding.rivals.empty()) continue;
    const std::string path = folder + "/figures/rivals_" + finding.effect + ".svg";
    if (auto done = writeFile(path, svgWithMade(rivalsSvg(d, finding, language))); !done) return done;
  }
  if (auto done = writeFile(folder + "/figures/gain.svg", svgWithMade(gainSvg(d, language))); !done) return done;
  if (auto done = buildReport(d, bench, recordings, heldout, figures, language).write(folder + "/report.html"); !done)
    return done;
  return writeDiagnosis(d, folder + "/diagnosis.json");
}

}  // namespace breakaway
