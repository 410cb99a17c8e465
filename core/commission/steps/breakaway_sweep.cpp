// What starts a rotor from standstill, angle by angle, or a linear axis, place by place, both ways.
#include <algorithm>

#include "commission/steps.h"
#include "commission/sweep_layout.h"
#include "commission/travel_plan.h"
#include "experiment/breakaway_sweep.h"

namespace breakaway {

namespace {

/// The line from command to current that breakaway ramps follow: what the board doesn't straighten, as a tangent.
WindingLine rampLine(const Commission& known) {
  WindingLine line;
  line.resistance_ohm.value = known.shownResistance_ohm;
  if (known.linearised) return line;
  line.deadZone_V = known.motor.deadZone_V;
  const DutyCurve& curve = known.motor.dutyCurve;
  if (!curve.known()) return line;
  const double supply_V = known.identity.supply_V;
  const double near_A = std::max({known.expected_A[0], known.expected_A[1], 1e-3});
  const auto volts = [&](double current_A) {
    return supply_V * curve.input(known.shownResistance_ohm * current_A / supply_V);
  };
  line.resistance_ohm.value = (volts(1.2 * near_A) - volts(0.8 * near_A)) / (0.4 * near_A);
  line.deadZone_V.value = volts(near_A) - line.resistance_ohm.value * near_A;
  return line;
}

BreakawaySweepOptions sweepAround(const Commission& known) {
  const WindingLine line = rampLine(known);
  BreakawaySweepOptions options;
  options.bins = known.sweeps.bins;
  options.turns = known.sweeps.turns;
  options.indexAngle_rad = known.indexAngle_rad.value;
  options.torqueConstant_Nm_per_A = known.torquePerAmpere_Nm();
  options.resistance_ohm = line.resistance_ohm.value;
  options.deadZone_V = line.deadZone_V.value;
  options.windingTime_s = windingTime_s(known);
  options.inertia_kg_m2 = known.motor.inertia_kg_m2.value;
  options.backEmfConstant_V_s_per_rad = known.motor.backEmfConstant_V_s_per_rad.value;
  options.expected_A = known.expected_A;
  for (const Way way : {Way::cw, Way::ccw})
    options.moving_A[static_cast<size_t>(way)] = movingCurrent_A(known.runs, way, frictionOptions(known));
  options.countsPerRev = known.identity.countsPerRev;
  options.zeroing_s = sensorZeroing_s(known);
  options.indexTolerance_rad = indexTolerance_rad(options.countsPerRev);
  options.zeroEvery_s = 20.0 * std::max(0.5, options.zeroing_s);
  options.current_limit_A = known.settings.current_limit_A;
  return options;
}

/// How the breakaways were measured, for the map's file.
std::vector<std::pair<std::string, double>> settingsOf(const BreakawayOptions& options, const Commission& known) {
  std::vector<std::pair<std::string, double>> settings{{"torque_constant_Nm_per_A", options.torqueConstant_Nm_per_A},
                                                       {"resistance_ohm", options.resistance_ohm},
                                                       {"dead_zone_V", options.deadZone_V},
                                                       {"inertia_kg_m2", options.inertia_kg_m2},
                                                       {"dwell_s", options.dwell_s},
                                                       {"settle_s", options.settle_s},
                                                       {"ramp_s", options.ramp_s},
                                                       {"motion_velocity_rad_per_s", options.motionVelocity_rad_per_s},
                                                       {"motion_counts", static_cast<double>(options.motionCounts)}};
  for (auto& [name, value] : settings) name = nameOn(known.identity.axis, name);
  if (known.linear()) {
    const Travel& travel = known.counted;
    settings.emplace_back("travel_m", travel.high_m - travel.low_m);
    settings.emplace_back("margin_m", travel.margin_m);
    settings.emplace_back("highest_speed_m_per_s", known.pace.speed_m_per_s);
  } else {
    settings.emplace_back("index_angle_rad", known.indexAngle_rad.value);
  }
  settings.emplace_back("missed", static_cast<double>(known.missed));
  return settings;
}

Facts needsOf(Axis axis) {
  Facts needs{Known::sensorZero, Known::motor, Known::straight, Known::carefulGains, Known::index, Known::runs};
  if (axis == Axis::linear) needs.add({Known::ends});
  return needs;
}

class Breakaways : public Step {
 public:
  explicit Breakaways(Axis axis) : Step("breakaway sweep", needsOf(axis), {Known::breakaways}) {}
  double expected_s(const SweepSettings& sweeps) const override {
    return 1.1 * static_cast<double>(2 * sweeps.bins * sweeps.turns);
  }

  Result<StepRun> begin(OnBench& on) override {
    const Commission& known = on.known;
    std::vector<BreakawayEvent> earlier = known.breakaways;
    if (known.linear()) {
      const auto moving_A = movingCurrent_A(known.strokes);
      if (!moving_A) return moving_A.error();
      zero_ = known.indexAngle_rad.value;
      for (BreakawayEvent& event : earlier) event.angle_rad += zero_;
      const TravelBreakawayOptions options = breakawaySweepOver(known, *moving_A);
      options_ = options;
      sweep_ = std::make_shared<TravelBreakaway>(options, earlier);
    } else {
      const BreakawaySweepOptions options = sweepAround(known);
      options_ = options;
      sweep_ = std::make_shared<BreakawaySweep>(options, earlier);
    }
    before_ = sweep_->events().size();
    return StepRun{known.linear() ? "07-breakaway-sweep" : "06-breakaway-sweep", sweep_};
  }

  bool gather(Commission& known) override {
    const bool more = known.breakaways.size() != sweep_->events().size();
    known.breakaways = sweep_->events();
    known.missed = sweep_->missed();
    for (BreakawayEvent& event : known.breakaways) event.angle_rad -= zero_;
    countFresh(sweep_->zeros(), known.noiseRms_A, before_, known.breakaways);
    return more;
  }

  Result<StepEnd> end(OnBench& on, const Result<void>& ran) override {
    if (!ran) return ran.error();
    Commission& known = on.known;
    const auto& events = known.breakaways;
    const ZeroTrack zeros(sweep_->zeros(), known.noiseRms_A);
    known.eventsZeroError_A = events.empty() ? 0.0 : zeros.at(events[events.size() / 2].time_s).standardError;
    known.zeroing_s = options_.zeroing_s;
    known.zeroings = sweep_->zeros().size();
    known.howMeasured = settingsOf(options_, known);
    remarkMissed(known);
    return StepEnd::over;
  }

 private:
  BreakawayOptions options_;
  std::shared_ptr<BreakawayProcedure> sweep_;
  size_t before_ = 0;
  double zero_ = 0.0;  ///< from which places count, as the encoder counts it; 0: events count from the index already
};

}  // namespace

StepPtr breakawaySweepStep(Axis axis) {
  return std::make_unique<Breakaways>(axis);
}

}  // namespace breakaway
