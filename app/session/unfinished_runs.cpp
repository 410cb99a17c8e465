#include "session/unfinished_runs.h"

#include <QDateTime>
#include <QLocale>
#include <utility>

#include "session/language.h"

namespace breakaway {

namespace {

constexpr qint64 writtenEvery_ms = 400;

std::string placeIn(const Project& project) {
  return unfinishedPlace(project.folder());
}

}  // namespace

UnfinishedRuns::UnfinishedRuns(Connection& connection, BenchRuns& bench, KeptResults& kept, BenchProject& project,
                               Messages& messages, QObject* parent)
    : QObject(parent), connection_(connection), bench_(bench), project_(project), messages_(messages) {
  connect(&connection_, &Connection::came, this, &UnfinishedRuns::lookForOne);
  connect(&connection_, &Connection::runReported, this, &UnfinishedRuns::follow);
  connect(&kept, &KeptResults::mapKept, this, &UnfinishedRuns::remove);
  connect(&bench_, &BenchRuns::sweepsForgotten, this, &UnfinishedRuns::remove);
}

void UnfinishedRuns::lookForOne() {
  const Identity board = connection_.identity();
  if (isUnfinished(bench_.known()) || bench_.known().knows(Known::motor)) return;
  project_.inProject([this, jobs = jobs_, board](Project* project) -> std::function<void()> {
    if (project == nullptr || jobs->count(boardName(board)) > 0) return {};
    auto found = UnfinishedJob::find(placeIn(*project), board);
    if (!found) return {};
    const auto job = jobs->emplace(boardName(board), std::move(*found)).first;
    return [this, board, known = job->second.known(), since_s = job->second.since_s()] {
      takeUp(boardName(board), known, since_s);
    };
  });
}

void UnfinishedRuns::takeUp(const std::string& board, const Commission& known, double since_s) {
  // What was started meanwhile may have ended, too, and would be forgotten.
  const bool still = connection_.connected() && boardName(connection_.identity()) == board && !connection_.hasRun();
  if (!still) {
    // It stays on disk for another time.
    project_.inProject([jobs = jobs_, board](Project*) -> std::function<void()> {
      jobs->erase(board);
      return {};
    });
    return;
  }
  bench_.takeUp(known);
  const QDateTime since = QDateTime::fromMSecsSinceEpoch(static_cast<qint64>(since_s * 1e3));
  messages_.say(tr("The sweeps of %1 were not finished: %2 are there, and Friction goes on with them")
                    .arg(QLocale().toString(since, QLocale::ShortFormat), inLanguage(howFar(known))));
}

void UnfinishedRuns::follow(const RunSnapshot& snapshot) {
  const auto* known = std::get_if<KnownPtr>(&snapshot.result);
  if (known == nullptr || *known == nullptr || *known == written_ || !isUnfinished(**known)) return;
  // What the last one to be written doesn't hold comes with the next, at the latest when the run ends.
  if (snapshot.running() && (*writing_ || (sinceWritten_.isValid() && sinceWritten_.elapsed() < writtenEvery_ms)))
    return;
  write(*known);
}

void UnfinishedRuns::write(const KnownPtr& known) {
  written_ = known;
  sinceWritten_.start();
  *writing_ = true;
  project_.inProject([this, jobs = jobs_, writing = writing_, known](Project* project) -> std::function<void()> {
    Result<void> kept;
    if (project != nullptr) {
      auto& job = jobs->try_emplace(boardName(known->identity), placeIn(*project)).first->second;
      kept = job.keep(*known);
    }
    return [this, writing, kept] {
      *writing = false;
      if (!kept) messages_.warn(kept.error());
    };
  });
}

void UnfinishedRuns::remove(const std::string& board) {
  project_.inProject([jobs = jobs_, board](Project*) -> std::function<void()> {
    if (const auto job = jobs->find(board); job != jobs->end()) {
      job->second.remove();
      jobs->erase(job);
    }
    return {};
  });
}

}  // namespace breakaway
