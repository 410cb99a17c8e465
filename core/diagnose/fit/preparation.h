// From bench and recordings to what a fit runs on.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "diagnose/fit/parameter_vector.h"
#include "diagnose/fit/split.h"
#include "diagnose/model/criteria.h"
#include "diagnose/model/effect.h"
#include "diagnose/model/model.h"
#include "motor/bench.h"
#include "recording/recording.h"

namespace breakaway {

struct Preparation {
  std::vector<Track> tracks;  ///< training recordings first, then held-out ones
  size_t recordings = 0;      ///< how many of them train
  std::vector<Track>
      training;  ///< the training tracks with rows outside the training windows masked, for inverse models
  Split split;
  std::vector<Model> starts;  ///< base models with start values and the restart's horizon, the inverse model's first
  Excitation seen;
  Freedom freedom;
  Criteria criteria;
  bool scaleDoubted = false;  ///< the scale of all torques rests on a value that nobody trusts
  std::vector<std::string> remarks;
};

/// Checks the channels, splits, and finds start values. Errors name the recording and what it lacks: a channel, any
/// value, length, motion.
Result<Preparation> prepare(const Bench& bench, const std::vector<Recording>& recordings,
                            const std::vector<Recording>& heldout, double window_s, HeldOut part = HeldOut::last,
                            ErrorIn errorIn = ErrorIn::motion, const Criteria& criteria = {});

/// Copies of the tracks that hold held-out windows, rows outside these masked: for inverse models.
std::vector<Track> heldoutTracks(const Preparation& prepared);

/// The model with intervals that also carry what least squares can't know: each effect's own doubt
/// (ParameterSpec::doubt), and the doubt of 10 % about an untrusted value that sets the scale (torques and inertias).
Model withDoubts(Model model, const Preparation& prepared);

}  // namespace breakaway
