#include "report/diagnosis_report.h"

#include <algorithm>
#include <cmath>

#include "base/atomic_file.h"
#include "diagnose/catalogue.h"
#include "diagnose/fit/inverse_fit.h"
#include "diagnose/simulate/simulation.h"
#include "diagnose/where.h"
#include "report/html_report.h"

namespace breakaway {

namespace {

std::string positionLabel(Axis axis) {
  return axis == Axis::rotary ? "angle / rad" : "position / m";
}

std::string torqueLabel(Axis axis) {
  return axis == Axis::rotary ? "torque / Nm" : "force / N";
}

std::vector<double> positionsOf(const Recording& recording, Axis axis) {
  const auto values = recording.channel(axis == Axis::rotary ? "angle_rad" : "position_m");
  return {values.begin(), values.end()};
}

/// A gap before every restart, so that a picture doesn't join what isn't joined.
std::vector<double> withGaps(std::vector<double> values, const std::vector<size_t>& restarts) {
  for (const size_t row : restarts) {
    if (row > 0) values[row - 1] = std::nan("");
  }
  return values;
}

std::vector<double> difference(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> out(a.size());
  for (size_t k = 0; k < a.size(); ++k) out[k] = a[k] - b[k];
  return out;
}

/// Measurement, simulation before and after, and the residuals, of one recording.
void addTimeFigures(std::vector<NamedFigure>& figures, const Diagnosis& d, const Recording& recording,
                    const std::string& which) {
  const Axis axis = d.model.axis;
  const SimulateOptions options{d.fit.window_s};
  const auto before = simulate(d.base, recording, options), after = simulate(d.model, recording, options);
  if (!before || !after) return;
  const std::vector<double> time(recording.time().begin(), recording.time().end());
  const std::vector<double> measured = positionsOf(recording, axis);
  Figure motion{.title = "Measured and simulated, " + which, .xLabel = "time / s", .yLabel = positionLabel(axis)};
  motion.curves.push_back({.label = "measured", .x = time, .y = measured, .colour = 6});
  motion.curves.push_back(
      {.label = "base model", .x = time, .y = withGaps(before->position, before->restarts), .colour = 1});
  if (!d.findings.empty()) {
    motion.curves.push_back(
        {.label = "with what was missing", .x = time, .y = withGaps(after->position, after->restarts), .colour = 0});
  }
  Figure residual{.title = "What the simulation misses, " + which,
                  .xLabel = "time / s",
                  .yLabel = "measured − simulated, " + positionLabel(axis)};
  residual.curves.push_back({.label = "base model",
                             .x = time,
                             .y = withGaps(difference(measured, before->position), before->restarts),
                             .colour = 1});
  if (!d.findings.empty()) {
    residual.curves.push_back({.label = "with what was missing",
                               .x = time,
                               .y = withGaps(difference(measured, after->position), after->restarts),
                               .colour = 0});
  }
  if (which == "training recording") {
    for (const auto& [first, last] : d.heldoutRows) {
      residual.highlights.push_back({time[first], time[std::min(last, time.size()) - 1], "held out"});
    }
  }
  const std::string name = which == "training recording" ? "training" : "heldout";
  figures.push_back({name + "_motion",
                     "Simulation restarts from the measurement every " + numberText(d.fit.window_s, 2) + " s.",
                     motion});
  figures.push_back(
      {name + "_residual", "The smaller, the better the model; restarts set it back to nearly zero.", residual});
}

Result<std::vector<Track>> tracksOf(const Model& model, const std::vector<Recording>& recordings) {
  std::vector<Track> tracks;
  for (const Recording& recording : recordings) {
    auto track = makeTrack(recording, model.axis, model.input, model.supply_V, model.count);
    if (!track) return track.error();
    tracks.push_back(std::move(*track));
  }
  return tracks;
}

/// Unexplained torque before and after over one axis.
void addWhereFigures(std::vector<NamedFigure>& figures, const Diagnosis& d, const std::vector<Recording>& recordings) {
  const auto tracks = tracksOf(d.model, recordings);
  if (!tracks) return;
  const auto before = residualMaps(d.base, *tracks, 1), after = residualMaps(d.model, *tracks, 1);
  for (const ResidualMap& map : before) {
    const bool listed =
        std::any_of(d.where.begin(), d.where.end(), [&map](const Place& place) { return place.axis == map.axis; });
    if (!listed && map.axis != "velocity") continue;
    const auto band = [](const ResidualMap& one, const std::string& label, int colour) {
      Curve curve{.label = label, .x = one.centre, .y = one.mean_Nm, .colour = colour};
      for (size_t k = 0; k < one.mean_Nm.size(); ++k) {
        curve.low.push_back(one.mean_Nm[k] - 1.96 * one.error_Nm[k]);
        curve.high.push_back(one.mean_Nm[k] + 1.96 * one.error_Nm[k]);
      }
      return curve;
    };
    Figure figure{.title = "Unexplained " + torqueLabel(d.model.axis) + " over " + map.axis,
                  .xLabel = map.axis + " / " + map.unit,
                  .yLabel = torqueLabel(d.model.axis)};
    figure.curves.push_back(band(map, "base model", 1));
    const auto same =
        std::find_if(after.begin(), after.end(), [&map](const ResidualMap& one) { return one.axis == map.axis; });
    if (!d.findings.empty() && same != after.end()) figure.curves.push_back(band(*same, "with what was missing", 0));
    for (const Place& place : d.where) {
      if (place.axis == map.axis) figure.highlights.push_back({place.from, place.to, "worst here"});
    }
    figures.push_back(
        {"where_" + map.axis, "What the motor gives beyond what the model needs, with 95 % bands.", figure});
  }
}

double termTorque(const Effect& effect, const std::vector<double>& p, const Situation& at) {
  const Term term = effect.term(p, at);
  return term.load_Nm + at.direction * term.friction_Nm;
}

/// The finding's own torque over velocity, or around the turn where it depends on the angle; the band moves each
/// parameter within its interval and takes the extremes.
NamedFigure termFigure(const Diagnosis& d, const Finding& finding, double highSpeed, double lowest, double highest,
                       double peak) {
  const Effect& effect = *findEffect(finding.effect);
  const Axis axis = d.model.axis;
  std::vector<std::vector<double>> sets(1);
  for (const Parameter& one : finding.parameters) sets.front().push_back(one.value);
  for (size_t k = 0; k < finding.parameters.size(); ++k) {
    for (const double end : {finding.parameters[k].low95, finding.parameters[k].high95}) {
      sets.push_back(sets.front());
      sets.back()[k] = end;
    }
  }
  Situation base;
  base.axis = axis;
  base.velocity = 0.3 * highSpeed;
  base.driveTorque = 0.5 * peak;
  base.direction = 1.0;
  Situation moved = base;
  moved.position = lowest + 0.137 * (highest - lowest);
  const bool overPosition = termTorque(effect, sets.front(), base) != termTorque(effect, sets.front(), moved);
  moved = base;
  moved.driveTorque = 0.9 * peak;
  const bool overTorque = termTorque(effect, sets.front(), base) != termTorque(effect, sets.front(), moved);
  const double from = overPosition ? lowest
                      : overTorque ? -peak
                                   : -highSpeed,
               to = overPosition ? highest
                    : overTorque ? peak
                                 : highSpeed;
  Curve curve{.label = finding.effect, .x = {}, .y = {}, .colour = 0};
  constexpr int points = 400;
  for (int k = 0; k <= points; ++k) {
    const double at = from + (to - from) * k / points;
    Situation situation = base;
    if (overPosition)
      situation.position = at;
    else if (overTorque)
      situation.driveTorque = at;
    else {
      situation.velocity = at;
      situation.direction = at < 0.0 ? -1.0 : 1.0;
    }
    double low = 1e300, high = -1e300;
    for (const auto& set : sets) {
      const double value = termTorque(effect, set, situation);
      low = std::min(low, value);
      high = std::max(high, value);
    }
    curve.x.push_back(at);
    curve.y.push_back(termTorque(effect, sets.front(), situation));
    curve.low.push_back(low);
    curve.high.push_back(high);
  }
  Figure figure{.title = finding.effect + ": the term itself",
                .xLabel = overPosition           ? positionLabel(axis)
                          : overTorque           ? "drive " + torqueLabel(axis)
                          : axis == Axis::rotary ? "velocity / rad/s"
                                                 : "velocity / m/s",
                .yLabel = "opposing " + torqueLabel(axis)};
  figure.curves.push_back(std::move(curve));
  return {"term_" + finding.effect,
          "What the effect adds against growing position, with its 95 % interval" +
              std::string(overTorque ? " (while moving towards growing position)." : "."),
          figure};
}

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
    for (const Parameter& one : term.parameters) add(term.effect, one, "");
  }
  return rows;
}

std::string listOf(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "" : ", ") + name;
  return out;
}

HtmlReport buildReport(const Diagnosis& d, const Bench& bench, const std::vector<Recording>& recordings,
                       const std::vector<Recording>& heldout, const std::vector<NamedFigure>& figures) {
  HtmlReport report("Diagnosis: where simulation and recording part", bench.name);
  const std::string words = inWords(d);
  report.verdict(words.substr(0, words.find('\n')));
  for (const Finding& finding : d.findings) report.paragraph(finding.sentence);
  const auto percent = [](double part) { return numberText(100.0 * part, 3) + " %"; };
  const std::string unit = bench.axis == Axis::rotary ? " rad" : " m";
  report.facts(
      {{"Held-out error before", numberText(d.fit.heldoutBefore) + unit},
       {"Held-out error after", numberText(d.fit.heldoutAfter) + unit},
       {"Improvement, 95 % interval", percent(d.fit.improvementLow95) + " to " + percent(d.fit.improvementHigh95)},
       {"Training error before, after",
        numberText(d.fit.trainBefore) + unit + ", " + numberText(d.fit.trainAfter) + unit},
       {"A perfect model would show", numberText(d.fit.floor) + unit},
       {"Windows", "restarted every " + numberText(d.fit.window_s) + " s; root mean square of " + d.fit.channel},
       {"Held out", d.fit.separateRecording ? "separate recordings"
                                            : "parts of the recordings, at least 1 s away from any training sample"},
       {"Left unexplained", percent(d.unexplainedShare) + " of the excess squared error"}});
  if (!d.findings.empty()) {
    report.heading("What is missing");
    std::vector<std::vector<std::string>> rows;
    for (const Finding& finding : d.findings) {
      rows.push_back(
          {finding.effect, percent(finding.share), numberText(finding.pValue, 2), listOf(finding.ambiguousWith)});
    }
    report.table({"effect", "share of the excess error", "p-value", "can't be told from"}, rows);
    for (const Finding& finding : d.findings) {
      const Effect& effect = *findEffect(finding.effect);
      report.details("How " + finding.effect + " is modelled",
                     {std::string(effect.formula()), "Source: " + std::string(effect.source()) + "."});
    }
  }
  if (!d.where.empty()) {
    report.heading("Where it shows");
    std::vector<std::string> items;
    for (const Place& place : d.where)
      items.push_back(place.sentence + " (" + percent(place.share) +
                      " of the unexplained square, p = " + numberText(place.pValue, 2) + ")");
    report.list(items);
  }
  report.heading("Pictures");
  for (const NamedFigure& one : figures) report.figure(one.figure, one.caption);
  report.heading("Parameters");
  report.table({"part", "parameter", "base model alone", "value", "95 % from", "95 % to"}, parameterRows(d));
  if (!d.nextSentence.empty()) {
    report.heading("Next experiment");
    report.paragraph(d.nextSentence);
  }
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

std::vector<NamedFigure> diagnosisFigures(const Diagnosis& d, const std::vector<Recording>& recordings,
                                          const std::vector<Recording>& heldout) {
  std::vector<NamedFigure> figures;
  addTimeFigures(figures, d, recordings.front(), "training recording");
  if (!heldout.empty()) addTimeFigures(figures, d, heldout.front(), "held-out recording");
  addWhereFigures(figures, d, recordings);
  const auto trace = simulate(d.model, recordings.front(), {d.fit.window_s});
  const std::vector<double> positions = positionsOf(recordings.front(), d.model.axis);
  double lowest = 1e300, highest = -1e300, speed = 0.0;
  for (const double position : positions) {
    if (!std::isfinite(position)) continue;
    lowest = std::min(lowest, position);
    highest = std::max(highest, position);
  }
  if (trace) {
    for (const double v : trace->velocity) speed = std::max(speed, std::abs(v));
  }
  const auto tracks = tracksOf(d.model, recordings);
  const double peak = tracks ? excitationOf(*tracks, d.model).peakTorque : 1.0;
  for (const Finding& finding : d.findings) figures.push_back(termFigure(d, finding, speed, lowest, highest, peak));
  return figures;
}

Result<void> writeDiagnosisFolder(const Diagnosis& d, const Bench& bench, const std::vector<Recording>& recordings,
                                  const std::vector<Recording>& heldout, const std::string& folder) {
  if (auto done = makeFolder(folder + "/figures"); !done) return done;
  if (auto done = writeModel(d.base, folder + "/base_model.json"); !done) return done;
  if (auto done = writeModel(d.model, folder + "/model.json"); !done) return done;
  const auto figures = diagnosisFigures(d, recordings, heldout);
  for (const NamedFigure& one : figures) {
    if (auto done = writeSvg(one.figure, folder + "/figures/" + one.name + ".svg"); !done) return done;
  }
  if (auto done = buildReport(d, bench, recordings, heldout, figures).write(folder + "/report.html"); !done)
    return done;
  return writeDiagnosis(d, folder + "/diagnosis.json");
}

}  // namespace breakaway
