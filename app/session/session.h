// What the window shows, without a window, and in which order it is made: each part knows only those above it.
#pragma once

#include "session/bench_runs.h"
#include "session/comparison.h"
#include "session/connection.h"
#include "session/live_samples.h"
#include "session/messages.h"

namespace breakaway {

struct Session {
  explicit Session(const DriveLoopOptions& options = {}) : connection(messages, options) {}

  Messages messages;
  Connection connection;
  BenchRuns bench{connection, messages};
  LiveSamples live{connection, messages};
  Comparison comparison{messages};
};

}  // namespace breakaway
