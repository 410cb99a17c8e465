#include "identify/shaft_load.h"

#include <cmath>
#include <complex>

#include "base/numbers.h"
#include "experiment/timed_procedure.h"
#include "identify/run_spectrum.h"

namespace breakaway {

namespace {

using Complex = std::complex<double>;
constexpr double leastPart = 0.2;  // of the mean Coulomb friction
constexpr double mostApart = 1.0 / 3.0;

/// Of a curve's harmonic, in standing and in moving.
struct Both {
  Complex still, moving;
  bool agree() const { return std::abs(still - moving) < mostApart * std::abs(still); }
};

Both positionTorque(const FrictionMap& map, size_t order) {
  std::vector<double> still, moving;
  for (const MapBin& bin : map.bins) {
    still.push_back(bin.positionTorque_Nm());
    moving.push_back(0.5 * (bin.way[0].coulomb_Nm.value - bin.way[1].coulomb_Nm.value));
  }
  return {harmonicOf(still, order), harmonicOf(moving, order)};
}

/// Of the mean over the bins: what they have in common is more than their own scatter.
double meanError(const FrictionMap& map) {
  double squares = 0.0;
  for (const MapBin& bin : map.bins)
    squares +=
        0.25 * (std::pow(bin.way[0].static_Nm.standardError, 2) + std::pow(bin.way[1].static_Nm.standardError, 2));
  return std::sqrt(squares) / static_cast<double>(map.bins.size());
}

Message sized(const Estimate& one, Axis axis) {
  const double scale = axis == Axis::linear ? 1.0 : 1e3;
  return message("{:.3g} ({:.3g} to {:.3g}) {}", scale * one.value, scale * one.low95(), scale * one.high95(),
                 axis == Axis::linear ? "N" : "mNm");
}

}  // namespace

ShaftLoad shaftLoad(const FrictionMap& map, double zeroError_Nm, double scaleError) {
  ShaftLoad load;
  if (map.bins.empty()) return load;
  const double least = leastPart * map.coulombAverage_Nm.value;
  if (!(least > 0.0)) return load;
  const double error = meanError(map);
  const Both constant = positionTorque(map, 0);
  if (std::abs(constant.still) > least && constant.agree())
    load.constant_Nm =
        Estimate{constant.still.real(), std::hypot(error, zeroError_Nm, scaleError * constant.still.real())};
  if (map.axis == Axis::linear) return load;
  const Both once = positionTorque(map, 1);
  if (std::abs(once.still) > least && once.agree()) {
    // −A·sin(θ − down) = Re(A·e^{j(θ − down + π/2)})
    const double down = 0.25 * turn_rad - std::arg(once.still);
    const double size = std::abs(once.still);
    load.arm = ArmTorque{{size, std::hypot(std::sqrt(2.0) * error, scaleError * size)},
                         down - turn_rad * std::floor(down / turn_rad)};
  }
  return load;
}

std::vector<Message> wordsOf(const ShaftLoad& load, Axis axis) {
  std::vector<Message> words;
  if (load.constant_Nm) {
    const Estimate size{std::abs(load.constant_Nm->value), load.constant_Nm->standardError};
    words.push_back(
        message("A constant load of {} pulls {} {}, or friction differs by twice that from way to way. The map's "
                "static friction is free of it, position {} shows it.",
                sized(size, axis), bodyText(axis), wayText(load.constant_Nm->value > 0.0, axis),
                axis == Axis::linear ? message("force") : message("torque")));
  }
  if (load.arm)
    words.push_back(
        message("Once per turn ±{} act on the shaft, the same both ways: an arm or an imbalance that hangs down at "
                "{} from the index. The map's static friction is free of it, position torque shows it; take it off, or "
                "declare it as the bench's load.",
                sized(load.arm->amplitude_Nm, axis), degreesText(load.arm->down_rad)));
  return words;
}

}  // namespace breakaway
