#include "report/map_figures.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace breakaway {

const MapUnits& mapUnitsOf(Axis axis) {
  static const MapUnits rotor{{marked("clockwise"), marked("counter-clockwise")},
                              marked("angle / °"),
                              180.0 / std::numbers::pi,
                              marked("torque"),
                              "mNm",
                              1e3,
                              marked("turn"),
                              marked("turns"),
                              "µNm s/rad",
                              1e6,
                              "rad/s"};
  static const MapUnits travel{{marked("backwards"), marked("forwards")},
                               marked("position / mm"),
                               1e3,
                               marked("force"),
                               "N",
                               1.0,
                               marked("pass"),
                               marked("passes"),
                               "N s/m",
                               1.0,
                               "m/s"};
  return axis == Axis::linear ? travel : rotor;
}

double staticMean(const FrictionMap& map, size_t way) {
  double sum = 0.0;
  for (const MapBin& bin : map.bins) sum += bin.way[way].static_Nm.value;
  return sum / static_cast<double>(map.bins.size());
}

Message repeatWords(const FrictionMap& map) {
  const MapUnits& units = mapUnitsOf(map.axis);
  if (map.turns < 2) return message("one {} tells nothing of how well it repeats", message(units.pass));
  return message("consecutive {} correlate by {:.3f} and {:.3f}", message(units.passes),
                 map.repeatability[0].correlation, map.repeatability[1].correlation);
}

std::array<std::string, 2> repeatCells(const FrictionMap& map, size_t way) {
  if (map.turns < 2) return {"–", "–"};
  return {numberText(map.repeatability[way].correlation),
          numberText(mapUnitsOf(map.axis).torqueScale * map.repeatability[way].rmsDifference_Nm)};
}

Curve outlierCurve(const FrictionMap& map, double placeScale) {
  Curve outliers;
  outliers.label = message("outlier");
  outliers.style = Curve::Style::points;
  outliers.colour = 6;
  outliers.width_px = 3.0;
  for (const MapBin& bin : map.bins) {
    for (const WayBin& way : bin.way) {
      if (!way.outlier) continue;
      outliers.x.push_back(placeScale * bin.angle_rad);
      outliers.y.push_back(mapUnitsOf(map.axis).torqueScale * way.static_Nm.value);
    }
  }
  return outliers;
}

Figure mapFigure(const FrictionMap& map, const Message& title, const Message& yTitle, double scale,
                 Estimate (*get)(const WayBin&)) {
  const MapUnits& units = mapUnitsOf(map.axis);
  Figure figure{title, message(units.place), yTitle};
  for (size_t w = 0; w < 2; ++w) {
    Curve curve;
    curve.label = message(units.ways[w]);
    curve.colour = wayColour(w);
    for (const MapBin& bin : map.bins) {
      const Estimate estimate = get(bin.way[w]);
      curve.x.push_back(units.placeScale * bin.angle_rad);
      curve.y.push_back(scale * estimate.value);
      curve.low.push_back(scale * estimate.low95());
      curve.high.push_back(scale * estimate.high95());
    }
    figure.curves.push_back(std::move(curve));
  }
  return figure;
}

Figure passesFigure(const FrictionMap& map, size_t way) {
  const MapUnits& units = mapUnitsOf(map.axis);
  const bool linear = map.axis == Axis::linear;
  const Message wayName = message(units.ways[way]);
  Figure figure{linear ? message("Pass by pass, {}", wayName) : message("Turn by turn, {}", wayName),
                message(units.place), message("breakaway {}", units.torqueTitle())};
  for (size_t pass = 0; pass < map.turnStatic_Nm[way].size(); ++pass) {
    Curve curve;
    curve.label = message("{} {}", message(units.pass), pass + 1);
    for (size_t k = 0; k < map.bins.size(); ++k) {
      curve.x.push_back(units.placeScale * map.bins[k].angle_rad);
      curve.y.push_back(units.torqueScale * map.turnStatic_Nm[way][pass][k]);
    }
    figure.curves.push_back(std::move(curve));
  }
  return figure;
}

Figure speedFigure(const Commission& done, std::array<Curve, 2> points, const Message& speedTitle) {
  const MapUnits& units = mapUnitsOf(done.identity.axis);
  const bool linear = done.linear();
  Figure figure{linear ? message("Force at constant speed") : message("Torque at constant speed"), speedTitle,
                units.torqueTitle()};
  for (size_t w = 0; w < 2; ++w) {
    points[w].label = message(units.ways[w]);
    points[w].style = Curve::Style::points;
    points[w].width_px = 3.5;
    Curve line;
    points[w].colour = line.colour = wayColour(w);
    line.label = message("Coulomb and viscous, {}", message(units.ways[w]));
    double highest = 0.0;
    for (const double speed : points[w].x) highest = std::max(highest, speed);
    for (const double speed : {0.0, highest}) {
      line.x.push_back(speed);
      line.y.push_back(units.torqueScale *
                       (done.moving[w].coulombMean_Nm.value + done.moving[w].viscousMean_Nm_s_per_rad.value * speed));
    }
    figure.curves.push_back(std::move(points[w]));
    figure.curves.push_back(std::move(line));
  }
  return figure;
}

}  // namespace breakaway
