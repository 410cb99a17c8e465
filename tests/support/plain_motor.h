// A motor with Coulomb and viscous friction and nothing else, logged as people log: a plant of its own, in explicit
// steps of 10 µs or less, that shares no code with the simulated boards, the trials or the search.
#pragma once

#include <cstdint>
#include <string>

#include "motor/bench.h"
#include "recording/recording.h"

namespace breakaway::test {

/// What a log adds to a sound motor.
struct LogFaults {
  double wander = 0.0;  ///< rms of a torque that changes at random (Ornstein and Uhlenbeck's), of the Coulomb friction
  double correlation_s = 0.1;   ///< of that torque
  double driveNoise = 0.0;      ///< of the recorded voltage or current, of its range; what acts has none
  double missingRows = 0.0;     ///< part of them
  double stampJitter = 0.0;     ///< of a time stamp, of the row's length; the readings themselves are on time
  double discOffset_rad = 0.0;  ///< once per turn
  double detent = 0.0;          ///< torque seven times per turn, of the Coulomb friction
};

enum class LogKind {
  sound,
  imperfect,  ///< with a draw of faults that sound rigs have
  measured    ///< of a current that runs smoothly and is read, with noise, at the rows' instants; its torque wanders
};

struct PlainMotorLog {
  Bench bench;
  Recording recording;
  LogFaults faults;
  std::string words;  ///< rate, length, drive, what the log adds
};

/// 15 to 40 s at 50 to 1000 Hz of a motor of 15 to 400 ms, driven by voltage, duty or current in steps, sines or a
/// chirp; the bench knows nothing, rough values or resistance and torque constant.
PlainMotorLog plainMotorLog(std::uint64_t seed, LogKind kind);

}  // namespace breakaway::test
