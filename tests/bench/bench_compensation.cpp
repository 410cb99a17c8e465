// What compensation gains on rigs whose friction was measured: seeds of the presets, and rigs at random with another 40
// % of friction concealed around the rotor. Usage: bench_compensation [COUNT [FIRST_SEED]]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <regex>

#include "base/atomic_file.h"
#include "figures/compensation_figures.h"
#include "figures/pulse_figures.h"
#include "firmware_link/presets.h"
#include "firmware_link/simulated_board.h"
#include "support/random_rig.h"

using namespace breakaway;

namespace {

double number(const BenchFigure& figure, const std::string& name) {
  for (const auto& [known, value] : figure.keyNumbers) {
    if (known == name) return value;
  }
  return 0.0;
}

Result<void> run(const std::string& name, const std::string& uri, unsigned seed) {
  auto drive = openDrive(uri, seed);
  if (!drive) return drive.error();
  CommissionOptions options;
  options.keepRecordings = false;
  auto bench = commissionBench(std::move(*drive), options);
  if (!bench) return bench.error();
  const auto pulses = twoWayPulseFigures(*bench);
  if (!pulses) return pulses.error();
  const auto slow = slowMotionFigure(*bench);
  if (!slow) return slow.error();
  // F + B·ω takes the mean off: what the friction varies by around the rotor is left.
  const FrictionMap& map = bench->measured.map;
  double squares = 0.0;
  for (const MapBin& bin : map.bins) {
    for (const WayBin& way : bin.way) squares += std::pow(way.coulomb_Nm.value / map.coulombAverage_Nm.value - 1.0, 2);
  }
  std::printf("%-20s %5.1f |", name.c_str(), std::sqrt(2.0 * static_cast<double>(map.bins.size()) / squares));
  for (const BenchFigure& one : *pulses) {
    const double none = number(one, "velocity_error_none_rad_per_s");
    if (none == 0.0) continue;
    std::printf(" %7.1f %7.1f |", number(one, "none_over_f_and_b"), none / number(one, "velocity_error_map_rad_per_s"));
  }
  std::printf(" %7.2f %7.2f\n", number(*slow, "average_over_map"), number(*slow, "average_over_map_alone"));
  std::fflush(stdout);
  return {};
}

/// A random rig's text with friction concealed in it.
std::string concealed(unsigned seed) {
  std::string text = test::RandomRig(seed).text();
  text.resize(text.rfind('}'));
  return text +
         ", \"effects\": [ { \"effect\": \"position_dependent_friction\", \"parameters\": { \"order\": 2, "
         "\"amplitude\": 0.4, \"phase_rad\": 1.0 } } ] }\n";
}

/// The preset `servo` with the same friction at every angle; without `step` static friction is hardly above Coulomb's.
std::string evenServo(bool step) {
  auto text = readFile(resourcesFolder() + "/presets/servo.rig.json");
  if (!text) return {};
  static const std::regex swings(R"re(("harmonics(_Nm)?": )\[\[[^}]*\]\])re");
  std::string even = std::regex_replace(*text, swings, "$1[]");
  if (step) return even;
  for (const auto& [from, to] : {std::pair("0.022", "0.0171"), std::pair("0.021,", "0.0166,")}) {
    const size_t at = even.find(from);
    if (at != std::string::npos) even.replace(at, std::string(from).size(), to);
  }
  return even;
}

}  // namespace

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 12;
  const unsigned first = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 9100;
  const auto folder = std::filesystem::temp_directory_path() / ("breakaway-compensation-" + std::to_string(first));
  if (!makeFolder(folder.string())) return 1;
  std::printf(
      "friction over its own rms variation around the rotor; times by which compensation brings the velocity error "
      "down: two-way pulses from standstill and at three speeds, none over F + B*w "
      "and "
      "over the map; slow motion, average over map, with disturbance feedback and alone\n");
  int failures = 0;
  const auto tried = [&failures](const std::string& name, const std::string& uri, unsigned seed) {
    if (const auto ran = run(name, uri, seed); !ran) {
      std::printf("%-20s %s\n", name.c_str(), ran.error().message().c_str());
      ++failures;
    }
  };
  for (const unsigned seed : {1u, 2u, 3u, 4u}) tried("servo seed " + std::to_string(seed), "simulated:servo", seed);
  for (const unsigned seed : {1u, 2u}) tried("uneven seed " + std::to_string(seed), "simulated:uneven", seed);
  tried("published-0134", "simulated:published-0134", 1);
  for (const bool step : {true, false}) {
    const std::string file = (folder / (step ? "even.rig.json" : "even-stepless.rig.json")).string();
    if (!writeFile(file, evenServo(step))) return 1;
    tried(step ? "servo, even" : "servo, even, no step", "simulated:" + file, 1);
  }
  for (int k = 0; k < count; ++k) {
    const unsigned seed = first + static_cast<unsigned>(k);
    const std::string file = (folder / ("random-" + std::to_string(seed) + ".rig.json")).string();
    if (!writeFile(file, concealed(seed))) return 1;
    tried("random seed " + std::to_string(seed), "simulated:" + file, seed);
  }
  std::error_code code;
  std::filesystem::remove_all(folder, code);
  return failures == 0 ? 0 : 1;
}
