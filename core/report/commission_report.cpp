#include "report/commission_report.h"

#include "base/atomic_file.h"
#include "commission/motor_file.h"
#include "friction/map_export.h"
#include "recording/csv.h"
#include "report/friction_chapter.h"
#include "report/map_figures.h"
#include "report/motor_chapter.h"

namespace breakaway {

namespace {

std::string nameOf(const Commission& done) {
  if (!done.map.rig.empty()) return done.map.rig;
  return done.bench.name.empty() ? done.identity.device : done.bench.name;
}

std::vector<std::pair<Saying, Saying>> circumstances(const Commission& done) {
  const bool linear = done.linear();
  const std::string counts = numberText(done.identity.countsPerRev, 6);
  std::vector<std::pair<Saying, Saying>> facts{
      {message("board"), boardName(done.identity) + ", " + done.identity.firmware},
      {message("control rate"), numberText(done.identity.loopRate_Hz) + " Hz"},
      {message("encoder"), linear ? message("{} counts per m", counts) : message("{} counts per turn", counts)}};
  if (done.knows(Known::index))
    facts.emplace_back(!linear || done.identity.hasIndex ? message("index at") : message("lower end at"),
                       linear ? withInterval(done.indexAngle_rad, 1e3, message("mm from power-up"))
                              : withInterval(done.indexAngle_rad, 1.0, message("rad from power-up")));
  facts.emplace_back(message("time on the bench"), numberText(done.rigTime_s / 60.0, 3) + " min");
  if (!done.knows(Known::map)) return facts;
  facts.emplace_back(linear ? message("passes") : message("turns"), message("{} each way", done.map.turns));
  for (const auto& [name, value] : done.map.settings) facts.emplace_back(name, numberText(value));
  return facts;
}

std::string reportHtml(const Commission& done, bool hasTruth, const Catalogue& language) {
  HtmlReport report(message("Friction of {}", nameOf(done)), done.identity.device, language);
  report.verdict(done.knows(Known::map) ? inWords(done) : motorInWords(done));
  if (!done.knows(Known::map)) {
    unfinishedChapter(report, done);
  } else {
    frictionChapter(report, done);
  }
  if (done.knows(Known::gainsInUse) || done.compensatedRun) useChapter(report, done);
  motorChapter(report, done);
  report.heading(message("How it was measured"));
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

Result<void> writeCommission(const Commission& done, const std::optional<FrictionMap>& truth, const std::string& folder,
                             const Catalogue& language) {
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
  return writeReport(done, truth.has_value(), folder + "/report.html", language);
}

Result<void> writeReport(const Commission& done, bool hasTruth, const std::string& path, const Catalogue& language) {
  if (!done.knows(Known::motor)) return Error{path, "nothing was measured yet"};
  return writeFile(path, reportHtml(done, hasTruth, language));
}

Message inWords(const Commission& done) {
  const FrictionMap& map = done.map;
  const MapUnits& units = mapUnitsOf(done.identity.axis);
  const double torque = units.torqueScale, viscous = units.viscousScale;
  const Estimate &F = map.coulombAverage_Nm, &B = map.viscousAverage_Nm_s_per_rad;
  const auto mean = [&](size_t way) {
    return message("{:.3g} {} {}", torque * staticMean(map, way), units.torqueUnit, message(units.ways[way]));
  };
  return message(
      "Breakaway {} on average {} and {}; {}. Coulomb friction {:.3g} {} ({:.3g} to {:.3g}), viscous friction {:.3g} "
      "{} "
      "({:.3g} to {:.3g}).",
      message(units.torque), mean(0), mean(1), repeatWords(map), torque * F.value, units.torqueUnit, torque * F.low95(),
      torque * F.high95(), viscous * B.value, units.viscousUnit, viscous * B.low95(), viscous * B.high95());
}

}  // namespace breakaway
