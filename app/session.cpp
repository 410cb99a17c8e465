#include "session.h"

#include <chrono>
#include <cmath>

#include "bench_job.h"
#include "experiment/abilities.h"
#include "firmware_link/presets.h"
#include "recording/sample_recording.h"
#include "slow_turning.h"

namespace breakaway {

using namespace std::chrono_literals;

namespace {

std::optional<Bench> benchBeside(const QString& uri) {
  if (!isSimulated(uri.toStdString())) return {};
  const auto rig = rigFileOf(uri.toStdString());
  if (!rig) return {};
  const std::string path = benchFileBeside(*rig);
  if (path.empty()) return {};
  const auto bench = readBench(path);
  return bench ? std::optional(*bench) : std::nullopt;
}

/// A clause as a tooltip shows it.
QString sentence(const std::string& clause) {
  QString text = QString::fromStdString(clause);
  return text.left(1).toUpper() + text.mid(1);
}

std::optional<double> trustedTorqueConstant(const std::optional<Bench>& bench) {
  if (!bench || !bench->trusted.contains("torque_constant_Nm_per_A")) return {};
  return bench->motor.torqueConstant;
}

}  // namespace

Session::Session(const DriveLoopOptions& options, QObject* parent)
    : QObject(parent),
      options_(options),
      board_([this](std::unique_ptr<Drive> drive) { begin(std::move(drive), board_.uri()); }),
      pace_(options.pace) {
  connect(&board_, &BoardConnection::changed, this, &Session::connectionChanged);
  heartbeat_.setTimerType(Qt::PreciseTimer);
  connect(&heartbeat_, &QTimer::timeout, this, [this] {
    if (loop_) loop_->beat();
  });
  heartbeat_.start(40ms);
}

Session::~Session() {
  pool_.waitForDone();
}

void Session::connectTo(const QString& uri, unsigned seed) {
  letGo();
  board_.open({uri.toStdString(), seed});
  if (board_.state() == ConnectionState::failed) emit said(board_.trouble(), true);
}

void Session::open(const QString& uri) {
  connectTo(uri);
  if (connected() && identity_.simulated) turnSlowly();
}

void Session::adopt(std::unique_ptr<Drive> drive, const QString& uri) {
  letGo();
  board_.keep();
  begin(std::move(drive), uri);
}

void Session::begin(std::unique_ptr<Drive> drive, const QString& uri) {
  uri_ = uri;
  identity_ = drive->identity();
  settings_ = drive->settings();
  bench_ = benchBeside(uri);
  survey_.rig = bench_ ? bench_->name : identity_.device;
  if (bench_ && bench_->dutyCurve.known()) {
    if (const auto taken = drive->linearise(bench_->dutyCurve); !taken)
      emit said(QString::fromStdString(taken.error().message()), true);
  }
  loop_ = std::make_unique<DriveLoop>(std::move(drive), options_);
  loop_->setPace(pace_);
  listenToLoop();
  emit connectionChanged();
  emit settingsChanged();
  emit said(tr("Connected to %1").arg(QString::fromStdString(identity_.device)), false);
}

void Session::listenToLoop() {
  // What an earlier connection still had on its way must not reach this one.
  const auto whileThisOne = [this, connection = ++connection_](auto take) {
    return [this, connection, take](const auto&... arguments) {
      if (loop_ && connection == connection_) take(arguments...);
    };
  };
  DriveLoop* loop = loop_.get();
  const auto listen = [this, loop, &whileThisOne](auto signal, auto take) {
    connect(loop, signal, this, whileThisOne(take), Qt::QueuedConnection);
  };
  listen(&DriveLoop::batchArrived, [this](const SampleBatchPtr& batch) { takeBatch(batch); });
  listen(&DriveLoop::runChanged, [this](const RunSnapshot& snapshot) { takeRun(snapshot); });
  listen(&DriveLoop::stopped, [this](DriveLoop::StopCause cause) { takeStop(cause); });
  listen(&DriveLoop::recordingFinished, [this](const auto& samples) { takeRecording(samples); });
  listen(&DriveLoop::linkChanged, [this](const LinkStatus& status) { takeLink(status); });
  listen(&DriveLoop::failed, [this](const QString& reason) { loseBoard(reason); });
}

void Session::loseBoard(const QString& why) {
  letGo();
  board_.lost(why);
  emit said(why, true);
}

void Session::disconnectBoard() {
  letGo();
  board_.close();
}

void Session::letGo() {
  if (!loop_) return;
  loop_.reset();
  identity_ = {};
  link_ = {};
  run_ = {};
  lastStop_.clear();
  recording_ = false;
  history_.clear();
  forgetMeasurements();
  emit connectionChanged();
  emit runChanged();
  emit recordingChanged();
}

bool Session::powered() const {
  const auto newest = history_.newest();
  return newest && newest->enabled;
}

QString Session::stateWords() const {
  if (board_.state() == ConnectionState::connecting) return tr("connecting");
  if (board_.state() == ConnectionState::reconnecting) return tr("link lost, connecting again");
  if (!connected()) return tr("not connected");
  if (run_.running()) return QString::fromStdString(run_.status.activity);
  if (powered()) return tr("powered");
  return lastStop_.isEmpty() ? tr("idle, windings open") : lastStop_;
}

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
  start({RunKind::turning, std::make_shared<SlowTurning>(SlowTurning::Options{}), {}});
}

void Session::home(const HomingOptions& options) {
  HomingOptions known = options;
  known.countsPerRev = identity_.countsPerRev;
  const auto homing = std::make_shared<Homing>(known);
  start({RunKind::homing, homing, [homing] {
           const bool finished = homing->state() == Procedure::State::finished;
           return HomingResult{homing->passes(), finished ? homing->indexAngle_rad() : Estimate{}};
         }});
}

void Session::measureStep(const VelocityStepOptions& options) {
  const auto step = std::make_shared<VelocityStep>(options);
  start({RunKind::step, step, [step, options, settings = settings_] {
           const bool finished = step->state() == Procedure::State::finished;
           return StepResult{step->curve(), finished ? step->figures() : StepFigures{}, options, settings};
         }});
}

void Session::identify() {
  start(identificationRun(trustedTorqueConstant(bench_)));
}

void Session::sweepVelocity(double highest_rad_per_s, size_t speeds, double duration_s) {
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
  BreakawayRequest request;
  request.bins = bins;
  request.turns = turns;
  request.index_rad = index_rad_ ? index_rad_->value : 0.0;
  request.indexTolerance_rad = index_rad_ ? indexTolerance_rad(identity_.countsPerRev) : 0.0;
  request.trustedTorqueConstant_Nm_per_A = trustedTorqueConstant(bench_);
  request.identification = survey_.identification;
  request.runs = survey_.runs;
  if (!survey_.sweepComplete && surveyedDevice_ == identity_.device && survey_.bins == bins && survey_.turns == turns)
    request.earlier = survey_.events;
  if (!request.earlier.empty())
    emit said(tr("The sweep goes on after %1 breakaways").arg(survey_.events.size()), false);
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
  if (!index_rad_) return tr("Home first: angles around the rotor count from the index");
  return {};
}

double Session::reachableSpeed_rad_per_s() const {
  double backEmf_V_s_per_rad = settings_.nominal_torque_constant_Nm_per_A;  // the same quantity in SI
  if (bench_ && bench_->motor.backEmfConstant) backEmf_V_s_per_rad = *bench_->motor.backEmfConstant;
  if (survey_.identification) backEmf_V_s_per_rad = survey_.identification->motor.backEmfConstant_V_s_per_rad.value;
  return backEmf_V_s_per_rad > 0.0 ? 0.55 * identity_.supply_V / backEmf_V_s_per_rad : 10.0;
}

void Session::setPace(double pace) {
  pace_ = pace;
  if (loop_) loop_->setPace(pace);
}

void Session::forgetSteps() {
  steps_.clear();
  emit measured();
}

void Session::configure(const ControllerSettings& wanted) {
  if (!loop_) return;
  loop_->post(
      [this, wanted](Drive& drive) {
        const auto accepted = drive.configure(wanted);
        QMetaObject::invokeMethod(
            this,
            [this, accepted] {
              if (!accepted) {
                emit said(QString::fromStdString(accepted.error().message()), true);
              } else {
                settings_ = *accepted;
              }
              emit settingsChanged();
            },
            Qt::QueuedConnection);
      },
      false);
}

void Session::onBoard(std::function<void(Drive&)> job) {
  if (loop_) loop_->post(std::move(job), false);
}

void Session::takeSettings(const ControllerSettings& settings) {
  if (!loop_) return;
  settings_ = settings;
  emit settingsChanged();
}

void Session::tune(Stiffness stiffness) {
  if (!tuningObstacle().isEmpty()) return;
  tuning_ = true;
  emit settingsChanged();
  pool_.start([this, stiffness, connection = connection_, identity = identity_, settings = settings_, known = motor()] {
    const auto tuned = tunedSettings(identity, settings, known, stiffness);
    QMetaObject::invokeMethod(
        this, [this, connection, tuned] { takeTuning(connection, tuned); }, Qt::QueuedConnection);
  });
}

void Session::takeTuning(unsigned connection, const Result<ControllerSettings>& tuned) {
  tuning_ = false;
  if (!tuned) emit said(QString::fromStdString(tuned.error().message()), true);
  if (tuned && loop_ && connection == connection_) configure(*tuned);
  emit settingsChanged();
}

QString Session::gainsObstacle() const {
  return connected() ? sentence(obstacleTo(Task::tuning, identity_)) : tr("No board is connected");
}

QString Session::tuningObstacle() const {
  if (QString never = gainsObstacle(); !never.isEmpty()) return never;
  return tuning_ ? tr("Tuning") : QString();
}

QString Session::marginLine() const {
  return connected() ? marginWords(boardLoop(identity_, settings_, motor())) : QString();
}

void Session::startRecording() {
  if (!loop_ || recording_) return;
  recording_ = true;
  loop_->startRecording();
  emit recordingChanged();
}

void Session::finishRecording() {
  if (loop_ && recording_) loop_->finishRecording();
}

void Session::takeBatch(const SampleBatchPtr& batch) {
  history_.append(batch->samples);
  emit samplesArrived();
}

void Session::takeLink(const LinkStatus& status) {
  link_ = status;
  emit linkChanged();
}

void Session::takeRun(const RunSnapshot& snapshot) {
  run_ = snapshot;
  keepSurvey(snapshot);
  keepResult(snapshot);
  emit runChanged();
}

void Session::keepResult(const RunSnapshot& snapshot) {
  const bool tripped = snapshot.status.state == Procedure::State::stopped && snapshot.endedByBoard;
  if (tripped) lastStop_ = tr("stopped by the board");
  if (tripped || snapshot.status.state == Procedure::State::failed)
    emit said(QString::fromStdString(snapshot.status.failure), true);
  if (snapshot.status.state != Procedure::State::finished) return;
  if (const auto* homing = std::get_if<HomingResult>(&snapshot.result)) {
    index_rad_ = homing->index_rad;
  } else if (const auto* step = std::get_if<StepResult>(&snapshot.result)) {
    steps_.push_back(*step);
  }
  emit measured();
}

void Session::keepSurvey(const RunSnapshot& snapshot) {
  const bool ended = snapshot.status.state != Procedure::State::running;
  if (const auto* identified = std::get_if<IdentificationResult>(&snapshot.result)) {
    if (identified->found) survey_.identification = identified->found;
  } else if (const auto* sweep = std::get_if<VelocitySweepResult>(&snapshot.result)) {
    survey_.identification = sweep->identification;
    survey_.runs = sweep->runs;
  } else if (const auto* breakaways = std::get_if<BreakawayResult>(&snapshot.result)) {
    survey_.identification = breakaways->identification;
    survey_.events = breakaways->events;
    survey_.bins = breakaways->bins;
    survey_.turns = breakaways->turns;
    survey_.missed = breakaways->missed;
    survey_.sweepComplete = snapshot.status.state == Procedure::State::finished;
  } else {
    return;
  }
  surveyedDevice_ = identity_.device;
  emit surveyChanged();
  if (ended) estimateSurvey();
}

void Session::estimateSurvey() {
  pool_.start([this, number = ++surveyNumber_, survey = survey_]() mutable {
    survey.estimate();
    QMetaObject::invokeMethod(
        this,
        [this, number, survey = std::move(survey)] {
          if (number != surveyNumber_) return;
          survey_ = survey;
          emit surveyChanged();
        },
        Qt::QueuedConnection);
  });
}

void Session::forgetMeasurements() {
  index_rad_.reset();
  steps_.clear();
  emit measured();
}

void Session::takeStop(DriveLoop::StopCause cause) {
  if (cause == DriveLoop::StopCause::pressed) {
    lastStop_ = tr("stopped");
    emit said(tr("STOP: the motor is off"), false);
  } else if (cause == DriveLoop::StopCause::watchdog) {
    lastStop_ = tr("stopped by watchdog");
    emit said(tr("The window did not answer for %1 ms, so the motor was stopped").arg(options_.watchdog_s * 1e3), true);
  }
  emit runChanged();
}

void Session::takeRecording(const std::shared_ptr<const std::vector<Sample>>& samples) {
  recording_ = false;
  auto recording =
      sealSamples("live recording", *samples, {{"device", identity_.device}, {"firmware", identity_.firmware}});
  if (recording) {
    lastRecording_ = *recording;
    emit said(tr("Recorded %1 samples").arg(samples->size()), false);
  } else {
    emit said(QString::fromStdString(recording.error().message()), true);
  }
  emit recordingChanged();
}

}  // namespace breakaway
