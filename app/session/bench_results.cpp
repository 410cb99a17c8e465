// What comes of the runs, and what the bench keeps of it.
#include <algorithm>
#include <utility>

#include "firmware_link/presets.h"
#include "session/bench_runs.h"
#include "session/language.h"

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
  if (!known_.identity.device.empty() && !mayBeSame(known_.identity, identity)) {
    const std::string before = boardName(known_.identity);
    messages_.say(tr("This is another board: what was measured on %1 is kept until it comes back")
                      .arg(QString::fromStdString(before)));
    otherBoards_[before] = std::exchange(known_, {});
    tookUp_ = false;
    const auto earlier = std::find_if(otherBoards_.begin(), otherBoards_.end(), [&identity](const auto& one) {
      return mayBeSame(one.second.identity, identity);
    });
    if (earlier != otherBoards_.end()) {
      known_ = std::move(earlier->second);
      otherBoards_.erase(earlier);
    }
    forgetSteps();
  }
  known_.identity = identity;
  emit knownChanged();
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
  known_.forgetBoard();
  emit knownChanged();
}

void BenchRuns::forgetSteps() {
  steps_.clear();
  emit measured();
}

void BenchRuns::takeUp(const Commission& earlier) {
  known_ = earlier;
  known_.identity = connection_.identity();
  known_.settings = connection_.settings();
  tookUp_ = true;
  emit tookUp();
  emit knownChanged();
}

void BenchRuns::forgetSweeps() {
  known_.forget({Known::runs, Known::breakaways});
  emit sweepsForgotten(boardName(known_.identity));
  emit knownChanged();
}

void BenchRuns::keepResult(const RunSnapshot& snapshot) {
  const Procedure::State state = snapshot.status.state;
  if (const auto* known = std::get_if<KnownPtr>(&snapshot.result)) keepKnown(*known);
  if (state != Procedure::State::finished) return;
  if (const auto* step = std::get_if<StepResult>(&snapshot.result)) steps_.push_back(*step);
  emit measured();
}

void BenchRuns::keepKnown(const KnownPtr& now) {
  if (now == last_) return;
  last_ = now;
  const Commission& known = *now;
  if (known.settings != connection_.settings()) connection_.takeSettings(known.settings);
  for (size_t k = known_.remarks.size(); k < known.remarks.size(); ++k) messages_.say(inLanguage(known.remarks[k]));
  known_ = known;
  emit knownChanged();
}

}  // namespace breakaway
