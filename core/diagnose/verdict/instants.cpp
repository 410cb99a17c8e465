#include "diagnose/verdict/instants.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "diagnose/fit/inverse_rows.h"
#include "diagnose/fit/unexplained.h"

namespace breakaway {

namespace {

constexpr double smoothing_Hz = 25.0;

void addTrack(AllInstants& all, const Model& model, const Track& track) {
  Unexplained u = unexplainedAlong(model, track);
  const size_t n = u.time.size();
  if (n < 2) return;
  const size_t firstBlock = all.blocks;
  all.spectrum.add(u, track.noise, track.usualStep_s, firstBlock);
  // Pauses, which the rows leave out, hold no block.
  all.blocks += static_cast<size_t>(static_cast<double>(n) * u.step_s) + 1;
  const double cutoff = std::min(smoothing_Hz, 0.05 / u.step_s);
  for (auto* values : {&u.torque, &u.voltage, &u.acceleration}) {
    if (!values->empty()) lowPass(*values, u.step_s, cutoff);
  }
  const auto every = std::max<size_t>(1, static_cast<size_t>(1.0 / (4.0 * cutoff * u.step_s)));
  for (size_t k = 0; k < n; k += every) {
    const std::array<double, alongs> values = placesAt(u, k, track, all.turns);
    const auto add = [&](Instants& instants, double value, double way) {
      instants.value.push_back(value);
      instants.way.push_back(way);
      instants.block.push_back(firstBlock + static_cast<size_t>(static_cast<double>(k) * u.step_s));
      for (size_t a = 0; a < alongs; ++a) instants.along[a].push_back(values[a]);
    };
    if (u.usable[k] != 0) add(all.mechanical, u.torque[k], u.velocity[k] > 0.0 ? 1.0 : -1.0);
    if (!u.voltage.empty() && u.driven[k] != 0) add(all.electrical, u.voltage[k], u.velocity[k] > 0.0 ? 1.0 : -1.0);
  }
}

}  // namespace

std::array<double, alongs> placesAt(const Unexplained& u, size_t instant, const Track& track, bool turns) {
  const double position = u.position[instant];
  return {track.origin_s + u.time[instant],
          turns ? position - turn_rad * std::floor(position / turn_rad) : position,
          u.velocity[instant],
          u.acceleration[instant],
          u.drive[instant],
          u.travel[instant],
          track.temperature.empty() ? 0.0 : track.temperature[u.row[instant]],
          u.current[instant],
          u.speedingUp[instant]};
}

AllInstants instantsOf(const Model& model, const std::vector<Track>& tracks, const AllInstants* like) {
  AllInstants all;
  all.temperature = true;
  for (const Track& track : tracks) {
    const auto [low, high] = std::minmax_element(track.position.begin(), track.position.end());
    all.turns = all.turns || (model.axis == Axis::rotary && *high - *low > turn_rad);
    all.temperature = all.temperature && !track.temperature.empty();
  }
  if (like != nullptr) {
    all.turns = like->turns;
    all.temperature = all.temperature && like->temperature;
  }
  for (const Track& track : tracks) addTrack(all, model, track);
  return all;
}

}  // namespace breakaway
