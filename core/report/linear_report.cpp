#include "report/linear_report.h"

#include <fmt/core.h>
#include <array>

#include "draw/html_report.h"
#include "report/map_figures.h"
#include "report/motor_chapter.h"

namespace breakaway {

namespace {

constexpr double mm = 1e3;

Figure breakawayFigure(const FrictionMap& map) {
  Figure figure = mapFigure(map, "Breakaway force over the travel", "force / N", 1.0,
                            [](const WayBin& bin) { return bin.static_Nm; });
  Curve outliers = outlierCurve(map, mm);
  if (!outliers.x.empty()) figure.curves.push_back(std::move(outliers));
  return figure;
}

/// Mean force of each speed's strokes, by way.
std::array<Curve, 2> speedPoints(const Commission& done) {
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

}  // namespace

Figure strokesFigure(const Commission& done) {
  return speedFigure(done, speedPoints(done), "speed / m/s");
}

void travelChapter(HtmlReport& report, const Commission& done) {
  const FrictionMap& map = done.map;
  report.heading("Friction over the travel");
  std::vector<std::vector<std::string>> rows;
  for (size_t w = 0; w < 2; ++w) {
    const auto repeat = repeatCells(map, w);
    rows.push_back({mapUnitsOf(map.axis).ways[w], numberText(staticMean(map, w)),
                    withInterval(done.moving[w].coulombMean_Nm, 1.0, "N"),
                    withInterval(done.moving[w].viscousMean_Nm_s_per_rad, 1.0, "N s/m"), repeat[0], repeat[1]});
  }
  report.table(
      {"way", "breakaway, mean / N", "Coulomb", "viscous", "correlation of passes", "difference of passes / N rms"},
      rows);
  report.figure(
      breakawayFigure(map),
      "Whole motor force that starts motion from standstill: friction and position force; the band is the 95 % "
      "interval. Forwards is growing position.");
  for (size_t w = 0; w < 2; ++w) report.figure(passesFigure(map, w));
  report.figure(mapFigure(map, "Coulomb force over the travel", "force / N", 1.0,
                          [](const WayBin& bin) { return bin.coulomb_Nm; }),
                "Whole motor force, extrapolated to zero speed from moving.");
  report.figure(mapFigure(map, "Viscous coefficient over the travel", "coefficient / N s/m", 1.0,
                          [](const WayBin& bin) { return bin.viscous_Nm_s_per_rad; }),
                "Its slope with speed, smoothed as far as the noise asks for it.");
  report.figure(mapFigure(map, "Total force over the travel at " + numberText(map.totalVelocity_rad_per_s) + " m/s",
                          "force / N", 1.0, [](const WayBin& bin) {
                            return Estimate{bin.total_Nm, 0.0};
                          }));
  report.figure(strokesFigure(done));
}

std::string linearInWords(const Commission& done) {
  const FrictionMap& map = done.map;
  return fmt::format(
      "Breakaway force on average {:.3g} N backwards and {:.3g} N forwards; {}. Coulomb friction {:.3g} N ({:.3g} to "
      "{:.3g}), viscous friction {:.3g} N s/m ({:.3g} to {:.3g}).",
      staticMean(map, 0), staticMean(map, 1), repeatWords(map), map.coulombAverage_Nm.value,
      map.coulombAverage_Nm.low95(), map.coulombAverage_Nm.high95(), map.viscousAverage_Nm_s_per_rad.value,
      map.viscousAverage_Nm_s_per_rad.low95(), map.viscousAverage_Nm_s_per_rad.high95());
}

}  // namespace breakaway
