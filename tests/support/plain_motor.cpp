#include "support/plain_motor.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace breakaway::test {

namespace {

constexpr double turn = 6.283185307179586;

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : bits_(seed * 7919 + 13) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(bits_); }
  double evenly(double low, double high) { return low * std::exp(between(0.0, std::log(high / low))); }  ///< by ratio
  double normal() { return std::normal_distribution<double>()(bits_); }
  template <typename T, size_t n>
  T oneOf(const std::array<T, n>& all) {
    return all[bits_() % n];
  }

 private:
  std::mt19937_64 bits_;
};

struct Motor {
  double constant, resistance, inductance, inertia, viscous, coulomb, supply_V;
};

Motor motorFrom(Draw& draw) {
  Motor m{};
  m.constant = draw.evenly(0.01, 0.15);
  m.resistance = draw.evenly(0.5, 5.0);
  m.inductance = m.resistance * draw.evenly(2e-4, 1.5e-3);
  m.supply_V = draw.oneOf(std::array{12.0, 24.0});
  m.inertia = draw.evenly(0.015, 0.4) * m.constant * m.constant / m.resistance;
  m.coulomb = m.constant * m.supply_V / m.resistance * draw.between(0.02, 0.12);
  m.viscous = m.coulomb / (m.supply_V / m.constant) * draw.between(0.05, 0.6);
  return m;
}

enum class Shape { levels, sines, stairs, reversals, chirp };

/// The drive from row to row, of its range.
std::vector<double> driveOf(Draw& draw, Shape shape, double row_s, size_t rows) {
  const double amplitude = draw.between(0.4, 0.95), slow_Hz = draw.evenly(0.1, 0.4);
  const double middle_Hz = slow_Hz * draw.between(2.1, 3.7), fast_Hz = middle_Hz * draw.between(2.0, 3.3);
  constexpr std::array stairs{0.0, 0.5, 1.0, 0.5, 0.0, -0.5, -1.0, -0.5};
  double level = 0.0, until_s = 0.0;
  std::vector<double> out;
  out.reserve(rows);
  for (size_t k = 0; k < rows; ++k) {
    const double t = static_cast<double>(k) * row_s;
    if (t >= until_s && (shape == Shape::levels || shape == Shape::reversals)) {
      const bool reverses = shape == Shape::reversals;
      until_s = t + (reverses ? draw.between(0.1, 0.6) : draw.between(0.3, 1.2));
      level = reverses ? draw.oneOf(std::array{-1.0, 1.0}) * draw.between(0.5, 1.0) : draw.between(-1.0, 1.0);
    }
    const double part = std::fmod(t, 8.0) / 8.0;
    const double sines = 0.5 * std::sin(turn * slow_Hz * t) + 0.3 * std::sin(turn * middle_Hz * t + 2.0) +
                         0.2 * std::sin(turn * fast_Hz * t + 1.0);
    const double chirp = std::sin(turn * 0.1 * 8.0 / std::log(60.0) * (std::pow(60.0, part) - 1.0));
    const double stair = stairs[static_cast<size_t>(8.0 * std::fmod(t * slow_Hz, 1.0))];
    const double value = shape == Shape::sines    ? sines
                         : shape == Shape::chirp  ? chirp
                         : shape == Shape::stairs ? stair
                                                  : level;
    out.push_back(amplitude * value);
  }
  return out;
}

LogFaults faultsFrom(Draw& draw, LogKind kind) {
  LogFaults faults;
  if (kind == LogKind::sound) return faults;
  faults.wander = draw.between(0.0, 0.04);
  faults.correlation_s = draw.evenly(0.02, 1.0);
  if (kind == LogKind::measured) {
    faults.driveNoise = draw.oneOf(std::array{0.0, 0.002, 0.005, 0.01});
    return faults;
  }
  faults.driveNoise = draw.oneOf(std::array{0.0, 1.0}) * draw.between(0.001, 0.006);
  faults.missingRows = draw.oneOf(std::array{0.0, 0.0, 0.005});
  faults.stampJitter = draw.oneOf(std::array{0.0, 0.0, 0.01});
  faults.discOffset_rad = draw.between(0.0, 2e-4);
  faults.detent = 0.01;
  return faults;
}

/// The motor in small steps; `drive` in V, or A where `current` drives.
class Moving {
 public:
  Moving(const Motor& motor, const LogFaults& faults, bool current, Draw& draw)
      : motor_(motor),
        faults_(faults),
        current_(current),
        draw_(draw),
        pull_(faults.wander * motor.coulomb * draw.normal()) {}

  double angle() const { return angle_; }
  void go(double drive, double dt) {
    const Motor& m = motor_;
    if (faults_.wander > 0.0) {
      const double keep = std::exp(-dt / faults_.correlation_s);
      pull_ = keep * pull_ + faults_.wander * m.coulomb * std::sqrt(1.0 - keep * keep) * draw_.normal();
    }
    if (current_)
      amperes_ = drive;
    else
      amperes_ += (drive - m.resistance * amperes_ - m.constant * speed_) / m.inductance * dt;
    const double torque = m.constant * amperes_ + pull_ + faults_.detent * m.coulomb * std::sin(7.0 * angle_);
    if (speed_ == 0.0) {
      if (std::abs(torque) > m.coulomb) speed_ = dt * (torque - std::copysign(m.coulomb, torque)) / m.inertia;
      return;
    }
    double next = speed_ + dt * (torque - m.viscous * speed_ - std::copysign(m.coulomb, speed_)) / m.inertia;
    if (next * speed_ < 0.0) next = 0.0;
    angle_ += 0.5 * dt * (speed_ + next);
    speed_ = next;
  }

 private:
  const Motor& motor_;
  const LogFaults& faults_;
  bool current_;
  Draw& draw_;
  double pull_, amperes_ = 0.0, speed_ = 0.0, angle_ = 2.0;
};

Bench benchFor(const Motor& motor, DriveInput input, double counts, Draw& draw) {
  Bench bench;
  bench.name = "plain motor";
  bench.input = input;
  bench.supply_V = motor.supply_V;
  if (counts > 0.0) bench.countsPerUnit = counts;
  const int known = draw.oneOf(std::array{0, 1, 2});  // nothing, roughly, for sure
  if (known == 0) return bench;
  const auto roughly = [&](double value) { return known == 2 ? value : value * draw.between(0.8, 1.25); };
  bench.motor.resistance_ohm = roughly(motor.resistance);
  bench.motor.torqueConstant = roughly(motor.constant);
  if (known == 1) bench.motor.inertia = roughly(motor.inertia);
  if (known == 2) bench.trusted = {"resistance_ohm", "torque_constant_Nm_per_A"};
  return bench;
}

}  // namespace

PlainMotorLog plainMotorLog(std::uint64_t seed, LogKind kind) {
  Draw draw(seed);
  const bool runs = kind == LogKind::measured;  // on between two rows
  const Motor motor = motorFrom(draw);
  const double rate_Hz = draw.oneOf(std::array{50.0, 100.0, 200.0, 250.0, 500.0, 1000.0}), row_s = 1.0 / rate_Hz;
  const auto rows = static_cast<size_t>(draw.between(15.0, 40.0) * rate_Hz);
  const double counts = draw.oneOf(std::array{0.0, 400.0, 1024.0, 2000.0, 4096.0, 8192.0, 16384.0});
  const DriveInput input =
      runs ? DriveInput::current : draw.oneOf(std::array{DriveInput::voltage, DriveInput::duty, DriveInput::current});
  const auto shape =
      runs ? draw.oneOf(std::array{Shape::sines, Shape::chirp})
           : draw.oneOf(std::array{Shape::levels, Shape::sines, Shape::stairs, Shape::reversals, Shape::chirp});
  const auto parts = static_cast<size_t>(std::ceil(row_s / 1e-5));
  const size_t often = runs ? parts : 1;  // a new drive so often within a row
  const std::vector<double> drive = driveOf(draw, shape, row_s / static_cast<double>(often), often * rows);
  const Bench bench = benchFor(motor, input, counts, draw);
  const LogFaults faults = faultsFrom(draw, kind);
  const bool current = input == DriveInput::current;
  // A third of the stall's current turns any of them.
  const double range = input == DriveInput::duty ? 1.0
                       : current                 ? 0.33 * motor.supply_V / motor.resistance
                                                 : motor.supply_V;
  const double reading_rad = counts > 0.0 ? 0.0 : draw.evenly(1e-4, 2e-3);
  const auto actsAt = [&](size_t at) {
    return input == DriveInput::duty ? std::round(255.0 * drive[at]) / 255.0 : range * drive[at];
  };
  Moving moving(motor, faults, current, draw);
  std::vector<double> time, shown, angle;
  for (size_t k = 0; k < rows; ++k) {
    const double acts = actsAt(often * k);
    const double there = moving.angle() + faults.discOffset_rad * std::sin(moving.angle() + 1.0);
    if (k == 0 || draw.between(0.0, 1.0) >= faults.missingRows) {
      time.push_back(row_s * (static_cast<double>(k) + faults.stampJitter * draw.normal()));
      shown.push_back(input == DriveInput::duty ? acts : acts + faults.driveNoise * range * draw.normal());
      angle.push_back(counts > 0.0 ? turn / counts * std::floor(there * counts / turn)
                                   : there + reading_rad * draw.normal());
    }
    for (size_t part = 0; part < parts; ++part) {
      const double now = runs ? actsAt(often * k + part) : acts;
      moving.go(input == DriveInput::duty ? now * motor.supply_V : now, row_s / static_cast<double>(parts));
    }
  }
  auto sealed = Recording::seal("plain.csv", {{"time_s", time}, {"angle_rad", angle}, {bench.inputChannel(), shown}});
  constexpr std::array shapes{"levels", "sines", "stairs", "reversals", "chirp"};
  return {
      bench, std::move(*sealed), faults,
      fmt::format("{:4.0f} Hz, {:2.0f} s, {:5.0f} counts, {} in {}; wander {:.1f} %, drive's noise {:.1f} %, jitter "
                  "{:.0f} %, {:.1f} % missing",
                  rate_Hz, static_cast<double>(rows) * row_s, counts, bench.inputChannel(),
                  shapes[static_cast<size_t>(shape)], 100.0 * faults.wander, 100.0 * faults.driveNoise,
                  100.0 * faults.stampJitter, 100.0 * faults.missingRows)};
}

}  // namespace breakaway::test
