#include "session/live_samples.h"

#include "base/made.h"
#include "recording/sample_recording.h"
#include "session/language.h"
#include "session/run_title.h"

namespace breakaway {

namespace {

constexpr double leastGap_s = 0.2;  // so that it can be seen

bool isSameBoard(const Identity& one, const Identity& other) {
  return mayBeSame(one, other) && one.firmware == other.firmware && one.axis == other.axis &&
         one.simulated == other.simulated;
}

}  // namespace

LiveSamples::LiveSamples(Connection& connection, BenchProject& project, Messages& messages, QObject* parent)
    : QObject(parent), connection_(connection), project_(project), messages_(messages) {
  connect(&connection_, &Connection::samplesCame, this, [this](const SampleBatchPtr& batch) { take(*batch); });
  connect(&connection_, &Connection::came, this, &LiveSamples::meetBoard);
  connect(&connection_, &Connection::left, this, &LiveSamples::leaveBoard);
}

LiveSamples::~LiveSamples() {
  if (!recorder_) return;
  recorder_->finish(message("the window was closed"));
  recorder_->wait();
  endInProject(run_, recorder_->end());
}

void LiveSamples::take(const SampleBatch& batch) {
  if (batch.samples.empty()) return;
  flowing_ = true;
  if (comesBack_) {
    const double begins_s = batch.samples.front().time_s;
    const double gap_s = std::max(leastGap_s, 1e-3 * static_cast<double>(sinceLoss_.elapsed()));
    if (begins_s + ahead_s_ <= *lost_s_) ahead_s_ = *lost_s_ + gap_s - begins_s;
    comesBack_ = false;
  }
  if (ahead_s_ == 0.0) return history_.append(batch.samples);
  std::vector<Sample> samples = batch.samples;
  for (Sample& sample : samples) sample.time_s += ahead_s_;
  history_.append(samples);
}

std::optional<Sample> LiveSamples::current() const {
  return connection_.connected() && flowing_ ? history_.newest() : std::nullopt;
}

Result<Recording> LiveSamples::sealed(const char* name, const std::vector<Sample>& samples) const {
  return sealSamples(name, samples, notesOf(board_), board_.axis);
}

Result<Recording> LiveSamples::stretch(const LiveHistory& view, double from_s, double to_s) const {
  return sealed("visible stretch", view.between(from_s, to_s));
}

void LiveSamples::startRecording() {
  if (!connection_.connected() || recording_) return;
  recording_ = true;
  endWanted_ = false;
  ProjectRun run;
  run.device = board_.device;
  run.deviceSerial = board_.serialNumber;
  run.firmware = board_.firmware;
  run.by = thisRun().by;
  const BlockHead head{sampleColumns(board_.axis), notesOf(board_)};
  project_.inProject([this, run, head](Project* project) -> std::function<void()> {
    const auto blocks = std::make_shared<std::optional<BlockWriter>>();
    const auto begun = project != nullptr
                           ? project->beginRecording(run, head, *blocks)
                           : Result<ProjectRun>(Error{"recording", message("there is no project to keep it in")});
    return [this, begun, blocks] { begin(begun, *blocks ? &**blocks : nullptr); };
  });
  emit recordingChanged();
}

void LiveSamples::begin(const Result<ProjectRun>& run, BlockWriter* blocks) {
  if (!run) {
    recording_ = false;
    messages_.warn(run.error());
    emit recordingChanged();
    return;
  }
  run_ = *run;
  emit project_.changed();
  recorder_ = std::make_shared<Recorder>(
      std::move(*blocks), Recorder::Listener{[this](const RecordingEnd& end) {
                                               QMetaObject::invokeMethod(
                                                   this, [this, end] { takeEnd(end); }, Qt::QueuedConnection);
                                             },
                                             [this](const Message& warning) {
                                               QMetaObject::invokeMethod(
                                                   this, [this, warning] { messages_.warn(inLanguage(warning)); },
                                                   Qt::QueuedConnection);
                                             }});
  if (endWanted_ || !connection_.connected())
    return recorder_->finish(endWanted_ ? Message() : message("the link was lost"));
  connection_.startRecording(recorder_);
  emit recordingChanged();
}

void LiveSamples::finishRecording() {
  if (!recording_) return;
  endWanted_ = true;
  if (recorder_) connection_.finishRecording();
}

void LiveSamples::takeEnd(const RecordingEnd& end) {
  recording_ = false;
  last_ = QString::fromStdString(end.path);
  recorder_.reset();
  connection_.finishRecording();
  endInProject(run_, end);
  const QString what = tr("Recorded %1 samples").arg(end.rows);
  if (end.why.empty()) {
    messages_.say(what);
  } else {
    messages_.say(tr("Kept in the project: %1").arg(titleOf(run_)));
    messages_.warn(tr("%1, then %2; what was recorded is kept").arg(what, inLanguage(Message(end.why))));
  }
  emit recordingChanged();
}

void LiveSamples::endInProject(const ProjectRun& run, const RecordingEnd& end) {
  project_.inProject([messages = &messages_, project = &project_, run, end](Project* open) -> std::function<void()> {
    if (open == nullptr) return {};
    const auto ended = open->endRecording(run, end.why);
    return [messages, project, ended] {
      if (!ended) messages->warn(ended.error());
      emit project->changed();
    };
  });
}

void LiveSamples::saveLast(const QString& csv) {
  if (last_.isEmpty()) return;
  project_.inProject([messages = &messages_, from = last_.toStdString(), csv](Project*) -> std::function<void()> {
    const auto written = writeBlocksAsCsv(from, csv.toStdString());
    return [messages, written, csv] { messages->say(written, tr("The recording is written to %1").arg(csv)); };
  });
}

void LiveSamples::meetBoard() {
  const Identity before = board_;
  board_ = connection_.identity();
  flowing_ = false;
  comesBack_ = lost_s_.has_value() && history_.newest() && isSameBoard(before, board_);
  if (comesBack_) return;
  history_.clear();
  lost_s_.reset();
  ahead_s_ = 0.0;
}

void LiveSamples::leaveBoard() {
  const auto newest = history_.newest();
  flowing_ = false;
  lost_s_.reset();
  if (!connection_.loss().empty() && newest) {
    lost_s_ = newest->time_s;
    sinceLoss_.start();
  }
  if (recorder_)
    recorder_->finish(connection_.loss().empty() ? message("the board was let go") : message("the link was lost"));
}

}  // namespace breakaway
