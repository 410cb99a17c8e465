// Bench files that are wrong by a factor in one field, and what the bench job says of them.
#pragma once

#include <QByteArray>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "commission/commission.h"
#include "firmware_link/presets.h"
#include "firmware_link/simulated_board.h"
#include "motor/bench.h"

namespace breakaway::test {

/// A field of the bench file by a pointer to its value.
struct BelievedField {
  const char* name;
  std::optional<double>& (*value)(Bench& bench);
};
inline constexpr std::array<BelievedField, 7> believedFields{
    {{"counts", [](Bench& bench) -> std::optional<double>& { return bench.countsPerUnit; }},
     {"supply_V", [](Bench& bench) -> std::optional<double>& { return bench.supply_V; }},
     {"torque constant", [](Bench& bench) -> std::optional<double>& { return bench.motor.torqueConstant; }},
     {"back-EMF constant", [](Bench& bench) -> std::optional<double>& { return bench.motor.backEmfConstant; }},
     {"resistance_ohm", [](Bench& bench) -> std::optional<double>& { return bench.motor.resistance_ohm; }},
     {"inductance_H", [](Bench& bench) -> std::optional<double>& { return bench.motor.inductance_H; }},
     {"inertia", [](Bench& bench) -> std::optional<double>& { return bench.motor.inertia; }}}};
inline constexpr std::array<double, 6> mistakenFactors{1000.0, 57.296, 9.5493, 4.0, 2.0, 0.5};

/// Identifies the motor of `uri` with that belief. What the job ends with, and after how long.
inline Result<Commission> identifiedWith(const std::string& uri, const std::optional<Bench>& bench, unsigned seed = 3,
                                         bool anyway = false) {
  auto drive = openDrive(uri, seed);
  if (!drive) return drive.error();
  CommissionOptions options;
  options.rig = "rig";
  options.bench = bench;
  options.motorOnly = true;
  options.keepRecordings = false;
  options.anyway = anyway;
  return commission(**drive, options);
}

}  // namespace breakaway::test
