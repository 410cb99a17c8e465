// Resistance, dead zone and inductance from voltage and current of the standing rotor.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "experiment/free_swing.h"
#include "experiment/open_current.h"
#include "experiment/square_response.h"
#include "experiment/timed_procedure.h"
#include "motor/winding_line.h"

namespace breakaway {

struct WindingTestOptions {
  double start_V = 0.02;
  double doubling_s = 1.0;   ///< the ramp's voltage doubles in this time
  size_t ramps = 4;          ///< alternating ways
  double block_s = 0.01;     ///< of the points that are averaged
  double motion_rad = 0.01;  ///< travel that counts as motion
  double dates_s = 0.03;     ///< standing points this close before the first count, at least, are left out
  double square_s = 8.0;     ///< duration of the square wave
  double squareHalfPeriod_s = 0.008;
  double current_limit_A = 0.0;  ///< 0: the controller's own
  double mostDrift_A = 0.1;      ///< of the current sensor's zero, from one rest to the next
  double noise_A = 0.0;          ///< rms, of the current sensor; 0: unknown
  Axis axis = Axis::rotary;
};

/// Raises the voltage slowly until the rotor moves, both ways, for the steady line; then a square wave below that level
/// for the time constant. Fails in words when the rotor doesn't move up to the supply or the current limit's plateau,
/// when the current sensor drifts, when there is play between motor and encoder, when the current says that the motor
/// turns while the encoder stands, and when motion or current go against the voltage: which wires to swap.
class WindingTest : public TimedProcedure {
 public:
  explicit WindingTest(const WindingTestOptions& options = {}) : options_(options), swing_(options.axis) {}

  const std::vector<WindingPoint>& points() const { return points_; }
  /// Highest standing current of each ramp, positive in its way; the first look at the breakaway current.
  const std::array<std::vector<double>, 2>& breakaway_A() const { return breakaway_A_; }
  /// To the square wave; of a finished test.
  const SquareResponse& squareResponse() const { return *response_; }

 protected:
  Command run(const Sample& sample) override;
  Progress progress() const override;

 private:
  enum class Stage { rest, ramp, square };
  Command rest(const Sample& sample);
  Command ramp(const Sample& sample);
  Command square(const Sample& sample);
  void takePoint(const Sample& sample);
  void endRamp(const Sample& sample);
  Message wrongSigns() const;
  bool flowsAgainst() const;
  Message wrongCurrent(const Sample& sample) const;
  bool runsUnseen() const;
  double way() const { return ramp_ % 2 == 0 ? 1.0 : -1.0; }
  Command voltage(double voltage_V) const {
    return {Command::Mode::voltage, voltage_V, options_.current_limit_A, false};
  }

  WindingTestOptions options_;
  Stage stage_ = Stage::rest;
  size_t ramp_ = 0;
  std::vector<WindingPoint> points_, blocks_;
  std::vector<double> blockTimes_s_;
  double blockNoise_A_ = 0.0;  ///< of a block's mean
  WindingPoint peak_;          ///< of the ramp's current, both in its way
  std::array<std::vector<double>, 2> breakaway_A_;
  double restStart_rad_ = 0.0, halfway_rad_ = 0.0;
  double stageStart_s_ = 0.0, standing_rad_ = 0.0, target_V_ = 0.0, now_s_ = 0.0;
  double blockVoltage_ = 0.0, blockCurrent_ = 0.0, blockStart_s_ = 0.0;
  size_t blockCount_ = 0;
  OpenCurrent open_A_;
  FreeSwing swing_;
  double still_s_ = 0.0;                     ///< when it last stood where the ramp found it
  size_t against_ = 0;                       ///< ramps whose motion went the other way
  double along_A_ = 0.0;                     ///< sum of the last currents before motion, in the ramps' ways
  double standing_V_ = 0.0, onset_V_ = 0.0;  ///< that every ramp stood at; at which current first stood out
  std::optional<SquareResponse> response_;
  size_t squareTicks_ = 0;
  double squareTick_s_ = 0.0;
};

}  // namespace breakaway
