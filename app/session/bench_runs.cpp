// What is started at the bench, and why it can't be.
#include "session/bench_runs.h"

#include <cmath>

#include "bench_job.h"
#include "experiment/abilities.h"
#include "session/slow_strokes.h"
#include "session/slow_turning.h"

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

BenchRuns::BenchRuns(Connection& connection, Messages& messages, QObject* parent)
    : QObject(parent), connection_(connection), messages_(messages) {
  connect(&connection_, &Connection::came, this, &BenchRuns::meetBoard);
  connect(&connection_, &Connection::left, this, &BenchRuns::leaveBoard);
  connect(&connection_, &Connection::runReported, this, &BenchRuns::keepResult);
}

BenchRuns::~BenchRuns() {
  pool_.waitForDone();
}

void BenchRuns::turnSlowly() {
  if (const auto known = axis()) {
    connection_.start(
        {RunKind::turning, std::make_shared<SlowStrokes>(known->travel, 1.0 / connection_.identity().loopRate_Hz), {}});
    return;
  }
  if (connection_.linear()) return;
  connection_.start({RunKind::turning, std::make_shared<SlowTurning>(SlowTurning::Options{}), {}});
}

void BenchRuns::home(const HomingOptions& options) {
  if (connection_.linear()) {
    connection_.start(axisHoming());
    return;
  }
  HomingOptions known = options;
  known.countsPerRev = connection_.identity().countsPerRev;
  const auto homing = std::make_shared<Homing>(known);
  connection_.start({RunKind::homing, homing, [homing] {
                       const bool finished = homing->state() == Procedure::State::finished;
                       return HomingResult{homing->passes(), finished ? homing->indexAngle_rad() : Estimate{}};
                     }});
}

void BenchRuns::measureStep(const VelocityStepOptions& wanted) {
  VelocityStepOptions options = wanted;
  options.axis = connection_.identity().axis;
  auto step = std::make_shared<VelocityStep>(options);
  std::shared_ptr<Procedure> whole = step;
  if (const auto known = axis()) {
    AxisStep over = stepOver(*known, paceOf(*known), options);
    whole = over.whole;
    step = over.step;
  }
  connection_.start({RunKind::step, whole, [step, options, settings = connection_.settings()] {
                       const bool finished = step->state() == Procedure::State::finished;
                       return StepResult{step->curve(), finished ? step->figures() : StepFigures{}, options, settings};
                     }});
}

void BenchRuns::sweepVelocity(double highest_rad_per_s, size_t speeds, double duration_s, size_t bins) {
  if (connection_.linear()) {
    auto request = axisSweep(bins);
    if (!request) return;
    request->pace.speed_m_per_s = std::min(request->pace.speed_m_per_s, highest_rad_per_s);
    connection_.start(strokesRun(*request, speeds, duration_s, survey_.strokes));
    return;
  }
  VelocitySweepOptions options;
  for (size_t k = 0; k < speeds; ++k) {
    const double part = speeds < 2 ? 1.0 : static_cast<double>(k) / static_cast<double>(speeds - 1);
    options.speeds_rad_per_s.push_back(highest_rad_per_s * std::pow(0.06, 1.0 - part));
  }
  options.countsPerRev = connection_.identity().countsPerRev;
  options.indexAngle_rad = index_rad_ ? index_rad_->value : 0.0;
  options.indexTolerance_rad = index_rad_ ? indexTolerance_rad(connection_.identity().countsPerRev) : 0.0;
  options.run_s = duration_s;
  VelocityRequest request{options, {}, survey_.identification, trustedTorqueConstant(bench_)};
  if (survey_.runs.size() < 2 * speeds && surveyedDevice_ == connection_.identity().device)
    request.earlier = survey_.runs;
  connection_.start(velocitySweepRun(request));
}

void BenchRuns::sweepBreakaway(size_t bins, size_t turns) {
  std::vector<BreakawayEvent> earlier;
  if (!survey_.sweepComplete && surveyedDevice_ == connection_.identity().device && survey_.bins == bins &&
      survey_.turns == turns)
    earlier = survey_.events;
  if (!earlier.empty()) messages_.say(tr("The sweep goes on after %1 breakaways").arg(earlier.size()));
  if (connection_.linear()) {
    const auto request = axisSweep(bins);
    if (!request) return;
    auto run = travelBreakawayRun(*request, turns, survey_.strokes, earlier);
    if (!run) return messages_.warn(run.error());
    connection_.start(std::move(*run));
    return;
  }
  BreakawayRequest request;
  request.earlier = earlier;
  request.bins = bins;
  request.turns = turns;
  request.index_rad = index_rad_ ? index_rad_->value : 0.0;
  request.indexTolerance_rad = index_rad_ ? indexTolerance_rad(connection_.identity().countsPerRev) : 0.0;
  request.trustedTorqueConstant_Nm_per_A = trustedTorqueConstant(bench_);
  request.identification = survey_.identification;
  request.runs = survey_.runs;
  request.countsPerRev = connection_.identity().countsPerRev;
  request.current_limit_A = connection_.settings().current_limit_A;
  connection_.start(breakawayRun(request));
}

QString BenchRuns::homingObstacle() const {
  const std::string never = connection_.connected() ? obstacleTo(Task::homing, connection_.identity()) : std::string();
  return never.empty() ? connection_.obstacle() : sentence(never);
}

QString BenchRuns::sweepObstacle() const {
  if (connection_.connected()) {
    if (const std::string never = obstacleTo(Task::sweep, connection_.identity()); !never.empty())
      return sentence(never);
  }
  if (QString busy = connection_.obstacle(); !busy.isEmpty()) return busy;
  if (!index_rad_)
    return connection_.linear() ? tr("Home first: it feels for both ends, and places count from the index")
                                : tr("Home first: angles around the rotor count from the index");
  return {};
}

QString BenchRuns::breakawayObstacle(size_t bins) const {
  if (QString sweep = sweepObstacle(); !sweep.isEmpty() || !connection_.linear()) return sweep;
  if (survey_.strokes.empty())
    return tr("Run the velocity sweep first: its slow strokes tell what keeps the axis moving");
  if (survey_.strokeBins != bins)
    return tr("The velocity sweep was taken apart into %1 places: take as many here, or run it again")
        .arg(survey_.strokeBins);
  return {};
}

QString BenchRuns::turningObstacle() const {
  if (QString busy = connection_.obstacle(); !busy.isEmpty()) return busy;
  return connection_.linear() && !axis() ? tr("Home first: the ends of the travel are not known yet") : QString();
}

QString BenchRuns::stepObstacle() const {
  if (QString busy = connection_.obstacle(); !busy.isEmpty()) return busy;
  return connection_.linear() && !axis()
             ? tr("Home first: a step in velocity needs room, and the ends are not known yet")
             : QString();
}

std::optional<double> BenchRuns::highestStep_m_per_s() const {
  const auto known = axis();
  if (!known) return {};
  return breakaway::highestStep_m_per_s(*known, paceOf(*known), VelocityStepOptions{});
}

std::optional<KnownAxis> BenchRuns::axis() const {
  auto known = connection_.linear() && index_rad_ ? survey_.knownAxis() : std::nullopt;
  if (!known) return {};
  known->board = connection_.identity();
  known->current_limit_A = connection_.settings().current_limit_A;
  known->index_m = index_rad_->value;
  known->travel = moved(known->travel, known->index_m);
  return known;
}

Run BenchRuns::axisHoming() const {
  AxisHomingRequest request{
      connection_.identity(), connection_.settings(), survey_.identification, trustedTorqueConstant(bench_), {}};
  if (bench_ && bench_->currentGainInterval) request.scale.gainInterval = *bench_->currentGainInterval;
  if (bench_ && bench_->trusted.contains("mass_kg")) request.scale.trustedInertia_kg_m2 = bench_->motor.inertia;
  return axisHomingRun(request);
}

std::optional<AxisSweepRequest> BenchRuns::axisSweep(size_t bins) const {
  const auto known = axis();
  if (!known) return {};
  return AxisSweepRequest{
      *known, paceOf(*known), {known->travel.first_m(), known->travel.last_m(), bins}, survey_.identification};
}

double BenchRuns::reachableSpeed_rad_per_s() const {
  if (const auto known = axis()) return paceOf(*known).speed_m_per_s;
  double backEmf_V_s_per_rad = connection_.settings().nominal_torque_constant_Nm_per_A;  // the same quantity in SI
  if (bench_ && bench_->motor.backEmfConstant) backEmf_V_s_per_rad = *bench_->motor.backEmfConstant;
  if (survey_.identification) backEmf_V_s_per_rad = survey_.identification->motor.backEmfConstant_V_s_per_rad.value;
  return backEmf_V_s_per_rad > 0.0 ? 0.55 * connection_.identity().supply_V / backEmf_V_s_per_rad : 10.0;
}

QString BenchRuns::gainsObstacle() const {
  return connection_.connected() ? sentence(obstacleTo(Task::tuning, connection_.identity()))
                                 : tr("No board is connected");
}

QString BenchRuns::tuningObstacle() const {
  if (QString never = gainsObstacle(); !never.isEmpty()) return never;
  return tuning_ ? tr("Tuning") : QString();
}

QString BenchRuns::marginLine() const {
  return connection_.connected() ? marginWords(boardLoop(connection_.identity(), connection_.settings(), motor()))
                                 : QString();
}

void BenchRuns::tune(Stiffness stiffness) {
  if (!tuningObstacle().isEmpty()) return;
  tuning_ = true;
  emit tuningChanged();
  pool_.start([this, stiffness, board = board_, identity = connection_.identity(), settings = connection_.settings(),
               known = motor()] {
    const auto tuned = tunedSettings(identity, settings, known, stiffness);
    QMetaObject::invokeMethod(
        this, [this, board, tuned] { takeTuning(board, tuned); }, Qt::QueuedConnection);
  });
}

void BenchRuns::takeTuning(unsigned board, const Result<ControllerSettings>& tuned) {
  tuning_ = false;
  if (!tuned) messages_.warn(tuned.error());
  if (tuned && board == board_) connection_.configure(*tuned);
  emit tuningChanged();
}

}  // namespace breakaway
