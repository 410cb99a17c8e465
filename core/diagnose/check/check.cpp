#include "diagnose/check/check.h"

#include <cmath>

#include "base/statistics.h"
#include "diagnose/fit/noise_floor.h"
#include "diagnose/fit/preparation.h"
#include "diagnose/fit/read_track.h"
#include "diagnose/screen/linear_rig.h"
#include "diagnose/simulate/physics.h"
#include "diagnose/verdict/next_experiment.h"

namespace breakaway {

namespace {

constexpr double window_s = 0.5;
constexpr std::uint64_t anySeed = 1;

/// What a diagnosis would learn from, or all there is where it could hold nothing out.
Result<Preparation> prepared(const Bench& bench, const std::vector<Recording>& recordings) {
  auto usual = prepare(bench, recordings, {}, window_s, HeldOut::last);
  return usual ? std::move(usual) : prepare(bench, recordings, {}, window_s, HeldOut::none);
}

}  // namespace

Result<Check> check(const Bench& asGiven, const std::vector<Recording>& recordingsAsGiven) {
  const auto scales = checkScales(asGiven, recordingsAsGiven);
  if (!scales) return scales.error();
  Check out;
  out.axis = asGiven.axis;
  out.misread = scales->misread;
  out.remarks = scales->remarks;
  const Bench bench = out.misread ? mended(asGiven, *out.misread) : asGiven;
  const std::vector<Recording> recordings = mended(recordingsAsGiven, out.misread);
  for (const Recording& recording : recordings) {
    const auto track = readTrack(bench, recording);
    if (!track) return track.error();
    out.channels.push_back(qualityOf(bench, recording, *track));
    for (std::string& words : inWords(out.channels.back(), bench)) out.channelWords.push_back(std::move(words));
  }
  const auto data = prepared(bench, recordings);
  if (!data) return data.error();
  out.remarks.insert(out.remarks.end(), data->remarks.begin(), data->remarks.end());
  SearchInput input(*data, anySeed);
  FitResult base = fitBase(input, data->starts);
  input.windowWeights = robustWeights(base.windowSquares);
  base = fitModel(input, base.model, 10);
  input.seen.inertia = physicsOf(base.model).inertia;
  input.seen.coulomb = physicsOf(base.model).coulomb;
  const auto& windows = input.split.trainScore;
  out.floor = noiseFloor(base.model, input.tracks, windows, anySeed);
  const double restarts = mean(scoreWindows(base.model, input.tracks, windows));
  out.error = std::sqrt(restarts);
  out.wander = LinearRig(base.model, input.tracks, input.split.train, Torque::wandering).wander();
  out.base = withDoubts(base.model, *data);
  out.effects = sightOf(input, base, Worth(input, base, restarts, out.floor), out.wander);
  out.next = mostInformative(input.seen).sentence;
  return out;
}

}  // namespace breakaway
