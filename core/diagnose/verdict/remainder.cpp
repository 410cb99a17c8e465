#include "diagnose/verdict/remainder.h"

#include <algorithm>
#include <cmath>

#include "base/statistics.h"
#include "diagnose/effects/wording.h"
#include "diagnose/fit/noise_floor.h"
#include "diagnose/fit/windowed_fit.h"
#include "diagnose/simulate/physics.h"
#include "diagnose/verdict/where.h"

namespace breakaway {

namespace {

/// What is left is material if it is `materialFloors` times what sensors and scattering friction explain, and more than
/// the part `share` of the excess error. It is also material if several windows err by more than `farOff` times that:
/// restarts at the edge of standstill don't explain so many or so large errors. Beside a finding more may be left than
/// beside none.
struct Limits {
  double share, farOff;
};
constexpr Limits alone{0.25, 5.0}, besideFindings{0.4, 8.0};
constexpr double materialFloors = 2.5;
/// If the error is so many times what they explain, a smaller share is material, too: such a name is borrowed.
constexpr double glaringFloors = 6.0, glaringShare = 0.05;
/// So large a part of the windows, and at least five of them, isn't far off by accident.
constexpr double farOffPart = 0.05, fewestFarOff = 5.0;
/// Of the drive's peak, or of the friction: less than this doesn't count as a place.
constexpr double immaterialPart = 0.01;
/// Shares of what is unexplained, and the p-value: with less, or more often by chance, it doesn't count as a place.
constexpr double leastInPlace = 0.1, largelyInPlace = 0.25, likeliestByChance = 0.02;
/// If a larger share lies in one place, it isn't scattering friction.
constexpr double mostByScatter = 0.4;

/// Times the error of the window's own replay: less may come from scatter that grows, as near a pendulum's top.
constexpr double farBeyondUsual = 2.0;

/// The windows shifted by half their length, where the next one follows directly. If a drive reverses as often as
/// windows begin, all restarts lie at the edge of standstill; shifted windows begin elsewhere.
std::vector<Window> halfLater(const std::vector<Window>& windows) {
  std::vector<Window> later;
  for (size_t k = 0; k + 1 < windows.size(); ++k) {
    const Window &one = windows[k], &next = windows[k + 1];
    if (next.track != one.track || next.first > one.last + 1 || next.first <= one.first) continue;
    const auto half = [](const Window& window) { return window.first + (window.last - window.first) / 2; };
    later.push_back({one.track, half(one), half(next)});
  }
  return later;
}

bool holds(const Place& place) {
  return place.share >= leastInPlace && place.pValue <= likeliestByChance;
}

/// Whether it is larger than the inaccuracy that every rig has, as a part of its drive. If a large share lies in one
/// place, it may be smaller, but not smaller than the scatter of the friction.
bool notable(const Place& place, const Preparation& prepared, double friction) {
  const Excitation& seen = prepared.seen;
  const bool voltage = place.sizeUnit == "V";
  return (place.share >= largelyInPlace && (voltage || place.size >= immaterialPart * friction)) ||
         place.size >= immaterialPart * (voltage ? seen.peakInput : seen.peakTorque);
}

std::vector<Place> placesOf(const Model& model, const Preparation& prepared, std::uint64_t seed) {
  return places(residualMaps(model, prepared.training, seed), model);
}

/// One model's restarts, in the windows that are scored and between them.
class Restarts {
 public:
  Restarts(const Model& model, const Preparation& prepared, std::uint64_t seed, const TorqueNoise& left)
      : model_(model),
        prepared_(prepared),
        seed_(seed),
        scatter_(usualScatter(prepared.seen.highSpeed, physicsOf(model).coulomb, left)) {}

  const std::vector<double>& squaresLater() {
    if (squaresLater_.empty()) {
      windowsLater_ = halfLater(prepared_.split.trainScore);
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

Remainder beside(const WindowErrors& errors, const Floors& floors, const Limits& limits, Restarts& restarts) {
  Remainder rest;
  rest.floors = floors;
  const double before = typicalSquare(errors.before), after = typicalSquare(errors.after);
  const double unit = floors.perfect * floors.perfect;
  const double most = std::pow(materialFloors * floors.tolerated, 2);
  if (after > most && typicalSquare(restarts.squaresLater()) > most)
    rest.share = std::clamp((after - unit) / std::max(before - unit, 1e-300), 0.0, 1.0);
  const bool glares = rest.share > glaringShare && after > std::pow(glaringFloors * floors.tolerated, 2);
  rest.material = rest.share > limits.share || glares;
  const double ofAll = mean(errors.after) / std::max(mean(errors.before), 1e-300);
  if (!rest.material && ofAll > limits.share && restarts.oftenFarOff(errors.after, limits.farOff * floors.tolerated)) {
    rest.material = true;
    rest.share = std::min(ofAll, 1.0);
  }
  rest.wanders = !rest.material && after > std::pow(materialFloors * floors.perfect, 2);
  return rest;
}

}  // namespace

size_t farOffWindows(const Model& model, const Preparation& prepared, const std::vector<Window>& windows,
                     std::uint64_t seed, const TorqueNoise& left) {
  const Floors floors = floorsOf(model, prepared, windows, seed, left);
  return Restarts(model, prepared, seed, left)
      .farOff(windows, scoreWindows(model, prepared.tracks, windows), besideFindings.farOff * floors.tolerated);
}

std::string farOffText() {
  return std::to_string(std::lround(besideFindings.farOff)) + " times";
}

Floors floorsOf(const Model& model, const Preparation& prepared, const std::vector<Window>& windows, std::uint64_t seed,
                const TorqueNoise& left) {
  const FrictionScatter scatter = usualScatter(prepared.seen.highSpeed, physicsOf(model).coulomb, left);
  return {noiseFloor(model, prepared.tracks, windows, seed),
          noiseFloor(model, prepared.tracks, windows, seed, scatter)};
}

Remainder remainderOf(const Model& model, bool named, const Preparation& prepared, const WindowErrors& errors,
                      const TorqueNoise& left, std::uint64_t seed) {
  const std::vector<Window>& windows = prepared.split.trainScore;
  const Limits& limits = named ? besideFindings : alone;
  Restarts restarts(model, prepared, seed, left);
  Remainder rest = beside(errors, floorsOf(model, prepared, windows, seed, left), limits, restarts);
  if (!rest.wanders) return rest;
  const auto found = placesOf(model, prepared, seed);
  const auto stands = [&, friction = physicsOf(model).coulomb](const Place& place) {
    return holds(place) && notable(place, prepared, friction);
  };
  if (std::none_of(found.begin(), found.end(), stands)) return rest;
  const Floors floors = floorsOf(model, prepared, windows, seed, {});
  const bool clear = std::any_of(found.begin(), found.end(), [&stands](const Place& place) {
    return stands(place) && place.share > mostByScatter;
  });
  const Floors strict{floors.perfect, floors.perfect};
  Restarts placed(model, prepared, seed, {});
  return clear ? beside(errors, strict, {alone.share, besideFindings.farOff}, placed)
               : beside(errors, floors, limits, placed);
}

void findPlaces(Remainder& rest, const Model& model, const Preparation& prepared, std::uint64_t seed) {
  auto left = placesOf(model, prepared, seed);
  std::erase_if(left, [&, friction = physicsOf(model).coulomb](const Place& place) {
    return !notable(place, prepared, friction);
  });
  if (left.empty()) return;
  rest.pValue = left.front().pValue;
  if (!holds(left.front())) return;
  for (Place place : left) {
    place.sentence = "Not explained by any known effect. " + place.sentence;
    rest.where.push_back(std::move(place));
  }
}

std::string wanderRemark(const TorqueNoise& left, double friction, const Excitation& seen) {
  const bool small = left.rms < friction;
  const std::string size = torqueText(left.rms, seen.axis) + " rms (" +
                           digitsText(100.0 * left.rms / (small ? friction : seen.peakTorque)) + " % of the " +
                           (small ? "friction" : "drive's peak") + ")";
  const std::string torque = torqueWord(seen.axis);
  if (!left.usual(friction)) return "taken for a " + torque + " that wanders at random, what is left is " + size;
  return "what is left is no more than a " + torque + " that wanders at random by " + size +
         ", as brushes and bearings make it";
}

}  // namespace breakaway
