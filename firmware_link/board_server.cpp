#include "firmware_link/board_server.h"

namespace breakaway {

namespace {

using Seconds = std::chrono::duration<double>;
constexpr double turn_s = 0.001;
constexpr double mostBehind_s = 0.1;
constexpr double idle_s = 0.5;            // so that a signal is seen even if it came between two waits
constexpr std::size_t ticksAtOnce = 256;  // between two looks at the line
constexpr int ticksToGather = 32;         // what they say fits into the board's outbox
// What waits for a slow host, some ten seconds of 10 kHz × 12 channels: this process stands for the serial adapter and
// the system's driver too, and shares its processor with the host.
constexpr std::size_t mostWaiting = std::size_t{4} << 20;
constexpr double goneAfter_s =
    3.0;  // a host that takes nothing for so long isn't there, and isn't told what was before

}  // namespace

void BoardServer::turn() {
  if (pace_ == board::Pace::granted) {
    runGranted();
  } else {
    runReal();
  }
}

void BoardServer::listen(double wait_s) {
  came_.clear();
  line_.read(came_, wait_s);
  firmware_.receive(came_);
  firmware_.transmit(going_);
}

/// Whether all that waited has gone.
bool BoardServer::send(double wait_s) {
  while (sent_ < going_.size()) {
    const std::size_t taken = line_.write(std::span(going_).subspan(sent_), wait_s);
    if (taken == 0) break;
    sent_ += taken;
    taken_ = Clock::now();
  }
  if (sent_ < going_.size()) return false;
  taken_ = Clock::now();
  going_.clear();
  sent_ = 0;
  return true;
}

/// Takes what the board has to send, as long as there is room.
void BoardServer::gather() {
  if (going_.size() - sent_ > mostWaiting) return;
  if (sent_ > mostWaiting) {
    going_.erase(going_.begin(), going_.begin() + static_cast<std::ptrdiff_t>(sent_));
    sent_ = 0;
  }
  firmware_.transmit(going_);
}

/// Nothing is lost: a host that reads slowly holds up the clock, which is his.
void BoardServer::runGranted() {
  const bool runs = firmware_.board().mayTick();
  listen(runs || !going_.empty() ? 0.0 : idle_s);
  if (!going_.empty() && !send(turn_s)) return;
  firmware_.run(ticksAtOnce, going_);
  send(0.0);
}

/// The clock waits for nobody: when more waits for a slow host than there is room for, the board's outbox fills, and
/// then samples are dropped and counted, as on a board. Where this process itself was kept waiting, its clock lags
/// behind the wall's, and no tick is missing.
void BoardServer::runReal() {
  const auto tick = std::chrono::duration_cast<Clock::duration>(Seconds(firmware_.tick_s()));
  if (Clock::now() - due_ > Seconds(mostBehind_s)) {
    late_s_ += Seconds(Clock::now() - due_).count();
    due_ = Clock::now();
  }
  for (int ticks = 1; Clock::now() >= due_; ++ticks) {
    firmware_.tickWithoutSending();
    due_ += tick;
    if (ticks % ticksToGather == 0) gather();
  }
  gather();
  if (!send(0.0) && Clock::now() - taken_ > Seconds(goneAfter_s)) {
    going_.clear();
    sent_ = 0;
  }
  const double wait_s = std::min(turn_s, Seconds(due_ - Clock::now()).count());
  came_.clear();
  line_.read(came_, wait_s < turn_s ? turn_s : wait_s);
  firmware_.receive(came_);
}

}  // namespace breakaway
