// A turn at each of a few slow speeds both ways: what friction is between standing and moving.
#pragma once

#include <vector>

#include "experiment/timed_procedure.h"
#include "experiment/zeroing.h"

namespace breakaway {

struct SlowTurnsOptions {
  std::vector<double> speeds_rad_per_s;  ///< positive; each is run ccw and cw
  double settle_s = 0.7;
  double zeroing_s = 0.5;  ///< of the current sensor, windings open, before the first turn
  double patience = 2.5;   ///< times the time that a turn should take, after which it is given up
  double current_limit_A = 0.0;
};

/// One turn. Both are means over the angle, in which a rotor that halts now and then doesn't count while it stands; the
/// current's is then the work of friction, to the little that the rotor's speed has gained.
struct SlowTurn {
  double velocity_rad_per_s = 0.0;  ///< signed
  double current_A = 0.0;           ///< signed, as the board gives it
};

/// Runs the turns one by one; one that the rotor doesn't finish in time is left out. It never fails for that.
class SlowTurns : public TimedProcedure {
 public:
  explicit SlowTurns(SlowTurnsOptions options);
  const std::vector<SlowTurn>& turns() const { return turns_; }

 protected:
  Command run(const Sample& sample) override;
  Progress progress() const override;

 private:
  double target() const;
  double expected_s() const;
  void next(const Sample& sample);

  SlowTurnsOptions options_;
  Zeroing zeroing_;
  bool zeroed_ = false, begun_ = false;
  size_t number_ = 0;  ///< of the turn that runs
  double start_s_ = 0.0, startAngle_rad_ = 0.0, lastAngle_rad_ = 0.0;
  double current_A_rad_ = 0.0, velocity_rad2_per_s_ = 0.0;  ///< integrals over the angle
  std::vector<SlowTurn> turns_;
};

}  // namespace breakaway
