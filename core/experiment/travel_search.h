// Feeling for both ends of a linear axis' travel.
#pragma once

#include "experiment/timed_procedure.h"
#include "experiment/travel.h"

namespace breakaway {

struct TravelSearchOptions {
  double speed_m_per_s = 0.05;
  double firstLimit_A = 0.0;  ///< of the current while nothing is known of the friction; it grows until the axis moves
  double mostLimit_A = 0.0;
  double growth = 1.4;          ///< of the limit from one try to the next
  double overMoving = 2.0;      ///< times the limit at which the axis began to move, on the way to an end
  double try_s = 0.4;           ///< each way, per limit
  double stall_s = 0.4;         ///< without motion: the end, or what holds it
  double count_m = 0.0;         ///< of the encoder
  double leastTravel_m = 0.01;  ///< between the ends
  double margin = 0.03;         ///< that is kept from the ends, part of the travel
  double timeout_s = 900.0;     ///< of the whole search
};

/// Tries both ways with a growing current limit until the axis moves, goes on that way until it gets no further, and
/// back to the other end; then to the middle. One that bounces at its stop is there. An axis that stands at a stop thus
/// leaves it before anything pushes hard. Fails in words when it moves neither way up to mostLimit_A, when it doesn't
/// leave an end again, as under a load that presses it there, when the ends lie closer than leastTravel_m, and at the
/// time-out.
class TravelSearch : public TimedProcedure {
 public:
  explicit TravelSearch(const TravelSearchOptions& options);

  /// Both ends; valid when finished.
  const Travel& travel() const { return travel_; }
  /// The current limit at which it began to move: no less than its breakaway current.
  double moving_A() const { return moving_A_; }

 protected:
  Command run(const Sample& sample) override;
  Progress progress() const override;

 private:
  enum class Stage { feel, onwards, back, middle };
  Command feel(const Sample& sample);
  Command towardsEnd(const Sample& sample);
  Command toMiddle(const Sample& sample);
  void enter(Stage stage, const Sample& sample);
  bool stalled(const Sample& sample);
  bool getsNoFurther(const Sample& sample);
  double end_m(const Sample& sample) const;
  void pause(const Sample& sample);
  Message heldWords() const;
  Command move(double way) const { return {Command::Mode::velocity, way * options_.speed_m_per_s, limit_A_, false}; }

  TravelSearchOptions options_;
  Stage stage_ = Stage::feel;
  Travel travel_;
  Glide glide_;
  double motion_m_ = 0.0, limit_A_ = 0.0, moving_A_ = 0.0, way_ = 1.0;
  double there_A_ = 0.0;  ///< the limit, on the way to the first end
  double pauseEnd_s_ = 0.0;
  double anchor_m_ = 0.0, anchor_s_ = 0.0, far_s_ = 0.0, stageStart_m_ = 0.0, firstEnd_m_ = 0.0;
  double furthest_m_ = 0.0;  ///< in this stage's way
  bool left_ = false;
};

}  // namespace breakaway
