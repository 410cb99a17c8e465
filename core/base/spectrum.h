// Which frequencies a stretch of evenly spaced values holds, and how much of each.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace breakaway {

/// By what the values are weighed before the transform: the narrower a line, the more a strong one leaks into its
/// neighbours.
enum class SpectrumWindow : std::uint8_t {
  hann,
  blackmanHarris,  ///< of four terms: 92 dB below a line nothing of it is left
  flatTop,         ///< ISO 18431-2: the highest line of a sine is its amplitude, wherever it lies between two
  rectangular
};

/// One-sided, of amplitudes: a sine of amplitude 1 gives a line of 1, in the values' unit.
struct AmplitudeSpectrum {
  SpectrumWindow window = SpectrumWindow::hann;
  double step_Hz = 0.0;           ///< from line to line; line k is at k steps
  std::vector<double> amplitude;  ///< from 0 to half the rate
  /// As wide as the window makes the line of a pure sine, to either side.
  size_t halfWidth() const;
};

/// Mean and slope are taken away first, a constant speed's angle and its drift with them. Of n values the last m are
/// used, m the greatest number up to n without a prime factor beyond 5: the transform of others takes long. Fewer than
/// 16 values, or a rate that isn't positive, give no line.
AmplitudeSpectrum amplitudeSpectrum(std::span<const double> values, double rate_Hz, SpectrumWindow window);

struct SpectrumPeak {
  double frequency_Hz = 0.0;
  double amplitude = 0.0;
};

/// The highest line from one frequency to another, by its neighbour as the window's own shape has it between lines (as
/// V. K. Jain, W. L. Collins, D. C. Davis, IEEE Trans. Instrum. Meas. 28(2), 1979, for no window): right for a pure
/// sine that no other is near. What mean and slope may have left, below a line's width, is no peak. Nothing where no
/// line lies there, or all are 0.
std::optional<SpectrumPeak> highestPeak(const AmplitudeSpectrum& spectrum, double from_Hz, double to_Hz);

}  // namespace breakaway
