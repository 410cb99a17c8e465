#include "commission/step_recorder.h"

#include "recording/sample_recording.h"

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
  auto all = notes;
  all.emplace_back("step", step_);
  all.emplace_back("decimation", every_ == 1 ? "every control tick"
                                             : "every " + std::to_string(every_) + "th control tick, not averaged");
  return sealSamples(step_, kept_, std::move(all), axis_);
}

}  // namespace breakaway
