#include "session/bench_project.h"

#include <QStandardPaths>
#include <QTemporaryDir>

#include "session/language.h"
#include "session/run_title.h"

namespace breakaway {

BenchProject::BenchProject(Messages& messages, QObject* parent)
    : QObject(parent), messages_(messages), project_(std::make_shared<std::unique_ptr<Project>>()) {
  pool_.setMaxThreadCount(1);
  writers_.setMaxThreadCount(1);
}

BenchProject::~BenchProject() {
  writers_.waitForDone();
  pool_.waitForDone();
}

QString BenchProject::defaultFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) + "/breakaway/project";
}

void BenchProject::open(const QString& folder) {
  folder_ = folder;
  pool_.start([this, folder, project = project_] {
    auto opened = Project::open(folder.toStdString(), Project::Missing::isMade);
    *project = opened ? std::make_unique<Project>(std::move(*opened)) : nullptr;
    const std::vector<Message> said = *project ? (**project).said() : std::vector<Message>();
    const QString why = opened ? QString() : inLanguage(opened.error().said());
    QMetaObject::invokeMethod(
        this,
        [this, said, why] {
          for (const Message& line : said) messages_.say(inLanguage(line));
          if (!why.isEmpty()) messages_.warn(tr("Nothing can be kept: %1").arg(why));
          emit changed();
        },
        Qt::QueuedConnection);
  });
}

void BenchProject::inProject(Work work) {
  if (folder_.isEmpty()) open(defaultFolder());
  queue(std::move(work));
}

void BenchProject::queue(Work work) {
  pool_.start([this, project = project_, work = std::move(work)] {
    const std::function<void()> then = work(project->get());
    if (then) QMetaObject::invokeMethod(this, then, Qt::QueuedConnection);
  });
}

void BenchProject::put(const NewRun& run, std::function<void()> then) {
  if (folder_.isEmpty()) open(defaultFolder());
  writers_.start([this, run, then = std::move(then)] {
    const auto place = std::make_shared<QTemporaryDir>();
    NewRun whole = run;
    // Where the system's temporary files have no room, the project's own disk may: then add() writes it.
    if (run.write && place->isValid() && run.write(place->path().toStdString())) {
      whole.write = {};
      whole.sources.push_back(place->path().toStdString());
    }
    queue([this, place, whole, then](Project* project) -> std::function<void()> {
      if (project == nullptr) return {};
      const auto put = project->add(whole);
      return [this, put, then] {
        if (!put) return messages_.warn(put.error());
        messages_.say(tr("Kept in the project: %1").arg(titleOf(*put)));
        emit changed();
        if (then) then();
      };
    });
  });
}

}  // namespace breakaway
