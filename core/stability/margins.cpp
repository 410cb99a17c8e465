#include "stability/margins.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include "stability/root_locus.h"

namespace breakaway {

namespace {

using Complex = std::complex<double>;
constexpr size_t searchSteps = 600;
constexpr double noLoop = 1e-12;  ///< a loop gain that is only what rounding leaves of none

/// Where `value` of L changes its sign between two frequencies.
template <typename Value>
double crossing(FrequencyResponse& open, double low, double high, const Value& value) {
  const bool lowSign = value(open(low)) > 0.0;
  for (int step = 0; step < 48; ++step) {
    const double middle = std::sqrt(low * high);
    ((value(open(middle)) > 0.0) == lowSign ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

double gainAboveOne(const Complex& L) {
  return std::norm(L) - 1.0;
}

double imaginaryPart(const Complex& L) {
  return L.imag();
}

void takeGainCrossing(FrequencyResponse& open, double low, double high, LoopMargins& found) {
  const double frequency = crossing(open, low, high, gainAboveOne);
  const double phase = std::abs(std::arg(-open(frequency)));
  found.delayMargin_s = std::min(found.delayMargin_s, phase / frequency);
  if (phase >= found.phaseMargin_rad) return;
  found.phaseMargin_rad = phase;
  found.gainCrossover_rad_per_s = frequency;
}

void takePhaseCrossing(double frequency_rad_per_s, const Complex& L, LoopMargins& found) {
  if (L.real() > -noLoop) return;
  const double factor = -1.0 / L.real();
  if (factor < 1.0) {
    found.gainReduction = std::max(found.gainReduction, factor);
  } else if (factor < found.gainMargin) {
    found.gainMargin = factor;
    found.phaseCrossover_rad_per_s = frequency_rad_per_s;
  }
}

/// The largest of |value(L)|, parabolically refined in the logarithm of frequency around the largest grid point.
template <typename Value>
std::pair<double, double> peak(FrequencyResponse& open, const std::vector<double>& frequencies,
                               const std::vector<Complex>& loop, const Value& value) {
  size_t best = 0;
  for (size_t k = 1; k < loop.size(); ++k) {
    if (value(loop[k]) > value(loop[best])) best = k;
  }
  double low = frequencies[best > 0 ? best - 1 : 0], high = frequencies[std::min(best + 1, loop.size() - 1)];
  constexpr double golden = 0.6180339887498949;
  for (int step = 0; step < 30; ++step) {
    const double span = std::log(high / low), left = high * std::exp(-golden * span),
                 right = low * std::exp(golden * span);
    const bool leftIsMore = value(open(left)) > value(open(right));
    (leftIsMore ? high : low) = leftIsMore ? right : left;
  }
  const double frequency = std::sqrt(low * high), refined = value(open(frequency));
  return refined > value(loop[best]) ? std::pair(frequency, refined) : std::pair(frequencies[best], value(loop[best]));
}

std::vector<double> searched(FrequencyResponse& open, double tick_s) {
  const double highest = std::numbers::pi / tick_s;
  double lowest = 1e-5 * highest;
  while (lowest > 1e-12 * highest && std::abs(open(lowest)) < 10.0) lowest *= 0.1;
  return decades(lowest, highest, searchSteps);
}

}  // namespace

LoopResponse loopResponse(const ServoLoop& loop, const std::vector<double>& frequencies_rad_per_s) {
  LoopResponse found;
  found.frequency_rad_per_s = frequencies_rad_per_s;
  found.loop = response(openLoop(loop), 0, 0, frequencies_rad_per_s);
  for (const Complex& L : found.loop) {
    found.sensitivity.push_back(1.0 / (1.0 + L));
    found.complementary.push_back(L / (1.0 + L));
  }
  return found;
}

ClosedResponse closedResponse(const ServoLoop& loop, const std::vector<double>& frequencies_rad_per_s) {
  const DiscreteSystem closed = closedLoop(loop);
  const auto over = [&](LoopInput from, LoopOutput to) {
    return response(closed, static_cast<Eigen::Index>(from), static_cast<Eigen::Index>(to), frequencies_rad_per_s);
  };
  const LoopOutput followed = loop.mode == ServoMode::position ? LoopOutput::angle : LoopOutput::velocity;
  return {over(LoopInput::reference, followed), over(LoopInput::load, LoopOutput::velocity),
          over(LoopInput::load, LoopOutput::disturbanceEstimate)};
}

LoopMargins margins(const ServoLoop& loop) {
  return margins(closedLoop(loop), openLoop(loop));
}

LoopMargins margins(const DiscreteSystem& closed, const DiscreteSystem& cut) {
  LoopMargins found;
  const auto closedPoles = poles(closed);
  found.stable = std::abs(closedPoles.front()) < 1.0;
  found.damping = damping(closedPoles);
  if (!found.stable) return found;
  found.gainMargin = found.phaseMargin_rad = found.delayMargin_s = HUGE_VAL;
  FrequencyResponse open(cut, 0, 0);
  const auto frequencies = searched(open, cut.tick_s);
  std::vector<Complex> L;
  L.reserve(frequencies.size());
  for (const double frequency : frequencies) L.push_back(open(frequency));
  for (size_t k = 1; k < frequencies.size(); ++k) {
    const double low = frequencies[k - 1], high = frequencies[k];
    if ((gainAboveOne(L[k - 1]) > 0.0) != (gainAboveOne(L[k]) > 0.0)) takeGainCrossing(open, low, high, found);
    if ((imaginaryPart(L[k - 1]) > 0.0) == (imaginaryPart(L[k]) > 0.0)) continue;
    const double frequency = crossing(open, low, high, imaginaryPart);
    takePhaseCrossing(frequency, open(frequency), found);
  }
  takePhaseCrossing(frequencies.back(), L.back(), found);  // real at π/T without a change of sign
  std::tie(found.peakSensitivity_rad_per_s, found.peakSensitivity) =
      peak(open, frequencies, L, [](const Complex& l) { return 1.0 / std::abs(1.0 + l); });
  found.peakComplementary = peak(open, frequencies, L, [](const Complex& l) { return std::abs(l / (1.0 + l)); }).second;
  return found;
}

}  // namespace breakaway
