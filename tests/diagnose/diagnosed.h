// Diagnoses of recordings of the simulated rig's plant, and what every proof must hold.
#pragma once

#include <QElapsedTimer>
#include <QtGlobal>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "diagnose/diagnosis.h"
#include "support/recorded_rig.h"
#include "support/sanitized.h"
#include "support/within.h"

namespace breakaway::test {

/// recordRig()'s bench believes 1.3 Ω where the rig has 1.2 Ω. A voltage-driven recording can't tell, so that all
/// torques come out smaller by this factor.
inline constexpr double gauge = 1.2 / 1.3;

/// Under sanitizers of a short recording, whose numbers nobody should look at.
inline Diagnosis diagnosed(const RigRecording& wanted) {
  QElapsedTimer timer;
  timer.start();
  RigRecording fitted = wanted;
  fitted.seconds = secondsToFit(wanted.seconds);
  const auto rig = recordRig(fitted);
  const auto diagnosis = diagnose(rig.bench, {rig.recording}, {}, {});
  if (!diagnosis) qFatal("%s", diagnosis.error().message().c_str());
  qInfo("seed %u, %lld ms: %s", wanted.seed, static_cast<long long>(timer.elapsed()), inWords(*diagnosis).c_str());
  return *diagnosis;
}

/// Under sanitizers the beginning of a recording, whose numbers nobody should look at; else all of it.
inline Recording partToFit(const Recording& whole) {
  const auto time = whole.time();
  const double last_s = time.front() + secondsToFit(time.back() - time.front());
  const auto rows = std::upper_bound(time.begin(), time.end(), last_s) - time.begin();
  std::vector<Channel> channels = whole.channels();
  for (Channel& channel : channels) channel.values.resize(static_cast<size_t>(rows));
  const auto part = Recording::seal(whole.name(), std::move(channels), whole.notes());
  if (!part) qFatal("%s", part.error().message().c_str());
  return *part;
}

/// The finding's parameter; NaN when it has none of that name.
inline double parameter(const Finding& finding, const std::string& name) {
  for (const Parameter& one : finding.parameters) {
    if (one.name == name) return one.value;
  }
  return std::nan("");
}

/// Better on held-out data for sure, and no better than an encoder of 14400 counts (0.13 mrad rms) can show.
inline bool isProved(const FitScore& fit) {
  return fit.improvementLow95 > 0.0 && fit.improvementLow95 < fit.improvementHigh95 && fit.improvementHigh95 < 1.0 &&
         fit.trainAfter < fit.trainBefore && fit.heldoutAfter < fit.heldoutBefore && fit.heldoutAfter > 1e-4 &&
         !fit.separateRecording && fit.window_s == 0.5;
}

}  // namespace breakaway::test
