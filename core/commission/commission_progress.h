// What an interrupted commissioning has already, as files: enough to go on where it ended.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/estimate.h"
#include "base/result.h"
#include "experiment/travel.h"
#include "friction/measurements.h"
#include "identify/motor_identification.h"

namespace breakaway {

struct CommissionProgress {
  std::string device;  ///< the board's, for a resumption on another one to be refused
  size_t bins = 0, turns = 0;
  double speedRun_s = 0.0;
  std::optional<double> trustedTorqueConstant_Nm_per_A;
  size_t part = 1;  ///< 1 for the first start, one more for each resumption
  double rigTime_s = 0.0;
  std::vector<std::string> remarks;

  std::optional<IdentifiedMotor> motor;  ///< once it is identified
  std::array<double, 2> expected_A{};    ///< first look at the breakaway current by Way, with the motor
  double shownResistance_ohm = 0.0;      ///< with the current as the sensor shows it, with the motor
  std::vector<VelocityRun> runs;         ///< complete ones, in the order they were run
  std::vector<BreakawayEvent> events;    ///< on a linear axis with places from the index on
  double addedInertia_kg_m2{};           ///< of the disc that is mounted
  std::vector<TravelRun> strokes{};      ///< of a linear axis, complete ones
  std::optional<Travel> travel{};        ///< likewise, from the index on
};

/// Writes progress/state.json, progress/run-NN.json, progress/strokes-NN.json and progress/breakaways.json into
/// `folder`. Runs never change, so those that are there are not written again.
Result<void> writeProgress(const CommissionProgress& progress, const std::string& folder);

/// What writeProgress() wrote. Errors: there is none, or a field is missing or wrong, by file and name.
Result<CommissionProgress> readProgress(const std::string& folder);

/// Removes what writeProgress() wrote; nothing there is fine.
Result<void> removeProgress(const std::string& folder);

}  // namespace breakaway
