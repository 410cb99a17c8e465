#include "firmware_link/wish.h"

#include <chrono>
#include <cmath>

#include "firmware_link/leg_start.h"

namespace breakaway {

namespace {

constexpr std::chrono::milliseconds resendAfter(20);  // on a local link an answer takes far less

}  // namespace

void Wish::want(const Command& command) {
  if (!leg_ && command == command_) return;
  leg_.reset();
  command_ = command;
  sendAnew();
}

void Wish::want(const Leg& leg) {
  leg_ = leg;
  command_ = {};
  ++legNumber_;
  sendAnew();
}

void Wish::begin(const Command& command) {
  leg_.reset();
  command_ = command;
  fresh_ = true;
  sendAnew();
}

void Wish::rest() {
  leg_.reset();
  command_ = {};
  fresh_ = false;
  acknowledged_ = true;
}

void Wish::sendAnew() {
  ++changes_;
  acknowledged_ = false;
  sent_ = {};
}

void Wish::prepare(BoardLink& link, const Terms& terms) {
  if (acknowledged_ || BoardLink::Clock::now() - sent_ < resendAfter) return;
  sequence_ = send(link, terms);
  sent_ = BoardLink::Clock::now();
}

std::uint16_t Wish::send(BoardLink& link, const Terms& terms) const {
  using Flag = wire::MotorCommand::Flag;
  const auto flags = static_cast<std::uint8_t>((command_.zeroCurrentSensor ? Flag::zeroCurrentSensor : 0) |
                                               (terms.watched ? Flag::watched : 0) | (fresh_ ? Flag::fresh : 0));
  if (leg_) {
    const LegStart start = legStart(*leg_, {legNumber_, flags, terms.latch}, terms.count_rad);
    return link.prepare(start.type, start.body);
  }
  wire::MotorCommand frame;
  frame.mode = static_cast<wire::MotorCommand::Mode>(command_.mode);
  frame.flags = flags;
  frame.latch = terms.latch;
  frame.current_limit_A = static_cast<float>(command_.current_limit_A);
  if (command_.mode == Command::Mode::position) {
    // A float can't tell counts apart after a few hundred turns.
    const double counts = std::floor(command_.target / terms.count_rad);
    frame.targetCounts = static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::int64_t>(counts)));
    frame.target = static_cast<float>(command_.target - counts * terms.count_rad);
  } else {
    frame.target = static_cast<float>(command_.target);
  }
  return link.prepare(wire::Type::command, bodyOf(frame));
}

bool Wish::isAnswered(const wire::Frame& frame) {
  for (const auto type :
       {wire::Type::command, wire::Type::startHoming, wire::Type::startBreakaway, wire::Type::startSpeed}) {
    if (frame.type == (static_cast<std::uint8_t>(type) | wire::answerBit)) return true;
  }
  return false;
}

std::optional<wire::Code> Wish::answered(const wire::Frame& frame) {
  if (frame.sequence != sequence_ || frame.body.empty()) return std::nullopt;
  const auto code = static_cast<wire::Code>(frame.body[0]);
  if (code == wire::Code::outdated) {  // a later heartbeat was faster; it is still what is wished for
    sendAnew();
    return std::nullopt;
  }
  acknowledged_ = true;  // where it is refused, asking for it again would not help
  if (code != wire::Code::ok) return code;
  fresh_ = false;
  return std::nullopt;
}

}  // namespace breakaway
