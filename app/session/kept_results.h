// What is finished goes into the project by itself: an identified motor, a friction map, a diagnosis.
#pragma once

#include <QObject>
#include <string>

#include "session/bench_project.h"
#include "session/bench_runs.h"
#include "session/comparison.h"
#include "session/connection.h"

namespace breakaway {

class KeptResults : public QObject {
  Q_OBJECT

 public:
  KeptResults(Connection& connection, BenchRuns& bench, Comparison& comparison, BenchProject& project,
              QObject* parent = nullptr);

 signals:
  /// The friction map of this board's sweeps is in the project.
  void mapKept(const std::string& board);  ///< boardName()

 private:
  void keepRun(const RunSnapshot& snapshot);
  void keepDiagnosis();

  BenchRuns& bench_;
  Comparison& comparison_;
  BenchProject& project_;
};

}  // namespace breakaway
