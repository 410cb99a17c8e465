// What a simulated rig's faults do to its board at each control tick.
#pragma once

#include <cstdint>
#include <vector>

#include "plant/rig_faults.h"

namespace breakaway {

/// What is wrong in one tick.
struct BoardTrouble {
  bool linkLost = false;
  bool blocked = false;
  bool hidesIndex = false;
  bool showsIndex = false;
  int64_t slippedCounts = 0;
  double past_A = 0.0;  ///< current that the sensor sees beside the winding's, offset drift included
  double supplyPart = 1.0;
  double resistancePart = 1.0;
};

class BoardFaults {
 public:
  BoardFaults() = default;
  explicit BoardFaults(const std::vector<RigFault>& faults);

  /// Called once per control tick; `angle_rad` is the shaft's from the index.
  BoardTrouble step(double time_s, double angle_rad);
  bool none() const { return plays_.empty(); }

 private:
  struct Play {
    RigFault fault;
    bool begun = false, caught = false;  ///< caught: the shaft, at the angle where it is held
  };
  void add(Play& play, double time_s, double angle_rad, BoardTrouble& trouble) const;

  std::vector<Play> plays_;
  double before_rad_ = 0.0;
  int64_t slippedCounts_ = 0;
  bool first_ = true;
};

}  // namespace breakaway
