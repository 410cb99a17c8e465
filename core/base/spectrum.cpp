#include "base/spectrum.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "base/numbers.h"

namespace breakaway {

namespace {

constexpr size_t leastValues = 16;
constexpr double rounding = 1e-11;  // of the greatest value

/// w(k) = Σ terms[j] cos(2πjk/n). F. J. Harris, Proc. IEEE 66(1), 1978; flat top: ISO 18431-2.
std::span<const double> termsOf(SpectrumWindow window) {
  static constexpr double hann[] = {0.5, -0.5};
  static constexpr double blackmanHarris[] = {0.35875, -0.48829, 0.14128, -0.01168};
  static constexpr double flatTop[] = {1.0, -1.933, 1.286, -0.388, 0.0322};
  static constexpr double rectangular[] = {1.0};
  switch (window) {
    case SpectrumWindow::hann:
      return hann;
    case SpectrumWindow::blackmanHarris:
      return blackmanHarris;
    case SpectrumWindow::flatTop:
      return flatTop;
    case SpectrumWindow::rectangular:
      break;
  }
  return rectangular;
}

double sinc(double x) {
  const double angle = std::numbers::pi * x;
  return std::abs(angle) < 1e-9 ? 1.0 : std::sin(angle) / angle;
}

/// What a sine of amplitude 1 gives a line that lies `apart` lines beside it.
double shape(SpectrumWindow window, double apart) {
  const auto terms = termsOf(window);
  double sum = 0.0;
  for (size_t j = 0; j < terms.size(); ++j) {
    const auto shift = static_cast<double>(j);
    sum += (j % 2 == 0 ? 0.5 : -0.5) * terms[j] * (sinc(apart - shift) + sinc(apart + shift));
  }
  return std::abs(sum / terms[0]);
}

size_t quickLength(size_t most) {
  for (size_t length = most; length > 1; --length) {
    size_t rest = length;
    for (const size_t factor : {2U, 3U, 5U}) {
      while (rest % factor == 0) rest /= factor;
    }
    if (rest == 1) return length;
  }
  return most;
}

/// Without the least-squares line; what rounding leaves of a line is 0.
std::vector<double> level(std::span<const double> values) {
  const auto n = static_cast<double>(values.size());
  const double middle = 0.5 * (n - 1.0);
  double mean = 0.0, tilt = 0.0;
  for (size_t k = 0; k < values.size(); ++k) {
    mean += values[k] / n;
    tilt += (static_cast<double>(k) - middle) * values[k];
  }
  tilt *= 12.0 / (n * (n * n - 1.0));
  std::vector<double> left(values.size());
  double most = 0.0, mostLeft = 0.0;
  for (size_t k = 0; k < values.size(); ++k) {
    left[k] = values[k] - mean - tilt * (static_cast<double>(k) - middle);
    most = std::max(most, std::abs(values[k]));
    mostLeft = std::max(mostLeft, std::abs(left[k]));
  }
  if (mostLeft < rounding * most) std::fill(left.begin(), left.end(), 0.0);
  return left;
}

}  // namespace

size_t AmplitudeSpectrum::halfWidth() const {
  return termsOf(window).size();
}

AmplitudeSpectrum amplitudeSpectrum(std::span<const double> values, double rate_Hz, SpectrumWindow window) {
  AmplitudeSpectrum out;
  out.window = window;
  if (values.size() < leastValues || !(rate_Hz > 0.0)) return out;
  const size_t n = quickLength(values.size());
  std::vector<double> weighed = level(values.last(n));
  const auto terms = termsOf(window);
  for (size_t k = 0; k < n; ++k) {
    const double angle = turn_rad * static_cast<double>(k) / static_cast<double>(n);
    double weight = 0.0;
    for (size_t j = 0; j < terms.size(); ++j) weight += terms[j] * std::cos(static_cast<double>(j) * angle);
    weighed[k] *= weight;
  }
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  std::vector<std::complex<double>> lines;
  fft.fwd(lines, weighed);
  out.step_Hz = rate_Hz / static_cast<double>(n);
  out.amplitude.resize(lines.size());
  for (size_t k = 0; k < lines.size(); ++k) {
    const double sides = k == 0 || 2 * k == n ? 1.0 : 2.0;
    out.amplitude[k] = sides * std::abs(lines[k]) / (static_cast<double>(n) * terms[0]);
  }
  return out;
}

std::optional<SpectrumPeak> highestPeak(const AmplitudeSpectrum& spectrum, double from_Hz, double to_Hz) {
  const auto& lines = spectrum.amplitude;
  if (lines.empty()) return {};
  const auto lineAt = [&](double frequency_Hz) {
    return std::clamp(frequency_Hz / spectrum.step_Hz, 0.0, static_cast<double>(lines.size()));
  };
  const auto first = std::max(static_cast<size_t>(std::ceil(lineAt(from_Hz))), spectrum.halfWidth());
  const auto last = std::min(static_cast<size_t>(std::floor(lineAt(to_Hz))) + 1, lines.size());
  if (first >= last) return {};
  const auto highest = static_cast<size_t>(std::max_element(lines.begin() + static_cast<std::ptrdiff_t>(first),
                                                            lines.begin() + static_cast<std::ptrdiff_t>(last)) -
                                           lines.begin());
  if (lines[highest] <= 0.0) return {};
  const bool isLast = highest + 1 == lines.size();
  const bool above = !isLast && lines[highest + 1] > lines[highest - 1];
  const double beside = lines[above ? highest + 1 : highest - 1] / lines[highest];
  double low = 0.0, high = 0.5;  // lines from the highest one to the sine
  for (int halving = 0; halving < 50; ++halving) {
    const double middle = 0.5 * (low + high);
    (shape(spectrum.window, 1.0 - middle) < beside * shape(spectrum.window, middle) ? low : high) = middle;
  }
  const double apart = isLast ? 0.0 : low;
  return SpectrumPeak{spectrum.step_Hz * (static_cast<double>(highest) + (above ? apart : -apart)),
                      lines[highest] / shape(spectrum.window, apart)};
}

}  // namespace breakaway
