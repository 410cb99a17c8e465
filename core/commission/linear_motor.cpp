// The motor's chapter of a linear axis' commissioning: zero, ends, winding, strokes, scale, tuning.
#include <cmath>
#include <memory>

#include "commission/axis_identification.h"
#include "commission/commission_begin.h"
#include "commission/linear_job.h"
#include "experiment/current_zeroing.h"

namespace breakaway {

Result<void> LinearJob::zero() {
  const auto zeroing = std::make_shared<CurrentZeroing>();
  if (auto ran = steps_.run("01-zero", zeroing, 0.002); !ran) return ran;
  done_.noiseRms_A = zeroing->noiseRms_A();
  done_.sensorZero_A = zeroing->zero_A();
  return {};
}

Result<void> LinearJob::findEnds() {
  const auto search = std::make_shared<TravelSearch>(searchOn(drive_.identity(), drive_.settings()));
  if (auto ran = steps_.run("02-ends", search, 0.02); !ran) return ran;
  travel_ = search->travel();
  done_.travel = travel_;
  return {};
}

Result<void> LinearJob::identify() {
  if (kept_.motor) {
    done_.motor = *kept_.motor;
    expected_A_ = kept_.expected_A;
    shownResistance_ohm_ = kept_.shownResistance_ohm;
    return {};
  }
  const auto winding = std::make_shared<WindingTest>(windingTestOn(drive_.identity()));
  if (auto ran = steps_.run("03-winding", winding, 0.02); !ran) return ran;
  const auto fit = fitWinding(*winding);
  if (!fit) return Error{"03-winding", fit.error().message()};
  expected_A_ = fit->expected_A;
  const auto strokesOptions = strokesOn(drive_.identity(), drive_.settings(), travel_, *fit);
  const auto strokes = std::make_shared<TravelStrokes>(strokesOptions);
  if (auto ran = steps_.run("04-strokes", strokes, 0.03); !ran) return ran;
  const auto motor = identifyAxis({*fit, winding->points(), strokes->blocks(), strokesOptions.block_s,
                                   drive_.identity().supply_V, trustedConstant(options_)},
                                  done_.remarks);
  if (!motor) return Error{"04-strokes", motor.error().message()};
  done_.motor = *motor;
  return setScale();
}

Result<void> LinearJob::setScale() {
  CurrentScaleOptions options;
  if (options_.bench) {
    if (options_.bench->currentGainInterval) options.gainInterval = *options_.bench->currentGainInterval;
    if (options_.bench->trusted.contains("mass_kg")) options.trustedInertia_kg_m2 = options_.bench->motor.inertia;
  }
  if (options_.against) {
    const Estimate &here = options_.addedInertia_kg_m2, &other = options_.against->addedInertia_kg_m2;
    options.added = AddedInertia{options_.against->motor.shownInertia_kg_m2,
                                 {here.value - other.value, std::hypot(here.standardError, other.standardError)}};
  }
  shownResistance_ohm_ = done_.motor.resistance_ohm.value;
  setAxisScale(done_.motor, options);
  done_.remarks.push_back(done_.motor.gauge);
  return steps_.keep([this] {
    kept_.motor = done_.motor;
    kept_.expected_A = expected_A_;
    kept_.shownResistance_ohm = shownResistance_ohm_;
  });
}

/// The bridge's curve, where it has one, to the board.
void LinearJob::lineariseBoard() {
  const DutyCurve& curve = done_.motor.dutyCurve;
  if (!curve.known()) return;
  const auto taken = drive_.linearise(curve);
  linearised_ = taken.ok();
  done_.remarks.push_back(linearised_
                              ? "The bridge bends its duty: the board takes its voltages through the measured curve's "
                                "inverse."
                              : "The bridge bends its duty, and the board can't straighten it (" + taken.error().fact +
                                    "): breakaway ramps are made along a straight line.");
}

/// What the chapters so far know of the axis.
KnownAxis LinearJob::known() const {
  return {drive_.identity(),
          travel_,
          done_.motor,
          shownResistance_ohm_,
          done_.noiseRms_A,
          linearised_,
          drive_.settings().current_limit_A,
          done_.indexAngle_rad.value};
}

/// Careful gains, and how fast the axis may go between its ends.
Result<void> LinearJob::tune() {
  lineariseBoard();
  pace_ = paceOf(known());
  const auto accepted = drive_.configure(carefulSettings(known(), pace_, drive_.settings()));
  if (!accepted) return accepted.error();
  done_.settings = *accepted;
  return {};
}

}  // namespace breakaway
