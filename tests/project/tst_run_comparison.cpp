// Two runs side by side: what has changed is said, and what hasn't is not.
#include <QTest>
#include <cmath>

#include "base/atomic_file.h"
#include "friction/map_export.h"
#include "recording/csv.h"
#include "report/run_comparison.h"
#include "support/noisy_map.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

class TestRunComparison : public QObject {
  Q_OBJECT
 private slots:
  void sameMotorTwice_hasNotChanged();
  void higherFriction_isBeyondTheIntervals();
  void placeThatHasChanged_isFound();
  void otherNumberOfBins_isCompared();
  void runsWithNothingInCommon_areAnError();
  void recordings_areLaidOverEachOtherFromTheirBeginnings();
  void recordingsWithoutACommonChannel_areAnError();
  void comparison_isWrittenWhole();
  void report_isInTheLanguage();
};

namespace {

ProjectRun put(Project& project, const FrictionMap& map, const std::string& at) {
  NewRun run;
  run.write = [&map](const std::string& folder) { return exportMap(map, "json", folder + "/map.json"); };
  run.at = at;
  auto put = project.add(run);
  if (!put) qFatal("%s", put.error().message().c_str());
  return *put;
}

struct Two {
  TemporaryFolder folder;
  Project project;
  ProjectRun before, after;
  Two(const FrictionMap& first, const FrictionMap& second)
      : project(std::move(*Project::open(folder.path("p"), Project::Missing::isMade))),
        before(put(project, first, "2026-01-01T00:00:00Z")),
        after(put(project, second, "2026-02-01T00:00:00Z")) {}
  RunComparison comparison() const {
    auto comparison = compareRuns(project, after, before);  // in any order
    if (!comparison) qFatal("%s", comparison.error().message().c_str());
    return *comparison;
  }
};

size_t changed(const RunComparison& comparison) {
  size_t count = 0;
  for (const ValueChange& one : comparison.values) count += one.beyond ? 1 : 0;
  for (const MapChange& one : comparison.maps) count += one.isBeyond() ? 1 : 0;
  return count;
}

}  // namespace

void TestRunComparison::sameMotorTwice_hasNotChanged() {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const auto changes = compareMaps(noisyMap(0.02, seed), noisyMap(0.02, 100 + seed));
    QCOMPARE(changes.size(), size_t{4});
    size_t beyond = 0;
    for (const MapChange& one : changes) beyond += one.isBeyond() ? 1 : 0;
    QVERIFY2(beyond <= 1, qPrintable(QString::number(seed)));
  }
  const Two same(noisyMap(0.02, 1), noisyMap(0.02, 2));
  const std::string words = inWords(same.comparison());
  QVERIFY2(words.find("Nothing has changed beyond the 95 % intervals.") != std::string::npos, words.c_str());
}

void TestRunComparison::higherFriction_isBeyondTheIntervals() {
  const Two two(noisyMap(0.02, 1), noisyMap(0.024, 2));
  const RunComparison comparison = two.comparison();
  QCOMPARE(comparison.before.id, two.before.id);
  QVERIFY(changed(comparison) >= 5);  // four quantities of the map, and the Coulomb average
  for (const ValueChange& one : comparison.values)
    QCOMPARE(one.beyond, one.before.name.find("viscous") == std::string::npos);
  QVERIFY(std::abs(comparison.maps.front().meanDifference - 0.004) < 2e-4);
  const std::string words = inWords(comparison);
  QVERIFY2(words.find("coulomb_average_Nm: 0.016") != std::string::npos && words.find("+20 %") != std::string::npos,
           words.c_str());
}

void TestRunComparison::placeThatHasChanged_isFound() {
  const auto changes = compareMaps(noisyMap(0.02, 1), noisyMap(0.02, 2, 90, 0.005));
  QVERIFY(changes[0].largestAt > 1.9 && changes[0].largestAt < 2.5);
  QVERIFY(std::abs(changes[0].largest - 0.005) < 1.5e-3);
}

void TestRunComparison::otherNumberOfBins_isCompared() {
  const auto changes = compareMaps(noisyMap(0.02, 1, 60), noisyMap(0.024, 2, 180));
  QCOMPARE(changes.front().bins, size_t{180});
  QVERIFY(std::abs(changes.front().meanDifference - 0.004) < 3e-4);
}

void TestRunComparison::runsWithNothingInCommon_areAnError() {
  const TemporaryFolder folder;
  auto project = Project::open(folder.path("p"), Project::Missing::isMade);
  VERIFY_OK(project);
  const auto map = put(*project, noisyMap(0.02, 1), "2026-01-01T00:00:00Z");
  const auto text = project->add({.sources = {folder.write("note.txt", "a note")}});
  VERIFY_OK(text);
  QVERIFY(compareRuns(*project, map, *text).error().fact.find("no result in common") != std::string::npos);
  QVERIFY(compareRuns(*project, map, map).error().fact.find("itself") != std::string::npos);
}

/// The second begins 5 s and two turns later, has every other row, and 0.1 A more.
void TestRunComparison::recordings_areLaidOverEachOtherFromTheirBeginnings() {
  const auto recordingOf = [](double begin_s, double begin_rad, double more_A, int every) {
    std::vector<double> time, angle, current;
    for (int k = 0; k <= 1000; k += every) {
      const double since_s = 0.01 * k;
      time.push_back(begin_s + since_s);
      angle.push_back(begin_rad + 2.0 * since_s);
      current.push_back(more_A + (k / 100 % 2 == 0 ? 0.5 : -0.5));
    }
    return Recording::seal("r", {{"time_s", time}, {"angle_rad", angle}, {"current_A", current}}).value();
  };
  const TemporaryFolder folder;
  auto project = Project::open(folder.path("p"), Project::Missing::isMade);
  VERIFY_OK(project);
  const auto keep = [&project](const Recording& recording, const std::string& at) {
    NewRun run;
    run.at = at;
    run.write = [&recording](const std::string& into) { return writeCsv(recording, into + "/r.csv"); };
    return project->add(run).value();
  };
  const ProjectRun before = keep(recordingOf(0.0, 0.0, 0.0, 1), "2026-01-01T00:00:00Z");
  const ProjectRun after = keep(recordingOf(5.0, 12.566, 0.1, 2), "2026-02-01T00:00:00Z");
  QCOMPARE(before.kind, std::string("recording"));
  const auto comparison = compareRuns(*project, after, before);
  VERIFY_OK(comparison);
  QVERIFY(comparison->recordings);
  const RecordingComparison& recordings = *comparison->recordings;
  QVERIFY(std::abs(recordings.length_s - 10.0) < 1e-9);
  QCOMPARE(recordings.channels.size(), size_t{2});
  QCOMPARE(recordings.channels[0].channel, std::string("angle_rad"));
  QVERIFY(recordings.channels[0].differenceRms < 1e-9);
  const ChannelChange& current = recordings.channels[1];
  QVERIFY(std::abs(current.meanAfter - current.meanBefore - 0.1) < 2e-3);
  QVERIFY(std::abs(current.rmsBefore - 0.5) < 2e-3 && std::abs(current.differenceRms - 0.1) < 1e-6);
  const std::string words = inWords(*comparison);
  QVERIFY2(
      words.find("current_A: mean ") != std::string::npos && words.find("differ by 0.1 (RMS)") != std::string::npos,
      words.c_str());
  QVERIFY2(words.find("intervals") == std::string::npos, words.c_str());
  VERIFY_OK(writeComparison(*comparison, folder.path("out")));
  const auto svg = readFile(folder.path("out/figures/current_A.svg"));
  VERIFY_OK(svg);
  QVERIFY(svg->find("stroke-dasharray") != std::string::npos);
  QVERIFY(readFile(folder.path("out/comparison.json"))->find("\"difference_rms\"") != std::string::npos);
}

void TestRunComparison::recordingsWithoutACommonChannel_areAnError() {
  const TemporaryFolder folder;
  auto project = Project::open(folder.path("p"), Project::Missing::isMade);
  VERIFY_OK(project);
  const auto turned = project->add({.sources = {folder.write("a.csv", "time_s,angle_rad\n0,0\n1,1\n")}});
  const auto moved = project->add({.sources = {folder.write("b.csv", "time_s,position_m\n0,0\n1,1\n")}});
  VERIFY_OK(turned);
  VERIFY_OK(moved);
  QVERIFY(compareRuns(*project, *turned, *moved).error().fact.find("no result in common") != std::string::npos);
}

void TestRunComparison::comparison_isWrittenWhole() {
  const Two two(noisyMap(0.02, 1), noisyMap(0.024, 2));
  VERIFY_OK(writeComparison(two.comparison(), two.folder.path("c")));
  for (const char* name : {"comparison.json", "report.html", "figures/map.svg", "figures/difference.svg"}) {
    const auto text = readFile(two.folder.path(std::string("c/") + name));
    VERIFY_OK(text);
    QVERIFY2(text->size() > 500 && text->find("\"run\":") != std::string::npos, name);
  }
}

void TestRunComparison::report_isInTheLanguage() {
  const auto text =
      readFile(qEnvironmentVariable("BREAKAWAY_SOURCE_DIR").toStdString() + "/resources/lang/core_de.json");
  VERIFY_OK(text);
  const auto german = Catalogue::read(*text);
  VERIFY_OK(german);
  const Two two(noisyMap(0.02, 1), noisyMap(0.024, 2));
  const RunComparison comparison = two.comparison();
  VERIFY_OK(writeComparison(comparison, two.folder.path("c"), *german));
  const std::string report = readFile(two.folder.path("c/report.html")).value();
  for (const char* words : {"Was sich geändert hat", "Über die 95-%-Intervalle hinaus geändert:", "im Mittel",
                            "Haftreibung, rechtsherum", "früher, linksherum", "jenseits der Intervalle"})
    QVERIFY2(report.find(words) != std::string::npos, words);
  for (const char* words : {"changed", "Changed", "before<", "on average", "earlier", "clockwise", "interval of"})
    QVERIFY2(report.find(words) == std::string::npos, words);
  QVERIFY(readFile(two.folder.path("c/comparison.json"))->find("Changed beyond") != std::string::npos);
}

QTEST_APPLESS_MAIN(TestRunComparison)
#include "tst_run_comparison.moc"
