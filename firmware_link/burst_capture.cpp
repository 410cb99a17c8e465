#include "firmware_link/burst_capture.h"

#include <algorithm>

#include "firmware_link/fault_words.h"
#include "firmware_link/sample_decoder.h"

namespace breakaway {

namespace {

using Clock = BoardLink::Clock;
constexpr double captureBeatEvery_s = 0.05, grant_s = 0.2, slack_s = 5.0;

class BurstJob {
 public:
  BurstJob(BoardLink& link, const BoardDictionary& board) : link_(link), board_(board) {}

  Result<CapturedBurst> run(const BurstRequest& request) {
    if (auto begun = begin(request); !begun) return begun.error();
    auto filled = fill();
    const auto stopped = link_.ask<wire::Alive>(wire::Type::stop);
    if (!filled) return filled.error();
    if (!stopped) return stopped.error();
    return read();
  }

 private:
  Result<void> begin(const BurstRequest& request) {
    if (!board_.can(wire::Hello::capture)) return Error{link_.place(), message("takes no burst")};
    const auto stopped = link_.ask<wire::Alive>(wire::Type::stop);
    if (!stopped) return stopped.error();
    const bool acts = request.mode != wire::MotorCommand::Mode::off;
    wire::Capture wanted;
    wanted.trigger = acts ? wire::Capture::Trigger::nextCommand : wire::Capture::Trigger::now;
    wanted.every = static_cast<std::uint8_t>(request.every);
    wanted.schema = wire::usualChannels;
    wanted.samples = request.samples;
    const auto accepted = link_.ask<wire::Capture>(wire::Type::startCapture, wanted);
    if (!accepted) return accepted.error();
    if (accepted->samples == 0) return Error{link_.place(), message("has no room for a burst")};
    accepted_ = *accepted;
    if (!acts) return {};
    wire::MotorCommand command;
    command.mode = request.mode;
    command.flags = wire::MotorCommand::fresh;
    command.latch = stopped->latch;
    command.target = static_cast<float>(request.target);
    const auto taken = link_.ask<wire::MotorCommand>(wire::Type::command, command);
    return taken ? Result<void>{} : taken.error();
  }

  /// Keeps the lease until the board has all samples.
  Result<void> fill() {
    const double rate_Hz = static_cast<double>(board_.hello().loopRate_Hz);
    const double length_s = accepted_.samples * static_cast<double>(accepted_.every) / rate_Hz;
    const auto begun = Clock::now();
    std::uint32_t until = 0;
    while (std::chrono::duration<double>(Clock::now() - begun).count() < 10.0 * length_s + slack_s) {
      const auto alive = link_.ask<wire::Alive>(wire::Type::heartbeat, wire::Heartbeat{until});
      if (!alive) return alive.error();
      until = alive->tick + static_cast<std::uint32_t>(grant_s * rate_Hz);
      if (alive->fault != wire::FaultCode::none) faulted_ = true;
      const auto page = link_.ask<wire::CapturePage>(wire::Type::readCapture, wire::CaptureAsked{0});
      if (!page) return page.error();
      if (page->taken >= accepted_.samples) return {};
      if (auto taken = link_.take(std::min(captureBeatEvery_s, length_s)); !taken) return taken.error();
    }
    return Error{link_.place(), message("did not come to the end of the burst")};
  }

  Result<CapturedBurst> read() {
    CapturedBurst burst;
    SampleDecoder decoder(board_.telemetry());
    std::size_t lost = 0;
    while (burst.samples.size() < accepted_.samples && lost == 0) {
      const wire::CaptureAsked asked{static_cast<std::uint16_t>(burst.samples.size())};
      const auto body = link_.ask(wire::Type::readCapture, bodyOf(asked));
      if (!body) return body.error();
      wire::Reader in(*body);
      wire::CapturePage page;
      in(page);
      const std::size_t before = burst.samples.size();
      if (in.ok() && page.first == asked.first) lost = decoder.take(in.rest(), burst.samples);
      if (burst.samples.size() == before)
        return Error{link_.place(), message("gave another part of the burst than was asked for")};
    }
    if (lost > 0) return Error{link_.place(), message("gave a burst with a gap")};
    const auto values = board_.values(link_, {"current_zero_A", "current_trip_A", "blocked_for_s", "lease_s"});
    if (!values) return values.error();
    for (Sample& sample : burst.samples) sample.current_A -= decoder.unzeroed() ? (*values)[0] : 0.0;
    if (!faulted_) return burst;
    const auto fault = link_.ask<wire::Fault>(wire::Type::fault);
    if (!fault) return fault.error();
    burst.fault = faultWords(*fault, {(*values)[1], (*values)[2], (*values)[3],
                                      static_cast<double>(board_.hello().supply_V), decoder.count_rad()});
    return burst;
  }

  BoardLink& link_;
  const BoardDictionary& board_;
  wire::Capture accepted_;
  bool faulted_ = false;
};

}  // namespace

Result<CapturedBurst> captureBurst(BoardLink& link, const BoardDictionary& board, const BurstRequest& request) {
  return BurstJob(link, board).run(request);
}

}  // namespace breakaway
