#include "figures/friction_figures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/numbers.h"
#include "base/statistics.h"
#include "draw/html_report.h"

namespace breakaway {

namespace {

constexpr size_t differencesPerTurn = 60;  // half the span over which the inertia's torque is taken: 6°
constexpr std::array<const char*, 2> ways{"cw", "ccw"};
constexpr std::array<const char*, 2> wayLabels{"clockwise", "counter-clockwise"};

Channel angles(const FrictionMap& map) {
  Channel angle{"angle_rad", {}};
  for (const MapBin& bin : map.bins) angle.values.push_back(bin.angle_rad);
  return angle;
}

template <typename Get>
Channel aroundTurn(const FrictionMap& map, const std::string& name, Get get) {
  Channel channel{name, {}};
  for (const MapBin& bin : map.bins) channel.values.push_back(get(bin));
  return channel;
}

/// The raw slope of torque over speed in each bin of one way's runs; NaN where a bin has fewer than two speeds.
std::vector<double> rawViscous(const Commission& measured, Way way, size_t bins) {
  const double Kt = measured.motor.torqueConstant_Nm_per_A.value, J = measured.motor.inertia_kg_m2.value;
  const double sign = signOf(way);
  std::vector<std::array<double, 5>> sums(bins);  // n, Σω, Στ, Σω², Σωτ
  for (const VelocityRun& run : measured.runs) {
    if (run.way() != way || run.bins.empty()) continue;
    const size_t n = run.bins.size();
    const auto speedOf = [&run, n](size_t k) {
      const AngleBinSums& bin = run.bins[k % n];
      return bin.samples == 0 ? std::nan("") : bin.velocity_rad_per_s / static_cast<double>(bin.samples);
    };
    const size_t reach = std::max<size_t>(1, n / differencesPerTurn);
    for (size_t k = 0; k < n; ++k) {
      const double before = speedOf(k + n - reach), here = speedOf(k), after = speedOf(k + reach);
      const double slope = 0.5 * (after * after - before * before) /
                           (2.0 * turn_rad * static_cast<double>(reach) / static_cast<double>(n));
      if (std::isnan(slope) || std::isnan(here)) continue;
      const double current = run.bins[k].current_A / static_cast<double>(run.bins[k].samples);
      const double torque = sign * (Kt * current - J * slope), speed = std::abs(here);
      auto& s = sums[k * bins / n];
      const double row[] = {1.0, speed, torque, speed * speed, speed * torque};
      for (size_t j = 0; j < s.size(); ++j) s[j] += row[j];
    }
  }
  std::vector<double> slopes;
  for (const auto& s : sums) {
    const double spread = s[0] * s[3] - s[1] * s[1];
    slopes.push_back(spread > 1e-9 * s[0] * s[3] ? (s[0] * s[4] - s[1] * s[2]) / spread : std::nan(""));
  }
  return slopes;
}

double relativeScatter(const std::vector<double>& values) {
  const double middle = mean(values);
  std::vector<double> off;
  off.reserve(values.size());
  for (const double value : values) off.push_back(value - middle);
  return rms(off) / std::abs(middle);
}

}  // namespace

BenchFigure constantVelocityFigure(const Commission& measured) {
  BenchFigure figure{"constant-velocity",
                     "The motor torque that keeps each of several speeds, averaged over whole turns, and the straight "
                     "line through it: Coulomb friction F where it meets zero speed, viscous friction B its slope.",
                     {"Torque at constant speed", "speed / rad/s", "torque / mNm"},
                     {{"speed_rad_per_s", {}}, {"torque_Nm", {}}, {"torque_std_Nm", {}}, {"line_Nm", {}}}};
  const double Kt = measured.motor.torqueConstant_Nm_per_A.value;
  for (const VelocityRun& run : measured.runs) {
    const auto& moving = measured.moving[static_cast<size_t>(run.way())];
    const Estimate current = meanCurrent_A(run);
    const double sign = signOf(run.way()), speed = std::abs(run.target_rad_per_s);
    const double line = moving.coulombMean_Nm.value + moving.viscousMean_Nm_s_per_rad.value * speed;
    const double row[] = {run.target_rad_per_s, sign * Kt * current.value, Kt * current.standardError, sign * line};
    for (size_t k = 0; k < 4; ++k) figure.columns[k].values.push_back(row[k]);
  }
  for (size_t w = 0; w < 2; ++w) {
    const double sign = signOf(Way(w));
    Curve points{wayLabels[w], {}, {}}, line{std::string("F + B·ω, ") + wayLabels[w], {0.0}, {}};
    for (size_t k = 0; k < figure.columns[0].values.size(); ++k) {
      if (sign * figure.columns[0].values[k] < 0.0) continue;
      points.x.push_back(figure.columns[0].values[k]);
      points.y.push_back(1e3 * figure.columns[1].values[k]);
      if (std::abs(points.x.back()) > std::abs(line.x.back()))
        line.x.resize(2, points.x.back()), line.x.back() = points.x.back();
    }
    const MovingFriction& moving = measured.moving[w];
    for (const double speed : line.x)
      line.y.push_back(1e3 * (sign * moving.coulombMean_Nm.value + moving.viscousMean_Nm_s_per_rad.value * speed));
    points.style = Curve::Style::points;
    points.width_px = 3.5;
    points.colour = line.colour = static_cast<int>(w);
    figure.figure.curves.push_back(std::move(points));
    figure.figure.curves.push_back(std::move(line));
    const std::string way = ways[w];
    figure.keyNumbers.emplace_back("coulomb_" + way + "_Nm", moving.coulombMean_Nm.value);
    figure.keyNumbers.emplace_back("coulomb_" + way + "_std_Nm", moving.coulombMean_Nm.standardError);
    figure.keyNumbers.emplace_back("viscous_" + way + "_Nm_s_per_rad", moving.viscousMean_Nm_s_per_rad.value);
    figure.keyNumbers.emplace_back("viscous_" + way + "_std_Nm_s_per_rad",
                                   moving.viscousMean_Nm_s_per_rad.standardError);
  }
  return figure;
}

std::vector<BenchFigure> staticFrictionFigures(const Commission& measured) {
  const FrictionMap& map = measured.map;
  std::vector<BenchFigure> figures;
  for (size_t w = 0; w < 2; ++w) {
    BenchFigure figure{std::string("static-friction-") + ways[w],
                       "The motor torque that starts motion from standstill at each angle, turn by turn: each turn is "
                       "measured on its own, so how well they agree says how far the map can be trusted.",
                       {std::string("Static friction, ") + wayLabels[w], "angle / °", "torque / mNm"},
                       {angles(map)}};
    for (size_t k = 0; k < map.turnStatic_Nm[w].size(); ++k) {
      const std::string number = std::to_string(k + 1);
      figure.columns.push_back({"turn_" + number + "_Nm", map.turnStatic_Nm[w][k]});
      figure.figure.curves.push_back(
          drawn(figure, "turn " + number, "angle_rad", "turn_" + number + "_Nm", 1e3, 360.0 / turn_rad));
    }
    figure.columns.push_back(
        aroundTurn(map, "static_Nm", [w](const MapBin& bin) { return bin.way[w].static_Nm.value; }));
    figure.keyNumbers = {{"mean_Nm", mean(columnOf(figure, "static_Nm"))}};
    if (map.turns > 1) {
      figure.keyNumbers.push_back({"correlation_of_turns", map.repeatability[w].correlation});
      figure.keyNumbers.push_back({"rms_difference_of_turns_Nm", map.repeatability[w].rmsDifference_Nm});
    }
    figures.push_back(std::move(figure));
  }
  return figures;
}

BenchFigure breakawayMapFigure(const Commission& measured) {
  const FrictionMap& map = measured.map;
  BenchFigure figure{"breakaway-map",
                     "The motor torque that starts motion from standstill at each angle, the mean over the turns, and "
                     "the 95 % interval of each bin as a band. The centre isn't zero: else the bands couldn't be seen.",
                     {"Breakaway torque around the rotor", "", "torque / mNm"},
                     {angles(map)}};
  figure.figure.polar = true;
  double least_mNm = 1e300, most_mNm = 0.0;
  for (size_t w = 0; w < 2; ++w) {
    const std::string way = ways[w];
    const auto of = [&](const std::string& ending, double (*get)(const Estimate&)) {
      figure.columns.push_back(
          aroundTurn(map, way + ending + "_Nm", [w, get](const MapBin& bin) { return get(bin.way[w].static_Nm); }));
    };
    of("", [](const Estimate& one) { return one.value; });
    of("_low95", [](const Estimate& one) { return one.low95(); });
    of("_high95", [](const Estimate& one) { return one.high95(); });
    Curve curve = drawn(figure, wayLabels[w], "angle_rad", way + "_Nm", 1e3);
    curve.low = drawn(figure, "", "angle_rad", way + "_low95_Nm", 1e3).y;
    curve.high = drawn(figure, "", "angle_rad", way + "_high95_Nm", 1e3).y;
    least_mNm = std::min(least_mNm, *std::min_element(curve.low.begin(), curve.low.end()));
    most_mNm = std::max(most_mNm, *std::max_element(curve.high.begin(), curve.high.end()));
    const auto& values = columnOf(figure, way + "_Nm");
    figure.keyNumbers.emplace_back("mean_" + way + "_Nm", mean(values));
    figure.keyNumbers.emplace_back("half_width_" + way + "_Nm",
                                   mean(columnOf(figure, way + "_high95_Nm")) - mean(values));
    figure.keyNumbers.emplace_back("variation_" + way, relativeScatter(values));
    figure.figure.curves.push_back(std::move(curve));
  }
  figure.figure.yRange = std::pair(std::max(0.0, 0.8 * least_mNm), 1.03 * most_mNm);  // or the bands couldn't be seen
  return figure;
}

std::vector<BenchFigure> viscousFigures(const Commission& measured) {
  const FrictionMap& map = measured.map;
  std::vector<BenchFigure> figures;
  for (size_t w = 0; w < 2; ++w) {
    auto raw = rawViscous(measured, static_cast<Way>(w), map.bins.size());
    auto filtered = aroundTurn(map, "filtered_Nm_s_per_rad",
                               [w](const MapBin& bin) { return bin.way[w].viscous_Nm_s_per_rad.value; });
    for (size_t k = 0; k < raw.size(); ++k) {
      if (std::isnan(raw[k])) raw[k] = filtered.values[k];
    }
    BenchFigure figure{std::string("viscous-") + ways[w],
                       "Raw: the slope over the speeds of each bin's own torque. Filtered: the harmonics of the angle "
                       "that stand out of their noise by 3.5 standard errors.",
                       {std::string("Viscous coefficient, ") + wayLabels[w], "angle / °", "coefficient / µNm s/rad"},
                       {angles(map), {"raw_Nm_s_per_rad", std::move(raw)}, std::move(filtered)}};
    figure.figure.curves = {drawn(figure, "raw", "angle_rad", "raw_Nm_s_per_rad", 1e6, 360.0 / turn_rad),
                            drawn(figure, "filtered", "angle_rad", "filtered_Nm_s_per_rad", 1e6, 360.0 / turn_rad)};
    figure.figure.curves[0].width_px = 1.0;
    figure.figure.curves[0].colour = 4;
    figure.figure.curves[1].colour = 1;
    figure.keyNumbers = {{"mean_Nm_s_per_rad", mean(columnOf(figure, "filtered_Nm_s_per_rad"))},
                         {"raw_variation", relativeScatter(columnOf(figure, "raw_Nm_s_per_rad"))},
                         {"filtered_variation", relativeScatter(columnOf(figure, "filtered_Nm_s_per_rad"))}};
    figures.push_back(std::move(figure));
  }
  return figures;
}

namespace {

/// A polar figure of both ways, closed, from columns cw_Nm and ccw_Nm.
BenchFigure polarFigure(const FrictionMap& map, BenchFigure figure) {
  figure.figure.polar = true;
  for (size_t w = 0; w < 2; ++w) {
    const std::string column = std::string(ways[w]) + "_Nm";
    Curve curve = drawn(figure, wayLabels[w], "angle_rad", column, 1e3);
    if (!curve.x.empty()) {
      curve.x.push_back(curve.x.front() + turn_rad);
      curve.y.push_back(curve.y.front());
    }
    figure.figure.curves.push_back(std::move(curve));
    figure.keyNumbers.emplace_back(std::string("mean_") + column, mean(columnOf(figure, column)));
  }
  figure.keyNumbers.emplace_back("speed_rad_per_s", map.totalVelocity_rad_per_s);
  return figure;
}

}  // namespace

BenchFigure totalViscousFigure(const Commission& measured) {
  const FrictionMap& map = measured.map;
  const double speed = map.totalVelocity_rad_per_s;
  BenchFigure figure{"total-viscous",
                     "B(θ)·ω: what viscous friction asks of the motor around the turn.",
                     {"Viscous friction at " + numberText(speed, 4) + " rad/s", "", "torque / mNm"},
                     {angles(map)}};
  for (size_t w = 0; w < 2; ++w) {
    figure.columns.push_back(aroundTurn(map, std::string(ways[w]) + "_Nm", [w, speed](const MapBin& bin) {
      return bin.way[w].viscous_Nm_s_per_rad.value * speed;
    }));
  }
  return polarFigure(map, std::move(figure));
}

BenchFigure overallFrictionFigure(const Commission& measured) {
  const FrictionMap& map = measured.map;
  BenchFigure figure{
      "overall-friction",
      "Coulomb, viscous and position torque together: what keeps the rotor turning at this speed, angle by angle.",
      {"Overall friction at " + numberText(map.totalVelocity_rad_per_s, 4) + " rad/s", "", "torque / mNm"},
      {angles(map)}};
  for (size_t w = 0; w < 2; ++w) {
    figure.columns.push_back(
        aroundTurn(map, std::string(ways[w]) + "_Nm", [w](const MapBin& bin) { return bin.way[w].total_Nm; }));
  }
  return polarFigure(map, std::move(figure));
}

}  // namespace breakaway
