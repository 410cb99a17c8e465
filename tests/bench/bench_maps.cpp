// Map accuracy against the truth: the preset and rigs at random. Usage: bench_maps [COUNT [FIRST_SEED]]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "base/atomic_file.h"
#include "firmware_link/simulated_board.h"
#include "firmware_link/simulated_truth.h"
#include "report/commission.h"
#include "support/map_accuracy.h"
#include "support/random_rig.h"

using namespace breakaway;

namespace {

struct Worst {
  double rms = 0.0, correlation = 1.0, coulomb = 0.0, viscous = 0.0;
  size_t failures = 0, rigs = 0, within = 0;
};

void run(const std::string& name, const std::string& uri, unsigned seed, Worst& worst) {
  auto drive = openDrive(uri, seed);
  if (!drive) {
    std::printf("%-22s %s\n", name.c_str(), drive.error().message().c_str());
    ++worst.failures;
    return;
  }
  CommissionOptions options;
  options.rig = name;
  options.keepRecordings = false;
  const auto begin = std::chrono::steady_clock::now();
  const auto result = commission(**drive, options);
  const double elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  ++worst.rigs;
  if (!result) {
    std::printf("%-22s %s\n", name.c_str(), result.error().message().c_str());
    ++worst.failures;
    return;
  }
  const auto truth = trueMap(uri, options.bins, result->map.totalVelocity_rad_per_s);
  if (!truth) std::exit(1);
  std::printf("%-22s", name.c_str());
  bool within = true;
  for (const Way way : {Way::cw, Way::ccw}) {
    const auto still = test::deviation(result->map, *truth, way, test::staticOf);
    const auto coulomb = test::deviation(result->map, *truth, way, test::coulombOf);
    const auto viscous = test::deviation(result->map, *truth, way, test::viscousOf);
    const double correlation = result->map.repeatability[static_cast<size_t>(way)].correlation;
    std::printf(" %5.2f %6.2f %7.4f %5.2f %6.2f |", 100.0 * still.rms, 100.0 * still.mean, correlation,
                100.0 * coulomb.rms, 100.0 * viscous.rms);
    worst.rms = std::max(worst.rms, still.rms);
    worst.correlation = std::min(worst.correlation, correlation);
    worst.coulomb = std::max(worst.coulomb, coulomb.rms);
    worst.viscous = std::max(worst.viscous, viscous.rms);
    within = within && still.rms <= 0.05 && correlation > 0.9;
  }
  worst.within += within ? 1 : 0;
  std::printf(" %4.0f %5.2f %4zu\n", result->rigTime_s, elapsed_s, result->missed);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 16;
  const unsigned first = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1000;
  const auto folder = std::filesystem::temp_directory_path() / ("breakaway-maps-" + std::to_string(first));
  if (!makeFolder(folder.string())) return 1;
  std::printf(
      "friction maps of simulated rigs against the truth, in %% of the mean: static rms, static mean, correlation of "
      "turns, coulomb rms, viscous rms\n");
  std::printf("%-22s %-35s| %-36s| rig s cpu s missed\n", "", " clockwise", " counter-clockwise");
  Worst preset, random;
  run("servo", "simulated", 1, preset);
  for (int k = 0; k < count; ++k) {
    const unsigned seed = first + static_cast<unsigned>(k);
    const std::string file = (folder / ("random-" + std::to_string(seed) + ".rig.json")).string();
    if (!writeFile(file, test::RandomRig(seed).text())) return 1;
    run("random seed " + std::to_string(seed), "simulated:" + file, seed, random);
  }
  std::error_code code;
  std::filesystem::remove_all(folder, code);
  std::printf(
      "%zu of %zu random rigs within 5 %% and above 0.9; worst: static %.2f %%, correlation %.4f, coulomb %.2f %%, "
      "viscous %.1f %%; %zu failed\n",
      random.within, random.rigs, 100.0 * random.rms, random.correlation, 100.0 * random.coulomb,
      100.0 * random.viscous, random.failures);
  return preset.failures + random.failures == 0 ? 0 : 1;
}
