#include "recording/sample_recording.h"

namespace breakaway {

namespace {

template <typename Read>
Channel column(const char* name, std::span<const Sample> samples, Read read) {
  Channel channel{name, {}};
  channel.values.reserve(samples.size());
  for (const Sample& sample : samples) channel.values.push_back(static_cast<double>(read(sample)));
  return channel;
}

}  // namespace

Result<Recording> sealSamples(const std::string& name, std::span<const Sample> samples,
                              std::vector<std::pair<std::string, std::string>> notes, Axis axis) {
  if (samples.empty()) return Error{name, "holds no sample"};
  std::vector<Channel> channels;
  const auto add = [&](const char* title, auto read) { channels.push_back(column(title, samples, read)); };
  add("time_s", [](const Sample& s) { return s.time_s; });
  const bool turns = axis == Axis::rotary;
  add(turns ? "angle_rad" : "position_m", [](const Sample& s) { return s.angle_rad; });
  add(turns ? "velocity_rad_per_s" : "velocity_m_per_s", [](const Sample& s) { return s.velocity_rad_per_s; });
  add("current_A", [](const Sample& s) { return s.current_A; });
  add("voltage_V", [](const Sample& s) { return s.voltage_V; });
  add("supply_V", [](const Sample& s) { return s.supply_V; });
  add("current_reference_A", [](const Sample& s) { return s.current_reference_A; });
  add(turns ? "velocity_reference_rad_per_s" : "velocity_reference_m_per_s",
      [](const Sample& s) { return s.velocity_reference_rad_per_s; });
  add(turns ? "angle_reference_rad" : "position_reference_m", [](const Sample& s) { return s.angle_reference_rad; });
  add(turns ? "disturbance_estimate_Nm" : "disturbance_estimate_N",
      [](const Sample& s) { return s.disturbance_estimate_Nm; });
  add("index", [](const Sample& s) { return s.index; });
  add("enabled", [](const Sample& s) { return s.enabled; });
  return Recording::seal(name, std::move(channels), std::move(notes));
}

}  // namespace breakaway
