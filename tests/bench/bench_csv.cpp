// How long a recording of a million rows takes to read and to import, beside `wc -l` and a plain std::getline/strtod
// reader; packed by gzip, and as a workbook of 100,000 rows.
#include <sys/resource.h>
#include <zip.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "recording/csv.h"
#include "recording/import/import.h"
#include "support/processor_time.h"

using namespace breakaway;
using namespace breakaway::test;

namespace {

constexpr size_t rows = 1'000'000;
constexpr double target_s = 1.0;
constexpr double importTarget_s = 0.5, packedTarget_s = 1.5, workbookTarget_s = 5.0;
constexpr double importTarget_MB = 150.0;
constexpr size_t workbookRows = 100'000;

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

/// The first rows as a workbook of one sheet.
bool writeWorkbook(const Recording& recording, const std::string& path) {
  std::string sheet = "<worksheet><sheetData><row>";
  for (const Channel& channel : recording.channels())
    sheet += "<c t=\"inlineStr\"><is><t>" + channel.name + "</t></is></c>";
  sheet += "</row>";
  char cell[64];
  for (size_t k = 0; k < workbookRows; ++k) {
    sheet += "<row>";
    for (const Channel& channel : recording.channels()) {
      std::snprintf(cell, sizeof cell, "<c><v>%.9g</v></c>", channel.values[k]);
      sheet += cell;
    }
    sheet += "</row>";
  }
  sheet += "</sheetData></worksheet>";
  const std::string book = "<workbook/>";
  zip_t* archive = zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, nullptr);
  if (archive == nullptr) return false;
  const auto add = [archive](const char* member, const std::string& text) {
    return zip_file_add(archive, member, zip_source_buffer(archive, text.data(), text.size(), 0), 0) >= 0;
  };
  return add("xl/workbook.xml", book) && add("xl/worksheets/sheet1.xml", sheet) && zip_close(archive) == 0;
}

double peakMemory_MB() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1e-3;
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

int main(int argc, char** argv) {
  if (argc == 2) {  // in a process of its own, so that its memory is import's
    if (!importRecording(argv[1])) return 1;
    std::printf("%.0f\n", peakMemory_MB());
    return 0;
  }
  const std::string path =
      std::filesystem::temp_directory_path() / ("breakaway_bench_csv_" + std::to_string(std::rand()) + ".csv");
  const std::string book = path + ".xlsx";
  if (const auto done = writeCsv(motion(), path); !done) {
    std::fprintf(stderr, "%s\n", done.error().message().c_str());
    return 2;
  }
  if (std::system(("gzip -1 -k '" + path + "'").c_str()) != 0 || !writeWorkbook(motion(), book)) return 2;
  const double megabytes = static_cast<double>(std::filesystem::file_size(path)) * 1e-6;
  const double read_s = shortest_s([&] { return readCsv(path)->rows() == rows; });
  const double import_s = shortest_s([&] { return importRecording(path)->recording.rows() == rows; });
  const double packed_s = shortest_s([&] { return importRecording(path + ".gz")->recording.rows() == rows; });
  const double workbook_s = shortest_s([&] { return importRecording(book)->recording.rows() == workbookRows; });
  const double getline_s = shortest_s([&] { return getlineReader(path) == rows; });
  const double wc_s = shortest_s([&] { return std::system(("wc -l '" + path + "' >/dev/null").c_str()) == 0; });
  double memory_MB = INFINITY;
  if (FILE* own = popen(("'" + std::string(argv[0]) + "' '" + path + "'").c_str(), "r")) {
    if (std::fscanf(own, "%lf", &memory_MB) != 1) memory_MB = INFINITY;
    pclose(own);
  }
  for (const char* end : {"", ".gz", ".xlsx"}) std::filesystem::remove(path + end);

  bool met = true;
  const auto line = [&met](const char* name, double value, double target, const char* unit) {
    std::printf("  %-22s %.3f %s   target < %.1f %s: %s\n", name, value, unit, target, unit,
                value < target ? "met" : "MISSED");
    met = met && value < target;
  };
  std::printf("reading %zu rows x 5 columns, %.0f MB, best of 5\n", rows, megabytes);
  line("readCsv", read_s, target_s, "s");
  line("import", import_s, importTarget_s, "s");
  line("import, memory", memory_MB, importTarget_MB, "MB");
  line("import, gzip", packed_s, packedTarget_s, "s");
  line("import, 100,000 of xlsx", workbook_s, workbookTarget_s, "s");
  std::printf("  getline and strtod   %.3f s  readCsv takes 1/%.1f of it\n", getline_s, getline_s / read_s);
  std::printf("  wc -l                %.3f s  readCsv takes %.1f times as long\n", wc_s, read_s / wc_s);
  return met ? 0 : 1;
}
