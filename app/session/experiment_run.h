// A diagnosis' next experiment on the board: run, recorded, and opened in the comparison.
#pragma once

#include <QObject>
#include <QString>

#include "session/bench_runs.h"
#include "session/comparison.h"
#include "session/connection.h"
#include "session/live_samples.h"
#include "session/messages.h"

namespace breakaway {

class ExperimentRun : public QObject {
  Q_OBJECT

 public:
  ExperimentRun(Connection& connection, BenchRuns& bench, LiveSamples& live, Comparison& comparison, Messages& messages,
                QObject* parent = nullptr);

  void start();
  /// Why it can't be started now; empty when it can.
  QString obstacle() const;
  /// What will move, and for how long; empty where there is no experiment.
  QString plan() const;

 signals:
  void changed();

 private:
  enum class Stage { none, recording, moving, sealing };
  void follow();
  void takeRun(const RunSnapshot& snapshot);

  Connection& connection_;
  BenchRuns& bench_;
  LiveSamples& live_;
  Comparison& comparison_;
  Messages& messages_;
  Stage stage_ = Stage::none;
  bool whole_ = false;  ///< the motion came to its end
  Maneuver motion_;
  QString before_;  ///< the newest recording before
};

}  // namespace breakaway
