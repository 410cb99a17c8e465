#include "diagnose/effects/wave.h"

#include <cmath>
#include <numbers>

#include "base/numbers.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

double waveNumber(double orderOrPeriod, Axis axis) {
  return axis == Axis::rotary ? orderOrPeriod : turn_rad / orderOrPeriod;
}

constexpr double mostWaves = 50.0;      ///< over a linear axis' travel
constexpr double leastCounts = 8.0;     ///< of a wave
constexpr double startOfFurther = 0.3;  ///< of a wave's size

/// sin(x) / x; the series' error is below 1.2e-8.
double meanCosine(double x) {
  const double square = x * x;
  if (square > 0.25) return std::sin(x) / x;
  return 1.0 - square / 6.0 * (1.0 - square / 20.0 * (1.0 - square / 42.0));
}

}  // namespace

std::vector<ParameterSpec> waveParameters(const std::string& amplitude, Axis axis) {
  const bool rotary = axis == Axis::rotary;
  return {{amplitude, -1e9, 1e9}, {"phase_rad", -1e3, 1e3}, {rotary ? "order" : "period_m", 1e-9, 1e9, rotary}};
}

std::vector<ParameterSpec> WaveEffect::parameters(Axis axis) const {
  return waveParameters(torqueName("amplitude", axis), axis);
}

bool WaveEffect::mayRepeat(const Excitation& seen) const {
  return seen.axis == Axis::rotary && seen.travel > 0.5 * turn_rad;
}

std::vector<std::vector<double>> WaveEffect::besides(std::span<const double> p, const Excitation& seen) const {
  std::vector<std::vector<double>> waves;
  if (seen.axis != Axis::linear) return waves;
  for (const double times : {0.5, 2.0, 1.0 / 3.0, 3.0}) {
    const std::vector<double> wave{startOfFurther * p[0], p[1], times * p[2]};
    if (wave[2] > leastCounts * seen.count && plausible(wave, seen)) waves.push_back(wave);
  }
  return waves;
}

std::vector<double> WaveEffect::scaled(const Shape& shape, std::span<const double> amplitude) const {
  const std::vector<double>& cosine = shape.front();
  return {cosine[0] * std::hypot(amplitude[0], amplitude[1]), std::atan2(amplitude[1], amplitude[0]), cosine[2]};
}

Message WaveEffect::furtherSentence(std::span<const double> largest, std::span<const std::vector<double>> further,
                                    const Excitation& seen) const {
  if (further.empty()) return {};
  Message text;
  for (const std::vector<double>& p : further)
    text = text + (text.empty() ? "" : ", ") +
           message("{} ({} of that)", waveText(p[2], seen.axis), percentText(std::abs(p[0] / largest[0])));
  return message(" With it, weaker: {}.", text);
}

double waveValue(std::span<const double> p, const Situation& at) {
  const double k = waveNumber(p[2], at.axis), half = 0.5 * k * at.span;
  return p[0] * meanCosine(half) * std::cos(k * at.position - p[1]);
}

std::string waveWritten(Axis axis) {
  return std::string("wave(p0, ") + (axis == Axis::rotary ? "p2" : "6.283185307179586 / p2") + ", p1, position, span)";
}

const char* const waveFunctions = R"(
/// sin(x) / x.
function mean_cosine(x) -> value {
  square = x * x;
  value = 1 - square / 6 * (1 - square / 20 * (1 - square / 42));
  if (square > 0.25) { value = sin(x) / x; }
}
/// The mean of a wave over a span around a place.
function wave(amplitude, number, phase, position, span) -> value {
  value = amplitude * mean_cosine(0.5 * number * span) * cos(number * position - phase);
}
)";

Shape waveBasis(double amplitude, double orderOrPeriod) {
  return {{amplitude, 0.0, orderOrPeriod}, {amplitude, 0.5 * std::numbers::pi, orderOrPeriod}};
}

std::vector<Shape> waveShapes(const Excitation& seen, int lowest, int highest, double amplitude) {
  std::vector<Shape> shapes;
  if (seen.travel <= 0.0) return shapes;
  if (seen.axis == Axis::rotary) {
    for (int order = lowest; order <= highest; ++order) {
      const double wave = turn_rad / order;
      const bool whole = seen.travel > 0.95 * turn_rad || seen.travel > 2.0 * wave;
      if (whole && wave > leastCounts * seen.count) shapes.push_back(waveBasis(amplitude, order));
    }
  } else {
    // Half a wave over the travel is near enough: the fit refines the period from there.
    for (double waves = lowest; waves <= mostWaves; waves += 0.5) {
      const double period = seen.travel / waves;
      if (period > leastCounts * seen.count) shapes.push_back(waveBasis(amplitude, period));
    }
  }
  return shapes;
}

bool wavePlausible(std::span<const double> p, const Excitation& seen, double largest, double longest) {
  const bool seenWhole = seen.axis == Axis::rotary || p[2] < longest * seen.travel;
  return std::abs(p[0]) <= largest && seenWhole;
}

Message waveText(double orderOrPeriod, Axis axis) {
  if (axis == Axis::linear) return message("every {}", lengthText(orderOrPeriod));
  return orderOrPeriod == 1.0 ? message("once per turn") : message("{} times per turn", digitsText(orderOrPeriod));
}

std::string wavePeakText(std::span<const double> p, Axis axis, double lowest) {
  const double phase = p[0] < 0.0 ? p[1] + std::numbers::pi : p[1];
  const double first = phase - turn_rad * std::floor(phase / turn_rad);
  if (axis == Axis::rotary) return angleText(first / p[2]);
  const double peak = first / turn_rad * p[2];
  return lengthText(peak + p[2] * std::ceil((lowest - peak) / p[2]));
}

}  // namespace breakaway
