// What is shown of the samples as they come: channels, each with its name, unit and scale.
#pragma once

#include <QString>
#include <array>
#include <vector>

#include "recording/sample.h"

namespace breakaway {

struct LiveChannel {
  QString name, unit;
  double scale = 1.0;      ///< shown value = scale · SI value
  double leastSpan = 1.0;  ///< in the shown unit: noise is not blown up beyond it
  int decimals = 3;
  double Sample::*value = nullptr;

  double of(const Sample& sample) const { return scale * (sample.*value); }
  QString title() const { return QString("%1 (%2)").arg(name, unit); }
};

/// Those that the live plots show.
std::array<LiveChannel, 4> liveChannels(bool linear);
/// All that a board sends: these four first, then voltages and references.
std::vector<LiveChannel> boardChannels(bool linear);

}  // namespace breakaway
