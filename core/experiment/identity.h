// What a board says of itself, and how its controller is set.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/axis.h"

namespace breakaway {

/// Gains and observer of the board's controller; names as in the bench file (resources/help/files.md).
struct ControllerSettings {
  double velocity_kp_A_s_per_rad = 0.0;
  double velocity_ki_A_per_rad = 0.0;
  double velocity_kd_A_s2_per_rad = 0.0;
  double position_kp_A_per_rad = 0.0;
  double position_ki_A_per_rad_s = 0.0;
  double position_kd_A_s_per_rad = 0.0;
  double observer_cutoff_rad_per_s = 0.0;  ///< 0: no disturbance feedback, the estimate still runs at its last cutoff
  double nominal_inertia_kg_m2 = 0.0;
  double nominal_torque_constant_Nm_per_A = 0.0;
  double current_limit_A = 0.0;
  double velocity_limit_rad_per_s = 0.0;
  double velocity_bandwidth_rad_per_s = 0.0;  ///< of the speed observer; 0: unsaid, stays as the board has it
  double current_bandwidth_rad_per_s = 0.0;   ///< of the current loop, likewise
  bool operator==(const ControllerSettings&) const = default;
};

/// What a board can do beyond turning its motor. What it can't is said where one would look for it: abilities.h.
struct Abilities {
  bool everyTick =
      true;  ///< a sample comes from each control tick; else the board is asked, loopRate_Hz times a second
  bool zeroesSensor = true;  ///< takes its current sensor's zero when told to
  bool takesGains = true;    ///< the gains and the observer of ControllerSettings
  bool compensates = true;   ///< takes a friction table
  bool positions = true;     ///< takes position commands
  bool runsLegs = false;     ///< what has to react in the very tick runs on the board, not from the host
  bool operator==(const Abilities&) const = default;
};

/// On a linear axis whatever is counted in rad here, in samples, commands and settings is in m, Nm are N, and kg m² are
/// kg: the same laws hold.
struct Identity {
  std::string device = {};
  std::string firmware = {};
  bool simulated = false;
  double loopRate_Hz = 0.0;
  double countsPerRev = 0.0;  ///< per m on a linear axis
  double supply_V = 0.0;
  bool hasIndex = false;
  Abilities can{};
  Axis axis = Axis::rotary;
  std::string serialNumber = {};  ///< empty: it says none
};

/// Whether two boards may be one: of the same model, and of the same serial number where both say theirs.
inline bool mayBeSame(const Identity& one, const Identity& other) {
  return one.device == other.device &&
         (one.serialNumber == other.serialNumber || one.serialNumber.empty() || other.serialNumber.empty());
}

/// The model, and behind it the serial number where the board says one: "reference board (0042)".
inline std::string boardName(const Identity& board) {
  return board.serialNumber.empty() ? board.device : board.device + " (" + board.serialNumber + ")";
}

/// What recordings note of the board that they are from.
inline std::vector<std::pair<std::string, std::string>> notesOf(const Identity& board) {
  std::vector<std::pair<std::string, std::string>> notes{{"device", board.device}, {"firmware", board.firmware}};
  if (!board.serialNumber.empty()) notes.emplace_back("serial_number", board.serialNumber);
  return notes;
}

}  // namespace breakaway
