// One step by hand: a set way on from where the shaft stands, slowly, and at rest again.
#pragma once

#include <memory>
#include <optional>

#include "experiment/timed_procedure.h"
#include "experiment/travel.h"
#include "session/hand_drive.h"

namespace breakaway {

struct JogOptions {
  double by_rad = 0.0;               ///< from where it stands; its sign is the way
  double speed_rad_per_s = 1.0;      ///< on the way
  double mostSpeed_rad_per_s = 0.0;  ///< beyond it the motor is let go; 0: no limit
  double most_A = 0.0;               ///< 0: the controller's own limit
  std::optional<Travel> travel{};    ///< of a linear axis: no step ends in its margins
  double count_rad = 0.0;            ///< of the encoder
};

/// Glides there and opens the windings. It ends when the grip is let go, and in words when it doesn't arrive in time or
/// gets faster than allowed.
class Jog : public TimedProcedure {
 public:
  Jog(const JogOptions& options, std::shared_ptr<HandGrip> grip);

 protected:
  Command run(const Sample& sample) override;
  Progress progress() const override;

 private:
  JogOptions options_;
  std::shared_ptr<HandGrip> grip_;
  Glide glide_;
  double target_rad_ = 0.0, way_rad_ = 0.0, left_rad_ = 0.0, allowed_s_ = 0.0;
};

}  // namespace breakaway
