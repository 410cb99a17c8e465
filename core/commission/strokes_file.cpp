#include "commission/strokes_file.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/json_object.h"
#include "base/made.h"

namespace breakaway {

namespace {

using Json = nlohmann::ordered_json;
constexpr const char* strokesSchema = "breakaway.progress/1";
constexpr const char* wayNames[] = {"bins_cw", "bins_ccw"};
constexpr double mostSamples = 1e9;

}  // namespace

std::string strokesFile(const std::string& folder, size_t number, bool brokenOff) {
  return fmt::format("{}/progress/strokes-{:02}{}.json", folder, number + 1, brokenOff ? "-broken-off" : "");
}

Result<void> writeStrokes(const TravelRun& run, const std::string& path) {
  Json json{{"schema", strokesSchema},      {"target_m_per_s", run.target_m_per_s},
            {"duration_s", run.duration_s}, {"middle_s", run.middle_s},
            {"zero_A", run.zero_A},         {"half_span_s", run.halfSpan_s},
            {"broken_off", run.brokenOff}};
  for (size_t way = 0; way < 2; ++way) {
    json[wayNames[way]] = Json::array();
    for (const TravelBinSums& sum : run.bins[way])
      json[wayNames[way]].push_back({sum.samples, sum.current_A, sum.velocity_m_per_s, sum.acceleration_m_per_s2});
  }
  return writeFile(path, withMade(json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n"));
}

Result<TravelRun> readStrokes(const std::string& path) {
  auto root = JsonObject::fromFile(path);
  if (!root) return root.error();
  if (const std::string found = root->text("schema"); found != strokesSchema)
    root->fault("schema", "is \"" + found + "\", expected \"" + strokesSchema + "\"");
  TravelRun run{root->number("target_m_per_s", Allowed::positive),
                root->number("duration_s", Allowed::positive),
                root->number("middle_s"),
                root->number("zero_A"),
                root->number("half_span_s", Allowed::positive),
                {},
                root->flag("broken_off", false)};
  for (size_t way = 0; way < 2; ++way) {
    for (const auto& row : root->rows(wayNames[way], 4)) {
      const bool count = row[0] >= 0.0 && row[0] <= mostSamples;
      if (!count) root->fault(wayNames[way], "holds a wrong number of samples");
      run.bins[way].push_back({count ? static_cast<size_t>(row[0]) : 0, row[1], row[2], row[3]});
    }
  }
  if (run.bins[0].size() != run.bins[1].size()) root->fault(wayNames[1], "has another length than the other way");
  if (const auto done = root->finish(); !done) return done.error();
  return run;
}

}  // namespace breakaway
