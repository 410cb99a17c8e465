// What comes back to a session from the I/O thread, and what it keeps of it.
#include "recording/sample_recording.h"
#include "session.h"

namespace breakaway {

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
  const bool finished = snapshot.status.state == Procedure::State::finished;
  if (const auto* identified = std::get_if<IdentificationResult>(&snapshot.result)) {
    if (identified->found) survey_.identification = identified->found;
  } else if (const auto* sweep = std::get_if<VelocitySweepResult>(&snapshot.result)) {
    survey_.identification = sweep->identification;
    survey_.runs = sweep->runs;
  } else if (const auto* homing = std::get_if<HomingResult>(&snapshot.result); homing && homing->travel) {
    if (homing->identification) survey_.identification = homing->identification;
    if (finished && !survey_.layOver(moved(*homing->travel, -homing->index_rad.value)))
      emit said(tr("The ends lie elsewhere than before: what was measured over the travel is forgotten"), true);
  } else if (const auto* strokes = std::get_if<StrokesResult>(&snapshot.result)) {
    survey_.strokes = strokes->strokes;
    survey_.strokeBins = strokes->bins;
    survey_.strokesZeroError_A = strokes->zeroError_A;
  } else if (const auto* breakaways = std::get_if<BreakawayResult>(&snapshot.result)) {
    survey_.identification = breakaways->identification;
    survey_.events = breakaways->events;
    survey_.bins = breakaways->bins;
    survey_.turns = breakaways->turns;
    survey_.missed = breakaways->missed;
    survey_.eventsZeroError_A = breakaways->zeroError_A;
    survey_.settings = breakaways->settings;
    survey_.sweepComplete = finished;
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
          const bool lacks = survey_.sweepComplete ? !survey_.map : !survey_.strokes.empty() && !survey_.moving;
          if (lacks && !survey_.mapObstacle.empty())
            emit said(tr("There is no map: %1").arg(QString::fromStdString(survey_.mapObstacle)), true);
        },
        Qt::QueuedConnection);
  });
}

void Session::forgetSurvey() {
  if (!surveyedDevice_.empty())
    emit said(
        tr("This is another board: what was measured on %1 is forgotten").arg(QString::fromStdString(surveyedDevice_)),
        false);
  ++surveyNumber_;  // an estimate that is under way is of the other board
  survey_ = {};
  surveyedDevice_.clear();
  emit surveyChanged();
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
  auto recording = sealSamples("live recording", *samples,
                               {{"device", identity_.device}, {"firmware", identity_.firmware}}, identity_.axis);
  if (recording) {
    lastRecording_ = *recording;
    emit said(tr("Recorded %1 samples").arg(samples->size()), false);
  } else {
    emit said(QString::fromStdString(recording.error().message()), true);
  }
  emit recordingChanged();
}

}  // namespace breakaway
