#include "firmware_link/board_server.h"

namespace breakaway {

namespace {

using Seconds = std::chrono::duration<double>;
constexpr double turn_s = 0.001;
constexpr double mostBehind_s = 0.1;
constexpr double idle_s = 0.5;            // so that a signal is seen even if it came between two waits
constexpr std::size_t ticksAtOnce = 256;  // between two looks at the line

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
  const std::size_t taken = line_.write(going_, wait_s);
  going_.erase(going_.begin(), going_.begin() + static_cast<std::ptrdiff_t>(taken));
  return going_.empty();
}

/// Nothing is lost: a host that reads slowly holds up the clock, which is his.
void BoardServer::runGranted() {
  const bool runs = firmware_.board().mayTick();
  listen(runs || !going_.empty() ? 0.0 : idle_s);
  if (!going_.empty() && !send(turn_s)) return;
  firmware_.run(ticksAtOnce, going_);
  send(0.0);
}

/// The clock waits for nobody: what a slow host doesn't take fills the board's outbox, and then samples are dropped and
/// counted, as on a board.
void BoardServer::runReal() {
  const auto tick = std::chrono::duration_cast<Clock::duration>(Seconds(firmware_.tick_s()));
  if (Clock::now() - due_ > Seconds(mostBehind_s)) {
    late_s_ += Seconds(Clock::now() - due_).count();
    due_ = Clock::now();
  }
  while (Clock::now() >= due_) {
    firmware_.tickWithoutSending();
    due_ += tick;
  }
  if (going_.empty() || send(0.0)) {
    firmware_.transmit(going_);
    send(0.0);
  }
  const double wait_s = std::min(turn_s, Seconds(due_ - Clock::now()).count());
  came_.clear();
  line_.read(came_, wait_s < turn_s ? turn_s : wait_s);
  firmware_.receive(came_);
}

}  // namespace breakaway
