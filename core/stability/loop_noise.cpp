#include "stability/loop_noise.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stability/root_locus.h"

namespace breakaway {

namespace {

constexpr auto speed = static_cast<Eigen::Index>(LoopOutput::velocity);
constexpr auto speedEstimate = static_cast<Eigen::Index>(LoopOutput::velocityEstimate);
constexpr auto estimate = static_cast<Eigen::Index>(LoopOutput::disturbanceEstimate);
constexpr auto voltage = static_cast<Eigen::Index>(LoopOutput::voltage);
constexpr auto currentReference = static_cast<Eigen::Index>(LoopOutput::currentReference);

Eigen::VectorXd variances(const SensorNoise& noise) {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(4);
  all[static_cast<Eigen::Index>(LoopInput::angleNoise)] = noise.angle_rms_rad * noise.angle_rms_rad;
  all[static_cast<Eigen::Index>(LoopInput::currentNoise)] = noise.current_rms_A * noise.current_rms_A;
  return all;
}

LoopNoise unknown() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  return {nan, nan, nan, nan, nan, nan, nan};
}

}  // namespace

double roundingRms_rad(double count_rad) {
  return count_rad / std::sqrt(12.0);
}

Result<LoopNoise> loopNoise(const ServoLoop& loop, const SensorNoise& noise) {
  const DiscreteSystem closed = closedLoop(loop);
  const auto both = stationaryRms(closed, variances(noise));
  if (!both) return both.error();
  const auto encoder = stationaryRms(closed, variances({noise.angle_rms_rad, 0.0}));
  if (!encoder) return encoder.error();
  return LoopNoise{(*both)[estimate], (*encoder)[estimate],   (*both)[currentReference], (*encoder)[currentReference],
                   (*both)[speed],    (*both)[speedEstimate], (*both)[voltage]};
}

std::vector<LoopNoise> noiseOverCutoff(const ServoLoop& loop, const SensorNoise& noise,
                                       const std::vector<double>& cutoffs_rad_per_s) {
  std::vector<LoopNoise> all;
  for (const double cutoff : cutoffs_rad_per_s) {
    const auto one = loopNoise(withCutoff(loop, cutoff), noise);
    all.push_back(one ? *one : unknown());
  }
  return all;
}

ObserverNoise noiseOverObserver(const ServoLoop& loop, const SensorNoise& noise, size_t count) {
  ObserverNoise found;
  found.inUse_rad_per_s = loop.board.velocityBandwidth_rad_per_s;
  found.bandwidth_rad_per_s = bandwidthsAround(found.inUse_rad_per_s, loop.board.tick_s, count);
  for (const double bandwidth : found.bandwidth_rad_per_s) {
    ServoLoop other = loop;
    other.board.velocityBandwidth_rad_per_s = bandwidth;
    const auto one = loopNoise(other, noise);
    found.current_A.push_back(one ? one->currentReference_A : unknown().currentReference_A);
  }
  return found;
}

std::vector<double> bandwidthsAround(double extra_rad_per_s, double tick_s, size_t count) {
  auto all = decades(0.02 / tick_s, 1.0 / tick_s, count);
  const auto near = std::lower_bound(all.begin(), all.end(), extra_rad_per_s);
  if (near == all.end() || std::abs(*near - extra_rad_per_s) > 1e-6 * extra_rad_per_s)
    all.insert(near, extra_rad_per_s);
  return all;
}

}  // namespace breakaway
