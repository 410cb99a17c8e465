#include "report/run_comparison.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/made.h"
#include "base/typeset.h"
#include "draw/html_report.h"
#include "draw/svg_polar.h"
#include "friction/map_export.h"
#include "recording/block_file.h"
#include "report/map_figures.h"

namespace breakaway {

namespace {

using Json = nlohmann::ordered_json;

double halfWidth(const RunValue& value) {
  return 0.5 * (value.high - value.low);
}

ValueChange changeOf(const RunValue& before, const RunValue& after) {
  const double allowed = std::hypot(halfWidth(before), halfWidth(after));
  return {before, after, allowed > 0.0 && std::abs(after.value - before.value) > allowed};
}

Message numberAndInterval(const RunValue& value) {
  return message("{} ({} to {})", numberText(value.value, 3), numberText(value.low, 3), numberText(value.high, 3));
}

std::string percent(const ValueChange& change) {
  if (change.before.value == 0.0) return "";
  return typeset(fmt::format("{:+.3g} %", 100.0 * (change.after.value / change.before.value - 1.0)));
}

Message kindOf(const ProjectRun& run) {
  const Message known[] = {message("commission"), message("identification"), message("map"),  message("diagnosis"),
                           message("tuning"),     message("recording"),      message("files")};
  const auto* found = std::find(std::begin(known), std::end(known), run.kind);
  return found == std::end(known) ? Message(run.kind) : *found;
}

/// "commission of 2026-03-02, 8b504e58 (before greasing)".
Message nameOf(const ProjectRun& run) {
  const Message name = message("{} of {}, {}", kindOf(run), run.at.substr(0, 10), run.id);
  return run.name.empty() ? name : name + (" (" + run.name + ")");
}

/// Those of `all` whose effect, the part before the colon, `others` don't have.
std::vector<std::string> without(const std::vector<std::string>& all, const std::vector<std::string>& others) {
  const auto effect = [](const std::string& finding) { return finding.substr(0, finding.find(':')); };
  std::vector<std::string> rest;
  for (const std::string& one : all) {
    const bool there = std::any_of(others.begin(), others.end(),
                                   [&](const std::string& other) { return effect(other) == effect(one); });
    if (!there) rest.push_back(one);
  }
  return rest;
}

Result<std::optional<FrictionMap>> mapOf(const Project& project, const ProjectRun& run) {
  const RunFile* file = run.file("map");
  if (file == nullptr) return std::optional<FrictionMap>();
  auto map = readMap(project.pathOf(run, file->path));
  if (!map) return map.error();
  return std::optional<FrictionMap>(std::move(*map));
}

/// What a run is about that is a recording, and nothing else.
bool isRecording(const ProjectRun& run) {
  return run.kind == "recording" && run.state != RunState::recording && run.file("recording") != nullptr;
}

Result<std::optional<RecordingComparison>> recordingsOf(const Project& project, const RunComparison& comparison) {
  if (!isRecording(comparison.before) || !isRecording(comparison.after)) return std::optional<RecordingComparison>();
  const auto read = [&project](const ProjectRun& run) {
    return readRecording(project.pathOf(run, run.file("recording")->path));
  };
  const auto before = read(comparison.before), after = read(comparison.after);
  if (!before) return before.error();
  if (!after) return after.error();
  auto compared = compareRecordings(*before, *after);
  return compared.channels.empty() ? std::optional<RecordingComparison>() : std::optional(std::move(compared));
}

std::string placeText(double place, Axis axis) {
  const MapUnits& units = mapUnitsOf(axis);
  return axis == Axis::rotary ? numberText(units.placeScale * place, 3) + "°" : numberText(1e3 * place, 3) + " mm";
}

Message sentenceOf(const MapChange& change, Axis axis) {
  const MapUnits& units = mapUnitsOf(axis);
  const double scale = units.torqueScale;
  return message(
      "{}: {:+.3g} {} on average (±{:.2g}); {} of {} bins beyond their intervals, by chance {:.0f}; the largest "
      "difference is {:+.3g} {} at {}.",
      change.quantity, scale * change.meanDifference, units.torqueUnit, scale * change.meanHalfWidth, change.beyond,
      change.bins, change.byChance, scale * change.largest, units.torqueUnit, placeText(change.largestAt, axis));
}

Message sentenceOf(const ValueChange& change) {
  const Message sentence =
      message("{}: {} → {}", change.before.name, numberAndInterval(change.before), numberAndInterval(change.after));
  return percent(change).empty() ? sentence : sentence + (", " + percent(change));
}

Message motorOf(const ProjectRun& run) {
  return run.motor.empty() ? message("one without serial number") : Message(run.motor);
}

Message indented(const Message& sentence) {
  return "  " + sentence + "\n";
}

struct Words {
  Message runs, changed, within;  ///< lines
};

Words wordsOf(const RunComparison& comparison) {
  Message beyond, within;
  const auto add = [&](bool isBeyond, const Message& sentence) {
    Message& to = isBeyond ? beyond : within;
    to = to + indented(sentence);
  };
  for (const ValueChange& change : comparison.values) add(change.beyond, sentenceOf(change));
  for (const MapChange& change : comparison.maps) add(change.isBeyond(), sentenceOf(change, comparison.mapAfter->axis));
  for (const std::string& one : comparison.findingsNew) add(true, message("new finding: {}", one));
  for (const std::string& one : comparison.findingsGone) add(true, message("no longer found: {}", one));
  Words words{nameOf(comparison.before) + " → " + nameOf(comparison.after) + "\n", {}, {}};
  if (comparison.before.motor != comparison.after.motor)
    words.changed = message("Of two motors: {} and {}.", motorOf(comparison.before), motorOf(comparison.after)) + "\n";
  if (comparison.recordings) {
    words.within =
        message("The recordings, over the {:.4g} s that both last, laid over each other from their beginnings:",
                comparison.recordings->length_s) +
        "\n";
    for (const ChannelChange& one : comparison.recordings->channels)
      words.within = words.within + indented(sentenceOf(one));
    return words;
  }
  words.changed = words.changed + (beyond.empty() ? message("Nothing has changed beyond the 95 % intervals.") + "\n"
                                                  : message("Changed beyond the 95 % intervals:") + "\n" + beyond);
  if (!within.empty()) words.within = message("Within them:") + "\n" + within;
  return words;
}

}  // namespace

Result<RunComparison> compareRuns(const Project& project, const ProjectRun& one, const ProjectRun& other) {
  const bool inOrder = one.at <= other.at;
  RunComparison comparison{inOrder ? one : other, inOrder ? other : one, {}, {}, {}, {}, {}, {}, {}};
  if (one.id == other.id) return Error{project.folder(), "run " + one.id + " is compared with itself, expected two"};
  for (const RunValue& before : comparison.before.values) {
    if (const RunValue* after = comparison.after.value(before.name); after != nullptr)
      comparison.values.push_back(changeOf(before, *after));
  }
  auto before = mapOf(project, comparison.before), after = mapOf(project, comparison.after);
  if (!before) return before.error();
  if (!after) return after.error();
  if (*before && *after && (**before).axis == (**after).axis) {
    comparison.maps = compareMaps(**before, **after);
    comparison.mapBefore = std::move(*before);
    comparison.mapAfter = std::move(*after);
  }
  comparison.findingsGone = without(comparison.before.findings, comparison.after.findings);
  comparison.findingsNew = without(comparison.after.findings, comparison.before.findings);
  auto recordings = recordingsOf(project, comparison);
  if (!recordings) return recordings.error();
  comparison.recordings = std::move(*recordings);
  const bool bothDiagnoses = !comparison.before.verdict.empty() && !comparison.after.verdict.empty();
  if (comparison.values.empty() && comparison.maps.empty() && !bothDiagnoses && !comparison.recordings)
    return Error{project.folder(), "runs " + one.id + " and " + other.id + " have no result in common"};
  return comparison;
}

Message inWords(const RunComparison& comparison) {
  const Words words = wordsOf(comparison);
  return words.runs + words.changed + words.within;
}

std::string comparisonJson(const RunComparison& comparison) {
  const auto side = [](const ProjectRun& run) {
    return Json{{"run", run.id}, {"kind", run.kind}, {"at", run.at}, {"name", run.name}, {"motor", run.motor}};
  };
  const auto interval = [](const RunValue& value) {
    return Json{{"value", value.value}, {"ci95", {value.low, value.high}}};
  };
  Json json{{"schema", "breakaway.comparison/1"},
            {"before", side(comparison.before)},
            {"after", side(comparison.after)},
            {"values", Json::array()},
            {"map", Json::array()}};
  for (const ValueChange& one : comparison.values)
    json["values"].push_back({{"name", one.before.name},
                              {"before", interval(one.before)},
                              {"after", interval(one.after)},
                              {"beyond_intervals", one.beyond}});
  const bool linear = comparison.mapAfter && comparison.mapAfter->axis == Axis::linear;
  const std::string unit = linear ? "_N" : "_Nm";
  for (const MapChange& one : comparison.maps)
    json["map"].push_back({{"quantity", one.quantity},
                           {"bins", one.bins},
                           {"bins_beyond_intervals", one.beyond},
                           {"by_chance", one.byChance},
                           {"mean_difference" + unit, one.meanDifference},
                           {"mean_difference_ci95" + unit,
                            {one.meanDifference - one.meanHalfWidth, one.meanDifference + one.meanHalfWidth}},
                           {"largest_difference" + unit, one.largest},
                           {linear ? "largest_at_m" : "largest_at_rad", one.largestAt},
                           {"beyond_intervals", one.isBeyond()}});
  json["findings_new"] = comparison.findingsNew;
  json["findings_gone"] = comparison.findingsGone;
  if (comparison.recordings) {
    json["recordings"] = {{"length_s", comparison.recordings->length_s}, {"channels", Json::array()}};
    for (const ChannelChange& one : comparison.recordings->channels)
      json["recordings"]["channels"].push_back({{"channel", one.channel},
                                                {"mean_before", one.meanBefore},
                                                {"mean_after", one.meanAfter},
                                                {"scatter_before", one.rmsBefore},
                                                {"scatter_after", one.rmsAfter},
                                                {"difference_rms", one.differenceRms}});
  }
  json["words"] = inWords(comparison).english();
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<void> writeComparison(const RunComparison& comparison, const std::string& folder, const Catalogue& language) {
  if (auto made = makeFolder(folder + "/figures"); !made) return made;
  HtmlReport report(message("What has changed"), nameOf(comparison.before) + " → " + nameOf(comparison.after),
                    language);
  const Words words = wordsOf(comparison);
  report.verdict(comparison.recordings ? words.changed + words.within : words.changed);
  if (comparison.mapBefore && comparison.mapAfter) {
    const Figure ghost = inLanguage(ghostFigure(*comparison.mapBefore, *comparison.mapAfter), language);
    const Figure over = inLanguage(differenceFigure(*comparison.mapBefore, *comparison.mapAfter), language);
    const std::string map = ghost.polar ? toPolarSvg(ghost, 720, 760) : toSvg(ghost);
    report.heading(message("The maps"));
    report.svg(map, message("Bands are 95 % intervals."));
    report.figure(over);
    if (auto done = writeFile(folder + "/figures/map.svg", svgWithMade(map)); !done) return done;
    if (auto done = writeSvg(over, folder + "/figures/difference.svg"); !done) return done;
    report.list([&] {
      std::vector<Saying> lines;
      lines.reserve(comparison.maps.size());
      for (const MapChange& one : comparison.maps) lines.push_back(sentenceOf(one, comparison.mapAfter->axis));
      return lines;
    }());
  }
  if (comparison.recordings) {
    report.heading(message("The recordings"));
    for (size_t k = 0; k < comparison.recordings->figures.size(); ++k) {
      const Figure figure = inLanguage(comparison.recordings->figures[k], language);
      report.figure(figure);
      const std::string path = folder + "/figures/" + comparison.recordings->channels[k].channel + ".svg";
      if (auto done = writeSvg(figure, path); !done) return done;
    }
  }
  if (!comparison.values.empty()) {
    std::vector<std::vector<Saying>> rows;
    rows.reserve(comparison.values.size());
    for (const ValueChange& one : comparison.values)
      rows.push_back({one.before.name, numberAndInterval(one.before), numberAndInterval(one.after), percent(one),
                      one.beyond ? message("yes") : Message()});
    report.heading(message("The results"));
    report.table(
        {message("result"), message("before"), message("after"), message("change"), message("beyond the intervals")},
        rows);
  }
  if (auto done = report.write(folder + "/report.html"); !done) return done;
  return writeFile(folder + "/comparison.json", withMade(comparisonJson(comparison)));
}

}  // namespace breakaway
