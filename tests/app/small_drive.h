// A drive with the least physics that moves and stops: inertia and a torque of friction. For tests of what lies above
// the port.
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <string>

#include "experiment/drive.h"

namespace breakaway::test {

/// What a test may see of the drive from outside of the I/O thread.
struct DriveWitness {
  std::atomic<bool> powered{false};
  std::atomic<int> stops{0};
  std::atomic<double> velocity_rad_per_s{0.0};
  std::atomic<size_t> lose{0};  ///< samples to lose from the next slice
  std::atomic<bool> cableCut{false};
  std::atomic<bool> trips{false};  ///< the board ends what runs by itself
};

class SmallDrive : public Drive {
 public:
  explicit SmallDrive(std::shared_ptr<DriveWitness> witness, const std::string& serialNumber = {})
      : witness_(std::move(witness)) {
    identity_ = {"small drive", "test 1.0", true, 1000.0, 4096.0, 24.0, true};
    identity_.serialNumber = serialNumber;
    settings_ = {0.02, 0.2, 0.0, 0.5, 0.0, 0.01, 200.0, 1e-4, 0.1, 4.0, 300.0};
  }

  const Identity& identity() const override { return identity_; }
  ControllerSettings settings() const override { return settings_; }
  Result<ControllerSettings> configure(const ControllerSettings& wanted) override {
    settings_ = wanted;
    settings_.observer_cutoff_rad_per_s = std::min(settings_.observer_cutoff_rad_per_s, 500.0);
    return settings_;
  }
  void command(const Command& command) override {
    procedure_.reset();
    command_ = command;
  }
  void start(std::shared_ptr<Procedure> procedure) override { procedure_ = std::move(procedure); }
  void stop(const Saying& reason) override {
    if (procedure_) procedure_->stop(reason);
    procedure_.reset();
    command_ = {};
    sample_.enabled = false;
    witness_->powered = false;
    ++witness_->stops;
  }
  Result<size_t> advance(double duration_s, std::vector<Sample>& samples) override {
    if (witness_->cableCut) return Error{"small drive", "the cable was pulled"};
    if (witness_->trips.exchange(false)) stop("over-current: 9.9 A measured");
    const auto ticks = static_cast<size_t>(std::lround(duration_s * identity_.loopRate_Hz));
    const size_t lost = std::min(ticks, witness_->lose.exchange(0));
    for (size_t k = 0; k < ticks; ++k) {
      tick();
      if (k >= lost) samples.push_back(sample_);
    }
    witness_->powered = sample_.enabled;
    witness_->velocity_rad_per_s = sample_.velocity_rad_per_s;
    return lost;
  }

 private:
  void tick() {
    if (procedure_) command_ = procedure_->step(sample_);
    const double period_s = 1.0 / identity_.loopRate_Hz;
    const bool velocity = command_.mode == Command::Mode::velocity;
    const double pull =
        velocity ? 30.0 * (command_.target - sample_.velocity_rad_per_s) : -20.0 * sample_.velocity_rad_per_s;
    sample_.time_s += period_s;
    sample_.velocity_rad_per_s += pull * period_s;
    sample_.angle_rad += sample_.velocity_rad_per_s * period_s;
    sample_.enabled = command_.mode != Command::Mode::off;
    sample_.current_A = sample_.enabled ? 0.2 + 1e-3 * pull : 0.0;
    sample_.current_reference_A = sample_.current_A;
    sample_.velocity_reference_rad_per_s = velocity ? command_.target : 0.0;
    sample_.disturbance_estimate_Nm = 0.02 * std::tanh(sample_.velocity_rad_per_s);
    sample_.supply_V = identity_.supply_V;
  }

  std::shared_ptr<DriveWitness> witness_;
  Identity identity_;
  ControllerSettings settings_;
  Command command_;
  Sample sample_;
  std::shared_ptr<Procedure> procedure_;
};

}  // namespace breakaway::test
