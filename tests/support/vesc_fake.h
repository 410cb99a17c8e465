// A VESC at the far end of a pseudo terminal: its protocol around our plant, in real time.
#pragma once

#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

#include "firmware_link/vesc/vesc_frame.h"
#include "plant/plant.h"
#include "plant/rig.h"
#include "support/pty.h"

namespace breakaway::test {

/// Written from the protocol's description, apart from the decoder and the messages that it tests; only the checksum is
/// shared, and that is held to published frames.
class VescFake {
 public:
  static constexpr int polePairs = 7;

  explicit VescFake(const Rig& rig);
  ~VescFake();

  const std::string& path() const { return pty_.path(); }
  // What a test does to it.
  std::atomic<int> fault{0};
  std::atomic<bool> mute{false};        ///< hears, but says nothing
  std::atomic<bool> knowsChoice{true};  ///< answers to selected values; old firmware doesn't
  std::atomic<bool> chatters{false};    ///< other bytes between its answers
  std::atomic<double> timeout_s{1.0};   ///< without a command or a sign of life it releases the motor
  void hangUp();
  // What a test sees of it.
  bool powered() const { return powered_; }
  double velocity_rad_per_s() const { return velocity_; }
  double angle_rad() const { return angle_; }
  /// The payloads of all that isn't a question, in order.
  std::vector<std::vector<std::uint8_t>> commands() const;

 private:
  enum class Mode { released, duty, current, speed, position };
  void work(const std::stop_token& ending);
  void receive();
  void obey(const std::vector<std::uint8_t>& payload);
  void answerVersion();
  void answerValues(bool selected, std::uint32_t fields);
  void send(const std::vector<std::uint8_t>& payload);
  void advance(double duration_s);
  double wantedCurrent_A(double tick_s);

  Rig rig_;
  Plant plant_;
  Pty pty_;
  VescDecoder decoder_;
  mutable std::mutex lock_;
  std::vector<std::vector<std::uint8_t>> commands_;
  std::atomic<bool> powered_{false};
  std::atomic<double> velocity_{0.0}, angle_{0.0};
  Mode mode_ = Mode::released;
  double target_ = 0.0, integral_A_ = 0.0, voltage_V_ = 0.0, sinceWord_s_ = 0.0, owed_s_ = 0.0;
  double currentSum_A_ = 0.0;
  size_t currentCount_ = 0;
  std::jthread thread_;  // last: it starts when all else stands
};

}  // namespace breakaway::test
