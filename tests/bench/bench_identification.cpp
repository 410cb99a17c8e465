// The identified motor against the truth on rigs at random whose current sensor errs. Usage: bench_identification
// [COUNT [FIRST_SEED]]
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "base/atomic_file.h"
#include "base/statistics.h"
#include "commission/commission.h"
#include "firmware_link/simulated_board.h"
#include "plant/rig.h"
#include "support/random_rig.h"

using namespace breakaway;

namespace {

constexpr size_t quantities = 9;
constexpr const char* names[quantities] = {"R", "L", "Kt", "J", "J by ramps", "J by reversal", "F", "B", "g"};
constexpr double targets[quantities] = {0.02, 0.02, 0.02, 0.02, 0.02, 0.02, 0.03, 0.03, 0.005};

/// What the bench believes of the sensor, and what else it has.
struct Case {
  const char* name;
  double gainInterval;  ///< and the rigs' gains err by as much
  bool knownInertia;
  bool disc;    ///< half as heavy again as the rotor, known to 0.5 %: the motor is identified with it before
  bool honest;  ///< rigs whose bridges bend their duty, with the sensors' tolerances
};
constexpr Case cases[] = {{"gain trusted to 0.5 %", 0.005, false, false, false},
                          {"the same on honest rigs", 0.005, false, false, true},
                          {"known added inertia, gain not, honest rigs", 0.027, false, true, true},
                          {"inertia known, gain not, honest rigs", 0.027, true, false, true},
                          {"nothing trusted, honest rigs", 0.027, false, false, true}};
constexpr double discTolerance = 0.005;

struct Tally {
  double worst = 0.0, squares = 0.0;
  size_t within = 0, covered = 0, judged = 0, runs = 0;
};

void take(Tally& tally, const Estimate& estimate, double truth, double target) {
  const double error = estimate.value / truth - 1.0;
  tally.worst = std::max(tally.worst, std::abs(error));
  tally.squares += error * error;
  tally.within += std::abs(error) <= target ? 1 : 0;
  if (estimate.standardError > 0.0) {
    ++tally.judged;
    tally.covered += estimate.low95() <= truth && truth <= estimate.high95() ? 1 : 0;
  }
  ++tally.runs;
}

/// Part of the current sensor's gain that comes from its own supply.
double bySupply(const Rig& rig) {
  return 1.0 + rig.currentSensor.supplyDeviation_V / rig.currentSensor.adcRange_V;
}

void compare(const Commission& done, const Rig& rig, std::array<Tally, quantities>& tallies) {
  const IdentifiedMotor& motor = done.motor;
  double F = 0.0, B = 0.0;
  for (size_t w = 0; w < 2; ++w) F += 0.5 * rig.coulomb_Nm[w].mean, B += 0.5 * rig.viscous_Nm_s_per_rad[w].mean;
  const std::array<std::pair<Estimate, double>, quantities> pairs{{
      {motor.resistance_ohm, rig.resistance_ohm},
      {motor.inductance_H, rig.inductance_H},
      {motor.torqueConstant_Nm_per_A, rig.torqueConstant_Nm_per_A},
      {motor.inertia_kg_m2, rig.inertia_kg_m2},
      {motor.rampInertia_kg_m2, rig.inertia_kg_m2},
      {motor.reversalInertia_kg_m2, rig.inertia_kg_m2},
      {motor.coulomb_Nm, F},
      {motor.viscous_Nm_s_per_rad, B},
      {motor.currentGain, (1.0 + rig.currentSensor.gainError) * bySupply(rig)},
  }};
  for (size_t k = 0; k < quantities; ++k) {
    if (pairs[k].first.value != 0.0) take(tallies[k], pairs[k].first, pairs[k].second, targets[k]);
  }
}

std::string with(std::string text, const std::string& field, const std::string& added, double value) {
  return text.replace(text.find(field), field.size(), added + ": " + std::to_string(value) + ", " + field);
}

/// The motor with a disc on its shaft that is as heavy as its tolerance allows by chance.
Result<MotorRecord> withDisc(const std::string& text, const std::string& file, double inertia_kg_m2, double error,
                             CommissionOptions options, unsigned seed) {
  char added[64];
  std::snprintf(added, sizeof added, "\"added_inertia_kg_m2\": %.12g, ", inertia_kg_m2 * (1.0 + error));
  std::string mounted = text;
  const std::string field = "\"inertia_kg_m2\"";
  mounted.replace(mounted.find(field), field.size(), added + field);
  if (auto written = writeFile(file, mounted); !written) return written.error();
  auto drive = openDrive("simulated:" + file, seed + 50000);
  if (!drive) return drive.error();
  options.motorOnly = true;
  options.addedInertia_kg_m2 = {inertia_kg_m2, discTolerance / 1.959964 * inertia_kg_m2};
  const auto done = commission(**drive, options);
  if (!done) return done.error();
  return MotorRecord{done->identity.device, done->motor, done->addedInertia_kg_m2};
}

}  // namespace

int main(int argc, char** argv) {
  const unsigned count = argc > 1 ? static_cast<unsigned>(std::atoi(argv[1])) : 20;
  const unsigned first = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 2000;
  const auto folder = std::filesystem::temp_directory_path() / ("breakaway-identification-" + std::to_string(first));
  if (!makeFolder(folder.string())) return 1;
  const std::string file = (folder / "random.rig.json").string();
  size_t failed = 0;
  for (const Case& one : cases) {
    std::array<Tally, quantities> tallies;
    for (unsigned seed = first; seed < first + count; ++seed) {
      Random random(seed);
      const double deviation = one.gainInterval / 1.959964 * random.normal();
      // What is trusted is the gain of the whole chain, the sensor's own supply included.
      const std::string plain = test::RandomRig(seed).text(one.honest);
      const auto drawn = readRigText(plain, "random");
      if (!drawn) return 1;
      const double gainError = (1.0 + deviation) / bySupply(*drawn) - 1.0;
      const std::string text = with(plain, "\"sensitivity_V_per_A\"", "\"gain_error\"", gainError);
      const auto rig = readRigText(text, "random");
      if (!rig) return 1;
      CommissionOptions options;
      options.keepRecordings = false;
      options.sweeps.bins = 36;
      options.bench.emplace();
      options.bench->currentGainInterval = one.gainInterval;
      if (one.knownInertia) {
        options.bench->trusted.insert("inertia_kg_m2");
        options.bench->motor.inertia = rig->inertia_kg_m2;
      }
      if (one.disc) {
        auto other =
            withDisc(text, file, 1.5 * rig->inertia_kg_m2, discTolerance / 1.959964 * random.normal(), options, seed);
        if (!other) {
          std::printf("seed %u: %s\n", seed, other.error().message().c_str());
          ++failed;
          continue;
        }
        options.against = std::move(*other);
      }
      if (!writeFile(file, text)) return 1;
      auto drive = openDrive("simulated:" + file, seed);
      if (!drive) return 1;
      const auto done = commission(**drive, options);
      if (!done) {
        std::printf("seed %u: %s\n", seed, done.error().message().c_str());
        ++failed;
        continue;
      }
      compare(*done, *rig, tallies);
    }
    std::printf("%s, %u rigs at random from seed %u\n", one.name, count, first);
    for (size_t k = 0; k < quantities; ++k) {
      const Tally& tally = tallies[k];
      const auto n = static_cast<double>(std::max<size_t>(1, tally.runs));
      std::printf(
          "  %-14s rms %5.2f %%, worst %6.2f %%, %2zu of %2zu within %.1f %%; 95 %% interval holds %2zu of %2zu\n",
          names[k], 100.0 * std::sqrt(tally.squares / n), 100.0 * tally.worst, tally.within, tally.runs,
          100.0 * targets[k], tally.covered, tally.judged);
    }
    std::fflush(stdout);
  }
  std::error_code code;
  std::filesystem::remove_all(folder, code);
  return failed == 0 ? 0 : 1;
}
