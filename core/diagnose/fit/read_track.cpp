#include "diagnose/fit/read_track.h"

#include "diagnose/fit/channel_checks.h"
#include "diagnose/fit/drive_noise.h"
#include "diagnose/fit/motion.h"

namespace breakaway {

namespace {

constexpr double bridged_s = 0.02;  ///< from reading to reading, over which a line is near enough

}  // namespace

Result<Track> readTrack(const Bench& bench, const Recording& recording) {
  auto track = makeTrack(recording, bench.axis, bench.input, bench.supply_V, bench.count(), bench.servo.has_value());
  if (!track) return track;
  track->leaps = leapsOf(*track);
  if (auto unwrapped = checkUnwrapped(bench, *track); !unwrapped) return unwrapped.error();
  bridgePositions(*track, bridged_s);
  track->motion = motionOf(*track);
  if (const double noise = voltageReadingNoise(*track); noise > 0.0) track->inputNoise = noise;
  return track;
}

}  // namespace breakaway
