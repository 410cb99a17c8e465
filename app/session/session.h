// What the window shows, without a window, and in which order it is made: each part knows only those above it.
#pragma once

#include "session/bench_project.h"
#include "session/bench_runs.h"
#include "session/comparison.h"
#include "session/connection.h"
#include "session/experiment_run.h"
#include "session/kept_results.h"
#include "session/live_samples.h"
#include "session/messages.h"
#include "session/profile_comparison.h"
#include "session/project_runs.h"
#include "session/settings_edits.h"
#include "session/shown_maps.h"
#include "session/trial_run.h"
#include "session/unfinished_runs.h"

namespace breakaway {

struct Session {
  explicit Session(const DriveLoopOptions& options = {}) : connection(messages, options) {
    QObject::connect(&bench, &BenchRuns::tuned, &edits, &SettingsEdits::edit);
  }

  Messages messages;
  Connection connection;
  SettingsEdits edits{connection, messages};
  BenchProject project{messages};
  BenchRuns bench{connection, messages};
  LiveSamples live{connection, project, messages};
  Comparison comparison{messages};
  ExperimentRun experiment{connection, bench, live, comparison, messages};
  TrialRun trial{comparison, messages};
  KeptResults kept{connection, bench, comparison, project};
  UnfinishedRuns unfinished{connection, bench, kept, project, messages};
  ProjectRuns runs{project, messages};
  ShownMaps maps;
  ProfileComparison profile{connection, bench, messages};
};

}  // namespace breakaway
