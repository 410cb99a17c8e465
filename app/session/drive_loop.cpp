#include "session/drive_loop.h"

#include <algorithm>

namespace breakaway {

namespace {

using namespace std::chrono_literals;

constexpr auto batchEvery = 10ms;
constexpr auto runEvery = 40ms;
constexpr auto statusEvery = 500ms;
constexpr size_t pendingLimit = 200'000;  ///< samples kept for a window that doesn't fetch them; then the oldest go

Message wordsOf(DriveLoop::StopCause cause) {
  switch (cause) {
    case DriveLoop::StopCause::pressed:
      return message("STOP was pressed");
    case DriveLoop::StopCause::watchdog:
      return message("the window did not answer");
    case DriveLoop::StopCause::starved:
      return message("the machine was too busy for the window to answer");
    case DriveLoop::StopCause::closing:
      return message("the connection was closed");
    case DriveLoop::StopCause::none:
      break;
  }
  return {};
}

double seconds(std::chrono::steady_clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

}  // namespace

DriveLoop::DriveLoop(std::unique_ptr<Drive> drive, const DriveLoopOptions& options)
    : drive_(std::move(drive)), options_(options), pace_(options.pace), pending_(std::make_shared<SampleBatch>()) {
  qRegisterMetaType<SampleBatchPtr>();
  qRegisterMetaType<LinkStatus>();
  qRegisterMetaType<RunSnapshot>();
  qRegisterMetaType<DriveLoop::StopCause>();
  qRegisterMetaType<Message>();
  link_.rate_Hz = drive_->identity().loopRate_Hz;
  nextTurn_ = lastBatch_ = lastStatus_ = lastRun_ = Clock::now();
  thread_ = std::jthread([this](const std::stop_token& ending) { work(ending); });
}

DriveLoop::~DriveLoop() {
  thread_.request_stop();
  thread_.join();
}

void DriveLoop::post(std::function<void(Drive&)> job, bool moves) {
  const std::lock_guard lock(jobsLock_);
  jobs_.push_back({std::move(job), moves, stops_.load()});
}

void DriveLoop::start(Run run) {
  post(
      [this, run = std::move(run)](Drive& drive) {
        if (run_.something() && run_.status().state == Procedure::State::running) {
          const Message why = message("another procedure was started");
          run_.job ? stopRun(why) : run_.procedure->stop(why);
          sendRun();
        }
        run_ = run;
        run_.job ? run_.job->begin(drive) : drive.start(run_.procedure);
        sendRun();
      },
      true);
}

void DriveLoop::startRecording(std::shared_ptr<Recorder> recorder) {
  post([this, recorder = std::move(recorder)](Drive&) { recorder_ = recorder; }, false);
}

void DriveLoop::finishRecording() {
  post(
      [this](Drive&) {
        if (recorder_) recorder_->finish();
        recorder_.reset();
        link_.recorded_s = 0.0;
      },
      false);
}

void DriveLoop::work(const std::stop_token& ending) {
  while (!ending.stop_requested()) {
    obeyStops();
    runJobs();
    if (!advance()) return;
    publish();
    waitForTurn();
  }
  halt(StopCause::closing);
}

void DriveLoop::obeyStops() {
  const unsigned wanted = stops_.load();
  if (wanted != obeyedStops_) {
    obeyedStops_ = wanted;
    halt(StopCause::pressed);
  } else if (link_.enabled) {
    watchWindow();
  }
}

/// A window that wants to go on, and had a processor for less than half of the time, doesn't hang: the machine is too
/// busy. The motor is stopped all the same, for nobody could press STOP.
void DriveLoop::watchWindow() {
  const Clock::rep beat = beat_.load();
  const double silent_s = seconds(Clock::duration(now() - beat));
  if (beat != seenBeat_) {
    seenBeat_ = beat;
    ranAtBeat_s_ = window_.ran_s();
  }
  if (silent_s <= options_.watchdog_s) return;
  const auto ran_s = window_.ran_s();
  const bool starved =
      ranAtBeat_s_ && ran_s && window_.ready().value_or(false) && *ran_s - *ranAtBeat_s_ < 0.5 * silent_s;
  halt(starved ? StopCause::starved : StopCause::watchdog);
}

void DriveLoop::runJobs() {
  std::vector<Job> jobs;
  {
    const std::lock_guard lock(jobsLock_);
    jobs.swap(jobs_);
  }
  for (const Job& job : jobs) {
    obeyStops();
    const bool overtaken = job.moves && job.stopsBefore != obeyedStops_;
    if (!overtaken) job.work(*drive_);
  }
}

void DriveLoop::halt(StopCause cause) {
  stopRun(wordsOf(cause));
  link_.enabled = false;
  if (run_.something()) sendRun();
  emit stopped(cause);
}

/// The motor first, whatever there is to end.
void DriveLoop::stopRun(const Saying& reason) {
  drive_->stop(reason);
  if (run_.job) run_.job->stop(*drive_, reason);
}

bool DriveLoop::advance() {
  slice_.clear();
  const auto lost = drive_->advance(options_.slice_s, slice_);
  if (!lost) {
    halt(StopCause::closing);
    emit failed(lost.error().said());
    return false;
  }
  if (recorder_) recorder_->append(slice_, *lost);
  pending_->samples.insert(pending_->samples.end(), slice_.begin(), slice_.end());
  pending_->lost += *lost;
  link_.lost += *lost;
  sinceStatus_s_ += options_.slice_s;
  if (!slice_.empty()) link_.enabled = slice_.back().enabled;
  if (run_.job) run_.job->take(*drive_, options_.slice_s, slice_, *lost);
  return true;
}

void DriveLoop::publish() {
  const auto time = Clock::now();
  if (time - lastBatch_ >= batchEvery) sendBatch(time);
  if (time - lastStatus_ >= statusEvery) sendStatus(time);
  if (!run_.something()) return;
  const bool ended = run_.status().state != Procedure::State::running;
  if (ended || time - lastRun_ >= runEvery) sendRun(ended);
}

void DriveLoop::sendBatch(Clock::time_point time) {
  lastBatch_ = time;
  auto& samples = pending_->samples;
  if (!sent_.expired()) {  // the window still has the last one on its way: keep collecting, within limits
    if (samples.size() > pendingLimit) samples.erase(samples.begin(), samples.end() - pendingLimit / 2);
    return;
  }
  if (samples.empty()) return;
  const SampleBatchPtr batch = std::exchange(pending_, std::make_shared<SampleBatch>());
  sent_ = batch;
  emit batchArrived(batch);
}

void DriveLoop::sendStatus(Clock::time_point time) {
  link_.realTimeFactor = sinceStatus_s_ / seconds(time - lastStatus_);
  link_.recorded_s = recorder_ ? static_cast<double>(recorder_->taken()) / std::max(1.0, link_.rate_Hz) : 0.0;
  lastStatus_ = time;
  sinceStatus_s_ = 0.0;
  emit linkChanged(link_);
}

void DriveLoop::sendRun(bool endedByBoard) {
  lastRun_ = Clock::now();
  RunSnapshot snapshot{run_.kind, run_.status(), run_.read ? run_.read() : RunResult{}, endedByBoard};
  const bool ended = snapshot.status.state != Procedure::State::running;
  emit runChanged(snapshot);
  if (ended) run_ = {};
}

void DriveLoop::waitForTurn() {
  if (!drive_->identity().simulated) return;  // a real board waits in advance()
  nextTurn_ +=
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options_.slice_s / pace_.load()));
  const auto time = Clock::now();
  if (nextTurn_ < time - 100ms) nextTurn_ = time;  // can't keep up: slower than asked, never in bursts
  std::this_thread::sleep_until(nextTurn_);
}

}  // namespace breakaway
