// The I/O thread: it alone touches the drive. Whatever the window does or fails to do, this thread keeps stopping
// power.
#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "base/message.h"
#include "base/thread_glance.h"
#include "experiment/drive.h"
#include "session/recorder.h"
#include "session/run.h"
#include "session/sample_batch.h"

namespace breakaway {

struct DriveLoopOptions {
  double pace = 1.0;         ///< board seconds per wall second for a simulated board; a real one keeps its own time
  double slice_s = 0.005;    ///< board time per turn of the loop; STOP waits for one turn at most
  double watchdog_s = 0.25;  ///< wall time without beat() after which a powered motor is stopped
};

/// What the loop knows of the link, copied to whoever asks by signal.
struct LinkStatus {
  bool enabled = false;         ///< windings powered in the last sample
  double rate_Hz = 0.0;         ///< samples per board second
  double realTimeFactor = 0.0;  ///< board seconds per wall second, over the last half second
  size_t lost = 0;              ///< samples lost since the connection
  double recorded_s = 0.0;      ///< length of the running recording; 0: none runs
};

class DriveLoop : public QObject {
  Q_OBJECT

 public:
  /// `starved`: the watchdog's, too, but the window was given no processor time in which it could have answered.
  enum class StopCause { none, pressed, watchdog, starved, closing };

  /// In the window's thread.
  DriveLoop(std::unique_ptr<Drive> drive, const DriveLoopOptions& options);
  /// Stops the motor, then ends the thread.
  ~DriveLoop() override;

  /// Asks for a stop; takes no lock and returns at once. It wins over every motion that was posted before it.
  void stop() noexcept { stops_.fetch_add(1); }
  /// The window is alive.
  void beat() noexcept { beat_.store(now()); }
  void setPace(double pace) noexcept { pace_.store(pace); }
  /// Runs `job` on the drive in the I/O thread; a job that `moves` is dropped when a stop comes before its turn.
  void post(std::function<void(Drive&)> job, bool moves);
  /// Starts a procedure or a job on the drive and reports its status and partial results until its end.
  void start(Run run);
  /// Gives every sample from now on to the recorder, until its end or that of the link.
  void startRecording(std::shared_ptr<Recorder> recorder);
  void finishRecording();

 signals:
  void batchArrived(const breakaway::SampleBatchPtr& batch);
  void linkChanged(const breakaway::LinkStatus& status);
  void runChanged(const breakaway::RunSnapshot& snapshot);
  void stopped(breakaway::DriveLoop::StopCause cause);
  void failed(const breakaway::Message& reason);

 private:
  using Clock = std::chrono::steady_clock;
  struct Job {
    std::function<void(Drive&)> work;
    bool moves = false;
    unsigned stopsBefore = 0;
  };

  static Clock::rep now() { return Clock::now().time_since_epoch().count(); }
  void work(const std::stop_token& ending);
  void obeyStops();
  void watchWindow();
  void runJobs();
  void halt(StopCause cause);
  void stopRun(const Saying& reason);
  bool advance();
  void publish();
  void sendBatch(Clock::time_point time);
  void sendStatus(Clock::time_point time);
  void sendRun(bool endedByBoard = false);
  void waitForTurn();

  std::unique_ptr<Drive> drive_;
  const DriveLoopOptions options_;
  std::atomic<unsigned> stops_{0};
  std::atomic<Clock::rep> beat_{now()};
  std::atomic<double> pace_;
  std::mutex jobsLock_;
  std::vector<Job> jobs_;

  const WatchedThread window_;

  // Touched by the I/O thread alone.
  Clock::rep seenBeat_ = 0;
  std::optional<double> ranAtBeat_s_;  ///< the window's thread, when that beat came
  unsigned obeyedStops_ = 0;
  Run run_;
  std::shared_ptr<Recorder> recorder_;
  std::vector<Sample> slice_;
  std::shared_ptr<SampleBatch> pending_;
  std::weak_ptr<const SampleBatch> sent_;
  LinkStatus link_;
  Clock::time_point lastBatch_, lastStatus_, lastRun_, nextTurn_;
  double sinceStatus_s_ = 0.0;

  std::jthread thread_;  // last: it starts when all else stands
};

}  // namespace breakaway

Q_DECLARE_METATYPE(breakaway::LinkStatus)
