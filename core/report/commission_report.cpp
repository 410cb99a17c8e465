#include "report/commission_report.h"

#include <fmt/core.h>
#include <array>
#include <cmath>

#include "base/atomic_file.h"
#include "base/numbers.h"
#include "commission/motor_file.h"
#include "draw/html_report.h"
#include "friction/map_export.h"
#include "recording/csv.h"
#include "report/linear_report.h"
#include "report/map_figures.h"
#include "report/motor_chapter.h"

namespace breakaway {

namespace {

constexpr int polar_px = 560;

/// One curve per way around the turn, closed, in mNm.
template <typename Get>
std::vector<Curve> aroundTheTurn(const FrictionMap& map, Get get) {
  std::vector<Curve> curves;
  for (size_t w = 0; w < 2; ++w) {
    Curve curve;
    curve.label = mapUnitsOf(Axis::rotary).ways[w];
    curve.colour = static_cast<int>(w);
    for (size_t k = 0; k <= map.bins.size(); ++k) {
      const MapBin& bin = map.bins[k % map.bins.size()];
      curve.x.push_back(bin.angle_rad + (k == map.bins.size() ? turn_rad : 0.0));
      curve.y.push_back(get(bin.way[w]));
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

Figure staticFigure(const FrictionMap& map) {
  Figure figure{"Breakaway torque around the rotor", "", "torque / mNm"};
  figure.polar = true;
  figure.curves = aroundTheTurn(map, [](const WayBin& bin) { return 1e3 * bin.static_Nm.value; });
  Curve outliers = outlierCurve(map, 1.0);
  if (!outliers.x.empty()) figure.curves.push_back(std::move(outliers));
  return figure;
}

/// Mean torque at each speed, by way.
std::array<Curve, 2> speedPoints(const Commission& done) {
  std::array<Curve, 2> points;
  for (const VelocityRun& run : done.runs) {
    Curve& own = points[static_cast<size_t>(run.way())];
    own.x.push_back(std::abs(run.target_rad_per_s));
    own.y.push_back(1e3 * done.motor.torqueConstant_Nm_per_A.value * meanCurrent_A(run).value);
  }
  return points;
}

void rotorChapter(HtmlReport& report, const Commission& done) {
  const FrictionMap& map = done.map;
  report.heading("Friction, motor and encoder");
  std::vector<std::vector<std::string>> rows;
  for (size_t w = 0; w < 2; ++w) {
    const auto repeat = repeatCells(map, w);
    rows.push_back({mapUnitsOf(map.axis).ways[w], numberText(1e3 * staticMean(map, w)),
                    withInterval(done.moving[w].coulombMean_Nm, 1e3, "mNm"),
                    withInterval(done.moving[w].viscousMean_Nm_s_per_rad, 1e6, "µNm s/rad"), repeat[0], repeat[1]});
  }
  report.table(
      {"way", "breakaway, mean / mNm", "Coulomb", "viscous", "correlation of turns", "difference of turns / mNm rms"},
      rows);
  report.figure(staticFigure(map),
                "Whole motor torque that starts motion from standstill: friction and position torque.", polar_px,
                polar_px);
  for (size_t w = 0; w < 2; ++w) report.figure(passesFigure(map, w));
  report.figure(mapFigure(map, "Coulomb torque around the rotor", "torque / mNm", 1e3,
                          [](const WayBin& bin) { return bin.coulomb_Nm; }),
                "Whole motor torque, extrapolated to zero speed from moving; the band is the 95 % interval.");
  report.figure(mapFigure(map, "Viscous coefficient around the rotor", "coefficient / µNm s/rad", 1e6,
                          [](const WayBin& bin) { return bin.viscous_Nm_s_per_rad; }),
                "Its slope with speed. Harmonics that don't stand out of the noise are left out.");
  Figure total{"Total torque around the rotor at " + numberText(map.totalVelocity_rad_per_s) + " rad/s", "",
               "torque / mNm"};
  total.polar = true;
  total.curves = aroundTheTurn(map, [](const WayBin& bin) { return 1e3 * bin.total_Nm; });
  report.figure(total, {}, polar_px, polar_px);
  report.figure(speedFigure(done, speedPoints(done), "speed / rad/s"));
}

/// Before there is a map: what the velocity sweep tells alone, and how far the breakaway sweep is.
void unfinishedChapter(HtmlReport& report, const Commission& done) {
  const bool linear = done.linear();
  const MapUnits& units = mapUnitsOf(done.identity.axis);
  report.heading(linear ? "Friction over the travel" : "Friction, motor and encoder");
  if (!done.breakaways.empty())
    report.paragraph("The breakaway sweep was stopped before its end: " + std::to_string(done.breakaways.size()) +
                     " of " + std::to_string(2 * done.sweeps.bins * done.sweeps.turns) + " breakaways were measured.");
  if (!done.knows(Known::runs)) return;
  std::vector<std::vector<std::string>> rows;
  for (size_t w = 0; w < 2; ++w)
    rows.push_back({units.ways[w], withInterval(done.moving[w].coulombMean_Nm, units.torqueScale, units.torqueUnit),
                    linear ? withInterval(done.moving[w].viscousMean_Nm_s_per_rad, 1.0, "N s/m")
                           : withInterval(done.moving[w].viscousMean_Nm_s_per_rad, 1e6, "µNm s/rad")});
  report.table({"way", "Coulomb", "viscous"}, rows);
  report.figure(linear ? strokesFigure(done) : speedFigure(done, speedPoints(done), "speed / rad/s"));
}

std::string nameOf(const Commission& done) {
  if (!done.map.rig.empty()) return done.map.rig;
  return done.bench.name.empty() ? done.identity.device : done.bench.name;
}

std::vector<std::pair<std::string, std::string>> circumstances(const Commission& done) {
  const bool linear = done.linear();
  std::vector<std::pair<std::string, std::string>> facts{
      {"board", done.identity.device + ", " + done.identity.firmware},
      {"control rate", numberText(done.identity.loopRate_Hz) + " Hz"},
      {"encoder", numberText(done.identity.countsPerRev, 6) + (linear ? " counts per m" : " counts per turn")}};
  if (done.knows(Known::index))
    facts.emplace_back(!linear || done.identity.hasIndex ? "index at" : "lower end at",
                       linear ? withInterval(done.indexAngle_rad, 1e3, "mm from power-up")
                              : withInterval(done.indexAngle_rad, 1.0, "rad from power-up"));
  facts.emplace_back("time on the bench", numberText(done.rigTime_s / 60.0, 3) + " min");
  if (!done.knows(Known::map)) return facts;
  facts.emplace_back(linear ? "passes" : "turns", std::to_string(done.map.turns) + " each way");
  for (const auto& [name, value] : done.map.settings) facts.emplace_back(name, numberText(value));
  return facts;
}

std::string reportHtml(const Commission& done, bool hasTruth) {
  HtmlReport report("Friction of " + nameOf(done), done.identity.device);
  report.verdict(done.knows(Known::map) ? inWords(done) : motorInWords(done));
  if (!done.knows(Known::map)) {
    unfinishedChapter(report, done);
  } else if (done.linear()) {
    travelChapter(report, done);
  } else {
    rotorChapter(report, done);
  }
  if (done.knows(Known::gainsInUse) || done.compensatedRun) useChapter(report, done);
  motorChapter(report, done);
  report.heading("How it was measured");
  report.facts(circumstances(done));
  closingChapter(report, done, hasTruth);
  return report.html();
}

}  // namespace

Result<void> writeStep(const std::string& step, const Recording& recording, const std::string& folder) {
  if (auto made = makeFolder(folder + "/recordings"); !made) return made;
  return writeCsv(recording, folder + "/recordings/" + step + ".csv");
}

Result<void> writeIdentification(const Commission& done, const std::string& folder) {
  if (auto made = makeFolder(folder); !made) return made;
  if (auto written = writeBench(done.bench, folder + "/bench.json"); !written) return written;
  return writeMotor({done.identity.device, done.motor, done.addedInertia_kg_m2, done.identity.axis},
                    folder + "/motor.json");
}

Result<void> writeCommission(const Commission& done, const std::optional<FrictionMap>& truth,
                             const std::string& folder) {
  if (auto made = makeFolder(folder + "/recordings"); !made) return made;
  for (const auto& [step, recording] : done.recordings) {
    if (auto written = writeStep(step, recording, folder); !written) return written;
  }
  if (auto written = writeIdentification(done, folder); !written) return written;
  if (auto written = exportMap(done.map, "json", folder + "/map.json"); !written) return written;
  if (auto written = exportMap(done.map, "csv", folder + "/map.csv"); !written) return written;
  if (truth) {
    if (auto written = exportMap(*truth, "csv", folder + "/truth.csv"); !written) return written;
  }
  return writeReport(done, truth.has_value(), folder + "/report.html");
}

Result<void> writeReport(const Commission& done, bool hasTruth, const std::string& path) {
  if (!done.knows(Known::motor)) return Error{path, "nothing was measured yet"};
  return writeFile(path, reportHtml(done, hasTruth));
}

std::string inWords(const Commission& done) {
  if (done.linear()) return linearInWords(done);
  const FrictionMap& map = done.map;
  return fmt::format(
      "Breakaway torque on average {:.3g} mNm clockwise and {:.3g} mNm counter-clockwise; {}. "
      "Coulomb friction {:.3g} mNm ({:.3g} to {:.3g}), viscous friction {:.3g} µNm s/rad ({:.3g} to {:.3g}).",
      1e3 * staticMean(map, 0), 1e3 * staticMean(map, 1), repeatWords(map), 1e3 * map.coulombAverage_Nm.value,
      1e3 * map.coulombAverage_Nm.low95(), 1e3 * map.coulombAverage_Nm.high95(),
      1e6 * map.viscousAverage_Nm_s_per_rad.value, 1e6 * map.viscousAverage_Nm_s_per_rad.low95(),
      1e6 * map.viscousAverage_Nm_s_per_rad.high95());
}

}  // namespace breakaway
