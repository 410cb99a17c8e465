// What sweeps have measured goes to disk while they run, and comes back when the board does.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <map>
#include <memory>
#include <string>

#include "commission/unfinished_job.h"
#include "session/bench_project.h"
#include "session/bench_runs.h"
#include "session/connection.h"
#include "session/kept_results.h"
#include "session/messages.h"

namespace breakaway {

class UnfinishedRuns : public QObject {
  Q_OBJECT

 public:
  UnfinishedRuns(Connection& connection, BenchRuns& bench, KeptResults& kept, BenchProject& project, Messages& messages,
                 QObject* parent = nullptr);

 private:
  using Jobs = std::map<std::string, UnfinishedJob>;  ///< by boardName()

  void lookForOne();
  void takeUp(const std::string& board, const Commission& known, double since_s);
  void follow(const RunSnapshot& snapshot);
  void write(const KnownPtr& known);
  void remove(const std::string& board);

  Connection& connection_;
  BenchRuns& bench_;
  BenchProject& project_;
  Messages& messages_;
  std::shared_ptr<Jobs> jobs_ = std::make_shared<Jobs>();  ///< touched in the project's thread alone
  KnownPtr written_;
  std::shared_ptr<bool> writing_ = std::make_shared<bool>(false);  ///< touched in the window's thread alone
  QElapsedTimer sinceWritten_;
};

}  // namespace breakaway
