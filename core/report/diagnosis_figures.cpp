#include "report/diagnosis_figures.h"

#include <algorithm>
#include <cmath>

#include "base/marked_text.h"
#include "base/numbers.h"
#include "diagnose/fit/motion.h"
#include "diagnose/fit/torque_residual.h"
#include "diagnose/simulate/simulation.h"
#include "diagnose/verdict/explained.h"
#include "diagnose/verdict/where.h"
#include "draw/html_report.h"
#include "report/error_bars.h"
#include "report/term_figures.h"

namespace breakaway {

namespace {

constexpr int wanderColour = 2, measuredColour = 6;

/// A track with what both models make of it: of its motion, or of its torque where that alone can be foreseen.
struct Replay {
  Track track;
  Trace before, after;
  TorqueTrace torqueBefore, torqueAfter;
};

std::vector<Replay> replays(const Diagnosis& d, const std::vector<Recording>& recordings,
                            const std::vector<Recording>& heldout) {
  std::vector<Replay> out;
  for (const auto* group : {&recordings, &heldout}) {
    for (const Recording& recording : *group) {
      auto track =
          makeTrack(recording, d.model.axis, d.model.input, d.model.supply_V, d.model.count, d.model.servo.has_value());
      if (!track) return {};
      track->motion = motionOf(*track);
      out.push_back({std::move(*track), {}, {}, {}, {}});
    }
  }
  return out;
}

void simulateBoth(const Diagnosis& d, Replay& replay) {
  if (d.fit.inTorque()) {
    if (!replay.torqueBefore.torque.empty()) return;
    replay.torqueBefore = torqueTrace(d.base, replay.track);
    replay.torqueAfter = torqueTrace(d.model, replay.track);
    return;
  }
  if (!replay.before.position.empty()) return;
  replay.before = simulate(d.base, replay.track, d.fit.window_s);
  replay.after = simulate(d.model, replay.track, d.fit.window_s);
}

/// Rows [first, last] of a trace over time, with a gap before every restart, so that a picture doesn't join what isn't
/// joined; less the measurement where `error`.
Curve traceCurve(const Replay& replay, const Trace& trace, size_t first, size_t last, double scale, bool error) {
  Curve curve;
  for (size_t k = first; k <= last; ++k) {
    curve.x.push_back(replay.track.origin_s + replay.track.time[k]);
    curve.y.push_back(scale * (error ? replay.track.position[k] - trace.position[k] : trace.position[k]));
  }
  for (const size_t row : trace.restarts) {
    if (row > first && row <= last) curve.y[row - 1 - first] = std::nan("");
  }
  return curve;
}

void addModels(Figure& figure, const Diagnosis& d, const Replay& replay, size_t first, size_t last, bool error) {
  const double scale = shownIn(d.model.axis).scale;
  Curve before = traceCurve(replay, replay.before, first, last, scale, error);
  before.label = message(beforeLabel);
  before.colour = beforeColour;
  figure.curves.push_back(std::move(before));
  if (d.findings.empty()) return;
  Curve after = traceCurve(replay, replay.after, first, last, scale, error);
  after.label = message(afterLabel);
  after.colour = afterColour;
  figure.curves.push_back(std::move(after));
}

/// What both models leave of the torque from one row to another, with the band in which a perfect one's would stay.
void addTorques(Figure& figure, const Diagnosis& d, const Replay& replay, size_t first, size_t last) {
  const Shown shown = leftIn(d.model.axis);
  const double from_s = replay.track.time[first], to_s = replay.track.time[last];
  const double wander = shown.scale * normal95 * std::max(d.fit.floor, d.fit.floorWithWander);
  figure.curves.push_back({.label = message("95 % of what a perfect model leaves"),
                           .x = {replay.track.origin_s + from_s, replay.track.origin_s + to_s},
                           .y = {0.0, 0.0},
                           .low = {-wander, -wander},
                           .high = {wander, wander},
                           .colour = wanderColour});
  const auto add = [&](const TorqueTrace& trace, const Message& label, int colour) {
    Curve curve{.label = label, .x = {}, .y = {}, .colour = colour};
    for (size_t k = 0; k < trace.torque.size(); ++k) {
      if (trace.time_s[k] < from_s || trace.time_s[k] > to_s) continue;
      curve.x.push_back(replay.track.origin_s + trace.time_s[k]);
      curve.y.push_back(shown.scale * trace.torque[k]);
    }
    figure.curves.push_back(std::move(curve));
  };
  add(replay.torqueBefore, message(beforeLabel), beforeColour);
  if (!d.findings.empty()) add(replay.torqueAfter, message(afterLabel), afterColour);
}

Message errorLabel(const Diagnosis& d) {
  if (!d.fit.inTorque()) return message("measured − simulated / {}", shownIn(d.model.axis).unit);
  return d.model.axis == Axis::rotary ? message("torque left / mNm") : message("force left / N");
}

/// One held-out window between its neighbours: the motion and, beneath, the error.
void addWindow(std::vector<NamedFigure>& figures, const Diagnosis& d, const Replay& replay, const Block& block,
               const std::string& name) {
  const Message which = name == "worst" ? message("worst") : message("typical");
  const Track& track = replay.track;
  const double begin = block.start_s - track.origin_s, length = d.fit.window_s;
  const auto rowAt = [&track](double t) {
    const auto at = std::lower_bound(track.time.begin(), track.time.end(), t - 1e-9);
    return std::min(static_cast<size_t>(at - track.time.begin()), track.rows() - 1);
  };
  const size_t first = rowAt(begin - length), last = rowAt(begin + 2.0 * length);
  const Shown shown = shownIn(d.model.axis);
  const Shown counted = d.fit.inTorque() ? leftIn(d.model.axis) : shown;
  Figure motion{.title = d.fit.inTorque() ? message("Measured, {} held-out window", which)
                                          : message("Measured and simulated, {} held-out window", which),
                .xLabel = message("time / s"),
                .yLabel = d.model.axis == Axis::rotary ? message("angle / °") : message("position / mm")};
  motion.highlights.push_back({block.start_s, block.start_s + length, which});
  Curve measured{.label = message("measured"), .x = {}, .y = {}, .colour = measuredColour, .width_px = 2.6};
  for (size_t k = first; k <= last; ++k) {
    measured.x.push_back(track.origin_s + track.time[k]);
    measured.y.push_back(track.seen[k] != 0 ? shown.scale * track.position[k] : std::nan(""));
  }
  Figure error{.title = d.fit.inTorque() ? message("What the model leaves of the drive there")
                                         : message("What the simulation misses there"),
               .xLabel = message("time / s"),
               .yLabel = errorLabel(d),
               .highlights = motion.highlights};
  motion.curves.push_back(std::move(measured));
  if (d.fit.inTorque()) {
    addTorques(error, d, replay, first, last);
  } else {
    addModels(motion, d, replay, first, last, false);
    addModels(error, d, replay, first, last, true);
  }
  const Message place = message("{}, from {} s", block.recording, numberText(block.start_s));
  const std::string space = d.fit.inTorque() ? " " : "";
  figures.push_back(
      {name + "_motion",
       d.fit.inTorque()
           ? message("{}. This motion can't be foreseen from the drive: what is compared is the torque along it.",
                     place)
           : message("{}. The simulation knows the drive alone and starts again from the measurement every {} s.",
                     place, numberText(length, 2)),
       motion});
  figures.push_back({name + "_error",
                     message("In this window {} rms before, {} after.",
                             numberText(counted.scale * block.before, 3) + space + counted.unit,
                             numberText(counted.scale * block.after, 3) + space + counted.unit),
                     error});
}

void addWholeResidual(std::vector<NamedFigure>& figures, const Diagnosis& d, const Replay& replay) {
  const bool inTorque = d.fit.inTorque();
  Figure figure{.title = inTorque ? message("What the model leaves of the drive, whole recording")
                                  : message("What the simulation misses, whole recording"),
                .xLabel = message("time / s"),
                .yLabel = errorLabel(d)};
  if (inTorque) {
    addTorques(figure, d, replay, 0, replay.track.rows() - 1);
  } else {
    addModels(figure, d, replay, 0, replay.track.rows() - 1, true);
  }
  for (const auto& [first, last] : d.heldoutRows) {
    const double from = replay.track.time[first];
    const double to = replay.track.time[std::min(last, replay.track.rows()) - 1];
    figure.highlights.push_back({replay.track.origin_s + from, replay.track.origin_s + to, message("held out")});
  }
  figures.push_back(
      {"training_residual",
       inTorque
           ? message("{}. The smaller, the better the model; gaps: no clear motion.", replay.track.name)
           : message("{}. The smaller, the better the model; restarts set it back to nearly zero.", replay.track.name),
       figure});
}

/// Scale and label of a map's axis and of its values, as people read them.
struct MapText {
  double scale = 1.0, valueScale = 1.0;
  Message name, label, value;
};

Message axisName(const ResidualMap& map, Axis axis) {
  if (map.axis == "reversal") return message("travel since reversal");
  if (map.axis == "current" && map.unit != "A")
    return map.unit == "N" ? message("motor force") : message("motor torque");
  if (map.axis == "angle") return axis == Axis::linear ? message("position") : message("angle");
  return map.axis == "velocity"       ? message("velocity")
         : map.axis == "time"         ? message("time")
         : map.axis == "frequency"    ? message("frequency")
         : map.axis == "current"      ? message("current")
         : map.axis == "acceleration" ? message("acceleration")
         : map.axis == "temperature"  ? message("temperature")
                                      : Message(map.axis);
}

MapText textOf(const ResidualMap& map, Axis axis) {
  MapText text;
  const bool rotary = axis == Axis::rotary;
  std::string unit = map.unit;
  if (map.unit == "rad" || map.unit == "m") {
    text.scale = shownIn(axis).scale;
    unit = shownIn(axis).unit;
  } else if (map.unit == "Nm") {
    text.scale = 1e3;
    unit = "mNm";
  }
  text.name = axisName(map, axis);
  text.label = text.name + " / " + Message(unit);
  text.valueScale = rotary ? 1e3 : 1.0;
  text.value = rotary ? message("unexplained torque / mNm") : message("unexplained force / N");
  if (map.shows == Unknown::friction)
    text.value = rotary ? message("unexplained friction / mNm") : message("unexplained friction / N");
  if (map.shows == Unknown::voltage) {
    text.valueScale = 1.0;
    text.value = message("unexplained voltage / V");
  }
  return text;
}

Curve bandOf(const ResidualMap& map, const MapText& text, const Message& label, int colour) {
  Curve curve{.label = label, .x = {}, .y = {}, .colour = colour};
  for (size_t k = 0; k < map.centre.size(); ++k) {
    curve.x.push_back(text.scale * map.centre[k]);
    curve.y.push_back(text.valueScale * map.mean[k]);
    curve.low.push_back(text.valueScale * (map.mean[k] - normal95 * map.error[k]));
    curve.high.push_back(text.valueScale * (map.mean[k] + normal95 * map.error[k]));
  }
  return curve;
}

Model withoutEffects(Model model) {
  model.effects.clear();
  return model;
}

/// What the findings say of what the base model leaves.
Curve lawOf(const Course& course, const MapText& text) {
  Curve curve{.label = message("what the findings say of it"), .x = {}, .y = {}, .colour = measuredColour};
  for (size_t k = 0; k < course.at.size(); ++k) {
    curve.x.push_back(text.scale * course.at[k]);
    curve.y.push_back(text.valueScale * course.value[k]);
  }
  return curve;
}

/// The map that a place was found in, of those that one model leaves; null where there is none.
const ResidualMap* mapOf(const Place& place, const std::vector<ResidualMap>& maps) {
  const ResidualMap* found = nullptr;  // of several ranges of speeds the one that shows more
  for (const ResidualMap& map : maps) {
    const bool same = map.axis == place.axis && map.unit == place.unit && map.shows == place.shows &&
                      map.ofSomeSpeeds() == place.ofSomeSpeeds;
    if (same && (found == nullptr || showsMore(map, *found))) found = &map;
  }
  return found;
}

/// The unexplained over each axis where it showed, before and after.
void addWhereFigures(std::vector<NamedFigure>& figures, const Diagnosis& d, const std::vector<Track>& tracks) {
  const auto before = residualMaps(d.base, tracks, 1), after = residualMaps(d.model, tracks, 1);
  for (const Place& place : d.where) {
    const ResidualMap* map = mapOf(place, before);
    const std::string name = "where_" + place.axis + (place.shows == Unknown::voltage ? "_voltage" : "");
    const bool drawn =
        std::any_of(figures.begin(), figures.end(), [&name](const NamedFigure& one) { return one.name == name; });
    if (map == nullptr || drawn) continue;
    const MapText text = textOf(*map, d.model.axis);
    Figure figure{.title = message("Where: over {}", text.name), .xLabel = text.label, .yLabel = text.value};
    figure.logX = map->axis == "frequency";
    figure.curves.push_back(bandOf(*map, text, message(beforeLabel), beforeColour));
    const ResidualMap* same = mapOf(place, after);
    if (!d.findings.empty() && same != nullptr)
      figure.curves.push_back(bandOf(*same, text, message(afterLabel), afterColour));
    if (!d.findings.empty() && map->axis != "frequency" && !map->ofSomeSpeeds())
      figure.curves.push_back(lawOf(explainedOver(*map, withoutEffects(d.model), d.model, tracks), text));
    figure.highlights.push_back({text.scale * place.from, text.scale * place.to, message("most here")});
    figures.push_back({name, message("{} Bands: 95 %.", place.sentence), figure});
  }
}

}  // namespace

std::vector<NamedFigure> diagnosisFigures(const Diagnosis& d, const std::vector<Recording>& recordings,
                                          const std::vector<Recording>& heldout) {
  std::vector<NamedFigure> figures;
  std::vector<Replay> all = replays(d, recordings, heldout);
  if (all.empty()) return figures;
  std::vector<Track> training;
  training.reserve(recordings.size());
  for (size_t k = 0; k < recordings.size(); ++k) training.push_back(all[k].track);
  addWhereFigures(figures, d, training);
  for (NamedFigure& term : termFigures(d, training)) figures.push_back(std::move(term));
  for (const auto& [block, which] : {std::pair{&d.proof.typical, "typical"}, std::pair{&d.proof.worst, "worst"}}) {
    if (block->recording.empty() || block->track >= all.size()) continue;
    simulateBoth(d, all[block->track]);
    addWindow(figures, d, all[block->track], *block, which);
  }
  simulateBoth(d, all.front());
  addWholeResidual(figures, d, all.front());
  return figures;
}

}  // namespace breakaway
