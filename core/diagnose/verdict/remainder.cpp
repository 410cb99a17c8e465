#include "diagnose/verdict/remainder.h"

#include <algorithm>
#include <cmath>

#include "base/statistics.h"
#include "diagnose/effects/wording.h"
#include "diagnose/fit/noise_floor.h"
#include "diagnose/fit/torque_residual.h"
#include "diagnose/fit/windowed_fit.h"
#include "diagnose/simulate/physics.h"
#include "diagnose/verdict/foretelling.h"
#include "diagnose/verdict/where.h"

namespace breakaway {

namespace {

/// Times the floor: what errs by less is a perfect model as far as sensors can tell.
constexpr double clearFloors = 1.6;
/// Times the floor with wander: what errs by less lacks nothing that a sound rig hasn't.
constexpr double materialFloors = 2.5;
/// Of the base model's excess: what findings leave of it is no more than their own inexactness.
constexpr double leastPart = 0.05;
/// Several windows that err by so many times what sensors and scattering friction explain: restarts at the edge of
/// standstill don't explain so many or so large errors.
constexpr double farOffFloors = 8.0;
/// So large a part of the windows, and at least five of them, isn't far off by accident.
constexpr double farOffPart = 0.05, fewestFarOff = 5.0;
/// Of the held-out windows' squared error a place surely takes away so much, as much as any rig may lack: what pays
/// less doesn't count.
constexpr double leastTaken = 0.05;
/// A place more often by chance doesn't count.
constexpr double likeliestByChance = 0.02;
/// A place in the voltage moves nothing, so that windows don't show it: its part of what is unexplained, and its size
/// as a part of the drive's peak.
constexpr double leastInPlace = 0.1, immaterialPart = 0.01;

/// Times the error of the window's own replay: less may come from scatter that grows, as near a pendulum's top.
constexpr double farBeyondUsual = 2.0;

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
bool showsInVoltage(const Place& place, const Excitation& seen) {
  const double foretold = std::clamp(place.foretells.value / place.share, 0.0, 1.0);
  return place.share >= leastInPlace && place.size * std::sqrt(foretold) >= immaterialPart * seen.peakInput;
}

/// One model's restarts, in the windows that are scored and between them.
class Restarts {
 public:
  Restarts(const Model& model, const Preparation& prepared, std::uint64_t seed, const TorqueNoise& left)
      : model_(model),
        prepared_(prepared),
        seed_(seed),
        scatter_(usualScatter(prepared.seen, physicsOf(model).coulomb, left)) {}

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
    for (size_t w = 0; w < beyond.size(); ++w) count += errors[w] > farBeyondUsual * farBeyondUsual * usual[w] ? 1 : 0;
    return count;
  }
  /// Whether so many windows are far off that it isn't accidental, in both sets of windows.
  bool oftenFarOff(const std::vector<double>& squares, double limit) {
    return often(prepared_.split.trainScore, squares, limit) && often(windowsLater_, squaresLater(), limit);
  }

 private:
  bool often(const std::vector<Window>& windows, const std::vector<double>& squares, double limit) const {
    const double enough = std::max(fewestFarOff, farOffPart * static_cast<double>(windows.size()));
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
      .farOff(windows, scoreWindows(model, prepared.tracks, windows), farOffFloors * floors.withWander);
}

std::string farOffText() {
  return std::to_string(std::lround(farOffFloors)) + " times";
}

/// `left` with no more torque than a mean squared error of `shown` over the training windows has room for: a torque
/// that wandered as `left` would make them err by itself.
static TorqueNoise asWindowsShow(TorqueNoise left, const Model& model, const Preparation& prepared, double shown,
                                 double perfect, std::uint64_t seed) {
  if (!(left.rms > 0.0)) return left;
  const double wandering = noiseFloor(model, prepared.tracks, prepared.split.trainScore, seed,
                                      {.wander = left.rms, .wander_s = left.time_s});
  const double own = wandering * wandering - perfect * perfect;
  if (own <= shown) return left;
  const double part = std::sqrt(shown / own);
  left.rms *= part;
  left.ratio *= part;
  return left;
}

Floors floorsOf(const Model& model, const Preparation& prepared, const std::vector<Window>& windows, std::uint64_t seed,
                const TorqueNoise& left) {
  const FrictionScatter scatter = usualScatter(prepared.seen, physicsOf(model).coulomb, left);
  return {noiseFloor(model, prepared.tracks, windows, seed),
          noiseFloor(model, prepared.tracks, windows, seed, scatter)};
}

Remainder remainderOf(const Model& model, const Preparation& prepared, const WindowErrors& errors,
                      const TorqueNoise& left, std::uint64_t seed) {
  Remainder rest;
  const double before = typicalSquare(errors.before), after = typicalSquare(errors.after);
  const std::vector<Window>& windows = prepared.split.trainScore;
  rest.floors.perfect = noiseFloor(model, prepared.tracks, windows, seed);
  rest.wander = asWindowsShow(left, model, prepared, after, rest.floors.perfect, seed);
  rest.floors.withWander = noiseFloor(model, prepared.tracks, windows, seed,
                                      usualScatter(prepared.seen, physicsOf(model).coulomb, rest.wander));
  Restarts restarts(model, prepared, seed, rest.wander);
  const double unit = rest.floors.perfect * rest.floors.perfect;
  const auto exceeds = [&](double floors, double floor) {
    const double most = std::pow(floors * floor, 2);
    return after > most && typicalSquare(restarts.squaresLater()) > most;
  };
  rest.part = std::clamp((after - unit) / std::max(before - unit, 1e-300), 0.0, 1.0);
  if (exceeds(materialFloors, rest.floors.withWander)) rest.share = rest.part;
  const bool typically = exceeds(clearFloors, rest.floors.perfect);
  rest.aboveFloor = typically || restarts.oftenFarOff(errors.after, farOffFloors * rest.floors.withWander);
  rest.wanders = typically && rest.wander.rms > mostWander(physicsOf(model).coulomb, prepared.seen.peakTorque);
  return rest;
}

bool Remainder::outside() const {
  return part > leastPart && (wanders || !where.empty());
}

void findPlaces(Remainder& rest, const Model& model, const Preparation& prepared, std::uint64_t seed) {
  if (!rest.aboveFloor) return;
  std::vector<ResidualMap> maps = residualMaps(model, prepared.training, seed, heldoutTracks(prepared));
  const ForetoldWindows windows(model, prepared);
  std::erase_if(maps, [&](const ResidualMap& map) {
    if (map.foretells.low95 <= 0.0) return true;
    return map.shows != Unknown::voltage && windows.foretold(map, seed).low95 < leastTaken;
  });
  for (Place& place : places(maps, model)) {
    if (place.pValue > likeliestByChance) continue;
    if (place.shows == Unknown::voltage && !showsInVoltage(place, prepared.seen)) continue;
    if (rest.where.empty()) rest.pValue = place.pValue;
    place.sentence = "Not explained by any known effect. " + place.sentence;
    rest.where.push_back(std::move(place));
  }
}

std::string wanderRemark(const TorqueNoise& left, double friction, const Excitation& seen) {
  const bool small = left.rms < friction;
  const double part = left.rms / (small ? friction : seen.peakTorque);
  const std::string size = torqueText(left.rms, seen.axis) + " rms, " + digitsText(100.0 * part) + " % of the " +
                           (small ? "friction" : "drive's peak");
  const bool sound = left.rms <= mostWander(friction, seen.peakTorque);
  return torqueWord(seen.axis) + " changes at random by " + size +
         (sound ? ": usual for brushes and bearings" : ": more than brushes and bearings do");
}

}  // namespace breakaway
