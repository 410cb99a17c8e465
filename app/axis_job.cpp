#include "axis_job.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "commission/axis_identification.h"
#include "experiment/current_zeroing.h"
#include "identify/zero_track.h"
#include "procedure_sequence.h"
#include "travel_to.h"

namespace breakaway {

namespace {

constexpr double slowestPart = 0.012;  // of the highest speed

/// What the way home gathers; touched in the I/O thread alone.
struct WayHome {
  AxisHomingRequest request;
  std::optional<Identification> identification;
  std::optional<Travel> travel;
  WindingFit windingFit;
  double block_s = 0.0;
  std::shared_ptr<CurrentZeroing> zeroing;
  std::shared_ptr<TravelSearch> search;
  std::shared_ptr<WindingTest> winding;
  std::shared_ptr<TravelStrokes> strokes;
  std::shared_ptr<TravelHoming> homing;

  KnownAxis axis() const {
    return {request.board,
            *travel,
            identification->motor,
            identification->shownResistance_ohm,
            identification->noiseRms_A,
            false,
            request.settings.current_limit_A,
            0.0};
  }
};

Result<void> nothing() {
  return {};
}

Result<void> identify(WayHome& job) {
  std::vector<std::string> remarks;  // the straight line that they speak of is the window's on a rotor, too
  auto motor = identifyAxis({job.windingFit, job.winding->points(), job.strokes->blocks(), job.block_s,
                             job.request.board.supply_V, job.request.trustedForceConstant_N_per_A},
                            remarks);
  if (!motor) return motor.error();
  Identification found{*motor, job.zeroing->noiseRms_A(), job.windingFit.expected_A, motor->resistance_ohm.value};
  setAxisScale(found.motor, job.request.scale);
  job.identification = found;
  return {};
}

std::vector<ProcedureSequence::Stage> identificationStages(const std::shared_ptr<WayHome>& job) {
  return {{30.0, [job] { return job->winding = std::make_shared<WindingTest>(windingTestOn(job->request.board)); },
           [job]() -> Result<void> {
             const auto fit = fitWinding(*job->winding);
             if (!fit) return fit.error();
             job->windingFit = *fit;
             return {};
           }},
          {12.0,
           [job] {
             const auto options = strokesOn(job->request.board, job->request.settings, *job->travel, job->windingFit);
             job->block_s = options.block_s;
             return job->strokes = std::make_shared<TravelStrokes>(options);
           },
           [job] { return identify(*job); }}};
}

HomingResult resultOf(const WayHome& job) {
  HomingResult result;
  result.travel = job.travel;
  result.identification = job.identification;
  if (job.homing && job.homing->state() == Procedure::State::finished) result.index_rad = job.homing->index_m();
  if (!job.request.board.hasIndex && job.travel && job.identification) result.index_rad = lowerEnd(job.axis());
  return result;
}

}  // namespace

Run axisHomingRun(const AxisHomingRequest& request) {
  const auto job = std::make_shared<WayHome>();
  job->request = request;
  job->identification = request.identification;
  std::vector<ProcedureSequence::Stage> stages{
      {1.1, [job] { return job->zeroing = std::make_shared<CurrentZeroing>(); }, nothing},
      {20.0,
       [job] {
         return job->search = std::make_shared<TravelSearch>(searchOn(job->request.board, job->request.settings));
       },
       [job]() -> Result<void> {
         job->travel = job->search->travel();
         return {};
       }}};
  if (!request.identification) {
    for (auto& stage : identificationStages(job)) stages.push_back(std::move(stage));
  }
  if (request.board.hasIndex) {
    stages.push_back({10.0,
                      [job] {
                        const KnownAxis axis = job->axis();
                        return job->homing = std::make_shared<TravelHoming>(homingOver(axis, paceOf(axis)));
                      },
                      nothing});
  }
  return {RunKind::homing, std::make_shared<ProcedureSequence>(std::move(stages)), [job] { return resultOf(*job); }};
}

AxisStep stepOver(const KnownAxis& axis, const TravelPace& pace, const VelocityStepOptions& options) {
  auto step = std::make_shared<VelocityStep>(options);
  const Glide glide(0.3 * pace.speed_m_per_s, pace.acceleration_m_per_s2);
  const double way_s = axis.travel.usable_m() / glide.speed_m_per_s();
  std::vector<ProcedureSequence::Stage> stages{{way_s,
                                                [travel = axis.travel, glide] {
                                                  return std::make_shared<TravelTo>(travel.first_m(),
                                                                                    0.5 * travel.margin_m, glide);
                                                },
                                                nothing},
                                               {options.before_s + options.after_s, [step] { return step; }, nothing}};
  return {std::make_shared<ProcedureSequence>(std::move(stages)), step};
}

double highestStep_m_per_s(const KnownAxis& axis, const TravelPace& pace, const VelocityStepOptions& options) {
  constexpr double part = 0.9;  // of the way between the margins
  // v·t + v²·m/(2·C): the friction alone stops it.
  const double coasting = 0.5 * axis.motor.inertia_kg_m2.value / std::max(1e-6, axis.motor.coulomb_Nm.value);
  const double t = options.after_s, room_m = part * axis.travel.usable_m();
  const double byRoom = (std::sqrt(t * t + 4.0 * coasting * room_m) - t) / (2.0 * coasting);
  return std::min(pace.speed_m_per_s, byRoom);
}

std::vector<double> strokeParts(size_t speeds) {
  constexpr double golden = 0.6180339887;
  std::vector<size_t> order(speeds);
  std::iota(order.begin(), order.end(), size_t{0});
  const auto turn = [](size_t k) { return std::fmod(golden * static_cast<double>(k + 1), 1.0); };
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return turn(a) < turn(b); });
  std::vector<double> parts;
  for (const size_t k : order) {
    const double up = speeds < 2 ? 1.0 : static_cast<double>(k) / static_cast<double>(speeds - 1);
    parts.push_back(std::pow(slowestPart, 1.0 - up));
  }
  return parts;
}

Run strokesRun(const AxisSweepRequest& request, size_t speeds, double run_s, const std::vector<TravelRun>& earlier) {
  const auto options = velocitySweepOver(request.axis, request.pace, request.bins, strokeParts(speeds), run_s);
  std::vector<TravelRun> kept;  // as long as they are the same sweep's
  for (const TravelRun& run : earlier) {
    const size_t k = kept.size();
    const bool same = k < options.speeds_m_per_s.size() && run.target_m_per_s == options.speeds_m_per_s[k] &&
                      run.bins[0].size() == options.bins.count;
    if (!same) break;
    kept.push_back(run);
  }
  if (kept.size() == options.speeds_m_per_s.size()) kept.clear();
  const auto sweep = std::make_shared<TravelSweep>(options, kept);
  return {RunKind::velocitySweep, sweep,
          [sweep, before = kept.size(), noise_A = request.axis.noiseRms_A, bins = request.bins.count] {
            StrokesResult result{sweep->runs(), bins};
            // A zero is known from the zeroings of its own part alone.
            const ZeroTrack zeros(sweep->zeros(), noise_A);
            const auto fresh = result.strokes.begin() + static_cast<std::ptrdiff_t>(before);
            countFrom(zeros, std::span(fresh, result.strokes.end()));
            if (!result.strokes.empty())
              result.zeroError_A = zeros.at(result.strokes[result.strokes.size() / 2].middle_s).standardError;
            return result;
          }};
}

Result<Run> travelBreakawayRun(const AxisSweepRequest& request, size_t passes, const std::vector<TravelRun>& strokes,
                               const std::vector<BreakawayEvent>& earlier) {
  const auto moving_A = movingCurrent_A(strokes);
  if (!moving_A) return moving_A.error();
  const auto options = breakawaySweepOver(request.axis, request.pace, request.bins, passes, *moving_A);
  const double index_m = request.axis.index_m;
  std::vector<BreakawayEvent> counted = earlier;
  for (BreakawayEvent& event : counted) event.angle_rad += index_m;
  const auto sweep = std::make_shared<TravelBreakaway>(options, counted);
  const size_t before = sweep->events().size();
  return Run{RunKind::breakaway, sweep, [sweep, before, request, options, index_m] {
               BreakawayResult result{sweep->events(), options.bins.count, options.passes, sweep->missed(),
                                      request.identification};
               for (BreakawayEvent& event : result.events) event.angle_rad -= index_m;
               const ZeroTrack zeros(sweep->zeros(), request.axis.noiseRms_A);
               const auto fresh = result.events.begin() + static_cast<std::ptrdiff_t>(before);
               countFrom(zeros, std::span(fresh, result.events.end()));
               if (!result.events.empty())
                 result.zeroError_A = zeros.at(result.events[result.events.size() / 2].time_s).standardError;
               result.settings = settingsOf(options, request.pace, result.missed);
               return result;
             }};
}

}  // namespace breakaway
