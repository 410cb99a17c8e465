// What a session starts, and why it can't.
#include <cmath>

#include "bench_job.h"
#include "experiment/abilities.h"
#include "session.h"
#include "slow_strokes.h"
#include "slow_turning.h"

namespace breakaway {

namespace {

/// A clause as a tooltip shows it.
QString sentence(const std::string& clause) {
  QString text = QString::fromStdString(clause);
  return text.left(1).toUpper() + text.mid(1);
}

std::optional<double> trustedTorqueConstant(const std::optional<Bench>& bench) {
  if (!bench || !bench->trusted.contains(motorNames(bench->axis).torqueConstant)) return {};
  return bench->motor.torqueConstant;
}

}  // namespace

QString Session::obstacle() const {
  if (!connected()) return tr("No board is connected");
  if (run_.running() && run_.kind != RunKind::turning) {
    return tr("Busy: %1. STOP ends it.").arg(QString::fromStdString(run_.status.activity));
  }
  return {};
}

void Session::stop() {
  if (loop_) loop_->stop();
}

void Session::start(Run run) {
  if (!loop_) return;
  lastStop_.clear();
  loop_->start(std::move(run));
}

void Session::turnSlowly() {
  if (const auto known = axis()) {
    start({RunKind::turning, std::make_shared<SlowStrokes>(known->travel, 1.0 / identity_.loopRate_Hz), {}});
    return;
  }
  if (linear()) return;
  start({RunKind::turning, std::make_shared<SlowTurning>(SlowTurning::Options{}), {}});
}

void Session::home(const HomingOptions& options) {
  if (linear()) {
    start(axisHoming());
    return;
  }
  HomingOptions known = options;
  known.countsPerRev = identity_.countsPerRev;
  const auto homing = std::make_shared<Homing>(known);
  start({RunKind::homing, homing, [homing] {
           const bool finished = homing->state() == Procedure::State::finished;
           return HomingResult{homing->passes(), finished ? homing->indexAngle_rad() : Estimate{}};
         }});
}

void Session::measureStep(const VelocityStepOptions& wanted) {
  VelocityStepOptions options = wanted;
  options.axis = identity_.axis;
  auto step = std::make_shared<VelocityStep>(options);
  std::shared_ptr<Procedure> whole = step;
  if (const auto known = axis()) {
    AxisStep over = stepOver(*known, paceOf(*known), options);
    whole = over.whole;
    step = over.step;
  }
  start({RunKind::step, whole, [step, options, settings = settings_] {
           const bool finished = step->state() == Procedure::State::finished;
           return StepResult{step->curve(), finished ? step->figures() : StepFigures{}, options, settings};
         }});
}

void Session::identify() {
  if (linear()) return home();
  start(identificationRun(trustedTorqueConstant(bench_)));
}

void Session::sweepVelocity(double highest_rad_per_s, size_t speeds, double duration_s, size_t bins) {
  if (linear()) {
    auto request = axisSweep(bins);
    if (!request) return;
    request->pace.speed_m_per_s = std::min(request->pace.speed_m_per_s, highest_rad_per_s);
    start(strokesRun(*request, speeds, duration_s, survey_.strokes));
    return;
  }
  VelocitySweepOptions options;
  for (size_t k = 0; k < speeds; ++k) {
    const double part = speeds < 2 ? 1.0 : static_cast<double>(k) / static_cast<double>(speeds - 1);
    options.speeds_rad_per_s.push_back(highest_rad_per_s * std::pow(0.06, 1.0 - part));
  }
  options.countsPerRev = identity_.countsPerRev;
  options.indexAngle_rad = index_rad_ ? index_rad_->value : 0.0;
  options.indexTolerance_rad = index_rad_ ? indexTolerance_rad(identity_.countsPerRev) : 0.0;
  options.run_s = duration_s;
  VelocityRequest request{options, {}, survey_.identification, trustedTorqueConstant(bench_)};
  if (survey_.runs.size() < 2 * speeds && surveyedDevice_ == identity_.device) request.earlier = survey_.runs;
  start(velocitySweepRun(request));
}

void Session::sweepBreakaway(size_t bins, size_t turns) {
  std::vector<BreakawayEvent> earlier;
  if (!survey_.sweepComplete && surveyedDevice_ == identity_.device && survey_.bins == bins && survey_.turns == turns)
    earlier = survey_.events;
  if (!earlier.empty()) emit said(tr("The sweep goes on after %1 breakaways").arg(earlier.size()), false);
  if (linear()) {
    const auto request = axisSweep(bins);
    if (!request) return;
    auto run = travelBreakawayRun(*request, turns, survey_.strokes, earlier);
    if (!run) return say(QString::fromStdString(run.error().message()), true);
    start(std::move(*run));
    return;
  }
  BreakawayRequest request;
  request.earlier = earlier;
  request.bins = bins;
  request.turns = turns;
  request.index_rad = index_rad_ ? index_rad_->value : 0.0;
  request.indexTolerance_rad = index_rad_ ? indexTolerance_rad(identity_.countsPerRev) : 0.0;
  request.trustedTorqueConstant_Nm_per_A = trustedTorqueConstant(bench_);
  request.identification = survey_.identification;
  request.runs = survey_.runs;
  request.countsPerRev = identity_.countsPerRev;
  request.current_limit_A = settings_.current_limit_A;
  start(breakawayRun(request));
}

QString Session::homingObstacle() const {
  const std::string never = connected() ? obstacleTo(Task::homing, identity_) : std::string();
  return never.empty() ? obstacle() : sentence(never);
}

QString Session::sweepObstacle() const {
  if (connected()) {
    if (const std::string never = obstacleTo(Task::sweep, identity_); !never.empty()) return sentence(never);
  }
  if (QString busy = obstacle(); !busy.isEmpty()) return busy;
  if (!index_rad_)
    return linear() ? tr("Home first: it feels for both ends, and places count from the index")
                    : tr("Home first: angles around the rotor count from the index");
  return {};
}

QString Session::breakawayObstacle(size_t bins) const {
  if (QString sweep = sweepObstacle(); !sweep.isEmpty() || !linear()) return sweep;
  if (survey_.strokes.empty())
    return tr("Run the velocity sweep first: its slow strokes tell what keeps the axis moving");
  if (survey_.strokeBins != bins)
    return tr("The velocity sweep was taken apart into %1 places: take as many here, or run it again")
        .arg(survey_.strokeBins);
  return {};
}

QString Session::turningObstacle() const {
  if (QString busy = obstacle(); !busy.isEmpty()) return busy;
  return linear() && !axis() ? tr("Home first: the ends of the travel are not known yet") : QString();
}

QString Session::stepObstacle() const {
  if (QString busy = obstacle(); !busy.isEmpty()) return busy;
  return linear() && !axis() ? tr("Home first: a step in velocity needs room, and the ends are not known yet")
                             : QString();
}

std::optional<double> Session::highestStep_m_per_s() const {
  const auto known = axis();
  if (!known) return {};
  return breakaway::highestStep_m_per_s(*known, paceOf(*known), VelocityStepOptions{});
}

std::optional<KnownAxis> Session::axis() const {
  auto known = linear() && index_rad_ ? survey_.knownAxis() : std::nullopt;
  if (!known) return {};
  known->board = identity_;
  known->current_limit_A = settings_.current_limit_A;
  known->index_m = index_rad_->value;
  known->travel = moved(known->travel, known->index_m);
  return known;
}

Run Session::axisHoming() const {
  AxisHomingRequest request{identity_, settings_, survey_.identification, trustedTorqueConstant(bench_), {}};
  if (bench_ && bench_->currentGainInterval) request.scale.gainInterval = *bench_->currentGainInterval;
  if (bench_ && bench_->trusted.contains("mass_kg")) request.scale.trustedInertia_kg_m2 = bench_->motor.inertia;
  return axisHomingRun(request);
}

std::optional<AxisSweepRequest> Session::axisSweep(size_t bins) const {
  const auto known = axis();
  if (!known) return {};
  return AxisSweepRequest{
      *known, paceOf(*known), {known->travel.first_m(), known->travel.last_m(), bins}, survey_.identification};
}

double Session::reachableSpeed_rad_per_s() const {
  if (const auto known = axis()) return paceOf(*known).speed_m_per_s;
  double backEmf_V_s_per_rad = settings_.nominal_torque_constant_Nm_per_A;  // the same quantity in SI
  if (bench_ && bench_->motor.backEmfConstant) backEmf_V_s_per_rad = *bench_->motor.backEmfConstant;
  if (survey_.identification) backEmf_V_s_per_rad = survey_.identification->motor.backEmfConstant_V_s_per_rad.value;
  return backEmf_V_s_per_rad > 0.0 ? 0.55 * identity_.supply_V / backEmf_V_s_per_rad : 10.0;
}

QString Session::gainsObstacle() const {
  return connected() ? sentence(obstacleTo(Task::tuning, identity_)) : tr("No board is connected");
}

}  // namespace breakaway
