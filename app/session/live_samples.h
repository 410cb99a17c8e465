// The samples as they come: the last minute of them, and recordings of every one.
#pragma once

#include <QObject>
#include <optional>

#include "base/result.h"
#include "recording/recording.h"
#include "session/connection.h"
#include "session/live_history.h"
#include "session/messages.h"

namespace breakaway {

class LiveSamples : public QObject {
  Q_OBJECT

 public:
  LiveSamples(Connection& connection, Messages& messages, QObject* parent = nullptr);

  /// Called for each batch that comes over the connection.
  void take(const SampleBatch& batch) { history_.append(batch.samples); }
  const LiveHistory& history() const { return history_; }
  /// Every sample with from ≤ time ≤ to. Errors: sealSamples()'s.
  Result<Recording> stretch(double from_s, double to_s) const;

  /// A recording of everything at the full rate. Does nothing without a board.
  void startRecording();
  void finishRecording();
  bool recording() const { return recording_; }
  const std::optional<Recording>& lastRecording() const { return lastRecording_; }

 signals:
  void recordingChanged();

 private:
  Result<Recording> sealed(const char* name, const std::vector<Sample>& samples) const;
  void takeRecorded(const std::vector<Sample>& samples);
  void forget();

  Connection& connection_;
  Messages& messages_;
  LiveHistory history_;
  bool recording_ = false;
  std::optional<Recording> lastRecording_;
};

}  // namespace breakaway
