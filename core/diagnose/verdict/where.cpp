#include "diagnose/verdict/where.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>

#include "base/numbers.h"
#include "base/statistics.h"
#include "diagnose/simulate/physics.h"
#include "diagnose/verdict/block_maps.h"
#include "diagnose/verdict/foretelling.h"
#include "diagnose/verdict/instants.h"

namespace breakaway {

namespace {

constexpr size_t coarse = 24, fine = 72;  ///< cells of an axis, and of the turn
constexpr int highestOrder = 100;
constexpr size_t speedsEachWay = 5;  ///< classes of speed, equally often seen

struct AxisName {
  const char *name, *rotaryUnit, *linearUnit;
};
constexpr std::array<AxisName, alongs> axes{{{"time", "s", "s"},
                                             {"angle", "rad", "m"},
                                             {"velocity", "rad/s", "m/s"},
                                             {"acceleration", "rad/s²", "m/s²"},
                                             {"current", "Nm", "N"},
                                             {"reversal", "rad", "m"},
                                             {"temperature", "°C", "°C"},
                                             {"current", "A", "A"},
                                             {"acceleration", "rad/s²", "m/s²"}}};

/// A map with the sums that its significance is found from.
struct Candidate {
  ResidualMap map;
  Along axis = alongs;         ///< alongs: the frequency
  std::vector<BlockMap> sums;  ///< any of them may show it
  double total = 0.0;          ///< squares, in the sums' unit
};

/// Leaves of each mean what has the other sign at the mirrored place; where either is unknown, nothing.
void keepOdd(BlockMap& map, double fewest) {
  for (size_t one = 0, other = map.count.size() - 1; one < other; ++one, --other) {
    double &here = map.count[one], &there = map.count[other];
    if (here <= fewest || there <= fewest) here = there = 0.0;
    if (here == 0.0) continue;
    for (size_t block = 0; block < map.sums[one].size(); ++block) {
      const double odd = 0.5 * (map.sums[one][block] / here - map.sums[other][block] / there);
      map.sums[one][block] = odd * here;
      map.sums[other][block] = -odd * there;
    }
  }
}

Candidate mapOver(const Instants& all, Along axis, Unknown shows, const AllInstants& context, Axis rig) {
  Candidate out;
  out.axis = axis;
  out.map.axis = axes[axis].name;
  out.map.along = axis;
  out.map.unit = rig == Axis::rotary ? axes[axis].rotaryUnit : axes[axis].linearUnit;
  out.map.shows = shows;
  std::vector<double> along(all.value.size());
  for (size_t k = 0; k < along.size(); ++k) along[k] = all.place(k, axis, shows);
  const bool round = axis == byAngle && context.turns;
  out.map.withinTurn = context.turns;
  std::vector<double> known;
  std::copy_if(along.begin(), along.end(), std::back_inserter(known), [](double x) { return std::isfinite(x); });
  if (known.size() < 50) return out;
  const bool fromZero = axis == byReversal;
  const bool signedAxis =
      axis == byVelocity || axis == byAcceleration || axis == byTorque || axis == byCurrent || axis == bySpeedingUp;
  const bool narrowNearZero = axis == byVelocity || fromZero;
  double low = round || fromZero ? 0.0 : quantile(known, 0.005), high = round ? turn_rad : quantile(known, 0.995);
  if (signedAxis && low < 0.0 && high > 0.0) {  // no cell has both signs
    high = std::max(-low, high);
    low = -high;
  }
  const double reach = std::max(std::abs(low), std::abs(high));
  const auto squeezed = [=](double x) { return narrowNearZero ? std::copysign(std::sqrt(reach * std::abs(x)), x) : x; };
  const auto stretched = [=](double x) { return narrowNearZero ? std::copysign(x * x / reach, x) : x; };
  low = squeezed(low);
  high = squeezed(high);
  const size_t cells = round ? fine : coarse;
  const double width = (high - low) / static_cast<double>(cells);
  if (!(width > 0.0)) return out;
  BlockMap sums{std::vector<std::vector<double>>(cells, std::vector<double>(context.blocks, 0.0)),
                std::vector<double>(cells, 0.0)};
  std::vector<double> up(cells, 0.0), down(cells, 0.0), ups(cells, 0.0), downs(cells, 0.0);
  for (size_t k = 0; k < along.size(); ++k) {
    if (!std::isfinite(along[k])) continue;
    const auto cell =
        static_cast<size_t>(std::clamp((squeezed(along[k]) - low) / width, 0.0, static_cast<double>(cells) - 0.5));
    const double value = all.shown(k, shows);
    sums.sums[cell][all.block[k]] += value;
    sums.count[cell] += 1.0;
    (all.way[k] > 0.0 ? up : down)[cell] += value;
    (all.way[k] > 0.0 ? ups : downs)[cell] += 1.0;
    out.total += value * value;
  }
  const double fewest =
      std::max(3.0, (narrowNearZero ? 0.01 : 0.05) * static_cast<double>(known.size()) / static_cast<double>(cells));
  // A drive's time error shows alike in gain and loss of speed, friction that lags the other way round.
  if (axis == bySpeedingUp) {
    if (low != -high) return out;
    keepOdd(sums, fewest);
  }
  for (size_t cell = 0; cell < cells; ++cell) {
    const double count = sums.count[cell];
    const auto part = [](double sum, double n) { return n > 2.0 ? sum / n : std::nan(""); };
    const double from = stretched(low + static_cast<double>(cell) * width);
    const double to = stretched(low + static_cast<double>(cell + 1) * width);
    out.map.centre.push_back(0.5 * (from + to));
    out.map.width.push_back(to - from);
    out.map.mean.push_back(count > fewest ? sums.sum(cell) / count : std::nan(""));
    out.map.error.push_back(count > fewest ? sums.error(cell) / count : std::nan(""));
    out.map.rising.push_back(part(up[cell], ups[cell]));
    out.map.falling.push_back(part(down[cell], downs[cell]));
    out.map.count.push_back(count);
    if (!(count > fewest)) sums.count[cell] = 0.0;
  }
  out.sums.push_back(std::move(sums));
  return out;
}

/// Waves per turn. Cells are cosine and sine of each order, of one class of the instants after the other, so that the
/// classes of an order lie side by side.
BlockMap wavesPerTurn(const Instants& all, Unknown shows, size_t blocks, const std::vector<size_t>& classOf,
                      size_t classes) {
  const size_t n = all.value.size(), perOrder = 2 * classes;
  BlockMap waves{std::vector<std::vector<double>>(perOrder * highestOrder, std::vector<double>(blocks, 0.0)),
                 std::vector<double>(perOrder * highestOrder, 0.0), perOrder};
  for (size_t k = 0; k < n; ++k) {
    const double value = all.shown(k, shows);
    const double c = std::cos(all.along[byAngle][k]), s = std::sin(all.along[byAngle][k]);
    double re = 1.0, im = 0.0;
    for (size_t cell = 2 * classOf[k]; cell < waves.sums.size(); cell += perOrder) {
      const double next = re * c - im * s;
      im = re * s + im * c;
      re = next;
      waves.sums[cell][all.block[k]] += value * re;
      waves.sums[cell + 1][all.block[k]] += value * im;
      waves.count[cell] += 0.5;
      waves.count[cell + 1] += 0.5;
    }
  }
  return waves;
}

void addOrders(Candidate& candidate, const Instants& all, size_t blocks) {
  const size_t n = all.value.size();
  candidate.sums.push_back(wavesPerTurn(all, candidate.map.shows, blocks, std::vector<size_t>(n, 0), 1));
  const BlockMap& waves = candidate.sums.back();
  for (size_t order = 0; order < highestOrder; ++order) {
    const double amplitude =
        std::hypot(waves.sum(2 * order), waves.sum(2 * order + 1)) / (0.5 * static_cast<double>(n));
    candidate.map.orders.push_back({static_cast<int>(order) + 1, amplitude});
  }
  std::partial_sort(candidate.map.orders.begin(), candidate.map.orders.begin() + 3, candidate.map.orders.end(),
                    [](const Order& a, const Order& b) { return a.amplitude > b.amplitude; });
  candidate.map.orders.resize(3);
}

/// Torque over the angle that isn't the same at every speed: waves by classes of speed, and the map of the class that
/// shows most.
Candidate overAngleBySpeed(const Instants& all, const AllInstants& context, Axis rig) {
  const std::vector<double>& speed = all.along[byVelocity];
  std::vector<double> limits;  // from the fastest backwards to the fastest forwards
  for (const double way : {-1.0, 1.0}) {
    std::vector<double> seen;
    std::copy_if(speed.begin(), speed.end(), std::back_inserter(seen), [way](double v) { return v * way > 0.0; });
    if (seen.empty()) continue;
    for (size_t part = 0; part < speedsEachWay; ++part)
      limits.push_back(quantile(seen, static_cast<double>(part) / speedsEachWay));
  }
  std::vector<size_t> classOf;
  classOf.reserve(speed.size());
  for (const double v : speed) {
    const auto above = std::upper_bound(limits.begin(), limits.end(), v) - limits.begin();
    classOf.push_back(static_cast<size_t>(std::max<std::ptrdiff_t>(above - 1, 0)));
  }
  BlockMap waves = wavesPerTurn(all, Unknown::torque, context.blocks, classOf, limits.size());
  size_t worst = 0, order = 0;
  double most = 0.0, mostOfOrder = 0.0, ofOrder = 0.0;
  for (size_t cell = 0; cell + 1 < waves.sums.size(); cell += 2) {
    const double energy =
        std::pow(std::hypot(waves.sum(cell), waves.sum(cell + 1)), 2) / std::max(waves.count[cell], 1.0);
    if (cell % waves.together == 0) ofOrder = 0.0;
    ofOrder += energy;
    if (energy > most) {
      most = energy;
      worst = cell / 2 % limits.size();
    }
    if (ofOrder > mostOfOrder) {
      mostOfOrder = ofOrder;
      order = cell / waves.together;
    }
  }
  Instants one;
  double slowest = std::numeric_limits<double>::infinity(), fastest = -slowest;
  for (size_t k = 0; k < speed.size(); ++k) {
    if (classOf[k] != worst) continue;
    slowest = std::min(slowest, speed[k]);
    fastest = std::max(fastest, speed[k]);
    one.value.push_back(all.value[k]);
    one.way.push_back(all.way[k]);
    one.block.push_back(all.block[k]);
    one.along[byAngle].push_back(all.along[byAngle][k]);
  }
  Candidate out = mapOver(one, byAngle, Unknown::torque, context, rig);
  if (out.map.centre.empty()) return out;
  addOrders(out, one, context.blocks);
  out.map.fromSpeed = slowest;
  out.map.toSpeed = fastest;
  out.map.waveOrder = static_cast<int>(order) + 1;
  for (size_t speeds = 0; speeds < limits.size(); ++speeds) {
    const size_t cell = order * waves.together + 2 * speeds;
    const double count = std::max(waves.count[cell], 1.0);
    out.map.waves.push_back({limits[speeds], waves.sum(cell) / count, waves.sum(cell + 1) / count});
  }
  out.sums = {std::move(waves)};
  out.total = std::inner_product(all.value.begin(), all.value.end(), all.value.begin(), 0.0);
  return out;
}

Candidate overFrequency(const ResidualSpectrum& spectrum, size_t blocks) {
  Candidate out;
  out.map.axis = "frequency";
  out.map.unit = "Hz";
  for (const auto& band : spectrum.bands()) {
    out.map.centre.push_back(0.5 * (band.from_Hz + band.to_Hz));
    out.map.width.push_back(band.to_Hz - band.from_Hz);
    const bool heard = band.torque > 0.0;
    out.map.mean.push_back(heard ? band.torque : std::nan(""));
    out.map.error.push_back(heard ? band.error : std::nan(""));
    out.map.count.push_back(band.count);
  }
  out.map.rising = out.map.falling = std::vector<double>(out.map.centre.size(), std::nan(""));
  out.map.answer = spectrum.answer();
  out.sums.push_back(spectrum.map(blocks));
  out.total = spectrum.total();
  return out;
}

}  // namespace

double ResidualMap::at(double place) const {
  if (centre.empty()) return 0.0;
  // Cells follow one another.
  auto cell = static_cast<size_t>(std::lower_bound(centre.begin(), centre.end(), place) - centre.begin());
  if (cell == centre.size() || (cell > 0 && place < centre[cell] - 0.5 * width[cell])) --cell;
  const bool inside = std::abs(place - centre[cell]) <= 0.5 * width[cell] * (1.0 + 1e-9);
  return inside && std::isfinite(mean[cell]) ? mean[cell] : 0.0;
}

double ResidualMap::at(double place, double speed) const {
  if (waves.empty()) return at(place);
  auto next = std::upper_bound(waves.begin(), waves.end(), speed,
                               [](double v, const WaveFrom& wave) { return v < wave.speed; });
  if (next != waves.begin()) --next;  // slower than any that was seen: as the slowest
  return next->cosine * std::cos(waveOrder * place) + next->sine * std::sin(waveOrder * place);
}

/// How many seconds of a torque that wanders are one event: two correlation times, while enough events are left to
/// flip.
static size_t secondsTogether(double wander_s, size_t seconds) {
  constexpr size_t fewestEvents = 12;
  const double lasts_s = std::ceil(2.0 * wander_s);
  const size_t most = std::max<size_t>(1, seconds / fewestEvents);
  return lasts_s < static_cast<double>(most) ? std::max<size_t>(1, static_cast<size_t>(lasts_s)) : most;
}

std::vector<ResidualMap> residualMaps(const Model& model, const std::vector<Track>& tracks, std::uint64_t seed,
                                      const std::vector<Track>& heldout, double wander_s) {
  const AllInstants all = instantsOf(model, tracks), kept = instantsOf(model, heldout, &all);
  std::vector<Candidate> candidates;
  const auto add = [&](Along axis, Unknown shows) {
    const Instants& instants = all.of(shows);
    Candidate candidate = mapOver(instants, axis, shows, all, model.axis);
    if (candidate.map.centre.empty()) return;
    if (axis == byAngle && all.turns) addOrders(candidate, instants, all.blocks);
    candidates.push_back(std::move(candidate));
    if (axis != byAngle || shows != Unknown::torque || !all.turns) return;
    Candidate bySpeed = overAngleBySpeed(instants, all, model.axis);
    if (!bySpeed.map.centre.empty()) candidates.push_back(std::move(bySpeed));
  };
  for (const Along axis : {byTime, byAngle, byVelocity, byAcceleration, byTorque}) add(axis, Unknown::torque);
  for (const Along axis : {byTime, byAngle, byTorque, byReversal, bySpeedingUp}) add(axis, Unknown::friction);
  if (all.temperature) add(byTemperature, Unknown::friction);
  if (!all.electrical.value.empty()) add(byCurrent, Unknown::voltage);
  if (!candidates.empty()) {
    Candidate spectrum = overFrequency(all.spectrum, all.blocks);
    if (!spectrum.map.centre.empty()) candidates.push_back(std::move(spectrum));
  }
  std::vector<BlockMap> sums;
  for (Candidate& one : candidates) std::move(one.sums.begin(), one.sums.end(), std::back_inserter(sums));
  const std::vector<Significance> found = significances(sums, all.blocks, seed, secondsTogether(wander_s, all.blocks));
  // Lost voltage counts by the torque that it costs, beside the unexplained torque.
  const Physics p = physicsOf(model);
  const double torquePerVolt = p.electrical ? p.torqueConstant / p.resistance : 0.0;
  const double mechanical = rms(all.mechanical.value), electrical = torquePerVolt * rms(all.electrical.value);
  const double weight = electrical * electrical / std::max(mechanical * mechanical + electrical * electrical, 1e-300);
  std::vector<ResidualMap> maps;
  size_t at = 0;
  for (Candidate& one : candidates) {
    double energy = 0.0;
    for (size_t part = 0; part < one.sums.size(); ++part, ++at) {
      energy = std::max(energy, found[at].energy);
      one.map.pValue = std::min(one.map.pValue, found[at].pValue);
    }
    one.map.share = one.total > 0.0 ? std::clamp(energy / one.total, 0.0, 1.0) : 0.0;
    if (one.map.shows == Unknown::voltage) one.map.share *= weight;
    if (!heldout.empty()) {
      one.map.foretells = one.axis == alongs ? foretold(all.spectrum, kept.spectrum, seed)
                                             : foretold(one.map, one.axis, kept.of(one.map.shows), seed);
    }
    maps.push_back(std::move(one.map));
  }
  return maps;
}

}  // namespace breakaway
