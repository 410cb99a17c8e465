#include "bench_job.h"

#include <algorithm>

#include "experiment/current_zeroing.h"
#include "experiment/spin_test.h"
#include "experiment/winding_test.h"
#include "identify/velocity_friction.h"
#include "identify/winding_fit.h"
#include "procedure_sequence.h"

namespace breakaway {

namespace {

/// What a job gathers while it runs; touched in the I/O thread alone.
struct Gathered {
  std::optional<Identification> identification;
  std::shared_ptr<CurrentZeroing> zeroing;
  std::shared_ptr<WindingTest> winding;
  std::shared_ptr<SpinTest> spin;
  std::shared_ptr<BreakawaySweep> sweep;
};

Result<void> identify(Gathered& job, std::optional<double> trusted_Nm_per_A) {
  const auto winding = fitWinding(*job.winding);
  if (!winding) return winding.error();
  MotorIdentificationOptions options;
  options.trustedTorqueConstant_Nm_per_A = trusted_Nm_per_A;
  const auto motor = identifyMotor(job.spin->blocks(), winding->line, winding->timeConstant_s, options);
  if (!motor) return motor.error();
  const Identification found{*motor, job.zeroing->noiseRms_A(), winding->expected_A};
  job.identification = found;
  return {};
}

std::vector<ProcedureSequence::Stage> identificationStages(const std::shared_ptr<Gathered>& job,
                                                           std::optional<double> trusted_Nm_per_A) {
  const auto nothing = [] { return Result<void>{}; };
  return {{1.1, [job] { return job->zeroing = std::make_shared<CurrentZeroing>(); }, nothing},
          {30.0, [job] { return job->winding = std::make_shared<WindingTest>(); }, nothing},
          {24.0, [job] { return job->spin = std::make_shared<SpinTest>(); },
           [job, trusted_Nm_per_A] { return identify(*job, trusted_Nm_per_A); }}};
}

BreakawaySweepOptions sweepOptions(const BreakawayRequest& request, const Identification& known) {
  const IdentifiedMotor& motor = known.motor;
  BreakawaySweepOptions options;
  options.bins = request.bins;
  options.turns = request.turns;
  options.indexAngle_rad = request.index_rad;
  options.torqueConstant_Nm_per_A = motor.torqueConstant_Nm_per_A.value;
  options.resistance_ohm = motor.resistance_ohm.value;
  options.deadZone_V = motor.deadZone_V.value;
  options.inertia_kg_m2 = motor.inertia_kg_m2.value;
  options.backEmfConstant_V_s_per_rad = motor.backEmfConstant_V_s_per_rad.value;
  options.expected_A = known.expected_A;
  options.countsPerRev = request.countsPerRev;
  options.indexTolerance_rad = request.indexTolerance_rad;
  options.current_limit_A = request.current_limit_A;
  VelocityFrictionOptions friction;
  friction.torqueConstant_Nm_per_A = options.torqueConstant_Nm_per_A;
  friction.inertia_kg_m2 = options.inertia_kg_m2;
  friction.bins = request.bins;
  for (const Way way : {Way::cw, Way::ccw})
    options.moving_A[static_cast<size_t>(way)] = movingCurrent_A(request.runs, way, friction);
  return options;
}

}  // namespace

Run identificationRun(std::optional<double> trustedTorqueConstant_Nm_per_A) {
  const auto job = std::make_shared<Gathered>();
  const auto whole = std::make_shared<ProcedureSequence>(identificationStages(job, trustedTorqueConstant_Nm_per_A));
  return {RunKind::identification, whole, [job] { return IdentificationResult{job->identification}; }};
}

Run breakawayRun(const BreakawayRequest& request) {
  const auto job = std::make_shared<Gathered>();
  job->identification = request.identification;
  std::vector<ProcedureSequence::Stage> stages;
  if (!request.identification) stages = identificationStages(job, request.trustedTorqueConstant_Nm_per_A);
  const double expected_s = 1.1 * static_cast<double>(2 * request.bins * request.turns);
  stages.push_back({expected_s,
                    [job, request] {
                      return job->sweep = std::make_shared<BreakawaySweep>(sweepOptions(request, *job->identification),
                                                                           request.earlier);
                    },
                    [] { return Result<void>{}; }});
  const auto whole = std::make_shared<ProcedureSequence>(std::move(stages));
  return {RunKind::breakaway, whole, [job, request] {
            BreakawayResult result{request.earlier, request.bins, request.turns, 0, job->identification};
            if (job->sweep) {
              result.events = job->sweep->events();
              result.missed = job->sweep->missed();
            }
            return result;
          }};
}

Run velocitySweepRun(const VelocityRequest& request) {
  const auto job = std::make_shared<Gathered>();
  job->identification = request.identification;
  std::vector<ProcedureSequence::Stage> stages;
  if (!request.identification) stages = identificationStages(job, request.trustedTorqueConstant_Nm_per_A);
  const VelocitySweepOptions& options = request.options;
  const double expected_s = 2.0 * static_cast<double>(options.speeds_rad_per_s.size()) *
                            (options.run_s + options.settle_s + options.zeroing_s);
  auto sweep = std::make_shared<VelocitySweep>(options, request.earlier);
  stages.push_back({expected_s, [sweep] { return sweep; }, [] { return Result<void>{}; }});
  const auto whole = std::make_shared<ProcedureSequence>(std::move(stages));
  return {RunKind::velocitySweep, whole, [job, sweep] {
            return VelocitySweepResult{sweep->runs(), job->identification};
          }};
}

}  // namespace breakaway
