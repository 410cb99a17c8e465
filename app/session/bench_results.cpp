// What comes of the runs, and what the bench keeps of it.
#include "firmware_link/presets.h"
#include "session/bench_runs.h"

namespace breakaway {

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

void BenchRuns::meetBoard() {
  ++board_;
  const Identity& identity = connection_.identity();
  bench_ = benchBeside(connection_.uri());
  if (surveyedDevice_ != identity.device) forgetSurvey();
  survey_.axis = identity.axis;
  survey_.board = identity;
  survey_.rig = bench_ ? bench_->name : identity.device;
  if (bench_ && bench_->dutyCurve.known()) lineariseBoard();
}

void BenchRuns::lineariseBoard() {
  // An error comes to the messages, which live longer than this.
  connection_.onBoard([messages = &messages_, curve = bench_->dutyCurve](Drive& drive) {
    const auto taken = drive.linearise(curve);
    if (taken) return;
    QMetaObject::invokeMethod(
        messages, [messages, error = taken.error()] { messages->warn(error); }, Qt::QueuedConnection);
  });
}

void BenchRuns::leaveBoard() {
  index_rad_.reset();
  forgetSteps();
}

void BenchRuns::forgetSteps() {
  steps_.clear();
  emit measured();
}

void BenchRuns::keepResult(const RunSnapshot& snapshot) {
  keepSurvey(snapshot);
  if (snapshot.status.state != Procedure::State::finished) return;
  if (const auto* homing = std::get_if<HomingResult>(&snapshot.result)) {
    index_rad_ = homing->index_rad;
  } else if (const auto* step = std::get_if<StepResult>(&snapshot.result)) {
    steps_.push_back(*step);
  }
  emit measured();
}

void BenchRuns::keepSurvey(const RunSnapshot& snapshot) {
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
      messages_.warn(tr("The ends lie elsewhere than before: what was measured over the travel is forgotten"));
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
  surveyedDevice_ = connection_.identity().device;
  emit surveyChanged();
  if (ended) estimateSurvey();
}

void BenchRuns::estimateSurvey() {
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
            messages_.warn(tr("There is no map: %1").arg(QString::fromStdString(survey_.mapObstacle)));
        },
        Qt::QueuedConnection);
  });
}

void BenchRuns::forgetSurvey() {
  if (!surveyedDevice_.empty())
    messages_.say(
        tr("This is another board: what was measured on %1 is forgotten").arg(QString::fromStdString(surveyedDevice_)));
  ++surveyNumber_;  // an estimate that is under way is of the other board
  survey_ = {};
  surveyedDevice_.clear();
  emit surveyChanged();
}

}  // namespace breakaway
