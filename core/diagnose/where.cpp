#include "diagnose/where.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "base/statistics.h"
#include "diagnose/effects/wording.h"
#include "diagnose/fit/inverse_rows.h"
#include "diagnose/simulate/physics.h"

namespace breakaway {

namespace {

constexpr size_t bins = 16;
constexpr size_t flips = 499;
constexpr double smoothing_Hz = 25.0;
constexpr double turn = 2.0 * std::numbers::pi;

/// Unexplained torque at single instants, with what it may depend on.
struct Instants {
  std::vector<double> torque;
  std::vector<size_t> block;  ///< stretches of one second, across tracks
  size_t blocks = 0;
  std::vector<std::vector<double>> along;  ///< one vector per axis, in the order of axesOf()
};

struct AxisName {
  const char* name;
  const char* rotaryUnit;
  const char* linearUnit;
};
constexpr std::array<AxisName, 6> axes{{{"time", "s", "s"},
                                        {"angle", "rad", "m"},
                                        {"velocity", "rad/s", "m/s"},
                                        {"acceleration", "rad/s²", "m/s²"},
                                        {"current", "Nm", "N"},
                                        {"reversal", "rad", "m"}}};

void addTrack(Instants& all, const Model& model, const Track& track, bool wrap) {
  const Physics p = physicsOf(model);
  const auto terms = termsOf(model);
  const InverseRows rows = inverseRows(track);
  const size_t n = rows.time.size();
  std::vector<double> torque(n), drive(n), travel(n);
  double since = 0.0, way = 0.0;
  for (size_t k = 0; k < n; ++k) {
    const double v = rows.velocity[k], s = v > 0.0 ? 1.0 : -1.0;
    if (std::abs(v) > 4.0 * rows.velocityNoise && s != way) {
      way = s;
      since = rows.position[k];
    }
    travel[k] = std::abs(rows.position[k] - since);
    drive[k] = p.torqueConstant * (p.electrical ? (rows.input[k] - p.backEmf * v) / p.resistance : rows.input[k]);
    Situation at;
    at.axis = model.axis;
    at.time_s = rows.time[k];
    at.position = rows.position[k];
    at.velocity = v;
    at.acceleration = rows.acceleration[k];
    at.driveTorque = drive[k];
    at.direction = s;
    at.current = drive[k] / p.torqueConstant;
    at.travel = travel[k];
    double needed = p.inertia * rows.acceleration[k] + p.viscous * v + s * p.coulomb +
                    p.gravity * std::sin(rows.position[k] - p.downAngle);
    for (const CompiledTerm& term : *terms) {
      if (term.effect->memory() > 0) continue;
      const Term part = term.effect->term(term.parameters, at);
      needed += part.load_Nm + s * part.friction_Nm;
    }
    torque[k] = drive[k] - needed;
  }
  const double cutoff = std::min(smoothing_Hz, 0.05 / rows.step_s);
  lowPass(torque, rows.step_s, cutoff);
  const auto every = std::max<size_t>(1, static_cast<size_t>(1.0 / (4.0 * cutoff * rows.step_s)));
  const size_t firstBlock = all.blocks;
  for (size_t k = 0; k < n; k += every) {
    if (!rows.moving[k]) continue;
    const double angle = wrap ? rows.position[k] - turn * std::floor(rows.position[k] / turn) : rows.position[k];
    const std::array<double, axes.size()> values{track.origin_s + rows.time[k], angle,    rows.velocity[k],
                                                 rows.acceleration[k],          drive[k], travel[k]};
    all.torque.push_back(torque[k]);
    all.block.push_back(firstBlock + static_cast<size_t>(rows.time[k]));
    all.blocks = std::max(all.blocks, all.block.back() + 1);
    for (size_t a = 0; a < axes.size(); ++a) all.along[a].push_back(values[a]);
  }
}

ResidualMap mapOver(const Instants& all, size_t axis, const Model& model, std::uint64_t seed) {
  const std::vector<double>& along = all.along[axis];
  ResidualMap map;
  map.axis = axes[axis].name;
  map.unit = model.axis == Axis::rotary ? axes[axis].rotaryUnit : axes[axis].linearUnit;
  const double low = quantile(along, 0.005), high = quantile(along, 0.995);
  const double width = (high - low) / static_cast<double>(bins);
  if (!(width > 0.0)) return map;
  std::vector<size_t> bin(along.size());
  std::vector<std::vector<double>> sums(bins, std::vector<double>(all.blocks, 0.0));
  map.count.assign(bins, 0.0);
  double total = 0.0;
  for (size_t k = 0; k < along.size(); ++k) {
    bin[k] = static_cast<size_t>(std::clamp((along[k] - low) / width, 0.0, static_cast<double>(bins) - 0.5));
    sums[bin[k]][all.block[k]] += all.torque[k];
    map.count[bin[k]] += 1.0;
    total += all.torque[k] * all.torque[k];
  }
  const double fewest = 0.002 * static_cast<double>(along.size());
  double explained = 0.0;
  std::vector<double> score(bins, 0.0), spread(bins, 0.0);
  for (size_t b = 0; b < bins; ++b) {
    map.centre.push_back(low + (static_cast<double>(b) + 0.5) * width);
    for (const double sum : sums[b]) {
      score[b] += sum;
      spread[b] += sum * sum;
    }
    spread[b] = std::sqrt(spread[b]);
    const bool enough = map.count[b] > fewest;
    map.mean_Nm.push_back(enough ? score[b] / map.count[b] : std::nan(""));
    map.error_Nm.push_back(enough ? spread[b] / map.count[b] : std::nan(""));
    if (enough) explained += score[b] * score[b] / map.count[b];
  }
  map.share = total > 0.0 ? std::clamp(explained / total, 0.0, 1.0) : 0.0;
  // The map's whole energy against that of maps whose seconds have random signs.
  Random random(seed + axis);
  size_t beaten = 0;
  std::vector<double> sign(all.blocks);
  for (size_t flip = 0; flip < flips; ++flip) {
    for (double& one : sign) one = random.bits() >> 63 ? 1.0 : -1.0;
    double energy = 0.0;
    for (size_t b = 0; b < bins; ++b) {
      if (!(map.count[b] > fewest)) continue;
      double sum = 0.0;
      for (size_t block = 0; block < all.blocks; ++block) sum += sign[block] * sums[b][block];
      energy += sum * sum / map.count[b];
    }
    if (energy >= explained) ++beaten;
  }
  // Six axes are looked at: Bonferroni.
  map.pValue = std::min(
      1.0, static_cast<double>(axes.size()) * static_cast<double>(1 + beaten) / static_cast<double>(1 + flips));
  return map;
}

Place placeOf(const ResidualMap& map, const Model& model) {
  size_t worst = 0;
  double most = -1.0;
  for (size_t b = 0; b < map.centre.size(); ++b) {
    const double energy = std::isfinite(map.mean_Nm[b]) ? map.mean_Nm[b] * map.mean_Nm[b] * map.count[b] : -1.0;
    if (energy > most) {
      most = energy;
      worst = b;
    }
  }
  const double sign = map.mean_Nm[worst] > 0.0 ? 1.0 : -1.0;
  const auto belongs = [&](size_t b) { return sign * map.mean_Nm[b] > 0.5 * std::abs(map.mean_Nm[worst]); };
  size_t first = worst, last = worst;
  while (first > 0 && belongs(first - 1)) --first;
  while (last + 1 < map.centre.size() && belongs(last + 1)) ++last;
  double energy = 0.0, all = 0.0, torque = 0.0, count = 0.0;
  for (size_t b = 0; b < map.centre.size(); ++b) {
    if (!std::isfinite(map.mean_Nm[b])) continue;
    const double one = map.mean_Nm[b] * map.mean_Nm[b] * map.count[b];
    all += one;
    if (b < first || b > last) continue;
    energy += one;
    torque += map.mean_Nm[b] * map.count[b];
    count += map.count[b];
  }
  const double half = 0.5 * (map.centre[1] - map.centre[0]);
  Place place{map.axis,
              map.centre[first] - half,
              map.centre[last] + half,
              map.unit,
              map.share * energy / std::max(all, 1e-300),
              map.pValue,
              {}};
  char range[120];
  std::snprintf(range, sizeof range, "between %.3g and %.3g %s", place.from, place.to, map.unit.c_str());
  const std::string what = map.axis == "reversal"  ? "travel since the last reversal"
                           : map.axis == "current" ? (model.axis == Axis::rotary ? "motor torque" : "motor force")
                           : map.axis == "angle" && model.axis == Axis::linear ? "position"
                                                                               : map.axis;
  place.sentence = "At a " + what + " " + range + " the motor gives " +
                   torqueText(std::abs(torque / std::max(count, 1.0)), model.axis) + (sign > 0.0 ? " more" : " less") +
                   " than the simple model needs.";
  return place;
}

}  // namespace

std::vector<ResidualMap> residualMaps(const Model& model, const std::vector<Track>& tracks, std::uint64_t seed) {
  Instants all;
  all.along.resize(axes.size());
  bool wrap = false;
  for (const Track& track : tracks) {
    const auto [low, high] = std::minmax_element(track.position.begin(), track.position.end());
    wrap = wrap || (model.axis == Axis::rotary && *high - *low > turn);
  }
  for (const Track& track : tracks) addTrack(all, model, track, wrap);
  std::vector<ResidualMap> maps;
  if (all.torque.size() < 50) return maps;
  for (size_t axis = 0; axis < axes.size(); ++axis) {
    ResidualMap map = mapOver(all, axis, model, seed);
    if (!map.centre.empty()) maps.push_back(std::move(map));
  }
  return maps;
}

std::vector<Place> places(const std::vector<ResidualMap>& maps, const Model& model) {
  std::vector<Place> found;
  for (const ResidualMap& map : maps) {
    if (map.pValue <= 0.05) found.push_back(placeOf(map, model));
  }
  std::stable_sort(found.begin(), found.end(), [](const Place& a, const Place& b) { return a.share > b.share; });
  return found;
}

}  // namespace breakaway
