#include "session/hand_drive.h"

#include <cmath>
#include <utility>

namespace breakaway {

HandDrive::HandDrive(const HandOptions& options, std::shared_ptr<HandGrip> grip)
    : options_(options), grip_(std::move(grip)), status_{State::running, 0.0, 0.0, message("driven by hand"), ""} {
}

bool HandDrive::intoMargin(double position_m) const {
  if (!options_.travel) return false;
  return options_.target > 0.0 ? position_m >= options_.travel->last_m() : position_m <= options_.travel->first_m();
}

Command HandDrive::step(const Sample& sample) {
  if (status_.state != State::running) return {};
  if (!grip_->held) {
    status_ = {State::finished, 1.0, 0.0, message("let go"), ""};
    return {};
  }
  if (intoMargin(sample.angle_rad)) {
    status_ = {State::failed, 0.0, 0.0, "", message("the margin of the travel is reached")};
    return {};
  }
  if (options_.mostSpeed_rad_per_s > 0.0 && std::abs(sample.velocity_rad_per_s) > options_.mostSpeed_rad_per_s) {
    status_ = {State::failed, 0.0, 0.0, "", message("faster than the limit on the page: let go")};
    return {};
  }
  const Command::Mode mode = options_.mode == HandMode::voltage   ? Command::Mode::voltage
                             : options_.mode == HandMode::current ? Command::Mode::current
                                                                  : Command::Mode::velocity;
  return {mode, options_.target, options_.most_A, false};
}

void HandDrive::stop(const Saying& reason) {
  if (status_.state == State::running) status_ = {State::stopped, 0.0, 0.0, message("stopped"), reason};
}

}  // namespace breakaway
