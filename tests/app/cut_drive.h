// A board whose cable a test can pull.
#pragma once

#include <atomic>
#include <memory>
#include <utility>
#include <vector>

#include "experiment/drive.h"

namespace breakaway::test {

class CutDrive : public Drive {
 public:
  CutDrive(std::unique_ptr<Drive> board, std::shared_ptr<std::atomic<bool>> cut)
      : board_(std::move(board)), cut_(std::move(cut)) {}

  const Identity& identity() const override { return board_->identity(); }
  ControllerSettings settings() const override { return board_->settings(); }
  std::vector<SettingRange> settingRanges() const override { return board_->settingRanges(); }
  Result<ControllerSettings> configure(const ControllerSettings& wanted) override { return board_->configure(wanted); }
  Result<void> compensate(const FrictionCompensation& friction) override { return board_->compensate(friction); }
  Result<void> linearise(const DutyCurve& curve) override { return board_->linearise(curve); }
  Result<FrictionCompensation> compensation() override { return board_->compensation(); }
  void command(const Command& command) override { board_->command(command); }
  void start(std::shared_ptr<Procedure> procedure) override { board_->start(std::move(procedure)); }
  void stop(const Saying& reason) override { board_->stop(reason); }
  Trip tripped() const override { return board_->tripped(); }
  Result<size_t> advance(double duration_s, std::vector<Sample>& samples) override {
    if (*cut_) return Error{"board", "the cable was pulled"};
    return board_->advance(duration_s, samples);
  }

 private:
  std::unique_ptr<Drive> board_;
  std::shared_ptr<std::atomic<bool>> cut_;
};

}  // namespace breakaway::test
