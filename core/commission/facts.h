// What a commissioning can know: what its steps leave, and what they need of each other.
#pragma once

#include <initializer_list>

namespace breakaway {

enum class Known : unsigned {
  sensorZero,    ///< of the current sensor, with its noise
  wiring,        ///< whether motor, encoder and sensors belong together, by a few pulses
  ends,          ///< of a linear axis, as the encoder counts
  windingTest,   ///< resistance, dead zone, time constant of the standing motor
  roughMotor,    ///< constants and inertia by the first test that moves it: enough for careful gains
  reversal,      ///< the inertia's second measurement, or that it can't be had
  bridge,        ///< its curve, and the winding by all tests together
  motor,         ///< with the current's scale and its doubt
  straight,      ///< the board takes the bridge's curve into account, where there is one and it can
  carefulGains,  ///< are on the board, and a linear axis' pace is known
  index,         ///< where angles or positions are counted from; over a travel with its bins
  runs,          ///< at constant speed, all of them, with the moving friction
  breakaways,    ///< all of them
  map,
  stribeck,    ///< over which speed friction falls from static to Coulomb, or that it can't be seen
  gainsInUse,  ///< tuned from what is known, on the board and in the bench file
  comparison,  ///< of the same course with and without the map
};

/// A set of them.
class Facts {
 public:
  Facts() = default;
  Facts(std::initializer_list<Known> facts) {
    for (const Known fact : facts) bits_ |= bit(fact);
  }

  bool has(Known fact) const { return (bits_ & bit(fact)) != 0; }
  bool hasAll(const Facts& others) const { return (others.bits_ & ~bits_) == 0; }
  bool hasAny(const Facts& others) const { return (others.bits_ & bits_) != 0; }
  void add(const Facts& others) { bits_ |= others.bits_; }
  void remove(const Facts& others) { bits_ &= ~others.bits_; }
  bool operator==(const Facts&) const = default;

 private:
  static unsigned bit(Known fact) { return 1U << static_cast<unsigned>(fact); }
  unsigned bits_ = 0;
};

}  // namespace breakaway
