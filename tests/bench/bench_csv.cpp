// How long a recording of a million rows takes to read, beside `wc -l` and a plain std::getline/strtod reader.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "recording/csv.h"
#include "support/processor_time.h"

using namespace breakaway;
using namespace breakaway::test;

namespace {

constexpr size_t rows = 1'000'000;
constexpr double target_s = 1.0;

Recording motion() {
  std::vector<Channel> channels{
      {"time_s", {}}, {"angle_rad", {}}, {"velocity_rad_per_s", {}}, {"current_A", {}}, {"voltage_V", {}}};
  for (size_t k = 0; k < rows; ++k) {
    const double t = static_cast<double>(k) * 1e-4;
    const double angle = std::floor(2000.0 * std::sin(0.7 * t)) * 6.283185307179586 / 14400.0;
    const std::vector<double> row{t, angle, 1400.0 * std::cos(0.7 * t), std::round(1e5 * std::sin(3.1 * t)) / 1e5,
                                  std::round(1e4 * std::cos(2.3 * t)) / 1e3};
    for (size_t c = 0; c < channels.size(); ++c) channels[c].values.push_back(row[c]);
  }
  return *Recording::seal("motion", std::move(channels));
}

/// The reader that everybody writes first.
size_t getlineReader(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  std::vector<std::vector<double>> columns(5);
  while (std::getline(file, line)) {
    const char* at = line.c_str();
    for (auto& column : columns) {
      char* end = nullptr;
      column.push_back(std::strtod(at, &end));
      at = *end == ',' ? end + 1 : end;
    }
  }
  return columns[0].size();
}

/// The shortest of five runs, in s of processor time.
double shortest_s(const std::function<bool()>& job) {
  double best = INFINITY;
  for (int run = 0; run < 5; ++run) {
    const ProcessorTime time;
    if (!job()) std::abort();
    best = std::min(best, time.elapsed_s());
  }
  return best;
}

}  // namespace

int main() {
  const std::string path =
      std::filesystem::temp_directory_path() / ("breakaway_bench_csv_" + std::to_string(std::rand()) + ".csv");
  if (const auto done = writeCsv(motion(), path); !done) {
    std::fprintf(stderr, "%s\n", done.error().message().c_str());
    return 2;
  }
  const double megabytes = static_cast<double>(std::filesystem::file_size(path)) * 1e-6;
  const double read_s = shortest_s([&] { return readCsv(path)->rows() == rows; });
  const double getline_s = shortest_s([&] { return getlineReader(path) == rows; });
  const double wc_s = shortest_s([&] { return std::system(("wc -l '" + path + "' >/dev/null").c_str()) == 0; });
  std::filesystem::remove(path);

  std::printf("reading %zu rows x 5 columns, %.0f MB, best of 5\n", rows, megabytes);
  std::printf("  readCsv              %.3f s  %4.0f MB/s   target < %.0f s: %s\n", read_s, megabytes / read_s, target_s,
              read_s < target_s ? "met" : "MISSED");
  std::printf("  getline and strtod   %.3f s  readCsv takes 1/%.1f of it\n", getline_s, getline_s / read_s);
  std::printf("  wc -l                %.3f s  readCsv takes %.1f times as long\n", wc_s, read_s / wc_s);
  return read_s < target_s ? 0 : 1;
}
