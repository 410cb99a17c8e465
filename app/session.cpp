#include "session.h"

#include <chrono>

#include "firmware_link/presets.h"

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
  // A linear axis stays where it is until its ends are known.
  if (connected() && identity_.simulated && !linear()) turnSlowly();
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
  if (surveyedDevice_ != identity_.device) forgetSurvey();
  survey_.axis = identity_.axis;
  survey_.board = identity_;
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

QString Session::tuningObstacle() const {
  if (QString never = gainsObstacle(); !never.isEmpty()) return never;
  return tuning_ ? tr("Tuning") : QString();
}

QString Session::marginLine() const {
  return connected() ? marginWords(boardLoop(identity_, settings_, motor())) : QString();
}

}  // namespace breakaway
