#include "report/friction_chapter.h"

#include <array>
#include <cmath>

#include "base/numbers.h"
#include "report/map_figures.h"
#include "report/motor_chapter.h"

namespace breakaway {

namespace {

constexpr int polar_px = 560;

/// One curve per way around the turn, closed, in mNm.
template <typename Get>
Figure polarFigure(const FrictionMap& map, const std::string& title, Get get) {
  Figure figure{title, "", "torque / mNm"};
  figure.polar = true;
  for (size_t w = 0; w < 2; ++w) {
    Curve curve;
    curve.label = mapUnitsOf(Axis::rotary).ways[w];
    curve.colour = wayColour(w);
    for (size_t k = 0; k <= map.bins.size(); ++k) {
      const MapBin& bin = map.bins[k % map.bins.size()];
      curve.x.push_back(bin.angle_rad + (k == map.bins.size() ? turn_rad : 0.0));
      curve.y.push_back(1e3 * get(bin.way[w]).value);
    }
    figure.curves.push_back(std::move(curve));
  }
  return figure;
}

void breakawayFigure(HtmlReport& report, const FrictionMap& map) {
  const bool linear = map.axis == Axis::linear;
  const auto get = [](const WayBin& bin) { return bin.static_Nm; };
  Figure figure = linear ? mapFigure(map, "Breakaway force over the travel", "force / N", 1.0, get)
                         : polarFigure(map, "Breakaway torque around the rotor", get);
  if (Curve outliers = outlierCurve(map, linear ? mapUnitsOf(map.axis).placeScale : 1.0); !outliers.x.empty())
    figure.curves.push_back(std::move(outliers));
  if (linear) {
    report.figure(figure,
                  "Whole motor force that starts motion from standstill: friction and position force; the band is the "
                  "95 % interval. Forwards is growing position.");
  } else {
    report.figure(figure, "Whole motor torque that starts motion from standstill: friction and position torque.",
                  polar_px, polar_px);
  }
}

void totalFigure(HtmlReport& report, const FrictionMap& map) {
  const MapUnits& units = mapUnitsOf(map.axis);
  const std::string speed = " at " + numberText(map.totalVelocity_rad_per_s) + " " + units.speedUnit;
  const auto get = [](const WayBin& bin) { return Estimate{bin.total_Nm, 0.0}; };
  if (map.axis == Axis::linear) {
    report.figure(mapFigure(map, "Total force over the travel" + speed, units.torqueTitle(), 1.0, get));
  } else {
    report.figure(polarFigure(map, "Total torque around the rotor" + speed, get), {}, polar_px, polar_px);
  }
}

/// Mean torque of each run, by way.
std::array<Curve, 2> runPoints(const Commission& done) {
  std::array<Curve, 2> points;
  for (const VelocityRun& run : done.runs) {
    Curve& own = points[static_cast<size_t>(run.way())];
    own.x.push_back(std::abs(run.target_rad_per_s));
    own.y.push_back(1e3 * done.motor.torqueConstant_Nm_per_A.value * meanCurrent_A(run).value);
  }
  return points;
}

/// Mean force of each speed's strokes, by way.
std::array<Curve, 2> strokePoints(const Commission& done) {
  const double Kf = done.motor.torquePerShownAmpere_Nm(), m = done.motor.inertia_kg_m2.value;
  std::array<Curve, 2> points;
  for (size_t w = 0; w < 2; ++w) {
    const double sign = signOf(Way(w));
    for (const TravelRun& run : done.strokes) {
      double force = 0.0, speed = 0.0, crossed = 0.0;
      for (const TravelBinSums& sum : run.bins[w]) {
        if (sum.samples == 0) continue;
        const auto n = static_cast<double>(sum.samples);
        force += sign * (Kf * sum.current_A - m * sum.acceleration_m_per_s2) / n;
        speed += sign * sum.velocity_m_per_s / n;
        crossed += 1.0;
      }
      if (crossed == 0.0) continue;
      points[w].x.push_back(speed / crossed);
      points[w].y.push_back(force / crossed);
    }
  }
  return points;
}

Figure speedsFigure(const Commission& done) {
  return speedFigure(done, done.linear() ? strokePoints(done) : runPoints(done),
                     std::string("speed / ") + mapUnitsOf(done.identity.axis).speedUnit);
}

/// A row per way: its name, Coulomb and viscous friction.
std::vector<std::vector<std::string>> movingRows(const Commission& done) {
  const MapUnits& units = mapUnitsOf(done.identity.axis);
  std::vector<std::vector<std::string>> rows;
  for (size_t w = 0; w < 2; ++w) {
    const MovingFriction& moving = done.moving[w];
    rows.push_back({units.ways[w], withInterval(moving.coulombMean_Nm, units.torqueScale, units.torqueUnit),
                    withInterval(moving.viscousMean_Nm_s_per_rad, units.viscousScale, units.viscousUnit)});
  }
  return rows;
}

}  // namespace

void frictionChapter(HtmlReport& report, const Commission& done) {
  const FrictionMap& map = done.map;
  const MapUnits& units = mapUnitsOf(map.axis);
  const bool linear = map.axis == Axis::linear;
  const std::string unit = units.torqueUnit, torque = units.torque, passes = units.passes();
  report.heading(linear ? "Friction over the travel" : "Friction, motor and encoder");
  auto rows = movingRows(done);
  for (size_t w = 0; w < 2; ++w) {
    const auto repeat = repeatCells(map, w);
    rows[w].insert(rows[w].begin() + 1, numberText(units.torqueScale * staticMean(map, w)));
    rows[w].insert(rows[w].end(), repeat.begin(), repeat.end());
  }
  report.table({"way", "breakaway, mean / " + unit, "Coulomb", "viscous", "correlation of " + passes,
                "difference of " + passes + " / " + unit + " rms"},
               rows);
  breakawayFigure(report, map);
  for (size_t w = 0; w < 2; ++w) report.figure(passesFigure(map, w));
  report.figure(mapFigure(map, "Coulomb " + torque + units.where, units.torqueTitle(), units.torqueScale,
                          [](const WayBin& bin) { return bin.coulomb_Nm; }),
                "Whole motor " + torque + ", extrapolated to zero speed from moving" +
                    (linear ? "." : "; the band is the 95 % interval."));
  report.figure(
      mapFigure(map, std::string("Viscous coefficient") + units.where,
                std::string("coefficient / ") + units.viscousUnit, units.viscousScale,
                [](const WayBin& bin) { return bin.viscous_Nm_s_per_rad; }),
      std::string("Its slope with speed") + (linear ? ", smoothed as far as the noise asks for it."
                                                    : ". Harmonics that don't stand out of the noise are left out."));
  totalFigure(report, map);
  report.figure(speedsFigure(done));
}

void unfinishedChapter(HtmlReport& report, const Commission& done) {
  report.heading(done.linear() ? "Friction over the travel" : "Friction, motor and encoder");
  if (!done.breakaways.empty())
    report.paragraph("The breakaway sweep was stopped before its end: " + std::to_string(done.breakaways.size()) +
                     " of " + std::to_string(2 * done.sweeps.bins * done.sweeps.turns) + " breakaways were measured.");
  if (!done.knows(Known::runs)) return;
  report.table({"way", "Coulomb", "viscous"}, movingRows(done));
  report.figure(speedsFigure(done));
}

}  // namespace breakaway
