#include "report/step_recorder.h"

namespace breakaway {

void StepRecorder::append(const std::vector<Sample>& samples) {
  for (const Sample& sample : samples) {
    index_ = index_ || sample.index;
    if (seen_++ % every_ != 0) continue;
    kept_.push_back(sample);
    kept_.back().index = index_;
    index_ = false;
  }
}

Result<Recording> StepRecorder::seal(const std::vector<std::pair<std::string, std::string>>& notes) const {
  std::vector<Channel> channels;
  const auto add = [&](const char* name, auto get) {
    Channel channel{name, {}};
    channel.values.reserve(kept_.size());
    for (const Sample& sample : kept_) channel.values.push_back(static_cast<double>(get(sample)));
    channels.push_back(std::move(channel));
  };
  add("time_s", [](const Sample& s) { return s.time_s; });
  add("angle_rad", [](const Sample& s) { return s.angle_rad; });
  add("velocity_rad_per_s", [](const Sample& s) { return s.velocity_rad_per_s; });
  add("current_A", [](const Sample& s) { return s.current_A; });
  add("voltage_V", [](const Sample& s) { return s.voltage_V; });
  add("supply_V", [](const Sample& s) { return s.supply_V; });
  add("current_reference_A", [](const Sample& s) { return s.current_reference_A; });
  add("velocity_reference_rad_per_s", [](const Sample& s) { return s.velocity_reference_rad_per_s; });
  add("angle_reference_rad", [](const Sample& s) { return s.angle_reference_rad; });
  add("disturbance_estimate_Nm", [](const Sample& s) { return s.disturbance_estimate_Nm; });
  add("index", [](const Sample& s) { return s.index; });
  add("enabled", [](const Sample& s) { return s.enabled; });
  auto all = notes;
  all.emplace_back("step", step_);
  all.emplace_back("decimation", every_ == 1 ? "every control tick"
                                             : "every " + std::to_string(every_) + "th control tick, not averaged");
  return Recording::seal(step_, std::move(channels), std::move(all));
}

}  // namespace breakaway
