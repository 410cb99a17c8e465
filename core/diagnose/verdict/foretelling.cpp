#include "diagnose/verdict/foretelling.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/statistics.h"
#include "diagnose/fit/unexplained.h"
#include "diagnose/fit/windowed_fit.h"
#include "diagnose/simulate/physics.h"

namespace breakaway {

namespace {

constexpr size_t resamples = 500;
constexpr size_t fewestSeconds = 3;

/// From squares second by second. Seconds without any are left out.
Foretold shareOf(std::vector<double> before, std::vector<double> after, std::uint64_t seed) {
  size_t kept = 0;
  for (size_t k = 0; k < before.size(); ++k) {
    if (!(before[k] > 0.0)) continue;
    before[kept] = before[k];
    after[kept++] = after[k];
  }
  if (kept < fewestSeconds) return {};
  before.resize(kept);
  after.resize(kept);
  const auto share = [&](std::span<const size_t> seconds) {
    double all = 0.0, left = 0.0;
    for (const size_t second : seconds) {
      all += before[second];
      left += after[second];
    }
    return 1.0 - left / all;
  };
  std::vector<size_t> every(kept);
  for (size_t k = 0; k < kept; ++k) every[k] = k;
  const Interval interval = bootstrap(kept, resamples, seed, share);
  return {share(every), interval.low, interval.high};
}

/// What the map foretells at an instant, Nm (N).
double torqueAt(const ResidualMap& map, const Unexplained& u, size_t k, const Track& track) {
  const double speed = u.velocity[k];
  if (u.usable[k] == 0) return 0.0;
  const double place = placesAt(u, k, track, map.withinTurn)[map.along];
  const double expected = map.at(placeFor(map.shows, map.along, place, speed < 0.0 ? -1.0 : 1.0), speed);
  return map.shows == Unknown::friction && speed < 0.0 ? -expected : expected;
}

/// The track with what the map foretells taken off its drive: the map holds what the drive gives beyond what is needed.
Track withTorque(const ResidualMap& map, const Model& model, const Unexplained& u, Track track) {
  const bool overFrequency = map.along == alongs;
  const std::vector<double> answered =
      overFrequency ? ResidualSpectrum::foretoldTorque(map.answer, u) : std::vector<double>();
  if (model.servo) track.push.assign(track.rows(), 0.0);
  std::vector<double>& acting = model.servo ? track.push : track.input;
  const double perInput = physicsOf(model).torquePerInput();
  for (size_t k = 0; k < u.time.size(); ++k)
    acting[u.row[k]] -= (overFrequency ? answered[k] : torqueAt(map, u, k, track)) / perInput;
  return track;
}

}  // namespace

Foretold foretold(const ResidualMap& map, Along axis, const Instants& heldout, std::uint64_t seed) {
  std::vector<double> before, after;
  for (size_t k = 0; k < heldout.value.size(); ++k) {
    const size_t block = heldout.block[k];
    if (block >= before.size()) {
      before.resize(block + 1, 0.0);
      after.resize(block + 1, 0.0);
    }
    const double shown = heldout.shown(k, map.shows), speed = heldout.along[byVelocity][k];
    const double place = heldout.place(k, axis, map.shows);
    const double expected = std::isfinite(place) ? map.at(place, speed) : 0.0;
    before[block] += shown * shown;
    after[block] += (shown - expected) * (shown - expected);
  }
  return shareOf(std::move(before), std::move(after), seed);
}

ForetoldWindows::ForetoldWindows(const Model& model, const Preparation& prepared)
    : model_(model),
      prepared_(prepared),
      before_(scoreWindows(model, prepared.tracks, prepared.split.heldoutScore)),
      unexplained_(prepared.tracks.size()) {
  for (const Window& one : prepared.split.heldoutScore) {
    if (Unexplained& u = unexplained_[one.track]; u.time.empty())
      u = unexplainedAlong(model, prepared.tracks[one.track]);
  }
}

Foretold ForetoldWindows::foretold(const ResidualMap& map, std::uint64_t seed) const {
  std::vector<Track> pushed(prepared_.tracks.size());
  for (size_t t = 0; t < pushed.size(); ++t) {
    if (!unexplained_[t].time.empty()) pushed[t] = withTorque(map, model_, unexplained_[t], prepared_.tracks[t]);
  }
  return shareOf(before_, scoreWindows(model_, pushed, prepared_.split.heldoutScore), seed);
}

Foretold foretold(const ResidualSpectrum& learned, const ResidualSpectrum& heldout, std::uint64_t seed) {
  const auto beside = [&](ResidualSpectrum::Beside which) {
    auto [before, after] = learned.foretold(heldout, which);
    return shareOf(std::move(before), std::move(after), seed);
  };
  const Foretold drive = beside(ResidualSpectrum::Beside::drive), motion = beside(ResidualSpectrum::Beside::motion);
  return motion.low95 < drive.low95 ? motion : drive;
}

}  // namespace breakaway
