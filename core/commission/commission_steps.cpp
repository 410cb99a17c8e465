#include "commission/commission_steps.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {
constexpr double slice_s = 0.25;
constexpr double tellEvery_s = 0.5, keepEvery_s = 30.0;
}  // namespace

size_t CommissionSteps::decimation(double expected_s) const {
  if (expected_s <= options_.shortStep_s) return 1;
  const double rate = drive_.identity().loopRate_Hz;
  const double byRows = expected_s * rate / static_cast<double>(std::max<size_t>(1, options_.mostRows));
  return static_cast<size_t>(std::max({1.0, std::round(rate / options_.recordingRate_Hz), std::round(byRows)}));
}

void CommissionSteps::tell(const Procedure& procedure, double share) const {
  if (!options_.progress) return;
  const auto status = procedure.status();
  options_.progress(progress_ + share * status.progress, status.activity);
}

Result<void> CommissionSteps::keep(const Gather& gather) {
  if (gather) gather();
  kept_.rigTime_s = done_.rigTime_s;
  kept_.remarks = done_.remarks;
  return options_.keepProgress ? options_.keepProgress(kept_) : Result<void>{};
}

Result<void> CommissionSteps::keepRecording(const StepRecorder& recorder, const std::string& step) {
  if (!options_.keepRecordings || recorder.empty()) return {};
  auto recording = recorder.seal({{"device", drive_.identity().device}, {"firmware", drive_.identity().firmware}});
  if (!recording) return recording.error();
  const std::string name = kept_.part > 1 ? step + "-part" + std::to_string(kept_.part) : step;
  if (options_.keepRecording) return options_.keepRecording(name, *recording);
  done_.recordings.emplace_back(name, std::move(*recording));
  return {};
}

Result<void> CommissionSteps::runToEnd(Procedure& procedure, StepRecorder& recorder, double share,
                                       const Gather& gather) {
  std::vector<Sample> samples;
  double told_s = 0.0, kept_s = 0.0;
  while (procedure.state() == Procedure::State::running) {
    if (options_.interrupted && options_.interrupted()) {
      drive_.stop("interrupted from the keyboard; the motor is off");
      break;
    }
    samples.clear();
    const auto advanced = drive_.advance(slice_s, samples);
    if (options_.keepRecordings) recorder.append(samples);
    if (!advanced) {
      procedure.stop(advanced.error().fact);
      break;
    }
    lost_ += *advanced;
    done_.rigTime_s += slice_s;
    if ((told_s += slice_s) >= tellEvery_s) tell(procedure, share), told_s = 0.0;
    if (gather && (kept_s += slice_s) >= keepEvery_s) {
      kept_s = 0.0;
      if (auto kept = keep(gather); !kept) return kept;
    }
  }
  return {};
}

Result<void> CommissionSteps::run(const std::string& step, const std::shared_ptr<Procedure>& procedure, double share,
                                  const Gather& gather) {
  StepRecorder recorder(step, decimation(procedure->status().remaining_s), drive_.identity().axis);
  lost_ = 0;
  if (procedure->state() == Procedure::State::running) {
    drive_.start(procedure);
    if (auto ran = runToEnd(*procedure, recorder, share, gather); !ran) return ran;
  }
  progress_ += share;
  if (lost_ > 0) done_.remarks.push_back(step + ": " + std::to_string(lost_) + " samples were lost on the way.");
  if (auto kept = keep(gather); !kept) return kept;
  if (auto kept = keepRecording(recorder, step); !kept) return kept;
  const auto status = procedure->status();
  return status.state == Procedure::State::finished ? Result<void>{} : Error{step, status.failure};
}

}  // namespace breakaway
