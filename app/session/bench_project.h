// The project that the window keeps everything in: opened, filled and listed in a thread of its own.
#pragma once

#include <QObject>
#include <QString>
#include <QThreadPool>
#include <functional>
#include <memory>

#include "project/project.h"
#include "session/messages.h"

namespace breakaway {

class BenchProject : public QObject {
  Q_OBJECT

 public:
  /// Gives what is then done in the window's thread, if anything.
  using Work = std::function<std::function<void()>(Project*)>;

  explicit BenchProject(Messages& messages, QObject* parent = nullptr);
  /// Waits for what is still being put in.
  ~BenchProject() override;

  /// Where a project is kept unless another is named: below the user's data.
  static QString defaultFolder();
  /// Opens the project, or makes it. Without this the default one is opened when something is to be kept.
  void open(const QString& folder);
  const QString& folder() const { return folder_; }

  /// Puts a run in, says under which name, and then does `then`.
  void put(const NewRun& run, std::function<void()> then = {});
  /// Does `work` with the project in its thread, one after the other, and then what that gave in this one. There is no
  /// project where none could be opened.
  void inProject(Work work);

 signals:
  /// It was opened, or a run was put in, began, ended, or is called otherwise.
  void changed();

 private:
  void queue(Work work);

  Messages& messages_;
  QThreadPool pool_, writers_;  ///< writers_: what takes long to write, so that recordings needn't wait
  QString folder_;
  std::shared_ptr<std::unique_ptr<Project>> project_;  ///< touched by the pool's one thread alone
};

}  // namespace breakaway
