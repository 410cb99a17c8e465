#include "diagnose/verdict/remainder.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/statistics.h"
#include "diagnose/effects/wording.h"
#include "diagnose/fit/noise_floor.h"
#include "diagnose/fit/torque_noise.h"
#include "diagnose/fit/torque_residual.h"
#include "diagnose/fit/windowed_fit.h"
#include "diagnose/simulate/physics.h"
#include "diagnose/verdict/foretelling.h"
#include "diagnose/verdict/where.h"

namespace breakaway {

namespace {

/// The windows shifted by half their length, where the next one follows directly. If a drive reverses as often as
/// windows begin, all restarts lie at the edge of standstill; shifted windows begin elsewhere.
std::vector<Window> halfLater(const std::vector<Window>& windows, const std::vector<Track>& tracks) {
  std::vector<Window> later;
  for (size_t k = 0; k + 1 < windows.size(); ++k) {
    const Window &one = windows[k], &next = windows[k + 1];
    if (next.track != one.track || next.first > one.last + 1 || next.first <= one.first) continue;
    const auto half = [](const Window& window) { return window.first + (window.last - window.first) / 2; };
    const Window between{one.track, half(one), half(next), one.errorIn};
    if (isLongEnough(tracks[one.track], between, 1)) later.push_back(between);  // it may lie where nothing moves
  }
  return later;
}

/// Whether a place in the voltage is more than the inaccuracy that every rig has.
bool showsInVoltage(const Place& place, const Excitation& seen, const Criteria& criteria) {
  const double foretold = std::clamp(place.foretells.value / place.share, 0.0, 1.0);
  return place.share >= criteria.little && place.size * std::sqrt(foretold) >= criteria.immaterial * seen.peakInput;
}

/// One model's restarts, in the windows that are scored and between them.
class Restarts {
 public:
  Restarts(const Model& model, const Preparation& prepared, std::uint64_t seed, const TorqueNoise& left)
      : model_(model),
        prepared_(prepared),
        seed_(seed),
        scatter_(usualScatter(prepared.seen, physicsOf(model).coulomb, left, prepared.criteria)) {}

  const std::vector<double>& squaresLater() {
    if (squaresLater_.empty()) {
      windowsLater_ = halfLater(prepared_.split.trainScore, prepared_.tracks);
      squaresLater_ = scoreWindows(model_, prepared_.tracks, windowsLater_);
    }
    return squaresLater_;
  }

  /// The windows that err by more than `limit`, and by far more than scattering friction makes of them.
  size_t farOff(const std::vector<Window>& windows, const std::vector<double>& squares, double limit) const {
    std::vector<Window> beyond;
    std::vector<double> errors;
    for (size_t w = 0; w < windows.size(); ++w) {
      if (squares[w] <= limit * limit) continue;
      beyond.push_back(windows[w]);
      errors.push_back(squares[w]);
    }
    if (beyond.empty()) return 0;
    const auto usual = usualSquares(model_, prepared_.tracks, beyond, seed_, scatter_);
    size_t count = 0;
    for (size_t w = 0; w < beyond.size(); ++w)
      count += errors[w] > std::pow(prepared_.criteria.nearFloor, 2) * usual[w] ? 1 : 0;
    return count;
  }
  /// Whether so many windows are far off that it isn't accidental, in both sets of windows.
  bool oftenFarOff(const std::vector<double>& squares, double limit) {
    return often(prepared_.split.trainScore, squares, limit) && often(windowsLater_, squaresLater(), limit);
  }

 private:
  bool often(const std::vector<Window>& windows, const std::vector<double>& squares, double limit) const {
    const double enough =
        std::max(prepared_.criteria.fewestFarOff, prepared_.criteria.soundPart * static_cast<double>(windows.size()));
    const auto far = std::count_if(squares.begin(), squares.end(), [limit](double one) { return one > limit * limit; });
    return static_cast<double>(far) >= enough && static_cast<double>(farOff(windows, squares, limit)) >= enough;
  }

  const Model& model_;
  const Preparation& prepared_;
  std::uint64_t seed_;
  FrictionScatter scatter_;
  std::vector<Window> windowsLater_;
  std::vector<double> squaresLater_;
};

}  // namespace

size_t farOffWindows(const Model& model, const Preparation& prepared, const std::vector<Window>& windows,
                     std::uint64_t seed, const TorqueNoise& left) {
  const Floors floors = floorsOf(model, prepared, windows, seed, left);
  return Restarts(model, prepared, seed, left)
      .farOff(windows, scoreWindows(model, prepared.tracks, windows), prepared.criteria.farOff * floors.withWander);
}

Message farOffText(const Criteria& criteria) {
  return message("{} times", digitsText(criteria.farOff));
}

/// `left` with no more torque than the training windows' squared errors, `squares`, have room for: a torque that
/// wandered as `left` would make them err by itself. Only windows in which a small cause doesn't grow tell.
static TorqueNoise asWindowsShow(TorqueNoise left, const Model& model, const Preparation& prepared,
                                 const std::vector<double>& squares, double perfect, std::uint64_t seed) {
  if (!(left.rms > 0.0)) return left;
  const std::vector<Window>& windows = prepared.split.trainScore;
  FrictionScatter scatter = usualScatter(prepared.seen, physicsOf(model).coulomb, {}, prepared.criteria);
  const auto usual = usualSquares(model, prepared.tracks, windows, seed, scatter);
  std::vector<Window> calm;
  double shown = 0.0, usually = 0.0;
  for (size_t w = 0; w < windows.size(); ++w) {
    if (usual[w] > std::pow(prepared.criteria.nearFloor * perfect, 2)) continue;
    calm.push_back(windows[w]);
    shown += squares[w];
    usually += usual[w];
  }
  scatter.wander = left.rms;
  scatter.wander_s = left.time_s;
  const auto wandering = usualSquares(model, prepared.tracks, calm, seed, scatter);
  const double own = std::accumulate(wandering.begin(), wandering.end(), 0.0);
  if (own <= shown) return left;
  const double part = std::sqrt(std::max(shown - usually, 0.0) / (own - usually));
  left.rms *= part;
  left.ratio *= part;
  return left;
}

Floors floorsOf(const Model& model, const Preparation& prepared, const std::vector<Window>& windows, std::uint64_t seed,
                const TorqueNoise& left) {
  const FrictionScatter scatter = usualScatter(prepared.seen, physicsOf(model).coulomb, left, prepared.criteria);
  return {noiseFloor(model, prepared.tracks, windows, seed),
          noiseFloor(model, prepared.tracks, windows, seed, scatter)};
}

Remainder remainderOf(const Model& model, const Preparation& prepared, const WindowErrors& errors,
                      const TorqueNoise& left, std::uint64_t seed) {
  const Criteria& criteria = prepared.criteria;
  Remainder rest;
  const double before = typicalSquare(errors.before), after = typicalSquare(errors.after);
  const std::vector<Window>& windows = prepared.split.trainScore;
  rest.floors.perfect = noiseFloor(model, prepared.tracks, windows, seed);
  rest.wander = asWindowsShow(left, model, prepared, errors.after, rest.floors.perfect, seed);
  rest.floors.withWander =
      noiseFloor(model, prepared.tracks, windows, seed,
                 usualScatter(prepared.seen, physicsOf(model).coulomb, rest.wander, prepared.criteria));
  Restarts restarts(model, prepared, seed, rest.wander);
  const double unit = rest.floors.perfect * rest.floors.perfect;
  const auto exceeds = [&](double floors, double floor) {
    const double most = std::pow(floors * floor, 2);
    return after > most && typicalSquare(restarts.squaresLater()) > most;
  };
  rest.part = std::clamp((after - unit) / std::max(before - unit, 1e-300), 0.0, 1.0);
  if (exceeds(criteria.material, rest.floors.withWander)) rest.share = rest.part;
  const bool typically = exceeds(criteria.atFloor, rest.floors.perfect);
  rest.aboveFloor = typically || restarts.oftenFarOff(errors.after, criteria.farOff * rest.floors.withWander);
  rest.wanders =
      typically && lastingRms(rest.wander) >
                       criteria.beyondChance * mostWander(physicsOf(model).coulomb, prepared.seen.peakTorque, criteria);
  rest.muchIsLeft = rest.part > criteria.soundPart;
  return rest;
}

bool Remainder::outside() const {
  return muchIsLeft && (wanders || !where.empty());
}

void findPlaces(Remainder& rest, const Model& model, const Preparation& prepared, std::uint64_t seed) {
  if (!rest.aboveFloor) return;
  const double lasts_s = rest.wander.rms > 0.0 ? rest.wander.time_s : 0.0;
  std::vector<ResidualMap> maps = residualMaps(model, prepared.training, seed, heldoutTracks(prepared), lasts_s);
  const Criteria& criteria = prepared.criteria;
  const ForetoldWindows windows(model, prepared);
  std::erase_if(maps, [&](const ResidualMap& map) {
    if (map.foretells.low95 <= 0.0) return true;
    return map.shows != Unknown::voltage && windows.foretold(map, seed).low95 < criteria.soundPart;
  });
  const double usual = mostWander(physicsOf(model).coulomb, prepared.seen.peakTorque, criteria);
  // Through a controller friction that wanders goes along with drive, speed and acceleration, and by itself with time:
  // there a place has to be more than that. And it has to foretell by itself, not by what its axis shows elsewhere.
  const auto isMore = [&](const Place& place) {
    const auto map = std::find_if(maps.begin(), maps.end(), [&place](const ResidualMap& one) {
      return one.axis == place.axis && one.shows == place.shows && one.ofSomeSpeeds() == place.ofSomeSpeeds;
    });
    const bool apart = map->along == byAngle || map->along == byReversal || map->along == byTemperature;
    return place.size >= (apart ? prepared.seen.immaterialTorque() : usual) &&
           windows.foretold(onlyThere(*map, place, criteria), seed).low95 >= criteria.soundPart;
  };
  for (Place& place : places(maps, model, criteria)) {
    if (place.pValue > criteria.likeliestByChance) continue;
    if (place.shows == Unknown::voltage ? !showsInVoltage(place, prepared.seen, criteria) : !isMore(place)) continue;
    if (rest.where.empty()) rest.pValue = place.pValue;
    place.sentence = message("Not explained by any known effect. {}", place.sentence);
    rest.where.push_back(std::move(place));
  }
}

Message wanderRemark(const TorqueNoise& left, double friction, const Excitation& seen, const Criteria& criteria) {
  const bool small = left.rms < friction;
  const double part = left.rms / (small ? friction : seen.peakTorque);
  const bool sound = lastingRms(left) <= mostWander(friction, seen.peakTorque, criteria);
  return message("{} changes at random by {} rms, {} % of the {}: {}", torqueWord(seen.axis),
                 torqueText(left.rms, seen.axis), digitsText(100.0 * part),
                 small ? message("friction") : message("drive's peak"),
                 sound ? message("usual for brushes and bearings") : message("more than brushes and bearings do"));
}

}  // namespace breakaway
