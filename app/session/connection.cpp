#include "session/connection.h"

#include <chrono>
#include <utility>

#include "experiment/profile.h"
#include "session/language.h"

namespace breakaway {

using namespace std::chrono_literals;

Connection::Connection(Messages& messages, const DriveLoopOptions& options, QObject* parent)
    : QObject(parent),
      messages_(messages),
      options_(options),
      opener_([this](std::unique_ptr<Drive> drive) { begin(std::move(drive)); }),
      pace_(options.pace) {
  connect(&opener_, &BoardOpener::changed, this, &Connection::changed);
  heartbeat_.setTimerType(Qt::PreciseTimer);
  connect(&heartbeat_, &QTimer::timeout, this, [this] {
    if (loop_) loop_->beat();
  });
}

void Connection::open(const QString& uri, unsigned seed) {
  letGo();
  uri_ = uri;
  opener_.open({uri.toStdString(), seed});
  if (state() == ConnectionState::failed) messages_.warn(inLanguage(trouble()));
}

void Connection::adopt(std::unique_ptr<Drive> drive, const QString& uri) {
  letGo();
  uri_ = uri;
  opener_.keep();
  begin(std::move(drive));
}

void Connection::close() {
  letGo();
  opener_.close();
}

void Connection::begin(std::unique_ptr<Drive> drive) {
  loss_ = {};
  hasRun_ = false;
  if (run_.kind != RunKind::none) {
    run_ = {};
    emit runChanged();
  }
  identity_ = drive->identity();
  settings_ = drive->settings();
  ranges_ = drive->settingRanges();
  loop_ = std::make_unique<DriveLoop>(std::move(drive), options_);
  loop_->setPace(pace_);
  listenToLoop();
  heartbeat_.start(40ms);
  emit came();
  emit changed();
  emit settingsChanged();
  messages_.say(tr("Connected to %1").arg(QString::fromStdString(identity_.device)));
}

void Connection::listenToLoop() {
  // What an earlier connection still had on its way must not reach this one.
  const auto whileThisOne = [this, number = ++number_](auto take) {
    return [this, number, take](const auto&... arguments) {
      if (loop_ && number == number_) take(arguments...);
    };
  };
  DriveLoop* loop = loop_.get();
  const auto listen = [this, loop, &whileThisOne](auto signal, auto take) {
    connect(loop, signal, this, whileThisOne(take), Qt::QueuedConnection);
  };
  listen(&DriveLoop::batchArrived, [this](const SampleBatchPtr& batch) {
    powered_ = batch->samples.back().enabled;
    emit samplesCame(batch);
  });
  listen(&DriveLoop::linkChanged, [this](const LinkStatus& status) {
    link_ = status;
    emit linkChanged();
  });
  listen(&DriveLoop::runChanged, [this](const RunSnapshot& snapshot) { takeRun(snapshot); });
  listen(&DriveLoop::stopped, [this](DriveLoop::StopCause cause) { takeStop(cause); });
  listen(&DriveLoop::failed, [this](const Message& reason) { loseBoard(reason); });
}

/// What ran says how far it came and why it ended, until a board is there again.
void Connection::loseBoard(const Message& why) {
  const bool broken = hasRun_ && run_.kind != RunKind::none &&
                      (run_.running() || run_.status.failure == message("the connection was closed").english());
  RunSnapshot run = run_;
  loss_ = why;
  letGo();
  opener_.lost(why);
  if (!broken) return messages_.warn(inLanguage(why));
  run.status.state = Procedure::State::stopped;
  run.status.failure = why;
  run_ = run;
  messages_.warn(tr("%1. What ran had come to %2 %, and what it measured is kept")
                     .arg(inLanguage(why))
                     .arg(100.0 * run.status.progress, 0, 'f', 0));
  emit runChanged();
}

void Connection::letGo() {
  if (!loop_) return;
  heartbeat_.stop();
  loop_.reset();
  identity_ = {};
  link_ = {};
  run_ = {};
  lastStop_ = nullptr;
  powered_ = false;
  emit left();
  emit changed();
  emit runChanged();
}

QString Connection::stateWords() const {
  if (state() == ConnectionState::connecting) return tr("connecting");
  if (state() == ConnectionState::reconnecting) return tr("link lost, connecting again");
  if (!connected()) return tr("not connected");
  if (run_.running()) return inLanguage(run_.status.activity);
  if (powered_) return tr("powered");
  return lastStop_ == nullptr ? tr("idle, windings open") : tr(lastStop_);
}

QString Connection::obstacle() const {
  if (!connected()) return tr("No board is connected");
  if (run_.running() && run_.kind != RunKind::turning)
    return tr("Busy: %1. STOP ends it.").arg(inLanguage(run_.status.activity));
  return {};
}

void Connection::stop() {
  if (loop_) loop_->stop();
}

void Connection::start(Run run) {
  if (!loop_) return;
  lastStop_ = nullptr;
  hasRun_ = true;
  loop_->start(std::move(run));
}

void Connection::takeRun(const RunSnapshot& snapshot) {
  run_ = snapshot;
  const Procedure::State state = snapshot.status.state;
  const bool tripped = state == Procedure::State::stopped && snapshot.endedByBoard;
  if (tripped) lastStop_ = QT_TR_NOOP("stopped by the board");
  if (tripped || state == Procedure::State::failed) messages_.warn(inLanguage(snapshot.status.failure));
  emit runReported(snapshot);
  emit runChanged();
}

void Connection::takeStop(DriveLoop::StopCause cause) {
  if (cause == DriveLoop::StopCause::pressed) {
    lastStop_ = QT_TR_NOOP("stopped");
    messages_.say(tr("STOP: the motor is off"));
  } else if (cause == DriveLoop::StopCause::watchdog) {
    lastStop_ = QT_TR_NOOP("stopped by watchdog");
    messages_.warn(tr("The window did not answer for %1 ms, so the motor was stopped").arg(options_.watchdog_s * 1e3));
  } else if (cause == DriveLoop::StopCause::starved) {
    lastStop_ = QT_TR_NOOP("stopped by watchdog");
    messages_.warn(tr("The machine was too busy: for %1 ms the window got hardly any processor time, so the motor was "
                      "stopped; end what else runs, or wait for it")
                       .arg(options_.watchdog_s * 1e3));
  }
  emit runChanged();
}

void Connection::configure(const ControllerSettings& wanted) {
  onBoard([this, wanted](Drive& drive) {
    const auto accepted = drive.configure(wanted);
    QMetaObject::invokeMethod(
        this,
        [this, accepted] {
          if (!accepted) {
            messages_.warn(accepted.error());
          } else {
            settings_ = *accepted;
          }
          emit settingsChanged();
        },
        Qt::QueuedConnection);
  });
}

void Connection::takeSettings(const ControllerSettings& settings) {
  if (!loop_) return;
  settings_ = settings;
  emit settingsChanged();
}

SettingRange Connection::rangeOf(double ControllerSettings::*setting) const {
  if (!connected()) return {false};
  for (size_t k = 0; k < ranges_.size(); ++k) {
    if (profileParameters()[k].value == setting) return ranges_[k];
  }
  return {};
}

void Connection::onBoard(std::function<void(Drive&)> job) {
  if (loop_) loop_->post(std::move(job), false);
}

void Connection::startRecording(std::shared_ptr<Recorder> recorder) {
  if (loop_) loop_->startRecording(std::move(recorder));
}

void Connection::finishRecording() {
  if (loop_) loop_->finishRecording();
}

void Connection::setPace(double pace) {
  pace_ = pace;
  if (loop_) loop_->setPace(pace);
}

}  // namespace breakaway
