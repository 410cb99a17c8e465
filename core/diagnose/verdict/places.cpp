// From maps of the unexplained to places and sentences.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "base/numbers.h"
#include "diagnose/effects/wording.h"
#include "diagnose/verdict/where.h"

namespace breakaway {

namespace {

struct Stretch {
  size_t first = 0, last = 0;
  double mean = 0.0, rising = 0.0, falling = 0.0;
  double share = 0.0;  ///< of the map's energy
};

/// Whether one order of the turn is clearly the strongest.
bool isWave(const ResidualMap& map, const Criteria& criteria) {
  return !map.orders.empty() && map.orders[0].amplitude > criteria.clearlyMore() * map.orders[1].amplitude;
}

double energyOf(const ResidualMap& map, size_t cell) {
  return std::isfinite(map.mean[cell]) ? map.mean[cell] * map.mean[cell] * map.count[cell] : 0.0;
}

double meanOver(const ResidualMap& map, const std::vector<double>& values, size_t first, size_t last) {
  double sum = 0.0, count = 0.0;
  for (size_t cell = first; cell <= last; ++cell) {
    if (!std::isfinite(values[cell])) continue;
    sum += values[cell] * map.count[cell];
    count += map.count[cell];
  }
  return count > 0.0 ? sum / count : std::nan("");
}

/// The stretch of one sign around the cell with the most energy.
Stretch worstStretch(const ResidualMap& map, const Criteria& criteria) {
  size_t worst = 0;
  double all = 0.0;
  for (size_t cell = 0; cell < map.centre.size(); ++cell) {
    all += energyOf(map, cell);
    if (energyOf(map, cell) > energyOf(map, worst)) worst = cell;
  }
  const auto part = [&](size_t cell) { return map.mean[cell] / map.mean[worst] > criteria.half; };
  Stretch out{worst, worst};
  while (out.first > 0 && part(out.first - 1)) --out.first;
  while (out.last + 1 < map.centre.size() && part(out.last + 1)) ++out.last;
  out.mean = meanOver(map, map.mean, out.first, out.last);
  out.rising = meanOver(map, map.rising, out.first, out.last);
  out.falling = meanOver(map, map.falling, out.first, out.last);
  for (size_t cell = out.first; cell <= out.last; ++cell) out.share += energyOf(map, cell) / std::max(all, 1e-300);
  return out;
}

/// The value of the map at the mirrored place, for what depends on the sign.
double mirrored(const ResidualMap& map, double from, double to) {
  double sum = 0.0, count = 0.0;
  for (size_t cell = 0; cell < map.centre.size(); ++cell) {
    if (map.centre[cell] < -to || map.centre[cell] > -from || !std::isfinite(map.mean[cell])) continue;
    sum += map.mean[cell] * map.count[cell];
    count += map.count[cell];
  }
  return count > 0.0 ? sum / count : 0.0;
}

Message moreOrLess(double value, Axis axis) {
  const std::string size = torqueText(std::abs(value), axis);
  return value > 0.0 ? message("{} more", size) : message("{} less", size);
}

/// "both ways", or the way on which it shows more.
Message waysText(const Stretch& at, Axis axis, const Criteria& criteria) {
  if (!std::isfinite(at.rising) || !std::isfinite(at.falling))
    return message("seen {} only", wayText(std::isfinite(at.rising) ? 1.0 : -1.0, axis));
  const double ratio = std::abs(at.rising) > std::abs(at.falling) ? at.falling / at.rising : at.rising / at.falling;
  if (ratio > criteria.half) return message("both ways");
  return message("mostly {}", wayText(std::abs(at.rising) - std::abs(at.falling), axis));
}

std::string accelerationText(double value, Axis axis) {
  return digitsText(value) + (axis == Axis::rotary ? " rad/s²" : " m/s²");
}

Message rangeText(const Place& place, const std::function<std::string(double)>& text) {
  return message("between {} and {}", text(place.from), text(place.to));
}

Message angleSentence(const ResidualMap& map, const Stretch& at, const Place& place, Axis axis,
                      const Criteria& criteria) {
  const Message range =
      rangeText(place, [axis](double x) { return axis == Axis::rotary ? angleText(x) : lengthText(x); });
  const Message ways = waysText(at, axis, criteria);
  const Message when = map.ofSomeSpeeds() ? message(" at speeds between {} and {}", speedText(map.fromSpeed, axis),
                                                    speedText(map.toSpeed, axis))
                       : ways == message("both ways") ? message(", whichever way it turns")
                                                      : ", " + ways;
  Message out = map.shows == Unknown::friction
                    ? message("The axis needs {} than the model {}, {}", moreOrLess(at.mean, axis), range, ways)
                    : message("Something pushes the axis {} with {} {}{}", wayText(-at.mean, axis),
                              torqueText(std::abs(at.mean), axis), range, when);
  if (isWave(map, criteria)) {
    const int number = map.orders[0].number;
    const std::string amplitude = torqueText(map.orders[0].amplitude, axis);
    out = out + (number == 1 ? message(". It comes once per turn with ±{}", amplitude)
                             : message(". It comes {} times per turn with ±{}", std::to_string(number), amplitude));
  }
  if (map.ofSomeSpeeds()) out = out + message(". At other speeds it isn't the same");
  return out + ".";
}

/// Friction over an axis along the motion: the drive's torque, or the gain in speed.
Message alongMotionSentence(const ResidualMap& map, const Stretch& at, const Place& place, Axis axis) {
  const bool torqueAxis = map.axis == "current";
  const bool against = place.to <= 0.0, both = place.from < 0.0 && place.to > 0.0;
  const auto text = [&](double x) { return torqueAxis ? torqueText(x, axis) : accelerationText(x, axis); };
  const std::string least = text(against ? 0.0 - place.to : place.from), most = text(against ? -place.from : place.to);
  const Message when = torqueAxis ? (both      ? message("While the motor gives {} to {} along the motion", least, most)
                                     : against ? message("While the motor brakes with {} to {}", least, most)
                                               : message("While the motor drives with {} to {}", least, most))
                       : against  ? message("While it slows down by {} to {}", least, most)
                                  : message("While it speeds up by {} to {}", least, most);
  return message("{} the axis needs {} than the model{}", when, moreOrLess(at.mean, axis), ".");
}

/// Where the axis runs through zero: velocity, acceleration, motor torque, current.
Message signedSentence(const ResidualMap& map, const Stretch& at, const Place& place, Axis axis,
                       const Criteria& criteria) {
  if (map.shows == Unknown::friction) return alongMotionSentence(map, at, place, axis);
  const double middle = 0.5 * (place.from + place.to), s = middle > 0.0 ? 1.0 : -1.0;
  const double other = mirrored(map, place.from, place.to);
  const bool odd = place.from * place.to > 0.0 && -other / at.mean > criteria.half;
  if (map.shows == Unknown::voltage) {
    const Message range = rangeText(place, [](double x) { return quantityText(x, "A"); });
    return message("At currents {} the drive loses {} {} than the model{}", range, quantityText(std::abs(at.mean), "V"),
                   s * at.mean > 0.0 ? message("more") : message("less"),
                   odd ? message(", and as much the other way.") : Message("."));
  }
  if (map.axis == "current") {
    return message("When the motor should give {}, it gives {}{}",
                   rangeText(place, [&](double x) { return torqueText(x, axis); }), moreOrLess(-s * at.mean, axis),
                   odd ? message(", and the same the other way.") : Message("."));
  }
  const Message when =
      map.axis == "velocity"
          ? message("At speeds {}", rangeText(place, [&](double x) { return speedText(x, axis); }))
          : message("At accelerations {}", rangeText(place, [&](double x) { return accelerationText(x, axis); }));
  return message("{} the axis needs {} than the model{}", when, moreOrLess(s * at.mean, axis),
                 odd ? message(", and as much the other way.") : Message("."));
}

Message sentenceOf(const ResidualMap& map, const Stretch& at, const Place& place, Axis axis, const Criteria& criteria) {
  if (map.axis == "angle") return angleSentence(map, at, place, axis, criteria);
  if (map.axis == "velocity" || map.axis == "acceleration" || map.axis == "current")
    return signedSentence(map, at, place, axis, criteria);
  if (map.axis == "frequency") {
    return message(
        "Changes between {} and {} Hz come out otherwise than in the model, by {} rms: the axis answers its drive "
        "late, weakly or in resonance.",
        digitsText(place.from), digitsText(place.to), torqueText(at.mean, axis));
  }
  const bool resists = map.shows == Unknown::friction;
  const std::string mean = torqueText(std::abs(at.mean), axis);
  const Message size = resists ? message("friction is {} {} than in the model", mean,
                                         at.mean > 0.0 ? message("higher") : message("lower"))
                               : message("something pushes the axis {} with {}", wayText(-at.mean, axis), mean);
  if (map.axis == "reversal") {
    const auto text = [axis](double x) { return travelText(x, axis); };
    const bool atOnce = at.first == 0;
    return atOnce ? message("Over the first {} after a reversal {}.", text(place.to), size)
                  : message("From {} to {} after a reversal {}.", text(place.from), text(place.to), size);
  }
  const std::string unit = map.axis == "time" ? " s" : " °C";
  return message("Between {} and {}{} {}{}.", digitsText(place.from), digitsText(place.to), unit, size,
                 resists ? ", " + waysText(at, axis, criteria) : Message());
}

/// The turn cut open half a turn on, for a stretch that runs over 0°.
ResidualMap cutElsewhere(ResidualMap map) {
  const auto half = static_cast<std::ptrdiff_t>(map.centre.size() / 2);
  for (auto* values : {&map.centre, &map.width, &map.mean, &map.error, &map.rising, &map.falling, &map.count})
    std::rotate(values->begin(), values->begin() + half, values->end());
  for (double& centre : map.centre) centre -= centre > std::numbers::pi ? turn_rad : 0.0;
  return map;
}

Place placeOf(const ResidualMap& whole, const Model& model, const Criteria& criteria) {
  const Stretch uncut = worstStretch(whole, criteria);
  const bool round = !whole.orders.empty();
  const bool atTheCut = round && (uncut.first == 0 || uncut.last + 1 == whole.centre.size());
  const ResidualMap map = atTheCut ? cutElsewhere(whole) : whole;
  const Stretch at = worstStretch(map, criteria);
  Place place;
  place.axis = map.axis;
  place.from = map.centre[at.first] - 0.5 * map.width[at.first];
  place.to = map.centre[at.last] + 0.5 * map.width[at.last];
  place.unit = map.unit;
  place.share = map.share * at.share;
  place.pValue = map.pValue;
  // A wave of the turn is as long as all of it, even where one of its hills is the highest.
  if (isWave(map, criteria)) place.share = map.share;
  if (map.axis == "reversal") place.from = std::max(0.0, place.from);
  place.sentence = sentenceOf(map, at, place, model.axis, criteria);
  place.size = std::abs(at.mean);
  place.shows = map.shows;
  place.ofSomeSpeeds = map.ofSomeSpeeds();
  place.foretells = map.foretells;
  if (model.axis == Axis::linear) place.sizeUnit = "N";
  if (map.shows == Unknown::voltage) place.sizeUnit = "V";
  return place;
}

}  // namespace

ResidualMap onlyThere(ResidualMap map, const Place& place, const Criteria& criteria) {
  if (map.along == alongs || !map.waves.empty() || isWave(map, criteria)) return map;
  const auto covers = [&place](double at) { return at >= place.from && at <= place.to; };
  for (size_t cell = 0; cell < map.centre.size(); ++cell) {
    const double at = map.centre[cell];
    const bool there =
        map.withinTurn && map.along == byAngle ? covers(at) || covers(at - turn_rad) : covers(at) || covers(-at);
    if (!there) map.mean[cell] = std::nan("");
  }
  return map;
}

bool showsMore(const ResidualMap& map, const ResidualMap& other, const Criteria& criteria) {
  const auto counts = [&criteria](const ResidualMap& one) {
    return one.share / (one.ofSomeSpeeds() ? criteria.clearlyMore() : 1.0);
  };
  return counts(map) > counts(other);
}

std::vector<Place> places(const std::vector<ResidualMap>& maps, const Model& model, const Criteria& criteria) {
  std::vector<const ResidualMap*> strongest;  // one per axis and side
  for (const ResidualMap& map : maps) {
    const bool seen = std::any_of(map.mean.begin(), map.mean.end(), [](double x) { return std::isfinite(x); });
    if (!seen || map.pValue > criteria.likeliestByChance || map.share < criteria.negligible) continue;
    const auto same = std::find_if(strongest.begin(), strongest.end(), [&map](const ResidualMap* one) {
      return one->axis == map.axis && (one->shows == Unknown::voltage) == (map.shows == Unknown::voltage);
    });
    if (same == strongest.end())
      strongest.push_back(&map);
    else if (showsMore(map, **same, criteria))
      *same = &map;
  }
  std::vector<Place> found;
  found.reserve(strongest.size());
  for (const ResidualMap* map : strongest) found.push_back(placeOf(*map, model, criteria));
  std::stable_sort(found.begin(), found.end(), [](const Place& a, const Place& b) { return a.share > b.share; });
  return found;
}

void preferAxis(std::vector<Place>& places, std::string_view axis, const Criteria& criteria) {
  if (axis == "travel") axis = "reversal";
  const auto own = std::find_if(places.begin(), places.end(), [axis](const Place& one) { return one.axis == axis; });
  if (own != places.end() && own->share > criteria.half * places.front().share)
    std::rotate(places.begin(), own, own + 1);
}

}  // namespace breakaway
