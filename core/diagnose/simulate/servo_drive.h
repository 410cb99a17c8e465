// What a servo's own position loop makes of its reference and of the model's motion.
#pragma once

#include <cstddef>
#include <optional>

#include "diagnose/model/model.h"
#include "diagnose/simulate/track.h"

namespace breakaway {

/// A model's law with numbers; its drive is the track's input: V (also where the law gives out a duty), A, Nm or N.
class ServoDrive {
 public:
  /// Nothing for models that another input drives.
  static std::optional<ServoDrive> of(const Model& model);

  /// The drive over [from_s, to_s] within `row`, where the law sees this motion.
  double input(const Track& track, size_t row, double from_s, double to_s, double position, double velocity) const;
  /// How much later than the law saw it the motion is answered to, on average, s.
  double late_s() const;
  /// How the drive falls with position and with velocity, per rad and per rad/s, in row `row`; 0 where it is clipped.
  double stiffness(const Track& track, size_t row, double drive) const;
  double damping(const Track& track, size_t row, double drive) const;
  /// Into how many steps of one drive each a row of dt is divided: fine enough for the law's lateness, and so that an
  /// inertia on its damping stays stable.
  size_t times(double dt, double inertia, double torquePerInput) const;

 private:
  double kp_ = 0.0, kd_ = 0.0;
  double limit_ = 0.0;    ///< 0: none
  double rate_Hz_ = 0.0;  ///< 0: at every instant
  double delay_s_ = 0.0;
  bool duty_ = false;
};

}  // namespace breakaway
