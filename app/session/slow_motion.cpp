#include "session/slow_motion.h"

#include <cmath>
#include <functional>
#include <optional>

#include "base/numbers.h"

namespace breakaway {

namespace {

constexpr double amplitude_rad_per_s = 6.0, period_s = 4.0;  // of a rotor
constexpr double most_m_per_s = 0.05;                        // of a linear axis
constexpr double stroke_s = 4.0;                             // at least, from place to place
constexpr double slowSpeedUp_s = 0.2;
constexpr double near = 0.01;  // of the travel

/// Goes at the velocity that `next` says, from the first sample on.
class Endless : public Procedure {
 public:
  using Next = std::function<double(double time_s, double angle_rad)>;
  Endless(const Message& activity, Next next)
      : status_{State::running, 0.0, 0.0, activity, ""}, next_(std::move(next)) {}

  Command step(const Sample& sample) override {
    if (status_.state != State::running) return {};
    if (!start_s_) start_s_ = sample.time_s;
    return {Command::Mode::velocity, next_(sample.time_s - *start_s_, sample.angle_rad)};
  }
  Status status() const override { return status_; }
  void stop(const Saying& reason) override {
    if (status_.state == State::running) status_ = {State::stopped, 0.0, 0.0, message("stopped"), reason};
  }

 private:
  Status status_;
  Next next_;
  std::optional<double> start_s_;
};

}  // namespace

std::shared_ptr<Procedure> slowTurning() {
  return std::make_shared<Endless>(message("turning slowly to and fro"), [](double time_s, double) {
    return amplitude_rad_per_s * std::sin(turn_rad * time_s / period_s);
  });
}

std::shared_ptr<Procedure> slowStrokes(const Travel& travel, double tick_s) {
  const double speed_m_per_s = std::min(most_m_per_s, 0.5 * travel.usable_m() / stroke_s);
  return std::make_shared<Endless>(
      message("going to and fro slowly"),
      [travel, tick_s, way = 1.0, glide = Glide(speed_m_per_s, speed_m_per_s / slowSpeedUp_s)](double,
                                                                                               double at_m) mutable {
        const double target_m = travel.middle_m() + way * 0.25 * travel.usable_m();
        if (way * (at_m - target_m) > -near * travel.usable_m()) way = -way;
        return glide.next(at_m, target_m, tick_s);
      });
}

}  // namespace breakaway
