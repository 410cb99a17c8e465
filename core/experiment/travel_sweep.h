// Strokes to and fro at several speeds over a linear axis' travel: Coulomb and viscous friction per place and way.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiment/timed_procedure.h"
#include "experiment/travel.h"
#include "experiment/travel_bins.h"
#include "experiment/zeroing.h"
#include "friction/measurements.h"

namespace breakaway {

struct TravelSweepOptions {
  Travel travel;
  TravelBins bins;                     ///< within the margins
  std::vector<double> speeds_m_per_s;  ///< in the order they are run
  double acceleration_m_per_s2 = 0.0;
  double run_s = 25.0;  ///< at each speed, at least one stroke each way
  double zeroing_s = 0.6;
  double index_m = 0.0, indexTolerance_m = 0.0;  ///< from homing; a tolerance of 0: no index
  Steadiness steadiness;                         ///< by which bins count
  double windingTime_s = 0.0;                    ///< L/R; 0: the current is there at once
  double stall_s = 2.0;
  double mostDrift_A = 0.1;
};

/// Before each speed the current sensor is zeroed. Fails in words when the axis doesn't move, when the encoder doesn't
/// count as it did, and when the current sensor drifts.
class TravelSweep : public TimedProcedure {
 public:
  /// `earlier`: runs of an interrupted sweep; those with the options' speeds and bins are kept. Of a speed that was
  /// broken off only what is left is run, a stroke each way at least.
  explicit TravelSweep(TravelSweepOptions options, const std::vector<TravelRun>& earlier = {});

  /// Those that are complete, and those that were broken off before.
  const std::vector<TravelRun>& runs() const { return runs_; }
  /// What the one under way has crossed by now, as if it were broken off. Nothing before its first bins, and of a run
  /// that failed.
  const TravelRun* underWay() const { return underWay_ && state() != State::failed ? &*underWay_ : nullptr; }
  const std::vector<ZeroReading>& zeros() const { return zeroing_.readings(); }

 protected:
  Command run(const Sample& sample) override;
  Progress progress() const override;

 private:
  enum class Stage { zero, approach, forth, back };
  void enter(Stage stage, const Sample& sample);
  Command zero(const Sample& sample);
  Command stroke(const Sample& sample);
  void endStroke(const Sample& sample);
  bool stalled(const Sample& sample);
  double farEnd_m() const;
  double speed() const { return options_.speeds_m_per_s[std::min(number_, options_.speeds_m_per_s.size() - 1)]; }
  double halfSpan_s() const;
  bool isDone(double speed_m_per_s) const;
  void skipDone();
  double left_s() const;
  void keepCrossed(const Sample& sample);

  TravelSweepOptions options_;
  Zeroing zeroing_;
  TravelWatch watch_;
  Glide glide_;
  Stage stage_ = Stage::zero;
  std::vector<TravelRun> runs_;
  TravelRun now_;
  std::optional<TravelRun> underWay_;
  StrokeTrace trace_;
  size_t number_ = 0;
  double stageStart_s_ = 0.0, runStart_s_ = 0.0, moved_m_ = 0.0, moved_s_ = 0.0;
  double thisRun_s_ = 0.0;  ///< for so long this run goes on
  double kept_s_ = 0.0;     ///< when what is under way was taken
};

}  // namespace breakaway
