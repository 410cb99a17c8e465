// The parts of effects that lie between the truth and what a sensor shows of it.
#pragma once

#include <span>
#include <string_view>

namespace breakaway {

class EncoderPart {
 public:
  /// What the encoder shows at a true position, rad.
  virtual double shown(std::span<const double> p, double position) const = 0;

 protected:
  ~EncoderPart() = default;
};

class CurrentSensorPart {
 public:
  /// What the sensor shows, given the true current in A and its slope in A/s.
  virtual double sensed(std::span<const double> p, double current, double slope) const = 0;
  /// How much later it shows what flows, s; sensed() has it to the first order.
  virtual double lag_s(std::span<const double> /*p*/) const { return 0.0; }
  /// The effect that is one and the same for the motion where the sensed current is what drives, so that only a
  /// voltage recorded beside it tells the two apart: by the current that is shown where none flows, which is then the
  /// only parameter. Empty: there is none.
  virtual std::string_view sameForMotion() const { return {}; }

 protected:
  ~CurrentSensorPart() = default;
};

}  // namespace breakaway
