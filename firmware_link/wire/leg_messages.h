// The messages that start a leg on the board. Freestanding.
#pragma once

#include <cstddef>
#include <cstdint>

#include "firmware_link/wire/bytes.h"

namespace breakaway::wire {

/// What stands before each plan, whose figures are those of control/leg. It is a command like MotorCommand: `flags` and
/// `latch` are those. A start with the number of the leg that runs, or that has ended last, is that one said again.
struct LegHead {
  std::uint8_t number = 0;
  std::uint8_t flags = 0;
  std::uint16_t latch = 0;
  float current_limit_A = 0;  ///< 0: the parameter's own

  template <typename Self, typename Io>
  static void pass(Self& s, Io& io) {
    io(s.number), io(s.flags), io(s.latch), io(s.current_limit_A);
  }
};

struct StartHoming {
  struct Plan {
    float searchSpeed_rad_per_s = 0, approachSpeed_rad_per_s = 0, backOff_rad = 0, tolerance_rad = 0, mostTurns = 0,
          timeout_s = 0, stall_s = 0;
    std::uint8_t approaches = 0;
  };
  LegHead head;
  Plan plan;

  template <typename Self, typename Io>
  static void pass(Self& s, Io& io) {
    auto& p = s.plan;
    io(s.head), io(p.searchSpeed_rad_per_s), io(p.approachSpeed_rad_per_s), io(p.backOff_rad), io(p.tolerance_rad);
    io(p.mostTurns), io(p.timeout_s), io(p.stall_s), io(p.approaches);
  }
};

struct StartBreakaway {
  enum Way : std::uint8_t { growing = 1, learning = 2 };
  struct Plan {
    std::int32_t targetCounts = 0;
    std::uint8_t ways = 0;
    float near_rad = 0, nearSpeed_rad_per_s = 0, near_s = 0, move_s = 0, dwell_s = 0, mostDwell_s = 0,
          restSpeed_rad_per_s = 0;
    float hold_A = 0, resistance_ohm = 0, deadZone_V = 0;
    float rampStart_A = 0, rampRate_A_per_s = 0, rampTop_A = 0;
    std::uint16_t motionCounts = 0;
    float motionSpeed_rad_per_s = 0;
  };
  LegHead head;
  Plan plan;

  template <typename Self, typename Io>
  static void pass(Self& s, Io& io) {
    auto& p = s.plan;
    io(s.head), io(p.targetCounts), io(p.ways), io(p.near_rad), io(p.nearSpeed_rad_per_s), io(p.near_s), io(p.move_s);
    io(p.dwell_s), io(p.mostDwell_s), io(p.restSpeed_rad_per_s), io(p.hold_A), io(p.resistance_ohm), io(p.deadZone_V);
    io(p.rampStart_A), io(p.rampRate_A_per_s), io(p.rampTop_A), io(p.motionCounts), io(p.motionSpeed_rad_per_s);
  }
};

struct StartSpeed {
  struct Plan {
    float target_rad_per_s = 0, wobble = 0, settle_s = 0, run_s = 0;
    std::uint16_t leastTurns = 0;
  };
  LegHead head;
  Plan plan;

  template <typename Self, typename Io>
  static void pass(Self& s, Io& io) {
    auto& p = s.plan;
    io(s.head), io(p.target_rad_per_s), io(p.wobble), io(p.settle_s), io(p.run_s), io(p.leastTurns);
  }
};

constexpr bool isFinite(float value) {
  return value - value == 0.0f;
}

/// Whether each of a message's floats is a finite number.
template <typename Message>
bool allFinite(const Message& message) {
  struct Floats {
    bool finite = true;
    void operator()(float value) { finite = finite && isFinite(value); }
    void operator()(std::uint8_t) {}
    void operator()(std::uint16_t) {}
    void operator()(std::int32_t) {}
    void operator()(const LegHead& head) { LegHead::pass(head, *this); }
  } floats;
  Message::pass(message, floats);
  return floats.finite;
}

}  // namespace breakaway::wire
