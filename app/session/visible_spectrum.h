// Which frequencies a visible stretch of the live samples holds, and how they go with the rotor.
#pragma once

#include <functional>
#include <vector>

#include "base/spectrum.h"
#include "session/live_history.h"

namespace breakaway {

/// The newest part of what is visible in which no sample is missing, 200,000 samples at most.
struct EvenStretch {
  std::vector<double> values, angle_rad;
  double rate_Hz = 0.0;  ///< 0 where there are too few
  double length_s() const { return rate_Hz > 0.0 ? static_cast<double>(values.size()) / rate_Hz : 0.0; }
};

EvenStretch evenStretch(const LiveHistory& history, double from_s, double to_s,
                        const std::function<double(const Sample&)>& value);

/// Turns per second where the rotor keeps its speed: over a turn at least, each eighth of the time within 5 % of the
/// mean. 0 where it doesn't.
double steadyTurns_Hz(const EvenStretch& stretch);

struct VisibleSpectrum {
  AmplitudeSpectrum lines;
  double length_s = 0.0;
  double turns_Hz = 0.0;  ///< 0 where the speed isn't steady
};

/// Takes as long as its transform: of 200,000 samples some tens of milliseconds.
VisibleSpectrum spectrumOf(const EvenStretch& stretch, SpectrumWindow window);

struct SpectrumPoint {
  double frequency_Hz = 0.0, amplitude = 0.0;
};

/// The highest line of each of so many steps of a logarithmic axis: no peak is lost on the way to the screen.
std::vector<SpectrumPoint> drawnLines(const AmplitudeSpectrum& spectrum, double from_Hz, double to_Hz, size_t steps);

}  // namespace breakaway
