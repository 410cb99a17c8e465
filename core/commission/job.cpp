#include "commission/job.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/made.h"
#include "commission/held_beliefs.h"
#include "commission/measured_bench.h"

namespace breakaway {

namespace {

constexpr double wholeSlice_s = 0.25;  // of the board's time, after which the job looks
constexpr double tellEvery_s = 0.5;
constexpr double rounding_s = 1e-9;

}  // namespace

Job::Job(CommissionOptions options, const Facts& wanted, Commission known)
    : options_(std::move(options)), wanted_(wanted), known_(std::move(known)) {
}

void Job::begin(Drive& drive) {
  if (const auto prepared = prepare(drive); !prepared) {
    end(drive, Procedure::State::failed, prepared.error());
    return;
  }
  steps_ = plan(known_.identity, known_.facts, wanted_);
  for (const StepPtr& step : steps_) {
    if (!step->leaves().has(Known::index) || known_.linear() || known_.identity.hasIndex) continue;
    end(drive, Procedure::State::failed, {"board", "has an encoder without index, which homing needs"});
    return;
  }
  next(drive);
}

Result<void> Job::prepare(Drive& drive) {
  const Identity identity = drive.identity();
  if (!(identity.countsPerRev > 0.0)) return Error{"board", message("has no encoder, which everything here rests on")};
  if (options_.against && options_.against->addedInertia_kg_m2.value == options_.addedInertia_kg_m2.value)
    return Error{identity.axis == Axis::linear ? "added mass" : "added inertia",
                 message("is the same as in the motor's file that it is held against, expected another one")};
  Commission asked;
  asked.identity = identity;
  asked.sweeps = options_.sweeps;
  asked.trustedTorqueConstant_Nm_per_A = trustedConstant(options_);
  asked.addedInertia_kg_m2 = options_.addedInertia_kg_m2;
  if (options_.earlier) {
    known_ = *options_.earlier;
    known_.forgetBoard();
    if (auto fits = goOn(asked); !fits) return fits;
    ++known_.part;
    known_.remark(message("The job was interrupted and went on: part {} began after {} runs and {} breakaways.",
                          known_.part, known_.runs.size() + known_.strokes.size(), known_.breakaways.size()));
  } else if (auto fits = goOn(asked); !fits) {
    return fits;
  }
  known_.identity = identity;
  known_.sweeps = asked.sweeps;
  known_.trustedTorqueConstant_Nm_per_A = asked.trustedTorqueConstant_Nm_per_A;
  known_.addedInertia_kg_m2 = asked.addedInertia_kg_m2;
  if (auto held = holdDeclarations(options_, known_); !held) return held;
  // Somebody else may have set the board since.
  if (drive.settings() != known_.settings) known_.facts.remove({Known::carefulGains, Known::gainsInUse});
  known_.settings = drive.settings();
  found_ = known_.settings;
  if (!known_.knows(Known::straight))
    static_cast<void>(drive.linearise({}));  // an earlier job's curve; a board that takes none has none
  return {};
}

/// Whether what is known belongs to what is asked now; where it may be measured anew, the rest is forgotten.
Result<void> Job::goOn(const Commission& asked) {
  if (known_.identity.device.empty()) return {};
  if (options_.measuresAnew) {
    if (!mayBeSame(known_.identity, asked.identity)) known_ = {};
    if (known_.trustedTorqueConstant_Nm_per_A != asked.trustedTorqueConstant_Nm_per_A ||
        known_.addedInertia_kg_m2.value != asked.addedInertia_kg_m2.value)
      known_.forget({Known::windingTest});
    known_.forgetOtherThan(asked.sweeps);
    return {};
  }
  const SweepSettings &before = known_.sweeps, &now = asked.sweeps;
  if (!mayBeSame(known_.identity, asked.identity))
    return Error{"board", message("is {}, but the interrupted job was begun on {}", boardName(asked.identity),
                                  boardName(known_.identity))};
  if (before.bins != now.bins || before.turns != now.turns)
    return Error{"bins and turns", message("are {} and {}, but the interrupted job was begun with {} and {}", now.bins,
                                           now.turns, before.bins, before.turns)};
  if (!before.sameSpeeds(now))
    return Error{"seconds at each speed",
                 message("are others than the interrupted job was begun with, expected the same")};
  if (known_.trustedTorqueConstant_Nm_per_A != asked.trustedTorqueConstant_Nm_per_A)
    return Error{
        "bench",
        message(
            "trusts another torque constant than the interrupted job was begun with, expected the same bench file")};
  if (known_.addedInertia_kg_m2.value != asked.addedInertia_kg_m2.value)
    return Error{"added inertia",
                 message("is another one than the interrupted job was begun with, expected the same disc")};
  return {};
}

size_t Job::decimation(double expected_s) const {
  if (expected_s <= options_.shortStep_s) return 1;
  const double rate = known_.identity.loopRate_Hz;
  const double byRows = expected_s * rate / static_cast<double>(std::max<size_t>(1, options_.mostRows));
  return static_cast<size_t>(std::max({1.0, std::round(rate / options_.recordingRate_Hz), std::round(byRows)}));
}

/// Begins steps until one moves something, or all are made.
void Job::next(Drive& drive) {
  while (running() && !cause_ && at_ < steps_.size()) {
    if (start(drive)) return;
    if (running()) concludeRun(drive);
  }
  if (running() && !cause_) end(drive, Procedure::State::finished, {});
}

/// Whether a procedure runs now. One that has nothing left to do isn't started.
bool Job::start(Drive& drive) {
  OnBench on{drive, options_, known_};
  auto run = steps_[at_]->begin(on);
  if (!run) {
    end(drive, Procedure::State::failed, run.error());
    return false;
  }
  run_ = std::move(*run);
  if (!run_.procedure) return false;
  record();
  if (run_.procedure->state() != Procedure::State::running) return false;
  drive.start(run_.procedure);
  return true;
}

void Job::record() {
  recorder_.emplace(run_.name, decimation(run_.procedure->status().remaining_s), known_.identity.axis);
  lost_ = 0;
  slice_s_ = told_s_ = 0.0;
}

void Job::take(Drive& drive, double passed_s, const std::vector<Sample>& samples, size_t lost) {
  if (!running() || !run_.procedure) return;
  if (options_.keepRecordings) recorder_->append(samples);
  lost_ += lost;
  slice_s_ += passed_s;
  if (slice_s_ < wholeSlice_s - rounding_s) return;
  slice_s_ = 0.0;
  known_.rigTime_s += wholeSlice_s;
  noteRigTime(known_.rigTime_s);
  if (options_.progress && (told_s_ += wholeSlice_s) >= tellEvery_s) {
    told_s_ = 0.0;
    const auto now = status();
    options_.progress(now.progress, now.activity);
  }
  if (const auto kept = keepNow(); !kept) return end(drive, Procedure::State::failed, kept.error());
  if (run_.procedure->state() == Procedure::State::running) return;
  if (cause_) return concludeCause(drive);
  concludeRun(drive);
  next(drive);
}

void Job::stop(Drive& drive, const Saying& reason) {
  if (!running()) return;
  if (!run_.procedure) {
    end(drive, Procedure::State::stopped, {"job", reason});
    return;
  }
  run_.procedure->stop(reason);
  if (cause_) return concludeCause(drive);
  concludeRun(drive);
  if (running()) end(drive, Procedure::State::stopped, {run_.name, reason});
}

/// What has ended is kept; then the step makes of it what it can, unless the job was stopped.
void Job::concludeRun(Drive& drive) {
  Step& step = *steps_[at_];
  Result<void> ran;
  if (run_.procedure) {
    if (const auto left = step.leave(drive); !left) return end(drive, Procedure::State::failed, left.error());
    if (const auto kept = keepRun(drive); !kept) return end(drive, Procedure::State::failed, kept.error());
    const auto status = run_.procedure->status();
    if (status.state != Procedure::State::finished) ran = Error{run_.name, status.failure};
    if (status.state == Procedure::State::stopped) {
      const Message cause = step.causeOf(drive.tripped());
      const Error failure = cause.empty() ? ran.error() : Error{run_.name, cause};
      return endEarly(drive, {Procedure::State::stopped, drive.tripped(), failure});
    }
  }
  OnBench on{drive, options_, known_};
  const auto ended = step.end(on, ran);
  run_.procedure.reset();
  if (!ended) return endEarly(drive, {Procedure::State::failed, Trip::none, ended.error()});
  ++revision_;
  if (*ended == StepEnd::again) return;
  known_.facts.add(step.leaves());
  ++at_;
  if (const auto kept = keep(); !kept) end(drive, Procedure::State::failed, kept.error());
}

/// At once, unless small pulses may tell what is the cause.
void Job::endEarly(Drive& drive, const EarlyEnd& how) {
  if (!leavesCauseOpen(how, known_)) return end(drive, how.state, how.failure);
  const OnBench on{drive, options_, known_};
  cause_.emplace(how, on);
  run_ = cause_->run();
  record();
  drive.start(run_.procedure);
}

void Job::concludeCause(Drive& drive) {
  const Error failure = cause_->conclude(drive.tripped(), known_);
  const auto kept = keepRun(drive);
  end(drive, cause_->end().state, kept ? failure : kept.error());
}

Result<void> Job::keepRun(Drive& drive) {
  if (lost_ > 0) known_.remark(message("{}: {} samples were lost on the way.", run_.name, lost_));
  if (auto kept = keep(); !kept) return kept;
  if (!options_.keepRecordings || recorder_->empty()) return {};
  auto recording = recorder_->seal(notesOf(drive.identity()));
  if (!recording) return recording.error();
  const std::string name = known_.part > 1 ? run_.name + "-part" + std::to_string(known_.part) : run_.name;
  if (options_.keepRecording) return options_.keepRecording(name, *recording);
  known_.recordings.emplace_back(name, std::move(*recording));
  return {};
}

/// Not in every slice, and only what is new.
Result<void> Job::keepNow() {
  const auto now = std::chrono::steady_clock::now();
  if (!options_.keepProgress || std::chrono::duration<double>(now - kept_).count() < options_.keepEvery_s) return {};
  kept_ = now;
  return !cause_ && steps_[at_]->gather(known_) ? keep() : Result<void>{};
}

Result<void> Job::keep() {
  if (run_.procedure && !cause_) steps_[at_]->gather(known_);
  return options_.keepProgress ? options_.keepProgress(known_) : Result<void>{};
}

void Job::end(Drive& drive, Procedure::State state, const Error& failure) {
  state_ = state;
  failure_ = failure;
  drive.stop(state == Procedure::State::finished ? message("the job is done") : failure.said());
  if (known_.knows(Known::motor)) known_.bench = measuredBench(known_, options_);
  if (options_.givesGainsBack && found_ && !known_.knows(Known::gainsInUse) && *found_ != known_.settings)
    giveBack(drive);
  ++revision_;
}

void Job::giveBack(Drive& drive) {
  const auto accepted = drive.configure(*found_);
  if (!accepted) return;
  known_.settings = *accepted;
  known_.facts.remove({Known::carefulGains});
}

const Commission& Job::known() {
  if (running() && run_.procedure && !cause_ && steps_[at_]->gather(known_)) ++revision_;
  return known_;
}

unsigned Job::revision() {
  known();
  return revision_;
}

double Job::expected_s(size_t from, size_t to) const {
  double whole_s = 0.0;
  for (size_t k = from; k < to; ++k) whole_s += steps_[k]->expected_s(known_.sweeps);
  return whole_s;
}

Procedure::Status Job::status() const {
  Procedure::Status whole{state_, 0.0, 0.0, "", ""};
  if (state_ == Procedure::State::finished) {
    whole.progress = 1.0;
    return whole;
  }
  whole.failure = failure_.place == run_.name ? failure_.fact : Saying(failure_.said());
  if (at_ >= steps_.size()) return whole;
  double past_s = expected_s(0, at_), length_s = expected_s(at_, at_ + 1);
  const auto now = run_.procedure ? run_.procedure->status() : Procedure::Status{};
  // A step knows its own length best once it runs.
  if (now.progress > 0.02) length_s = now.remaining_s / std::max(1e-9, 1.0 - now.progress);
  past_s += now.progress * length_s;
  whole.remaining_s = (1.0 - now.progress) * length_s + expected_s(at_ + 1, steps_.size());
  whole.progress = past_s / std::max(1e-9, past_s + whole.remaining_s);
  whole.activity = now.activity;
  return whole;
}

}  // namespace breakaway
