#include "trial/trial_imperfections.h"

#include <array>
#include <cassert>
#include <cmath>

#include "motor/bench.h"

namespace breakaway {

namespace {

constexpr double mostWander = 0.045, leastWander = 0.002;  ///< of the Coulomb friction, rms

/// Of the friction or of the drive: nobody would call them physics that is missing.
void addSmallEffects(TrialRig& rig, Random& random) {
  PlantPhysics& p = rig.physics;
  const auto part = [&random](double most) { return most * drawn(random, -1.0, 1.0); };
  p.load += part(0.003) * rig.coulomb();
  addCoulombAsymmetry(p, part(0.004) * rig.coulomb());
  addStribeckExcess(p, 0.004 * random.uniform() * rig.coulomb());
  if (rig.axis == Axis::linear) return;
  p.position.push_back({6.0 * static_cast<double>(1 + random.below(6)), part(0.004) * rig.coulomb(), 0.0});
  p.ripple.push_back({6.0, part(0.002), drawn(random, 0.0, 6.0)});
  rig.sensors.eccentricity = {static_cast<double>(1 + random.below(2)), part(0.4) * rig.sensors.count,
                              drawn(random, 0.0, 6.0)};
}

bool isDrive(const std::string& channel, const TrialRig& rig) {
  Bench names;
  names.axis = rig.axis;
  names.input = rig.input;
  return channel == names.inputChannel();
}

/// Which rows the logger keeps.
std::vector<char> keptRows(size_t rows, double row_s, const TrialLogger& logger, Random& random) {
  std::vector<char> kept(rows, 0);
  double silent_s = 0.0;
  for (size_t k = 0; k < rows; k += logger.every) {
    const double step_s = row_s * static_cast<double>(logger.every);
    silent_s -= step_s;
    if (random.uniform() < logger.lostGaps_per_s * step_s) silent_s = drawnLog(random, step_s, logger.longestGap_s);
    kept[k] = silent_s <= 0.0 && random.uniform() >= logger.lostShare;
  }
  return kept;
}

}  // namespace

TrialLogger drawImperfections(TrialRig& rig, Random& random) {
  OutsidePhysics& o = rig.physics.outside;
  o.wander = drawnLog(random, leastWander, mostWander) * rig.coulomb();
  o.wanderTime_s = drawnLog(random, 0.003, 10.0);
  addSmallEffects(rig, random);
  TrialSensors& s = rig.sensors;
  s.row_s = random.uniform() < 0.2 ? 2e-4 : 1e-3;
  const double range = 1.5 * rig.peakCurrent_A();
  s.currentStep_A = 2.0 * range / std::array{512.0, 1024.0, 4096.0, 16384.0}[random.below(4)];
  TrialLogger logger;
  if (s.row_s > 5e-4 && random.uniform() < 0.6) logger.every = std::array{2U, 5U, 5U, 10U}[random.below(4)];
  logger.meanDrive = logger.every > 1 && random.uniform() < 0.5;
  if (random.uniform() < 0.4) logger.lostShare = drawnLog(random, 1e-4, 0.02);
  if (random.uniform() < 0.2) {
    logger.lostGaps_per_s = drawn(random, 0.02, 0.1);
    logger.longestGap_s = 0.3;
  }
  return logger;
}

Recording logged(const Recording& recording, const TrialRig& rig, const TrialLogger& logger, Random& random) {
  const size_t rows = recording.rows();
  const std::vector<char> kept = keptRows(rows, rig.sensors.row_s, logger, random);
  std::vector<Channel> channels;
  for (const Channel& all : recording.channels()) {
    Channel one{all.name, {}};
    for (size_t k = 0; k < rows; ++k) {
      if (kept[k] == 0) continue;
      double value = all.values[k];
      if (logger.meanDrive && isDrive(all.name, rig)) {
        const size_t past = std::min(rows, k + logger.every);
        for (size_t j = k + 1; j < past; ++j) value += all.values[j];
        value /= static_cast<double>(past - k);
      }
      one.values.push_back(value);
    }
    channels.push_back(std::move(one));
  }
  auto out = Recording::seal(recording.name(), std::move(channels));
  assert(out.ok());
  return *out;
}

}  // namespace breakaway
