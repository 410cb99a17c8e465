#include "bench/window_kills.h"

#include <QProcess>
#include <QProcessEnvironment>
#include <QThread>
#include <set>

#include "app/streaming_drive.h"
#include "project/project.h"

namespace breakaway::test {

namespace {

constexpr int startsWithin_ms = 20'000, workFor_ms = 1500;

/// Kills it while it works; when that was, or nothing where it never began.
std::optional<double> killedAtWork(const QString& program, const QStringList& arguments, int after_ms) {
  QProcess window;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("QT_QPA_PLATFORM", "offscreen");
  window.setProcessEnvironment(environment);
  window.start(program, arguments);
  // It says so when it has begun.
  if (!window.waitForStarted(startsWithin_ms) || !window.waitForReadyRead(startsWithin_ms)) return std::nullopt;
  QThread::msleep(static_cast<unsigned long>(after_ms));
  const double at_s = steadyNow_s();
  window.kill();
  window.waitForFinished(startsWithin_ms);
  return at_s;
}

}  // namespace

ProjectKills killsOfTheWindow(const QString& program, const QString& work, const QString& folder, int kills,
                              std::mt19937& random) {
  ProjectKills all;
  std::uniform_int_distribution<int> moment_ms(0, workFor_ms);
  std::set<std::string> known;
  for (int k = 0; k < kills; ++k) {
    const auto at_s = killedAtWork(program, {"--at-work", work, folder}, moment_ms(random));
    if (!at_s) all.faults.push_back("the window did not begin with " + work.toStdString());
    const auto project = lookedAt(folder.toStdString(), all);
    if (!project || !at_s) continue;
    const auto runs = project->index().list({.kind = "recording"});
    for (const ProjectRun& run : runs ? *runs : std::vector<ProjectRun>()) {
      if (known.insert(run.id).second && run.state == RunState::cut) countCut(*project, run, *at_s, all);
    }
  }
  return all;
}

}  // namespace breakaway::test
