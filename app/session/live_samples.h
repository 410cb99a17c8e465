// The samples as they come: the last minute of them, which stays when the link goes, and recordings of every one, which
// go to the project's disk while they run.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <memory>
#include <optional>

#include "base/result.h"
#include "recording/recording.h"
#include "session/bench_project.h"
#include "session/connection.h"
#include "session/live_history.h"
#include "session/messages.h"
#include "session/recorder.h"

namespace breakaway {

class LiveSamples : public QObject {
  Q_OBJECT

 public:
  LiveSamples(Connection& connection, BenchProject& project, Messages& messages, QObject* parent = nullptr);
  /// Ends a recording that runs, and leaves it in the project.
  ~LiveSamples() override;

  /// Called for each batch that comes over the connection.
  void take(const SampleBatch& batch);
  const LiveHistory& history() const { return history_; }
  /// The newest one of the board that is there now; nothing while none is, or before its first one.
  std::optional<Sample> current() const;
  /// The board that the history is of, which may be gone.
  const Identity& board() const { return board_; }
  /// When its link was lost last, by the history's clock. When the same board is there again, the history goes on, and
  /// leaves out the time between.
  std::optional<double> lost_s() const { return lost_s_; }
  /// Every sample of `view`, the history or a copy of it, with from ≤ time ≤ to. Errors: sealSamples()'s.
  Result<Recording> stretch(const LiveHistory& view, double from_s, double to_s) const;

  /// A recording of everything at the full rate. Does nothing without a board.
  void startRecording();
  void finishRecording();
  bool recording() const { return recording_; }
  /// Every sample from now on goes into the file; recording() holds from before it was opened.
  bool filing() const { return recording_ && recorder_ != nullptr; }
  /// The file of the newest recording that has ended; empty before.
  const QString& lastRecording() const { return last_; }
  /// Writes it as CSV, in the project's thread.
  void saveLast(const QString& csv);

 signals:
  void recordingChanged();

 private:
  Result<Recording> sealed(const char* name, const std::vector<Sample>& samples) const;
  void begin(const Result<ProjectRun>& run, BlockWriter* blocks);
  void takeEnd(const RecordingEnd& end);
  void endInProject(const ProjectRun& run, const RecordingEnd& end);
  void meetBoard();
  void leaveBoard();

  Connection& connection_;
  BenchProject& project_;
  Messages& messages_;
  LiveHistory history_;
  Identity board_;
  std::optional<double> lost_s_;
  QElapsedTimer sinceLoss_;
  double ahead_s_ = 0.0;    ///< of the board's clock, the history's: a board that was without power counts anew
  bool comesBack_ = false;  ///< no sample has come since the link was lost
  bool flowing_ = false;    ///< samples have come since the board is there
  bool recording_ = false, endWanted_ = false;
  std::shared_ptr<Recorder> recorder_;
  ProjectRun run_;  ///< that the recorder fills
  QString last_;
};

}  // namespace breakaway
