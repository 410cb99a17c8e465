// Breakaway force over a linear axis' travel: at each place a slow current ramp from standstill until it moves, both
// ways, some times.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "experiment/breakaway_procedure.h"
#include "experiment/travel.h"
#include "experiment/travel_bins.h"

namespace breakaway {

/// `moving_A` per bin.
struct TravelBreakawayOptions : BreakawayOptions {
  Travel travel;
  TravelBins bins;
  size_t passes = 2;                                        ///< over the travel, each way
  double speed_m_per_s = 0.0, acceleration_m_per_s2 = 0.0;  ///< from place to place
  double move_s = 2.0;                                      ///< at most, beyond what the way takes
  double count_m = 0.0;
  double index_m = 0.0, indexTolerance_m = 0.0;
};

/// `angle_rad` of an event is the place in m as the encoder counts it, `torque_Nm` N.
class TravelBreakaway : public BreakawayProcedure {
 public:
  explicit TravelBreakaway(TravelBreakawayOptions options, const std::vector<BreakawayEvent>& earlier = {});

 protected:
  Command run(const Sample& sample) override;
  Progress progress() const override { return progressWith(activity(), 0.3); }
  void beginZeroing(const Sample& sample) override { enter(Stage::zero, sample); }
  void goToPlace(const Sample& sample) override { enter(Stage::move, sample); }
  double moving_A(Way way) const override { return options_.moving_A[static_cast<size_t>(way)][tour_.bin()]; }

 private:
  enum class Stage { zero, move, dwell, ramp };
  void enter(Stage stage, const Sample& sample);
  Command move(const Sample& sample);
  Command dwell(const Sample& sample);
  Command ramp(const Sample& sample);
  Command current(double inWay_A);
  bool moves(const Sample& sample) const;
  double expected_A() const;
  void takeEvent();
  Message activity() const;

  TravelBreakawayOptions options_;
  TravelWatch watch_;
  Glide glide_;
  Stage stage_ = Stage::zero;
  std::array<std::optional<double>, 2> overMoving_;  ///< last breakaway over what keeps it moving there
  double near_s_ = 0.0, now_m_ = 0.0, allowed_s_ = 0.0, commanded_A_ = 0.0;
};

}  // namespace breakaway
