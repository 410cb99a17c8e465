// Linear axes against their truth: the preset over seeds, and odd axes, each commissioned whole.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/atomic_file.h"
#include "commission/commission.h"
#include "firmware_link/presets.h"
#include "firmware_link/simulated_board.h"
#include "firmware_link/simulated_truth.h"
#include "plant/rig.h"
#include "support/linear_rig.h"
#include "support/processor_time.h"

using namespace breakaway;
using namespace breakaway::test;

namespace {

struct Curve {
  double rms = 0.0, covered = 0.0;  ///< of the truth's mean; part of the bins whose 95 % interval holds the truth
};

Curve compared(const FrictionMap& map, const FrictionMap& truth, const std::function<Estimate(const MapBin&)>& read) {
  double squares = 0.0, level = 0.0, covered = 0.0;
  for (size_t k = 0; k < truth.bins.size(); ++k) {
    const Estimate measured = read(map.bins[k]);
    const double right = read(truth.bins[k]).value, error = measured.value - right;
    squares += error * error, level += right;
    covered += std::abs(error) <= 1.959964 * measured.standardError ? 1.0 : 0.0;
  }
  const auto n = static_cast<double>(truth.bins.size());
  return {std::sqrt(squares / n) / (level / n), covered / n};
}

struct Total {
  double worst[3] = {0.0, 0.0, 0.0}, covered[3] = {0.0, 0.0, 0.0};
  size_t maps = 0, failed = 0;
};

void score(const std::string& name, const std::string& uri, unsigned seed, Total& total) {
  const ProcessorTime time(ProcessorTime::Of::thread);
  auto drive = openDrive(uri, seed);
  const auto rig = rigFileOf(uri) ? readRig(*rigFileOf(uri)) : Result<Rig>(rigFileOf(uri).error());
  CommissionOptions options;
  options.rig = name;
  options.keepRecordings = false;
  const auto done = drive ? commission(**drive, options) : Result<Commission>(drive.error());
  const double cpu_s = time.elapsed_s();
  const auto truth = done ? trueMap(uri, done->map) : Result<FrictionMap>(done.error());
  if (!truth || !rig) {
    ++total.failed;
    std::printf("%-22s %s\n", name.c_str(), truth ? rig.error().message().c_str() : truth.error().message().c_str());
    return;
  }
  const double unit = rig->unitPerRad(), mass = rig->inertia_kg_m2 / (unit * unit);
  for (size_t w = 0; w < 2; ++w) {
    const Curve curves[] = {
        compared(done->map, *truth, [w](const MapBin& bin) { return bin.way[w].static_Nm; }),
        compared(done->map, *truth, [w](const MapBin& bin) { return bin.way[w].coulomb_Nm; }),
        compared(done->map, *truth, [w](const MapBin& bin) { return bin.way[w].viscous_Nm_s_per_rad; })};
    std::printf("%-22s %-3s", w == 0 ? name.c_str() : "", w == 0 ? "cw" : "ccw");
    for (size_t k = 0; k < 3; ++k) {
      std::printf("  %5.2f %4.0f", 100.0 * curves[k].rms, 100.0 * curves[k].covered);
      total.worst[k] = std::max(total.worst[k], curves[k].rms);
      total.covered[k] += curves[k].covered;
    }
    ++total.maps;
    if (w == 0) {
      const auto off = [](const Estimate& one, double right) { return 100.0 * (one.value / right - 1.0); };
      std::printf("  %6.2f %6.2f %6.2f", off(done->motor.inertia_kg_m2, mass),
                  off(done->motor.resistance_ohm, rig->resistance_ohm),
                  off(done->motor.backEmfConstant_V_s_per_rad, rig->backEmfConstant_V_s_per_rad / unit));
      const auto& run = done->compensatedRun;
      std::printf("  %5.0f %4.1f %4zu %5.1f", done->rigTime_s, cpu_s, done->missed,
                  run ? run->without_rad_per_s / run->with_rad_per_s : 0.0);
    }
    std::printf("\n");
  }
  std::fflush(stdout);
}

struct OddAxis {
  const char* name;
  LinearAxis axis;
};

std::vector<OddAxis> oddAxes() {
  std::vector<OddAxis> all(7);
  all[0] = {"random", {}};
  all[1].name = "0.4 kg, 80 mm";
  all[1].axis.length_m = 0.08, all[1].axis.mass_kg = 0.4, all[1].axis.coulomb_N = 2.0;
  all[2].name = "25 kg, 2.4 m";
  all[2].axis.length_m = 2.4, all[2].axis.mass_kg = 25.0, all[2].axis.coulomb_N = 25.0;
  all[2].axis.forceConstant_N_per_A = 40.0, all[2].axis.supply_V = 48.0;
  all[3].name = "10 um encoder";
  all[3].axis.counts_per_m = 1e5;
  all[4].name = "no index";
  all[4].axis.hasIndex = false;
  all[5].name = "starts at its end";
  all[5].axis.start = 0.0;
  all[6].name = "friction of 60 mA";
  all[6].axis.coulomb_N = 0.9;
  return all;
}

}  // namespace

int main() {
  std::printf(
      "RMS error in %% of the mean, and %% of the bins whose 95 %% interval holds the truth; errors of mass,\n"
      "resistance and back-EMF constant in %%; rig and computing time in s; breakaways missed; times by which the\n"
      "map lessens the velocity error of a slow to and fro\n");
  std::printf("%-22s %-3s  breakaway    Coulomb      viscous       mass      R     Ke    rig  cpu miss  gain\n", "axis",
              "way");
  Total total;
  for (unsigned seed = 1; seed <= 4; ++seed)
    score("linear, seed " + std::to_string(seed), "simulated:linear", seed, total);
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "breakaway-linear-axes";
  if (auto made = makeFolder(folder.string()); !made) {
    std::fprintf(stderr, "%s\n", made.error().message().c_str());
    return 1;
  }
  unsigned seed = 100;
  for (const OddAxis& odd : oddAxes()) {
    for (int repeat = 0; repeat < 2; ++repeat) {
      const std::string file = (folder / ("axis" + std::to_string(++seed) + ".rig.json")).string();
      if (auto written = writeFile(file, linearRigText(odd.axis, seed)); !written) {
        std::fprintf(stderr, "%s\n", written.error().message().c_str());
        return 1;
      }
      score(odd.name, "simulated:" + file, seed, total);
    }
  }
  std::error_code code;
  std::filesystem::remove_all(folder, code);
  const auto n = static_cast<double>(std::max<size_t>(1, total.maps));
  std::printf(
      "worst: breakaway %.2f %%, Coulomb %.2f %%, viscous %.2f %%; intervals hold %.1f %%, %.1f %%, %.1f %% of the "
      "bins; %zu failed\n",
      100.0 * total.worst[0], 100.0 * total.worst[1], 100.0 * total.worst[2], 100.0 * total.covered[0] / n,
      100.0 * total.covered[1] / n, 100.0 * total.covered[2] / n, total.failed);
  return total.failed == 0 ? 0 : 1;
}
