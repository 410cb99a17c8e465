// What is started at the bench, and why it can't be.
#include "session/bench_runs.h"

#include <utility>

#include "base/numbers.h"
#include "commission/steps.h"
#include "experiment/abilities.h"
#include "experiment/maneuver_run.h"
#include "session/language.h"
#include "session/slow_motion.h"
#include "session/step_over_travel.h"

namespace breakaway {

namespace {

constexpr double partOfBraking = 0.5;  ///< of the strokes' acceleration: friction and loop leave so much

/// A clause as a tooltip shows it.
QString sentence(const Message& clause) {
  QString text = inLanguage(clause);
  return text.left(1).toUpper() + text.mid(1);
}

/// What a kind of run leaves, and what of it is made anew when all is known.
struct Wanted {
  Facts facts, anew;
};

Wanted wantedOf(RunKind kind) {
  switch (kind) {
    case RunKind::wiring:
      return {{Known::wiring}, {Known::wiring}};
    case RunKind::identification:
      return {{Known::motor}, {Known::windingTest}};
    case RunKind::homing:
      return {{Known::index}, {Known::ends, Known::index}};
    case RunKind::velocitySweep:
      return {{Known::runs}, {Known::runs}};
    case RunKind::breakaway:
      return {{Known::map, Known::stribeck}, {Known::breakaways}};
    case RunKind::trial:
      return {{Known::comparison}, {Known::gainsInUse}};
    default:
      return {};
  }
}

Task taskOf(RunKind kind) {
  if (kind == RunKind::wiring || kind == RunKind::identification) return Task::identification;
  return kind == RunKind::homing ? Task::homing : kind == RunKind::trial ? Task::commissioning : Task::sweep;
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
  if (connection_.linear() && !axisIsHomed()) return;
  connection_.start(
      {RunKind::turning,
       axisIsHomed() ? slowStrokes(known_.counted, 1.0 / connection_.identity().loopRate_Hz) : slowTurning(),
       {}});
}

void BenchRuns::measureStep(const VelocityStepOptions& wanted) {
  VelocityStepOptions options = wanted;
  options.axis = connection_.identity().axis;
  measure(RunKind::step, std::make_shared<VelocityStep>(options), options);
}

void BenchRuns::measureStep(const PositionStepOptions& wanted) {
  PositionStepOptions options = wanted;
  options.axis = connection_.identity().axis;
  measure(RunKind::positionStep, std::make_shared<PositionStep>(options), PositionStep::asVelocityStep(options));
}

template <class Step>
void BenchRuns::measure(RunKind kind, const std::shared_ptr<Step>& step, const VelocityStepOptions& options) {
  std::shared_ptr<Procedure> whole = step;
  if (axisIsHomed()) whole = std::make_shared<StepOverTravel>(known_, step);
  connection_.start(
      {kind, whole, [kind, step, options, settings = connection_.settings()] {
         const bool finished = step->state() == Procedure::State::finished;
         return StepResult{step->curve(), finished ? step->figures() : StepFigures{}, options, settings, kind};
       }});
}

void BenchRuns::runManeuver(const Maneuver& motion) {
  const Identity& board = connection_.identity();
  const ControllerSettings& settings = connection_.settings();
  ManeuverLimits limits{settings.velocity_limit_rad_per_s, settings.current_limit_A, {}};
  if (axisIsHomed()) {
    limits.travel = known_.counted;
    limits.speed = known_.pace.speed_m_per_s;
    limits.braking = partOfBraking * known_.pace.acceleration_m_per_s2;
  }
  connection_.start(
      {RunKind::experiment, std::make_shared<ManeuverRun>(motion, limits, board.can.zeroesSensor, board.axis), {}});
}

std::shared_ptr<HandGrip> BenchRuns::driveByHand(const HandOptions& options) {
  auto grip = std::make_shared<HandGrip>();
  HandOptions within = options;
  if (axisIsHomed()) within.travel = known_.counted;
  connection_.start({RunKind::hand, std::make_shared<HandDrive>(within, grip), {}});
  return grip;
}

std::shared_ptr<HandGrip> BenchRuns::jog(const JogOptions& options) {
  auto grip = std::make_shared<HandGrip>();
  JogOptions within = options;
  if (axisIsHomed()) within.travel = known_.counted;
  const double counts = connection_.identity().countsPerRev;
  if (counts > 0.0) within.count_rad = (connection_.linear() ? 1.0 : turn_rad) / counts;
  connection_.start({RunKind::hand, std::make_shared<Jog>(within, grip), {}});
  return grip;
}

CommissionOptions BenchRuns::optionsWith(const SweepSettings& sweeps) const {
  CommissionOptions options;
  options.bench = bench_;
  options.rig = bench_ && !bench_->name.empty() ? bench_->name : connection_.identity().device;
  options.sweeps = sweeps;
  options.keepRecordings = false;
  options.measuresAnew = options.givesGainsBack = true;
  return options;
}

Facts BenchRuns::forgottenFor(RunKind kind, const SweepSettings& sweeps) const {
  const Wanted wanted = wantedOf(kind);
  Facts forgotten = withComputed(known_.otherThan(sweeps)), left = known_.facts;
  left.remove(forgotten);
  if (left.hasAll(wanted.facts)) forgotten.add(withComputed(wanted.anew));
  return forgotten;
}

void BenchRuns::make(RunKind kind, const SweepSettings& sweeps) {
  Commission before = known_;
  before.forget(forgottenFor(kind, sweeps));
  before.sweeps = sweeps;
  Facts wanted = wantedOf(kind).facts;
  // A map drawn from new runs and the breakaways that are there moves nothing.
  if (kind == RunKind::velocitySweep && before.knows(Known::breakaways)) wanted.add({Known::map});
  if (kind == RunKind::breakaway && !before.breakaways.empty() && !before.knows(Known::breakaways))
    messages_.say(tr("The sweep goes on after %1 breakaways").arg(before.breakaways.size()));
  CommissionOptions options = optionsWith(sweeps);
  if (std::exchange(tookUp_, false)) options.earlier = std::exchange(before, {});
  connection_.start(runOf(kind, std::make_shared<Job>(std::move(options), wanted, std::move(before))));
}

QString BenchRuns::missingFor(RunKind kind, const SweepSettings& sweeps) const {
  const Wanted wanted = wantedOf(kind);
  Facts own = wanted.facts;
  own.add(wanted.anew);
  QStringList steps;
  Facts known = known_.facts;
  known.remove(forgottenFor(kind, sweeps));
  for (const StepPtr& step : plan(connection_.identity(), known, wanted.facts)) {
    // What is worth a word takes time.
    if (step->expected_s(sweeps) > 0.0 && !step->leaves().hasAny(own)) steps << inLanguage(step->words());
  }
  return steps.isEmpty() ? QString() : tr("First: %1").arg(steps.join(", "));
}

QString BenchRuns::obstacleToMake(RunKind kind) const {
  if (connection_.connected()) {
    if (const Message never = obstacleTo(taskOf(kind), connection_.identity()); !never.empty()) return sentence(never);
  }
  return connection_.obstacle();
}

QString BenchRuns::turningObstacle() const {
  if (QString busy = connection_.obstacle(); !busy.isEmpty()) return busy;
  return connection_.linear() && !axisIsHomed() ? tr("Home first: the ends of the travel are not known yet")
                                                : QString();
}

QString BenchRuns::stepObstacle() const {
  if (QString busy = connection_.obstacle(); !busy.isEmpty()) return busy;
  return connection_.linear() && !axisIsHomed() ? tr("Home first: a step needs room, and the ends are not known yet")
                                                : QString();
}

QString BenchRuns::handObstacle() const {
  if (connection_.runs(RunKind::hand)) return {};
  if (QString busy = connection_.obstacle(); !busy.isEmpty()) return busy;
  return connection_.linear() && !axisIsHomed() ? tr("Home first: the ends of the travel are not known yet")
                                                : QString();
}

std::optional<Estimate> BenchRuns::index_rad() const {
  return known_.knows(Known::index) ? std::optional(known_.indexAngle_rad) : std::nullopt;
}

std::optional<double> BenchRuns::highestStep() const {
  if (!axisIsHomed()) return {};
  return highestStep_m_per_s(known_, VelocityStepOptions{});
}

std::optional<double> BenchRuns::longestStep() const {
  if (!axisIsHomed()) return {};
  return longestStep_m(known_);
}

QString BenchRuns::gainsObstacle() const {
  return connection_.connected() ? sentence(obstacleTo(Task::tuning, connection_.identity()))
                                 : tr("No board is connected");
}

QString BenchRuns::tuningObstacle() const {
  if (QString never = gainsObstacle(); !never.isEmpty()) return never;
  return tuning_ ? tr("Tuning") : QString();
}

void BenchRuns::tune(Stiffness stiffness, const ControllerSettings& settings) {
  if (!tuningObstacle().isEmpty()) return;
  tuning_ = true;
  emit tuningChanged();
  pool_.start([this, stiffness, board = board_, identity = connection_.identity(), settings, motor = motor()] {
    const auto tuned = tunedSettings(identity, settings, motor, stiffness);
    QMetaObject::invokeMethod(
        this, [this, board, tuned] { takeTuning(board, tuned); }, Qt::QueuedConnection);
  });
}

void BenchRuns::takeTuning(unsigned board, const Result<ControllerSettings>& tuned) {
  tuning_ = false;
  if (!tuned) messages_.warn(tuned.error());
  if (tuned && board == board_) emit this->tuned(*tuned);
  emit tuningChanged();
}

}  // namespace breakaway
