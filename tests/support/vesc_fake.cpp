#include "support/vesc_fake.h"

#include <poll.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

namespace breakaway::test {

namespace {

constexpr double substep_s = 50e-6;
constexpr int substeps = 4;

void put(std::vector<std::uint8_t>& payload, double value, size_t bytes) {
  const auto whole = static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(value)));
  for (size_t k = bytes; k-- > 0;) payload.push_back(static_cast<std::uint8_t>(whole >> (8 * k)));
}

double int32At(const std::vector<std::uint8_t>& payload, size_t at) {
  std::uint32_t value = 0;
  for (size_t k = 0; k < 4; ++k) value = value << 8 | payload[at + k];
  return static_cast<std::int32_t>(value);
}

double withinTurn(double angle_rad) {
  const double turn = 2.0 * std::numbers::pi;
  return angle_rad - turn * std::floor(angle_rad / turn);
}

}  // namespace

VescFake::VescFake(const Rig& rig)
    : rig_(rig), plant_(rig, substep_s, 1), thread_([this](const std::stop_token& ending) { work(ending); }) {
}

VescFake::~VescFake() {
  hangUp();
}

void VescFake::hangUp() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
  pty_.hangUp();
}

std::vector<std::vector<std::uint8_t>> VescFake::commands() const {
  const std::lock_guard lock(lock_);
  return commands_;
}

void VescFake::work(const std::stop_token& ending) {
  auto before = std::chrono::steady_clock::now();
  while (!ending.stop_requested()) {
    receive();
    const auto now = std::chrono::steady_clock::now();
    // A machine that is too busy makes this board slow, not wild.
    advance(std::min(0.02, std::chrono::duration<double>(now - before).count()));
    before = now;
  }
}

void VescFake::receive() {
  pollfd one{pty_.far(), POLLIN, 0};
  if (::poll(&one, 1, 1) <= 0) return;
  if ((one.revents & POLLIN) == 0) {  // nobody has the port open
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return;
  }
  decoder_.add(pty_.receive());
  while (const auto payload = decoder_.next()) obey(*payload);
}

void VescFake::obey(const std::vector<std::uint8_t>& payload) {
  const std::uint8_t message = payload[0];
  if (message == 0) return answerVersion();
  if (message == 4) return answerValues(false, 0x3fffff);
  if (message == 50) {
    if (knowsChoice && payload.size() == 5) answerValues(true, static_cast<std::uint32_t>(int32At(payload, 1)));
    return;
  }
  {
    const std::lock_guard lock(lock_);
    commands_.push_back(payload);
  }
  sinceWord_s_ = 0.0;
  if (message < 5 || message > 9 || payload.size() != 5) return;
  static constexpr Mode modes[] = {Mode::duty, Mode::current, Mode::current, Mode::speed, Mode::position};
  static constexpr double scales[] = {1e5, 1e3, 1e3, 1.0, 1e6};
  const Mode before = mode_;
  mode_ = modes[message - 5];
  target_ = int32At(payload, 1) / scales[message - 5];
  if (mode_ == Mode::current && target_ == 0.0) mode_ = Mode::released;
  if (mode_ != before) integral_A_ = 0.0;
}

void VescFake::send(const std::vector<std::uint8_t>& payload) {
  if (mute) return;
  std::vector<std::uint8_t> bytes;
  if (chatters) bytes = {'b', 'o', 'o', 't', 2, 3, 3, 0, 2, 200, '\n'};
  const auto frame = vescFrame(payload);
  bytes.insert(bytes.end(), frame.begin(), frame.end());
  pty_.send(bytes);
}

void VescFake::answerVersion() {
  std::vector<std::uint8_t> payload{0, 6, 5};
  for (const char letter : std::string("60_MK5")) payload.push_back(static_cast<std::uint8_t>(letter));
  payload.push_back(0);
  for (std::uint8_t k = 1; k <= 12; ++k) payload.push_back(k);
  payload.insert(payload.end(), {0, 0, 0});
  send(payload);
}

void VescFake::answerValues(bool selected, std::uint32_t fields) {
  const double counts = rig_.encoder.countsPerRev;
  const double within = withinTurn(plant_.angle_rad());
  const double current_A = currentCount_ > 0 ? currentSum_A_ / static_cast<double>(currentCount_) : plant_.current_A();
  currentSum_A_ = 0.0;
  currentCount_ = 0;
  const double speed = plant_.velocity_rad_per_s() * 30.0 / std::numbers::pi * polePairs;
  const double steps = std::floor(plant_.angle_rad() * 6.0 * polePairs / (2.0 * std::numbers::pi));
  const double position_deg = std::floor(within * counts / (2.0 * std::numbers::pi)) * 360.0 / counts;
  struct Field {
    double value;
    size_t bytes;
  };
  const double duty = powered_ ? voltage_V_ / rig_.bridge.supply_V : 0.0;
  const Field all[] = {{251.0, 2},
                       {302.0, 2},
                       {100.0 * std::abs(current_A), 4},
                       {100.0 * current_A * duty, 4},
                       {0.0, 4},
                       {100.0 * current_A, 4},
                       {1000.0 * duty, 2},
                       {speed, 4},
                       {10.0 * rig_.bridge.supply_V, 2},
                       {0.0, 4},
                       {0.0, 4},
                       {0.0, 4},
                       {0.0, 4},
                       {steps, 4},
                       {std::abs(steps), 4},
                       {static_cast<double>(fault), 1},
                       {1e6 * position_deg, 4},
                       {1.0, 1},
                       {0.0, 6},
                       {0.0, 4},
                       {1000.0 * voltage_V_, 4},
                       {0.0, 1}};
  std::vector<std::uint8_t> payload{static_cast<std::uint8_t>(selected ? 50 : 4)};
  if (selected) put(payload, static_cast<std::int32_t>(fields), 4);
  for (size_t bit = 0; bit < std::size(all); ++bit) {
    if ((fields >> bit & 1u) == 0) continue;
    if (all[bit].bytes == 6) {
      payload.insert(payload.end(), 6, 0);
    } else {
      put(payload, all[bit].value, all[bit].bytes);
    }
  }
  send(payload);
}

double VescFake::wantedCurrent_A(double tick_s) {
  constexpr double most_A = 20.0;
  double error = 0.0, gain = 0.02, growth = 0.4, damping = 0.0;
  if (mode_ == Mode::current) return std::clamp(target_, -most_A, most_A);
  if (mode_ == Mode::speed) {
    error = target_ / polePairs * std::numbers::pi / 30.0 - plant_.velocity_rad_per_s();
  } else {
    error = std::remainder(target_ * std::numbers::pi / 180.0 - plant_.angle_rad(), 2.0 * std::numbers::pi);
    gain = 0.6;
    growth = 2.0;
    damping = 0.02;
  }
  integral_A_ = std::clamp(integral_A_ + growth * error * tick_s, -3.0, 3.0);
  return std::clamp(gain * error + integral_A_ - damping * plant_.velocity_rad_per_s(), -most_A, most_A);
}

void VescFake::advance(double duration_s) {
  constexpr double tick_s = substeps * substep_s;
  owed_s_ += duration_s;
  for (; owed_s_ >= tick_s; owed_s_ -= tick_s) {
    sinceWord_s_ += tick_s;
    if (sinceWord_s_ > timeout_s || fault != 0) mode_ = Mode::released;
    powered_ = mode_ != Mode::released;
    if (mode_ == Mode::released) {
      plant_.openWindings();
    } else {
      const double back_V = rig_.backEmfConstant_V_s_per_rad * plant_.velocity_rad_per_s();
      if (mode_ == Mode::duty) {
        voltage_V_ = target_ * rig_.bridge.supply_V;
      } else {
        const double wanted_A = wantedCurrent_A(tick_s);
        const double pull_V = 0.3 * rig_.inductance_H / tick_s * (wanted_A - plant_.current_A());
        voltage_V_ = rig_.resistance_ohm * wanted_A + back_V + pull_V;
      }
      voltage_V_ = std::clamp(voltage_V_, -rig_.bridge.supply_V, rig_.bridge.supply_V);
      plant_.applyVoltage(voltage_V_);
    }
    plant_.advance(substeps);
    currentSum_A_ += plant_.current_A();
    ++currentCount_;
  }
  velocity_ = plant_.velocity_rad_per_s();
  angle_ = plant_.angle_rad();
}

}  // namespace breakaway::test
