// What a simulated board sees of the plant: encoder, current sensor, bridge.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "base/random.h"
#include "plant/rig.h"

namespace breakaway {

/// An incremental encoder with index: counts from zero at power-up, rounded down; the index is seen when the shaft
/// enters it, from growing angle at its near edge and from falling angle at the far one.
class EncoderModel {
 public:
  explicit EncoderModel(const Rig& rig);

  struct Reading {
    int64_t count = 0;
    bool index = false;
  };
  /// `angle_rad` is the shaft's, from the index. Called once per control tick.
  Reading read(double angle_rad);

 private:
  double shown(double angle_rad) const;

  double countsPerRad_, startCounts_ = 0.0, index_rad_ = 0.0;
  bool hasIndex_ = true;
  struct Swing {
    double amplitude_rad = 0.0, phase_rad = 0.0;
  };
  Swing disc_, effect_;  ///< of the encoder's own and of a concealed eccentricity
  double quadrature_rad_ = 0.0, linesPerTurn_ = 0.0, indexWidth_rad_ = 0.0;
  int64_t entered_ = 0, left_ = 0;  ///< turns by the index' near edge and by its far one
  bool first_ = true;
};

/// A Hall current sensor read by an ADC: gain error, offset that drifts, noise, and the converter's steps and range.
class CurrentSensorModel {
 public:
  CurrentSensorModel(const Rig& rig, uint64_t seed);

  /// What the board makes of the converter's code with the nominal sensitivity, in A.
  double read(double current_A, double time_s);
  /// The largest current that it can show.
  double range_A() const { return 0.5 * sensor_.adcRange_V / sensor_.sensitivity_V_per_A; }

 private:
  RigCurrentSensor sensor_;
  double step_V_, supplied_;  ///< converter's step; the sensor's supply over the converter's reference
  Noise noise_;
};

/// The bridge: what mean voltage a commanded duty gives.
class BridgeModel {
 public:
  explicit BridgeModel(const Rig& rig) : bridge_(rig.bridge) {}

  /// The duty that the timer can make; what a step leaves over goes into the next one, so that the mean is exact.
  double realisable(double duty);
  double voltage(double duty) const;

 private:
  RigBridge bridge_;
  double left_ = 0.0;
};

}  // namespace breakaway
