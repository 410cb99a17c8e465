// The whole commissioning over a pty against the image on the emulated Cortex-M3: 36 bins, two turns, about five
// minutes of the rig's time. Run by ./dev test firmware.
#include <QElapsedTimer>
#include <QProcess>
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <future>

#include "firmware/emulator.h"
#include "firmware_link/simulated_truth.h"
#include "friction/map_export.h"
#include "recording/csv.h"
#include "support/map_accuracy.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

class TestCortexM3Journey : public QObject {
  Q_OBJECT
 private slots:
  void commissioning_isAsGoodAsInProcess();
};

namespace {

constexpr size_t bins = 36;

Result<FrictionMap> commissioned(const std::string& board, int seed, const std::string& folder, int patience_ms) {
  QProcess process;
  process.setStandardOutputFile(QProcess::nullDevice());
  const std::string source = qgetenv("BREAKAWAY_SOURCE_DIR").toStdString();
  process.start(
      QString::fromStdString(qgetenv("BREAKAWAY_BIN_DIR").toStdString() + "/breakaway"),
      {"commission", "--board", QString::fromStdString(board), "--bench",
       QString::fromStdString(source + "/resources/presets/servo.bench.json"), "--bins", QString::number(bins),
       "--turns", "2", "--run-s", "2", "--seed", QString::number(seed), "--out", QString::fromStdString(folder)});
  if (!process.waitForFinished(patience_ms)) {
    process.kill();
    process.waitForFinished(5000);
    return Error{board, "was not commissioned in time"};
  }
  if (process.exitCode() != 0) return Error{board, process.readAllStandardError().trimmed().toStdString()};
  return readMap(folder + "/map.json");
}

/// When the job's last recording ended, in the board's time.
double rigTimeOf(const std::string& folder) {
  double last_s = 0.0;
  for (const auto& file : std::filesystem::directory_iterator(folder + "/recordings")) {
    const auto recording = readCsv(file.path().string());
    if (!recording) qFatal("%s", recording.error().message().c_str());
    last_s = std::max(last_s, recording->time().back());
  }
  return last_s;
}

/// RMS error over the bins, relative, of each curve of the map.
std::array<double, 4> errorsOf(const FrictionMap& map, const FrictionMap& truth) {
  return {deviation(map, truth, Way::cw, staticOf).rms, deviation(map, truth, Way::ccw, staticOf).rms,
          deviation(map, truth, Way::cw, coulombOf).rms, deviation(map, truth, Way::ccw, coulombOf).rms};
}

/// One run's error is itself a matter of chance: the in-process board's is taken over several seeds.
Result<std::vector<FrictionMap>> commissionedInProcess(const TemporaryFolder& folder) {
  std::vector<FrictionMap> maps;
  for (int seed = 1; seed <= 8; ++seed) {
    const std::string number = std::to_string(seed);
    auto map = commissioned("simulated:servo", seed, folder.path("in_process" + number), 120000);
    if (!map) return map.error();
    maps.push_back(std::move(*map));
  }
  return maps;
}

double together(const std::array<double, 4>& errors) {
  double squares = 0.0;
  for (const double error : errors) squares += error * error;
  return std::sqrt(squares / 4.0);
}

}  // namespace

void TestCortexM3Journey::commissioning_isAsGoodAsInProcess() {
  const TemporaryFolder folder;
  const Emulator emulator(qgetenv("BREAKAWAY_FIRMWARE_DIR").toStdString() + "/emulated_board_quick.elf",
                          Emulator::byConsole());
  QVERIFY2(emulator.runs(), qPrintable(emulator.said()));
  // The emulator keeps to one core; the other one has time for these.
  auto others = std::async(std::launch::async, [&folder] { return commissionedInProcess(folder); });
  QElapsedTimer watch;
  watch.start();
  const auto map = commissioned(emulator.uri(), 1, folder.path("cortex_m3"), 900000);
  VERIFY_OK(map);
  const double took_s = static_cast<double>(watch.elapsed()) * 1e-3, rig_s = rigTimeOf(folder.path("cortex_m3"));
  QCOMPARE(map->bins.size(), bins);
  const auto truth = trueMap("simulated:servo", bins, map->totalVelocity_rad_per_s);
  VERIFY_OK(truth);
  const std::array<double, 4> emulated = errorsOf(*map, *truth);
  const auto maps = others.get();
  VERIFY_OK(maps);
  std::array<double, 4> inProcess{};
  for (const FrictionMap& other : *maps) {
    const std::array<double, 4> errors = errorsOf(other, *truth);
    for (size_t k = 0; k < 4; ++k) inProcess[k] = std::hypot(inProcess[k], errors[k]);
  }
  for (double& error : inProcess) error /= std::sqrt(static_cast<double>(maps->size()));
  std::printf(
      "commissioning over the pty took %.0f s for %.0f s of the rig's time; errors of the maps, emulated against "
      "in-process:\n",
      took_s, rig_s);
  const char* const names[] = {"static cw", "static ccw", "Coulomb cw", "Coulomb ccw"};
  for (size_t k = 0; k < 4; ++k)
    std::printf("  %-12s %.3f %% against %.3f %%\n", names[k], 100.0 * emulated[k], 100.0 * inProcess[k]);
  const double ratio = together(emulated) / together(inProcess);
  std::printf("  together     %.2f times\n", ratio);
  QVERIFY2(rig_s > 60.0 && rig_s <= 310.0, qPrintable(QString::number(rig_s)));
  QVERIFY2(ratio < 1.2, qPrintable(QString::number(ratio)));
  QVERIFY2(ratio > 0.4, qPrintable(QString::number(ratio)));
}

QTEST_GUILESS_MAIN(TestCortexM3Journey)
#include "tst_cortex_m3_journey.moc"
