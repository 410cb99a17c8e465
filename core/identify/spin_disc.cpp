#include "identify/spin_disc.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <utility>

#include "dense/dense_solve.h"

namespace breakaway {

namespace {

using Complex = std::complex<double>;
// A run of few turns tells the lower orders of torque and friction badly from the disc's swing.
constexpr int orders = 6;
constexpr int terms = 5 + 4 * orders;  // J, J·D's two parts, C, B; torque and friction at each order
using SpinRow = Eigen::Matrix<double, terms, 1>;
using Square = Eigen::Matrix<double, terms, terms>;
constexpr size_t width = 4;  // blocks of a balance
constexpr size_t leastSpinRows = 100;
constexpr double slowestSpin = 0.25;  // of the highest speed
constexpr double surelySpun = 20.0;   // gain in χ²
constexpr double mostSpinOff_rad = 0.3;
constexpr int spinRounds = 3;
constexpr double surelyAgainst = 20.0;  // loss in χ² of the voltage's balance

/// Mean of values at a block's end over the two blocks around it, as a rate.
template <typename Value>
Value rateAt(const std::vector<Value>& values, const std::vector<SpinBlock>& blocks, size_t k) {
  return (values[k + 1] - values[k - 1]) / (blocks[k].duration_s + blocks[k + 1].duration_s);
}

struct Balance {
  Square normal = Square::Zero();
  SpinRow right = SpinRow::Zero();
  double squares = 0.0;
  size_t rows = 0;

  void add(const SpinRow& row, double impulse) {
    normal += row * row.transpose();
    right += impulse * row;
    squares += impulse * impulse;
    ++rows;
  }
};

Balance balanceOf(const std::vector<SpinBlock>& blocks, const EncoderDisc& disc) {
  const size_t count = blocks.size();
  std::vector<double> shown(count), angles(count), speeds(count, 0.0);
  std::vector<Complex> waves(count);
  double highest = 0.0;
  for (size_t k = 0; k < count; ++k) {
    shown[k] = blocks[k].angle_rad;
    angles[k] = disc.known() ? disc.angleOf(shown[k]) : shown[k];
    waves[k] = std::polar(1.0, angles[k]);
    if (k > 0) speeds[k] = (angles[k] - angles[k - 1]) / blocks[k].duration_s;
    highest = std::max(highest, std::abs(speeds[k]));
  }
  Balance balance;
  for (size_t k = 1; k + width + 1 < count; ++k) {
    const bool oneWay = std::all_of(
        speeds.begin() + static_cast<std::ptrdiff_t>(k), speeds.begin() + static_cast<std::ptrdiff_t>(k + width + 2),
        [&](double speed) { return speed * speeds[k] > 0.0 && std::abs(speed) > slowestSpin * highest; });
    if (!oneWay) continue;
    double impulse = 0.0, duration = 0.0;
    std::array<Complex, orders> around{};
    for (size_t j = k + 1; j <= k + width; ++j) {
      impulse += blocks[j].current_A * blocks[j].duration_s;
      duration += blocks[j].duration_s;
      for (int n = 1; n <= orders; ++n)
        around[static_cast<size_t>(n - 1)] += waveOver(n, angles[j - 1], angles[j], blocks[j].duration_s);
    }
    const double sign = speeds[k] > 0.0 ? 1.0 : -1.0;
    const Complex swing = rateAt(waves, blocks, k + width) - rateAt(waves, blocks, k);
    SpinRow row;
    row.head<5>() << rateAt(shown, blocks, k + width) - rateAt(shown, blocks, k), -swing.real(), swing.imag(),
        sign * duration, angles[k + width] - angles[k];
    for (size_t n = 0; n < around.size(); ++n)
      row.segment<4>(static_cast<Eigen::Index>(5 + 4 * n)) << around[n].real(), around[n].imag(),
          sign * around[n].real(), sign * around[n].imag();
    balance.add(row, impulse);
  }
  return balance;
}

/// One round: D with the angles that the last one gives.
EncoderDisc fitOnce(const Balance& balance) {
  if (balance.rows < leastSpinRows) return {};
  const SpinRow scale =
      balance.normal.diagonal().unaryExpr([](double x) { return x > 0.0 ? 1.0 / std::sqrt(x) : 0.0; });
  const Square inverse = scale.asDiagonal() *
                         Square(pseudoInverse(scale.asDiagonal() * balance.normal * scale.asDiagonal())) *
                         scale.asDiagonal();
  const SpinRow x = inverse * balance.right;
  if (!(x[0] > 0.0)) return {};
  const double variance =
      std::max(0.0, balance.squares - x.dot(balance.right)) / static_cast<double>(balance.rows - terms);
  // Balances overlap: so many fewer stand apart from each other.
  const double parts = static_cast<double>(width + 1) * variance * 0.5 * (inverse(1, 1) + inverse(2, 2));
  return {Complex(x[1], x[2]) / x[0], parts / (x[0] * x[0])};
}

/// Squares of what the windings' voltage leaves of the speeds, ω = (v − R·i − L·di/dt − V₀·sgn ω)/Ke, all of them free,
/// over the blocks that turn with their voltage; and their number.
std::pair<double, size_t> leftByVoltage(const std::vector<SpinBlock>& blocks, const EncoderDisc& disc,
                                        double slowest_rad_per_s) {
  constexpr int columns = 5;
  using Row = Eigen::Matrix<double, columns, 1>;
  Eigen::Matrix<double, columns, columns> normal = Eigen::Matrix<double, columns, columns>::Zero();
  Row right = Row::Zero();
  std::vector<std::pair<Row, double>> rows;
  for (size_t k = 1; k + 1 < blocks.size(); ++k) {
    const SpinBlock &before = blocks[k - 1], &here = blocks[k], &after = blocks[k + 1];
    const double shown = (here.angle_rad - before.angle_rad) / here.duration_s;
    if (std::abs(shown) < slowest_rad_per_s || shown * here.voltage_V <= 0.0) continue;
    const double speed = (disc.angleOf(here.angle_rad) - disc.angleOf(before.angle_rad)) / here.duration_s;
    Row row;
    row << here.voltage_V, here.current_A, after.current_A - before.current_A, std::copysign(1.0, shown), 1.0;
    normal += row * row.transpose();
    right += speed * row;
    rows.emplace_back(row, speed);
  }
  const Row x = leastNorm(normal, right);
  double squares = 0.0;
  for (const auto& [row, speed] : rows) squares += std::pow(speed - x.dot(row), 2);
  return {squares, rows.size()};
}

/// Whether the voltage, on which neither friction nor torque act, says that the rotor doesn't swing so.
bool refutedByVoltage(const std::vector<SpinBlock>& blocks, const EncoderDisc& disc) {
  double highest = 0.0;
  for (size_t k = 1; k < blocks.size(); ++k)
    highest = std::max(highest, std::abs(blocks[k].angle_rad - blocks[k - 1].angle_rad) / blocks[k].duration_s);
  const auto [with, count] = leftByVoltage(blocks, disc, slowestSpin * highest);
  if (count < leastSpinRows) return false;
  const double without = leftByVoltage(blocks, {}, slowestSpin * highest).first;
  return with - without > surelyAgainst * without / static_cast<double>(count);
}

}  // namespace

std::complex<double> waveOver(int order, double from_rad, double to_rad, double duration_s) {
  const double travel_rad = order * (to_rad - from_rad);
  const Complex start = std::polar(1.0, order * from_rad), end = std::polar(1.0, order * to_rad);
  if (std::abs(travel_rad) < 1e-6) return duration_s * start;
  return duration_s * (end - start) / Complex(0.0, travel_rad);
}

EncoderDisc spinDisc(const std::vector<SpinBlock>& blocks) {
  EncoderDisc disc;
  for (int round = 0; round < spinRounds; ++round) {
    const EncoderDisc found = fitOnce(balanceOf(blocks, disc));
    const double size = std::abs(found.off_rad);
    if (!(std::norm(found.off_rad) > surelySpun * found.variance_rad2) || size > mostSpinOff_rad) return {};
    disc = found;
  }
  return refutedByVoltage(blocks, disc) ? EncoderDisc{} : disc;
}

std::vector<SpinBlock> freedOf(const EncoderDisc& disc, std::vector<SpinBlock> blocks) {
  for (SpinBlock& block : blocks) {
    if (disc.known()) block.angle_rad = disc.angleOf(block.angle_rad);
  }
  return blocks;
}

}  // namespace breakaway
