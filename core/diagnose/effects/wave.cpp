#include "diagnose/effects/wave.h"

#include <cmath>
#include <numbers>

#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

constexpr double turn = 2.0 * std::numbers::pi;

double waveNumber(double orderOrPeriod, Axis axis) {
  return axis == Axis::rotary ? orderOrPeriod : turn / orderOrPeriod;
}

}  // namespace

std::vector<ParameterSpec> waveParameters(Axis axis) {
  return {{torqueName("amplitude", axis), -1e9, 1e9},
          {"phase_rad", -1e3, 1e3},
          {axis == Axis::rotary ? "order" : "period_m", 1e-9, 1e9, true}};
}

double waveValue(std::span<const double> p, const Situation& at) {
  return p[0] * std::cos(waveNumber(p[2], at.axis) * at.position - p[1]);
}

void waveColumns(const Shape& shape, const Situation& at, double factor, std::span<double> out) {
  const double wave = waveNumber(shape[0], at.axis) * at.position;
  out[0] = factor * std::cos(wave);
  out[1] = factor * std::sin(wave);
}

std::vector<double> waveFromAmplitudes(const Shape& shape, std::span<const double> amplitude) {
  return {std::hypot(amplitude[0], amplitude[1]), std::atan2(amplitude[1], amplitude[0]), shape[0]};
}

std::vector<Shape> waveShapes(const Excitation& seen, int lowest, int highest) {
  std::vector<Shape> shapes;
  if (seen.travel <= 0.0) return shapes;
  if (seen.axis == Axis::rotary) {
    for (int order = lowest; order <= highest; ++order) {
      const double wave = turn / order;
      const bool whole = seen.travel > 0.95 * turn || seen.travel > 2.0 * wave;
      if (whole && wave > 8.0 * seen.count) shapes.push_back({static_cast<double>(order)});
    }
  } else {
    for (double waves = 2.0; waves <= 50.0; waves *= 1.2) shapes.push_back({seen.travel / waves});
  }
  return shapes;
}

std::string waveText(double orderOrPeriod, Axis axis) {
  if (axis == Axis::linear) return "every " + lengthText(orderOrPeriod);
  return orderOrPeriod == 1.0 ? "once per turn" : numberText(orderOrPeriod) + " times per turn";
}

std::string wavePeakText(std::span<const double> p, Axis axis) {
  const double phase = p[0] < 0.0 ? p[1] + std::numbers::pi : p[1];
  const double first = phase - turn * std::floor(phase / turn);
  return axis == Axis::rotary ? angleText(first / p[2]) : lengthText(first / turn * p[2]);
}

}  // namespace breakaway
