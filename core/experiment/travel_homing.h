// Homing of a linear axis to its encoder's index.
#pragma once

#include <vector>

#include "base/estimate.h"
#include "experiment/timed_procedure.h"
#include "experiment/travel.h"

namespace breakaway {

struct TravelHomingOptions {
  Travel travel;
  double searchSpeed_m_per_s = 0.05;
  double acceleration_m_per_s2 = 0.5;
  double approachSpeed_m_per_s = 0.005;  ///< towards growing position, always
  double backOff_m = 0.002;
  size_t approaches = 3;
  double stall_s = 3.0;
  double count_m = 0.0;
};

/// Goes to the lower end, runs over the whole travel to see the index once and only once, and passes its edge slowly
/// from below a few times. Fails in words when it isn't seen, is seen at two places, and when the axis doesn't move.
class TravelHoming : public TimedProcedure {
 public:
  explicit TravelHoming(const TravelHomingOptions& options)
      : options_(options), glide_(options.searchSpeed_m_per_s, options.acceleration_m_per_s2) {}

  /// The index as the encoder counts it; valid when finished.
  Estimate index_m() const;

 protected:
  Command run(const Sample& sample) override;
  Progress progress() const override;

 private:
  enum class Stage { lower, search, down, backOff, approach };
  void enter(Stage stage, const Sample& sample);
  void see(const Sample& sample, double before_m);
  Command glideTo(double target_m, const Sample& sample, Stage next);
  Command approach(const Sample& sample, double before_m);
  bool stalled(const Sample& sample);

  TravelHomingOptions options_;
  Glide glide_;
  Stage stage_ = Stage::lower;
  std::vector<double> sights_m_, edges_m_;
  double firstRoom_m_ = 0.0;  ///< half of what was passed in the tick of the first
  size_t rows_ = 0;           ///< samples seen
  double before_m_ = 0.0, stageStart_m_ = 0.0, moved_m_ = 0.0, moved_s_ = 0.0;
};

}  // namespace breakaway
