#include "session/live_samples.h"

#include "recording/sample_recording.h"

namespace breakaway {

LiveSamples::LiveSamples(Connection& connection, Messages& messages, QObject* parent)
    : QObject(parent), connection_(connection), messages_(messages) {
  connect(&connection_, &Connection::samplesCame, this, [this](const SampleBatchPtr& batch) { take(*batch); });
  connect(&connection_, &Connection::recorded, this, [this](const auto& samples) { takeRecorded(*samples); });
  connect(&connection_, &Connection::left, this, &LiveSamples::forget);
}

Result<Recording> LiveSamples::sealed(const char* name, const std::vector<Sample>& samples) const {
  const Identity& board = connection_.identity();
  return sealSamples(name, samples, {{"device", board.device}, {"firmware", board.firmware}}, board.axis);
}

Result<Recording> LiveSamples::stretch(double from_s, double to_s) const {
  return sealed("visible stretch", history_.between(from_s, to_s));
}

void LiveSamples::startRecording() {
  if (!connection_.connected() || recording_) return;
  recording_ = true;
  connection_.startRecording();
  emit recordingChanged();
}

void LiveSamples::finishRecording() {
  if (recording_) connection_.finishRecording();
}

void LiveSamples::takeRecorded(const std::vector<Sample>& samples) {
  recording_ = false;
  auto recording = sealed("live recording", samples);
  if (recording) {
    lastRecording_ = *recording;
    messages_.say(tr("Recorded %1 samples").arg(samples.size()));
  } else {
    messages_.warn(recording.error());
  }
  emit recordingChanged();
}

void LiveSamples::forget() {
  history_.clear();
  recording_ = false;
  emit recordingChanged();
}

}  // namespace breakaway
