#include "session/visible_spectrum.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"

namespace breakaway {

namespace {

constexpr uint64_t fewest = 64;  // samples
constexpr size_t mostSamples = 200'000;
constexpr double gap = 1.5;  // usual steps
constexpr size_t parts = 8;
constexpr double steadiness = 0.05;

double usualStep_s(const LiveHistory& history, uint64_t last) {
  std::vector<double> steps;
  for (uint64_t k = last; k > history.first() && last - k < fewest; --k)
    steps.push_back(history.at(k).time_s - history.at(k - 1).time_s);
  if (steps.empty()) return 0.0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

}  // namespace

EvenStretch evenStretch(const LiveHistory& history, double from_s, double to_s,
                        const std::function<double(const Sample&)>& value) {
  uint64_t last = history.end();
  while (last > history.first() && history.at(last - 1).time_s > to_s) --last;
  EvenStretch stretch;
  if (last < history.first() + fewest) return stretch;
  --last;
  const double step_s = usualStep_s(history, last);
  // Once through the samples, which fill no cache: this runs in the window's thread.
  double next_s = history.at(last).time_s;
  const double end_s = next_s;
  for (uint64_t k = last + 1; k-- > history.first() && stretch.values.size() < mostSamples;) {
    const Sample& sample = history.at(k);
    if (sample.time_s < from_s || next_s - sample.time_s >= gap * step_s) break;
    next_s = sample.time_s;
    stretch.values.push_back(value(sample));
    stretch.angle_rad.push_back(sample.angle_rad);
  }
  if (stretch.values.size() < fewest) return {};
  std::reverse(stretch.values.begin(), stretch.values.end());
  std::reverse(stretch.angle_rad.begin(), stretch.angle_rad.end());
  stretch.rate_Hz = static_cast<double>(stretch.values.size() - 1) / (end_s - next_s);
  return stretch;
}

double steadyTurns_Hz(const EvenStretch& stretch) {
  const auto& angle = stretch.angle_rad;
  if (angle.size() < 2 * parts || std::abs(angle.back() - angle.front()) < turn_rad) return 0.0;
  const size_t part = (angle.size() - 1) / parts;
  const double mean = (angle.back() - angle.front()) / static_cast<double>(angle.size() - 1);
  for (size_t k = 0; k < parts; ++k) {
    const double here = (angle[(k + 1) * part] - angle[k * part]) / static_cast<double>(part);
    if (std::abs(here - mean) > steadiness * std::abs(mean)) return 0.0;
  }
  return std::abs(mean) * stretch.rate_Hz / turn_rad;
}

VisibleSpectrum spectrumOf(const EvenStretch& stretch, SpectrumWindow window) {
  return {amplitudeSpectrum(stretch.values, stretch.rate_Hz, window), stretch.length_s(), steadyTurns_Hz(stretch)};
}

std::vector<SpectrumPoint> drawnLines(const AmplitudeSpectrum& spectrum, double from_Hz, double to_Hz, size_t steps) {
  std::vector<SpectrumPoint> drawn;
  if (!(from_Hz > 0.0) || !(to_Hz > from_Hz) || steps == 0) return drawn;
  const double perStep = std::log(to_Hz / from_Hz) / static_cast<double>(steps);
  size_t now = steps;  // none yet
  for (size_t k = 1; k < spectrum.amplitude.size(); ++k) {
    const double frequency_Hz = static_cast<double>(k) * spectrum.step_Hz;
    if (frequency_Hz < from_Hz || frequency_Hz > to_Hz) continue;
    const auto at = std::min(static_cast<size_t>(std::log(frequency_Hz / from_Hz) / perStep), steps - 1);
    if (at != now) {
      drawn.push_back({frequency_Hz, spectrum.amplitude[k]});
      now = at;
    } else if (spectrum.amplitude[k] > drawn.back().amplitude) {
      drawn.back() = {frequency_Hz, spectrum.amplitude[k]};
    }
  }
  return drawn;
}

}  // namespace breakaway
