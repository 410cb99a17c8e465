#include "session/project_runs.h"

#include <QPointer>
#include <map>
#include <set>
#include <utility>

#include "base/atomic_file.h"
#include "base/output_folder.h"
#include "friction/map_export.h"
#include "recording/block_file.h"
#include "session/language.h"
#include "session/run_title.h"

namespace breakaway {

namespace {

Error noProject() {
  return {"project", message("could not be opened")};
}

/// Each run with what it measured, which the index keeps apart.
Result<void> addValues(const RunIndex& index, const RunFilter& filter, std::vector<ProjectRun>& runs) {
  const auto values = index.history(filter);
  if (!values) return values.error();
  std::map<std::string_view, ProjectRun*> byId;
  for (ProjectRun& run : runs) byId[run.id] = &run;
  for (const ValueOfRun& one : *values) {
    const auto found = byId.find(one.runId);
    if (found != byId.end()) found->second->values.push_back(one.value);
  }
  return {};
}

}  // namespace

QString KeptRun::pathOf(std::string_view fileKind) const {
  const RunFile* file = run.file(fileKind);
  return file == nullptr ? QString() : QString::fromStdString(folder + "/" + file->path);
}

ProjectRuns::ProjectRuns(BenchProject& project, Messages& messages, QObject* parent)
    : QObject(parent), project_(project), messages_(messages) {
  connect(&project_, &BenchProject::changed, this, &ProjectRuns::refresh);
}

void ProjectRuns::filter(const RunFilter& filter) {
  filter_ = filter;
  list(false);
}

void ProjectRuns::refresh() {
  list(true);
}

void ProjectRuns::list(bool follow) {
  const unsigned mine = ++*wanted_;
  project_.inProject(
      [this, mine, follow, filter = filter_, wanted = wanted_](Project* project) -> std::function<void()> {
        // Whoever follows does it for those that come after, too.
        if (project == nullptr || (!follow && mine != *wanted)) return {};
        std::vector<Message> said;
        const auto list = listOf(*project, filter, follow, said);
        return [this, mine, list, said] {
          for (const Message& line : said) messages_.warn(inLanguage(line));
          if (!list) return messages_.warn(list.error());
          if (mine != *wanted_) return;
          list_ = *list;
          emit listed();
        };
      });
}

Result<ProjectRuns::List> ProjectRuns::listOf(Project& project, const RunFilter& filter, bool follow,
                                              std::vector<Message>& said) {
  RunIndex& index = project.index();
  if (follow) {
    if (auto done = index.follow(said); !done) return done.error();
  }
  const auto all = index.list({});
  if (!all) return all.error();
  List list;
  list.all = all->size();
  std::set<std::string> kinds, motors;
  for (const ProjectRun& run : *all) {
    kinds.insert(run.kind);
    if (!run.motor.empty()) motors.insert(run.motor);
  }
  list.kinds.assign(kinds.begin(), kinds.end());
  list.motors.assign(motors.begin(), motors.end());
  auto runs = index.list(filter);
  if (!runs) return runs.error();
  list.runs = std::move(*runs);
  if (auto done = addValues(index, filter, list.runs); !done) return done.error();
  return list;
}

template <class T>
void ProjectRuns::ask(std::function<Result<T>(Project&)> question, const QObject* asker,
                      std::function<void(const T&)> then) {
  project_.inProject([this, question = std::move(question), asker = QPointer(asker),
                      then = std::move(then)](Project* project) -> std::function<void()> {
    const Result<T> answer = project == nullptr ? Result<T>(noProject()) : question(*project);
    return [this, answer, asker, then] {
      if (!answer) return messages_.warn(answer.error());
      if (asker) then(*answer);
    };
  });
}

void ProjectRuns::note(const std::string& id, const RunNote& note) {
  ask<ProjectRun>([id, note](Project& project) { return project.annotate(id, note); }, this,
                  [this](const ProjectRun&) { emit project_.changed(); });
}

void ProjectRuns::read(const std::string& id, const QObject* asker, std::function<void(const KeptRun&)> then) {
  ask<KeptRun>(
      [id](Project& project) -> Result<KeptRun> {
        const auto run = project.index().find(id);
        if (!run) return run.error();
        return KeptRun{*run, project.folder() + "/" + run->folder};
      },
      asker, std::move(then));
}

void ProjectRuns::readMap(const std::string& id, const QObject* asker, std::function<void(const KeptMap&)> then) {
  ask<KeptMap>(
      [id](Project& project) -> Result<KeptMap> {
        const auto run = project.index().find(id);
        if (!run) return run.error();
        const RunFile* file = run->file("map");
        if (file == nullptr) return Error{titleOf(*run).toStdString(), message("has no friction map")};
        const auto map = breakaway::readMap(project.pathOf(*run, file->path));
        if (!map) return map.error();
        return KeptMap{*run, *map};
      },
      asker, std::move(then));
}

void ProjectRuns::compare(const std::string& one, const std::string& other, const QObject* asker,
                          std::function<void(const RunComparison&)> then) {
  ask<RunComparison>(
      [one, other](Project& project) -> Result<RunComparison> {
        const auto first = project.index().find(one), second = project.index().find(other);
        if (!first) return first.error();
        if (!second) return second.error();
        return compareRuns(project, *first, *second);
      },
      asker, std::move(then));
}

void ProjectRuns::writeReport(const RunComparison& comparison, const QString& folder) {
  ask<std::string>(
      [comparison, folder = folder.toStdString(), words = wordsOf(spokenLanguage())](Project&) -> Result<std::string> {
        auto out = OutputFolder::open({folder, "project", {"report.html", "figures", "comparison.json"}, {}});
        if (!out) return out.error();
        const auto written =
            out->fill([&](const std::string& into) { return writeComparison(comparison, into, words); });
        if (!written) return written.error();
        return folder + "/report.html";
      },
      this,
      [this](const std::string& report) { messages_.say(tr("Written: %1").arg(QString::fromStdString(report))); });
}

void ProjectRuns::saveCsv(const std::string& id, const QString& csv) {
  ask<std::string>(
      [id, csv](Project& project) -> Result<std::string> {
        const auto run = project.index().find(id);
        if (!run) return run.error();
        const RunFile* file = run->file("recording");
        if (file == nullptr) return Error{titleOf(*run).toStdString(), message("has no recording")};
        const std::string path = project.pathOf(*run, file->path);
        if (isBlockFile(path)) {
          if (auto written = writeBlocksAsCsv(path, csv.toStdString()); !written) return written.error();
        } else {
          const auto text = readFile(path);
          if (!text) return text.error();
          if (auto written = writeFile(csv.toStdString(), *text); !written) return written.error();
        }
        return csv.toStdString();
      },
      this,
      [this](const std::string& path) {
        messages_.say(tr("The recording is written to %1").arg(QString::fromStdString(path)));
      });
}

}  // namespace breakaway
