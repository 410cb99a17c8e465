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
Figure polarFigure(const FrictionMap& map, const Message& title, Get get) {
  Figure figure{title, "", mapUnitsOf(Axis::rotary).torqueTitle()};
  figure.polar = true;
  for (size_t w = 0; w < 2; ++w) {
    Curve curve;
    curve.label = message(mapUnitsOf(Axis::rotary).ways[w]);
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
  Figure figure =
      linear ? mapFigure(map, message("Breakaway force over the travel"), mapUnitsOf(map.axis).torqueTitle(), 1.0, get)
             : polarFigure(map, message("Breakaway torque around the rotor"), get);
  if (Curve outliers = outlierCurve(map, linear ? mapUnitsOf(map.axis).placeScale : 1.0); !outliers.x.empty())
    figure.curves.push_back(std::move(outliers));
  if (linear) {
    report.figure(figure, message("Whole motor force that starts motion from standstill: friction and position force; "
                                  "the band is the 95 % interval. Forwards is growing position."));
  } else {
    report.figure(figure,
                  message("Whole motor torque that starts motion from standstill: friction and position torque."),
                  polar_px, polar_px);
  }
}

void totalFigure(HtmlReport& report, const FrictionMap& map) {
  const MapUnits& units = mapUnitsOf(map.axis);
  const std::string speed = numberText(map.totalVelocity_rad_per_s) + " " + units.speedUnit;
  const auto get = [](const WayBin& bin) { return Estimate{bin.total_Nm, 0.0}; };
  if (map.axis == Axis::linear) {
    report.figure(mapFigure(map, message("Total force over the travel at {}", speed), units.torqueTitle(), 1.0, get));
  } else {
    report.figure(polarFigure(map, message("Total torque around the rotor at {}", speed), get), {}, polar_px, polar_px);
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
                     message("speed / {}", mapUnitsOf(done.identity.axis).speedUnit));
}

/// A row per way: its name, Coulomb and viscous friction.
std::vector<std::vector<Saying>> movingRows(const Commission& done) {
  const MapUnits& units = mapUnitsOf(done.identity.axis);
  std::vector<std::vector<Saying>> rows;
  for (size_t w = 0; w < 2; ++w) {
    const MovingFriction& moving = done.moving[w];
    rows.push_back({message(units.ways[w]), withInterval(moving.coulombMean_Nm, units.torqueScale, units.torqueUnit),
                    withInterval(moving.viscousMean_Nm_s_per_rad, units.viscousScale, units.viscousUnit)});
  }
  return rows;
}

Message chapterOf(bool linear) {
  return linear ? message("Friction over the travel") : message("Friction, motor and encoder");
}

}  // namespace

void frictionChapter(HtmlReport& report, const Commission& done) {
  const FrictionMap& map = done.map;
  const MapUnits& units = mapUnitsOf(map.axis);
  const bool linear = map.axis == Axis::linear;
  const std::string unit = units.torqueUnit;
  const Message passes = message(units.passes);
  report.heading(chapterOf(linear));
  auto rows = movingRows(done);
  for (size_t w = 0; w < 2; ++w) {
    const auto repeat = repeatCells(map, w);
    rows[w].insert(rows[w].begin() + 1, numberText(units.torqueScale * staticMean(map, w)));
    rows[w].insert(rows[w].end(), repeat.begin(), repeat.end());
  }
  report.table({message("way"), message("breakaway, mean / {}", unit), message("Coulomb"), message("viscous"),
                message("correlation of {}", passes), message("difference of {} / {} rms", passes, unit)},
               rows);
  breakawayFigure(report, map);
  for (size_t w = 0; w < 2; ++w) report.figure(passesFigure(map, w));
  const auto coulomb = [](const WayBin& bin) { return bin.coulomb_Nm; };
  const auto viscous = [](const WayBin& bin) { return bin.viscous_Nm_s_per_rad; };
  const Message coefficient = message("coefficient / {}", units.viscousUnit);
  if (linear) {
    report.figure(
        mapFigure(map, message("Coulomb force over the travel"), units.torqueTitle(), units.torqueScale, coulomb),
        message("Whole motor force, extrapolated to zero speed from moving."));
    report.figure(
        mapFigure(map, message("Viscous coefficient over the travel"), coefficient, units.viscousScale, viscous),
        message("Its slope with speed, smoothed as far as the noise asks for it."));
  } else {
    report.figure(
        mapFigure(map, message("Coulomb torque around the rotor"), units.torqueTitle(), units.torqueScale, coulomb),
        message("Whole motor torque, extrapolated to zero speed from moving; the band is the 95 % interval."));
    report.figure(
        mapFigure(map, message("Viscous coefficient around the rotor"), coefficient, units.viscousScale, viscous),
        message("Its slope with speed. Harmonics that don't stand out of the noise are left out."));
  }
  totalFigure(report, map);
  report.figure(speedsFigure(done));
}

void unfinishedChapter(HtmlReport& report, const Commission& done) {
  report.heading(chapterOf(done.linear()));
  if (!done.breakaways.empty())
    report.paragraph(message("The breakaway sweep was stopped before its end: {} of {} breakaways were measured.",
                             done.breakaways.size(), 2 * done.sweeps.bins * done.sweeps.turns));
  if (!done.knows(Known::runs)) return;
  report.table({message("way"), message("Coulomb"), message("viscous")}, movingRows(done));
  report.figure(speedsFigure(done));
}

}  // namespace breakaway
