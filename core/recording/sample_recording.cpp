#include "recording/sample_recording.h"

#include <array>

#include "recording/columns.h"

namespace breakaway {

namespace {

struct Source {
  Quantity quantity;
  double (*of)(const Sample& sample);
};

constexpr auto sources = std::to_array<Source>({
    {Quantity::time, [](const Sample& s) { return s.time_s; }},
    {Quantity::position, [](const Sample& s) { return s.angle_rad; }},
    {Quantity::velocity, [](const Sample& s) { return s.velocity_rad_per_s; }},
    {Quantity::current, [](const Sample& s) { return s.current_A; }},
    {Quantity::voltage, [](const Sample& s) { return s.voltage_V; }},
    {Quantity::supply, [](const Sample& s) { return s.supply_V; }},
    {Quantity::currentReference, [](const Sample& s) { return s.current_reference_A; }},
    {Quantity::velocityReference, [](const Sample& s) { return s.velocity_reference_rad_per_s; }},
    {Quantity::positionReference, [](const Sample& s) { return s.angle_reference_rad; }},
    {Quantity::disturbance, [](const Sample& s) { return s.disturbance_estimate_Nm; }},
    {Quantity::index, [](const Sample& s) { return s.index ? 1.0 : 0.0; }},
    {Quantity::enabled, [](const Sample& s) { return s.enabled ? 1.0 : 0.0; }},
});

}  // namespace

std::vector<std::string> sampleColumns(Axis axis) {
  std::vector<std::string> names;
  names.reserve(sources.size());
  for (const Source& source : sources) names.emplace_back(columnName(source.quantity, axis));
  return names;
}

void appendRow(const Sample& sample, std::vector<double>& rows) {
  for (const Source& source : sources) rows.push_back(source.of(sample));
}

Result<Recording> sealSamples(const std::string& name, std::span<const Sample> samples,
                              std::vector<std::pair<std::string, std::string>> notes, Axis axis) {
  if (samples.empty()) return Error{name, "holds no sample"};
  std::vector<Channel> channels;
  for (const Source& source : sources) {
    Channel& channel = channels.emplace_back(Channel{columnName(source.quantity, axis), {}});
    channel.values.reserve(samples.size());
    for (const Sample& sample : samples) channel.values.push_back(source.of(sample));
  }
  return Recording::seal(name, std::move(channels), std::move(notes));
}

}  // namespace breakaway
