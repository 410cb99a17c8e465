// Play between motor and encoder: what sits behind it swings to and fro between its two ends while the motor stands.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/message.h"
#include "experiment/drive.h"

namespace breakaway {

/// Watches a shaft that has just moved, with the windings open. A rotor comes to rest by its friction, or swings in a
/// well by less each time; through a gap the encoder swings by the same again and again.
class FreeSwing {
 public:
  explicit FreeSwing(Axis axis) : axis_(axis) {}

  /// The windings open anew.
  void begin();
  void take(const Sample& sample);
  /// What it means, in words, once it has swung four times by the same; empty otherwise.
  Message words() const;

 private:
  Axis axis_;
  double count_ = 0.0;  ///< least step of the angle that was seen
  double last_ = 0.0, extreme_ = 0.0;
  int way_ = 0;  ///< of the swing under way; 0: none yet
  bool begun_ = false;
  std::vector<double> swings_;  ///< from one turning point to the next
  double turned_ = 0.0;         ///< where it turned last
};

}  // namespace breakaway
