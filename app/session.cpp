#include "session.h"

#include <chrono>

#include "firmware_link/simulated_board.h"
#include "slow_turning.h"

namespace breakaway {

using namespace std::chrono_literals;

Session::Session(const DriveLoopOptions& options, QObject* parent) : QObject(parent), options_(options) {
  heartbeat_.setTimerType(Qt::PreciseTimer);
  connect(&heartbeat_, &QTimer::timeout, this, [this] {
    if (loop_) loop_->beat();
  });
  heartbeat_.start(40ms);
}

Session::~Session() = default;

void Session::connectTo(const QString& uri, unsigned seed) {
  auto drive = openDrive(uri.toStdString(), seed);
  if (!drive) {
    emit said(QString::fromStdString(drive.error().message()), true);
    return;
  }
  adopt(std::move(*drive), uri);
}

void Session::open(const QString& uri) {
  connectTo(uri);
  if (connected() && identity_.simulated) turnSlowly();
}

void Session::adopt(std::unique_ptr<Drive> drive, const QString& uri) {
  disconnectBoard();
  uri_ = uri;
  identity_ = drive->identity();
  settings_ = drive->settings();
  loop_ = std::make_unique<DriveLoop>(std::move(drive), options_);
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
  listen(&DriveLoop::failed, [this](const QString& reason) {
    disconnectBoard();
    emit said(reason, true);
  });
}

void Session::disconnectBoard() {
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

void Session::start(RunKind kind, std::shared_ptr<Procedure> procedure, std::function<RunResult()> read) {
  if (!loop_) return;
  lastStop_.clear();
  loop_->start({kind, std::move(procedure), std::move(read)});
}

void Session::turnSlowly() {
  start(RunKind::turning, std::make_shared<SlowTurning>(SlowTurning::Options{}), {});
}

void Session::home(const HomingOptions& options) {
  const auto homing = std::make_shared<Homing>(options);
  start(RunKind::homing, homing, [homing] {
    const bool finished = homing->state() == Procedure::State::finished;
    return HomingResult{homing->passes(), finished ? homing->indexAngle_rad() : Estimate{}};
  });
}

void Session::measureStep(const VelocityStepOptions& options) {
  const auto step = std::make_shared<VelocityStep>(options);
  start(RunKind::step, step, [step, options, settings = settings_] {
    const bool finished = step->state() == Procedure::State::finished;
    return StepResult{step->curve(), finished ? step->figures() : StepFigures{}, options, settings};
  });
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
  keepResult(snapshot);
  emit runChanged();
}

void Session::keepResult(const RunSnapshot& snapshot) {
  if (snapshot.status.state == Procedure::State::failed)
    emit said(QString::fromStdString(snapshot.status.failure), true);
  if (snapshot.status.state != Procedure::State::finished) return;
  if (const auto* homing = std::get_if<HomingResult>(&snapshot.result)) {
    index_rad_ = homing->index_rad;
  } else if (const auto* step = std::get_if<StepResult>(&snapshot.result)) {
    steps_.push_back(*step);
  }
  emit measured();
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
