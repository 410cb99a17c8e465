#include "session/experiment_run.h"

#include <cmath>

namespace breakaway {

ExperimentRun::ExperimentRun(Connection& connection, BenchRuns& bench, LiveSamples& live, Comparison& comparison,
                             Messages& messages, QObject* parent)
    : QObject(parent),
      connection_(connection),
      bench_(bench),
      live_(live),
      comparison_(comparison),
      messages_(messages) {
  connect(&live_, &LiveSamples::recordingChanged, this, &ExperimentRun::follow);
  connect(&connection_, &Connection::runReported, this, &ExperimentRun::takeRun);
  for (const auto changes : {&Connection::changed, &Connection::runChanged})
    connect(&connection_, changes, this, &ExperimentRun::changed);
  connect(&comparison_, &Comparison::diagnosisChanged, this, &ExperimentRun::changed);
  connect(&bench_, &BenchRuns::knownChanged, this, &ExperimentRun::changed);
}

QString ExperimentRun::plan() const {
  const auto& diagnosis = comparison_.diagnosis();
  if (!diagnosis || diagnosis->nextManeuver.empty()) return {};
  return tr("Moves the axis for %1 s within the board's limits, records it, and opens the recording here.")
      .arg(std::ceil(durationOf(diagnosis->nextManeuver)), 0, 'f', 0);
}

QString ExperimentRun::obstacle() const {
  const auto& diagnosis = comparison_.diagnosis();
  if (!diagnosis) return tr("Diagnose first: the experiment comes with the answer");
  if (diagnosis->nextSentence.empty()) return tr("No experiment is called for");
  if (diagnosis->nextManeuver.empty()) return tr("This experiment takes hands: a board alone can't make it");
  if (!connection_.connected()) return tr("Connect the board of this rig first");
  if (connection_.identity().axis != diagnosis->base.axis) return tr("The board has another kind of axis");
  if (live_.recording()) return tr("A recording is running");
  return bench_.turningObstacle();
}

void ExperimentRun::start() {
  if (!obstacle().isEmpty()) return;
  motion_ = comparison_.diagnosis()->nextManeuver;
  before_ = live_.lastRecording();
  whole_ = false;
  stage_ = Stage::recording;
  live_.startRecording();
}

/// The recording begins a little before the motion, and ends behind it.
void ExperimentRun::follow() {
  if (stage_ == Stage::recording && live_.filing()) {
    stage_ = Stage::moving;
    bench_.runManeuver(motion_);
  } else if (stage_ == Stage::sealing && !live_.recording() && live_.lastRecording() != before_) {
    stage_ = Stage::none;
    if (whole_) {
      const auto& own = bench_.known();
      if (own.knows(Known::motor)) {
        comparison_.takeBench(own.bench);
      } else if (bench_.bench()) {
        comparison_.takeBench(*bench_.bench());
      }
      comparison_.openRecording(live_.lastRecording());
      messages_.say(tr("The experiment is recorded and open: Diagnose says what it shows"));
    }
  }
  // No file could be opened, or the link was lost.
  if (!live_.recording() && (stage_ == Stage::recording || stage_ == Stage::moving)) stage_ = Stage::none;
  emit changed();
}

void ExperimentRun::takeRun(const RunSnapshot& snapshot) {
  if (stage_ != Stage::moving || snapshot.kind != RunKind::experiment || snapshot.running()) return;
  whole_ = snapshot.status.state == Procedure::State::finished;
  stage_ = Stage::sealing;
  live_.finishRecording();
}

}  // namespace breakaway
