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

std::string moreOrLess(double value, Axis axis) {
  return torqueText(std::abs(value), axis) + (value > 0.0 ? " more" : " less");
}

/// "both ways", or the way on which it shows more.
std::string waysText(const Stretch& at, Axis axis, const Criteria& criteria) {
  if (!std::isfinite(at.rising) || !std::isfinite(at.falling)) {
    return std::isfinite(at.rising) ? "seen " + wayText(1.0, axis) + " only" : "seen " + wayText(-1.0, axis) + " only";
  }
  const double ratio = std::abs(at.rising) > std::abs(at.falling) ? at.falling / at.rising : at.rising / at.falling;
  if (ratio > criteria.half) return "both ways";
  return "mostly " + wayText(std::abs(at.rising) - std::abs(at.falling), axis);
}

std::string rangeText(const Place& place, const std::function<std::string(double)>& text) {
  return "between " + text(place.from) + " and " + text(place.to);
}

std::string angleSentence(const ResidualMap& map, const Stretch& at, const Place& place, Axis axis,
                          const Criteria& criteria) {
  const std::string range =
      rangeText(place, [axis](double x) { return axis == Axis::rotary ? angleText(x) : lengthText(x); });
  std::string out = map.shows == Unknown::friction
                        ? "The axis needs " + moreOrLess(at.mean, axis) + " than the model " + range + ", " +
                              waysText(at, axis, criteria)
                        : "Something pushes the axis " + wayText(-at.mean, axis) + " with " +
                              torqueText(std::abs(at.mean), axis) + " " + range +
                              (map.ofSomeSpeeds() ? " at speeds between " + speedText(map.fromSpeed, axis) + " and " +
                                                        speedText(map.toSpeed, axis)
                               : waysText(at, axis, criteria) == "both ways" ? ", whichever way it turns"
                                                                             : ", " + waysText(at, axis, criteria));
  if (!map.orders.empty() && map.orders[0].amplitude > criteria.clearlyMore() * map.orders[1].amplitude) {
    const int number = map.orders[0].number;
    out += std::string(". It comes ") + (number == 1 ? "once" : std::to_string(number) + " times") +
           " per turn with ±" + torqueText(map.orders[0].amplitude, axis);
  }
  if (map.ofSomeSpeeds()) out += ". At other speeds it isn't the same";
  return out + ".";
}

/// Where the axis runs through zero: velocity, acceleration, motor torque, current.
std::string signedSentence(const ResidualMap& map, const Stretch& at, const Place& place, Axis axis,
                           const Criteria& criteria) {
  const double middle = 0.5 * (place.from + place.to), s = middle > 0.0 ? 1.0 : -1.0;
  const double other = mirrored(map, place.from, place.to);
  const bool odd =
      place.from * place.to > 0.0 && (map.shows == Unknown::friction ? 1.0 : -1.0) * other / at.mean > criteria.half;
  const bool torqueAxis = map.axis == "current";
  if (map.shows == Unknown::voltage) {
    const std::string range = rangeText(place, [](double x) { return quantityText(x, "A"); });
    return "At currents " + range + " the drive loses " + quantityText(std::abs(at.mean), "V") +
           (s * at.mean > 0.0 ? " more" : " less") + " than the model" + (odd ? ", and as much the other way." : ".");
  }
  const auto text = [&](double x) {
    return torqueAxis               ? torqueText(x, axis)
           : map.axis == "velocity" ? speedText(x, axis)
                                    : digitsText(x) + (axis == Axis::rotary ? " rad/s²" : " m/s²");
  };
  if (torqueAxis && map.shows == Unknown::torque) {
    return "When the motor should give " + rangeText(place, text) + ", it gives " + moreOrLess(-s * at.mean, axis) +
           (odd ? ", and the same the other way." : ".");
  }
  const std::string head = map.axis == "velocity"       ? "At speeds "
                           : map.axis == "acceleration" ? "At accelerations "
                                                        : "When the motor gives ";
  const double more = map.shows == Unknown::friction ? at.mean : s * at.mean;
  return head + rangeText(place, text) + " the axis needs " + moreOrLess(more, axis) + " than the model" +
         (odd ? ", and as much the other way." : ".");
}

std::string sentenceOf(const ResidualMap& map, const Stretch& at, const Place& place, Axis axis,
                       const Criteria& criteria) {
  if (map.axis == "angle") return angleSentence(map, at, place, axis, criteria);
  if (map.axis == "velocity" || map.axis == "acceleration" || map.axis == "current")
    return signedSentence(map, at, place, axis, criteria);
  if (map.axis == "frequency") {
    return "Changes between " + digitsText(place.from) + " and " + digitsText(place.to) +
           " Hz come out otherwise than in the model, by " + torqueText(at.mean, axis) +
           " rms: the axis answers its drive late, weakly or in resonance.";
  }
  const bool resists = map.shows == Unknown::friction;
  const std::string size =
      resists ? "friction is " + torqueText(std::abs(at.mean), axis) + (at.mean > 0.0 ? " higher" : " lower") +
                    " than in the model"
              : "something pushes the axis " + wayText(-at.mean, axis) + " with " + torqueText(std::abs(at.mean), axis);
  if (map.axis == "reversal") {
    const auto text = [axis](double x) { return travelText(x, axis); };
    const bool atOnce = at.first == 0;
    return (atOnce ? "Over the first " + text(place.to) + " after a reversal "
                   : "From " + text(place.from) + " to " + text(place.to) + " after a reversal ") +
           size + ".";
  }
  const std::string unit = map.axis == "time" ? " s" : " °C";
  std::string out = "Between " + digitsText(place.from) + " and " + digitsText(place.to) + unit + " " + size;
  if (resists) out += ", " + waysText(at, axis, criteria);
  return out + ".";
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
  if (!map.orders.empty() && map.orders[0].amplitude > criteria.clearlyMore() * map.orders[1].amplitude)
    place.share = map.share;
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
