#include "figures/homing_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/numbers.h"
#include "base/statistics.h"

namespace breakaway {

namespace {

/// To and fro between ±1, from 0 upwards.
double triangle(double periods) {
  const double within = periods - std::floor(periods);
  return within < 0.25 ? 4.0 * within : within < 0.75 ? 2.0 - 4.0 * within : 4.0 * within - 4.0;
}

struct Passage {
  double place_rad = 0.0;
  Way way = Way::ccw;
};

/// Half way between two samples, the second of which is the first to show the index; the way is that of the samples
/// around.
std::vector<Passage> passagesOf(const std::vector<Sample>& samples) {
  constexpr size_t around = 20;
  std::vector<Passage> passages;
  for (size_t k = around; k + around < samples.size(); ++k) {
    const Sample &before = samples[k - 1], &here = samples[k];
    if (!here.index || before.index) continue;
    const bool grows = samples[k + around].angle_rad > samples[k - around].angle_rad;
    passages.push_back({0.5 * (before.angle_rad + here.angle_rad), grows ? Way::ccw : Way::cw});
  }
  return passages;
}

double scatterOf(const std::vector<double>& values) {
  std::vector<double> off;
  off.reserve(values.size());
  for (const double value : values) off.push_back(value - mean(values));
  return rms(off);
}

}  // namespace

Result<BenchFigure> indexPassesFigure(CommissionedBench& bench, const IndexPassesOptions& options) {
  const double index_rad = bench.measured.indexAngle_rad.value;
  const double count_rad = turn_rad / bench.measured.identity.countsPerRev;
  const double period_s = 4.0 * options.reach_rad / options.speed_rad_per_s;
  CourseOptions course;
  course.activity = "passing the index";
  const auto seen = angleNow(bench);
  if (!seen) return seen.error();
  // Whole turns from where homing saw it.
  const double here_rad = index_rad + turn_rad * std::round((*seen - index_rad) / turn_rad);
  course.before = {Command::Mode::position, here_rad - options.reach_rad, 0.0, false};
  course.before_s = 1.5;
  course.duration_s = period_s * (static_cast<double>(options.passes) + 0.25);  // the last passage lags
  course.command = [period_s, here_rad, reach = options.reach_rad](double time_s, const Sample&) {
    return Command{Command::Mode::position, here_rad + reach * triangle(time_s / period_s - 0.25), 0.0, false};
  };
  const auto ran = runCourse(bench, course, CompensatedFriction::none);
  if (!ran) return ran.error();
  BenchFigure figure{"index-passes",
                     "The rotor goes to and fro over the encoder's index; each point is the place at which one passage "
                     "first showed it, counted from where homing found the index.",
                     {"Passages of the index", "passage", "place from homing's / counts"},
                     {{"passage", {}}, {"way", {}}, {"place_rad", {}}, {"place_counts", {}}}};
  std::array<std::vector<double>, 2> places;
  std::array<Curve, 2> points{Curve{"clockwise", {}, {}}, Curve{"counter-clockwise", {}, {}}};
  for (const Passage& one : passagesOf(ran->samples)) {
    const double place_rad = one.place_rad - here_rad;
    const auto number = static_cast<double>(figure.columns[0].values.size() + 1);
    const double row[] = {number, signOf(one.way), place_rad, place_rad / count_rad};
    for (size_t k = 0; k < figure.columns.size(); ++k) figure.columns[k].values.push_back(row[k]);
    const auto way = static_cast<size_t>(one.way);
    places[way].push_back(place_rad);
    points[way].x.push_back(number);
    points[way].y.push_back(place_rad / count_rad);
  }
  if (places[0].empty() || places[1].empty()) return Error{"index-passes", "the index wasn't passed both ways"};
  for (size_t way = 0; way < 2; ++way) {
    points[way].style = Curve::Style::points;
    points[way].width_px = 4.0;
    points[way].colour = static_cast<int>(way);
    figure.figure.curves.push_back(std::move(points[way]));
    const std::string name = way == 0 ? "cw" : "ccw";
    figure.keyNumbers.emplace_back("mean_" + name + "_rad", mean(places[way]));
    figure.keyNumbers.emplace_back("scatter_" + name + "_rad", scatterOf(places[way]));
    figure.keyNumbers.emplace_back("passages_" + name, static_cast<double>(places[way].size()));
  }
  figure.figure.yRange = std::pair(-3.0, 3.0);
  for (const double place : figure.columns[3].values) {
    figure.figure.yRange->first = std::min(figure.figure.yRange->first, place - 1.0);
    figure.figure.yRange->second = std::max(figure.figure.yRange->second, place + 1.0);
  }
  figure.keyNumbers.emplace_back("ways_apart_counts", (mean(places[1]) - mean(places[0])) / count_rad);
  figure.keyNumbers.emplace_back("count_rad", count_rad);
  return figure;
}

}  // namespace breakaway
