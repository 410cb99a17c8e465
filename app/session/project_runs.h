// The runs of the window's project: listed, filtered, named, read and compared, all in the project's thread.
#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "project/project.h"
#include "report/run_comparison.h"
#include "session/bench_project.h"
#include "session/messages.h"
#include "session/shown_maps.h"

namespace breakaway {

/// A run with its files and findings, and where it lies.
struct KeptRun {
  ProjectRun run;
  std::string folder;

  /// Where the first file of this kind lies; empty where there is none.
  QString pathOf(std::string_view fileKind) const;
};

class ProjectRuns : public QObject {
  Q_OBJECT

 public:
  ProjectRuns(BenchProject& project, Messages& messages, QObject* parent = nullptr);

  /// Lists what passes; listed() says when.
  void filter(const RunFilter& filter);
  /// Looks for what was put in since, by this window or another program, and lists again.
  void refresh();
  /// The newest first, with their values, without files and findings.
  const std::vector<ProjectRun>& runs() const { return list_.runs; }
  /// How many there are, whatever the filter.
  size_t all() const { return list_.all; }
  /// Which motors and kinds of run there are, by name.
  const std::vector<std::string>& motors() const { return list_.motors; }
  const std::vector<std::string>& kinds() const { return list_.kinds; }

  void note(const std::string& id, const RunNote& note);
  /// Reads the whole of a run, and then does `then`, if `asker` is still there; what goes wrong is said.
  void read(const std::string& id, const QObject* asker, std::function<void(const KeptRun&)> then);
  /// The friction map that a run left.
  void readMap(const std::string& id, const QObject* asker, std::function<void(const KeptMap&)> then);
  /// The older one comes first, whichever is named first.
  void compare(const std::string& one, const std::string& other, const QObject* asker,
               std::function<void(const RunComparison&)> then);
  /// report.html, comparison.json and figures into a folder, as `breakaway project compare --out` does.
  void writeReport(const RunComparison& comparison, const QString& folder);
  /// Writes a run's recording as CSV.
  void saveCsv(const std::string& id, const QString& csv);

 signals:
  void listed();

 private:
  struct List {
    std::vector<ProjectRun> runs;
    size_t all = 0;
    std::vector<std::string> motors, kinds;
  };

  void list(bool follow);
  static Result<List> listOf(Project& project, const RunFilter& filter, bool follow, std::vector<Message>& said);
  template <class T>
  void ask(std::function<Result<T>(Project&)> question, const QObject* asker, std::function<void(const T&)> then);

  BenchProject& project_;
  Messages& messages_;
  RunFilter filter_;
  List list_;
  /// Number of the newest list asked for: older ones are neither made nor shown.
  std::shared_ptr<std::atomic<unsigned>> wanted_ = std::make_shared<std::atomic<unsigned>>(0);
};

}  // namespace breakaway
