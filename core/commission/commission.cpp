#include "commission/commission.h"

#include "commission/job.h"

namespace breakaway {

namespace {

constexpr double slice_s = 0.25;

Facts wantedBy(const CommissionOptions& options) {
  if (options.wiringOnly) return {Known::wiring};
  return options.motorOnly ? Facts{Known::motor} : Facts{Known::comparison};
}

}  // namespace

std::optional<double> trustedConstant(const CommissionOptions& options) {
  if (!options.bench || !options.bench->trusted.contains(motorNames(options.bench->axis).torqueConstant)) return {};
  return options.bench->motor.torqueConstant;
}

Result<Commission> commission(Drive& drive, const CommissionOptions& options) {
  Job job(options, wantedBy(options));
  std::vector<Sample> samples;
  job.begin(drive);
  while (job.running()) {
    if (options.interrupted && options.interrupted()) {
      const char* const why = "interrupted from the keyboard; the motor is off";
      drive.stop(why);
      job.stop(drive, why);
      break;
    }
    samples.clear();
    if (const auto lost = drive.advance(slice_s, samples); lost) {
      job.take(drive, slice_s, samples, *lost);
    } else {
      job.stop(drive, lost.error().fact);
    }
  }
  if (job.status().state != Procedure::State::finished) return job.failure();
  return job.known();
}

}  // namespace breakaway
