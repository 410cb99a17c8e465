// Records the shipped example on its simulated rig: make_example EXAMPLE.rig.json OUT_FOLDER
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "experiment/drive.h"
#include "firmware_link/simulated_board.h"
#include "motor/bench.h"
#include "recording/csv.h"

using namespace breakaway;

namespace {

constexpr double duration_s = 30.0;

double rounded(double value, double step) {
  return std::round(value / step) * step;
}

/// Speeds from creeping to fast, both ways, with reversals: what tells friction's kinds apart.
double speedAt(double time_s) {
  const double turn = 2.0 * std::numbers::pi;
  if (time_s < 10.0) return 6.0 * std::sin(turn * 0.23 * time_s) + 2.0 * std::sin(turn * 0.91 * time_s);
  if (time_s < 20.0) return 35.0 * std::sin(turn * 0.17 * time_s) + 12.0 * std::sin(turn * 0.61 * time_s);
  const double steps[] = {3.0, -3.0, 15.0, 1.5, -15.0, 40.0, -1.5, -40.0, 8.0, -8.0};
  return steps[static_cast<size_t>(time_s - 20.0) % 10];
}

int fail(const Error& error) {
  std::fprintf(stderr, "make_example: %s\n", error.message().c_str());
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return fail({"", "expected the rig file and the folder to write to"});
  auto drive = openDrive(std::string("simulated:") + argv[1], 11);
  if (!drive) return fail(drive.error());
  std::vector<Sample> samples;
  (*drive)->command({.zeroCurrentSensor = true});
  if (const auto done = (*drive)->advance(1.0, samples); !done) return fail(done.error());
  samples.clear();
  for (double time_s = 0.0; time_s < duration_s - 1e-9; time_s += 0.001) {
    (*drive)->command({Command::Mode::velocity, speedAt(time_s), 0.0, false});
    if (const auto done = (*drive)->advance(0.001, samples); !done) return fail(done.error());
  }
  std::vector<Channel> channels{{"time_s", {}}, {"angle_rad", {}}, {"current_A", {}}};
  for (const Sample& sample : samples) {
    channels[0].values.push_back(rounded(sample.time_s - samples.front().time_s, 0.0001));
    channels[1].values.push_back(rounded(sample.angle_rad, 1e-5));
    channels[2].values.push_back(rounded(sample.current_A, 1e-4));
  }
  // Decimal text stays short only if the double is the nearest one to it.
  for (Channel& channel : channels) {
    for (double& value : channel.values) {
      char text[40];
      std::snprintf(text, sizeof text, "%.5f", value);
      value = std::strtod(text, nullptr);
    }
  }
  const std::string folder = argv[2];
  const auto recording = Recording::seal("example", std::move(channels), {{"board", (*drive)->identity().device}});
  if (!recording) return fail(recording.error());
  if (const auto done = writeCsv(*recording, folder + "/example.csv"); !done) return fail(done.error());
  Bench bench;
  bench.name = "example";
  bench.input = DriveInput::current;
  bench.supply_V = (*drive)->identity().supply_V;
  bench.countsPerUnit = (*drive)->identity().countsPerRev;
  bench.motor.torqueConstant = 0.07;
  bench.motor.inertia = 1.2e-3;
  bench.motor.viscous = 1e-4;
  bench.motor.coulomb = 0.035;
  bench.trusted = {"torque_constant_Nm_per_A"};
  bench.controller = {ControlMode::velocity,
                      (*drive)->settings().velocity_kp_A_s_per_rad,
                      0.0,
                      0.0,
                      (*drive)->settings().observer_cutoff_rad_per_s,
                      (*drive)->settings().nominal_inertia_kg_m2,
                      (*drive)->settings().nominal_torque_constant_Nm_per_A,
                      (*drive)->settings().current_limit_A};
  if (const auto done = writeBench(bench, folder + "/example.bench.json"); !done) return fail(done.error());
  return 0;
}
