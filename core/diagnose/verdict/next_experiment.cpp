#include "diagnose/verdict/next_experiment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagnose/effects/catalogue.h"
#include "diagnose/effects/wording.h"

namespace breakaway {

namespace {

constexpr double enoughTime_s = 60.0;
constexpr double fewRepeats = 20;

/// How an effect gives itself away, by the axis it is drawn over.
Message signOf(const Effect& effect) {
  const std::string_view over = effect.drawnOver();
  if (over == "velocity") return message("follows the speed");
  if (over == "angle") return message("comes back at the same place");
  if (over == "time") return message("comes with time, whatever the motion");
  if (over == "current") return message("grows with what the motor gives");
  if (over == "travel") return message("shows right after each reversal");
  if (over == "frequency") return message("grows with how fast the command changes");
  return {};
}

/// How an effect gives itself away beside another: as the two say of each other, or else by its axis.
Message signBeside(const Effect& effect, const Effect& other) {
  for (const Tell& tell : effect.tells()) {
    if (tell.beside == other.name()) return tell.sign;
  }
  return signOf(effect);
}

Message pairText(const Effect& one, const Effect& other) {
  const Message first = signBeside(one, other), second = signBeside(other, one);
  if (first.empty() || second.empty() || first == second) return {};
  return message(" What {} is {}; what {} is {}.", first, effectName(one), second, effectName(other));
}

/// What must not be exceeded, where the bench says so.
Message limits(const Bench& bench) {
  std::vector<Message> limits;
  if (bench.controller.currentLimit_A > 0.0) limits.emplace_back(quantityText(bench.controller.currentLimit_A, "A"));
  if (bench.electrical() && bench.supply_V.value_or(0.0) > 0.0) limits.emplace_back(quantityText(*bench.supply_V, "V"));
  return limits.empty() ? Message() : message(" Stay within {}.", listed(limits, message(" and ")));
}

/// A change of the experiment, and what the recording would then have seen.
struct Change {
  Message sentence;
  Excitation seen;
  Maneuver maneuver = {};
};

std::vector<Change> changes(const Excitation& seen) {
  std::vector<Change> out;
  const bool rotary = seen.axis == Axis::rotary;
  const auto add = [&](Message sentence, Maneuver maneuver = {}) -> Excitation& {
    out.push_back({std::move(sentence), seen, std::move(maneuver)});
    return out.back().seen;
  };
  Excitation* more = &add(message("Reverse at least twenty times at speeds up to {}, as long one way as the other.",
                                  speedText(seen.highSpeed, seen.axis)),
                          reversals(seen.highSpeed, static_cast<int>(fewRepeats), 1.0));
  more->bothWays = true;
  more->reversals = std::max(seen.reversals, static_cast<int>(fewRepeats));
  more->starts = std::max(seen.starts, static_cast<int>(fewRepeats));
  if (rotary) {
    more = &add(message("Turn over two whole turns, both ways, at {} and at {}.",
                        speedText(0.3 * seen.highSpeed, seen.axis), speedText(seen.highSpeed, seen.axis)),
                speedsBothWays({0.3 * seen.highSpeed, seen.highSpeed}, twoTurns(seen)));
    more->highest = std::max(seen.highest, seen.lowest + 4.0 * std::numbers::pi);
    more->travel = more->highest - more->lowest;
    more->bothWays = true;
    more->lowSpeed = std::min(seen.lowSpeed, 0.3 * seen.highSpeed);
    more->reversals = std::max(seen.reversals, 4);
  }
  more = &add(message("Hold constant speeds of {}, {} and {}, both ways.", speedText(0.1 * seen.highSpeed, seen.axis),
                      speedText(0.3 * seen.highSpeed, seen.axis), speedText(seen.highSpeed, seen.axis)),
              speedsBothWays({0.1 * seen.highSpeed, 0.3 * seen.highSpeed, seen.highSpeed}, twoTurns(seen)));
  more->bothWays = true;
  more->lowSpeed = std::min(seen.lowSpeed, 0.1 * seen.highSpeed);
  more = &add(message("Stop at least {} times, rest between 0.5 s and 10 s, and start slowly again, up to {}.",
                      digitsText(fewRepeats), torqueText(seen.peakTorque, seen.axis)),
              startsFromRest(0.2 * seen.highSpeed, {0.5, 2.0, 10.0}, static_cast<int>(fewRepeats)));
  more->starts = std::max(seen.starts, static_cast<int>(fewRepeats));
  more->longestRest_s = std::max(seen.longestRest_s, 10.0);
  more->reversals = std::max(seen.reversals, 4);
  more = &add(message("Start cold and record the same motion for {}.",
                      timeText(std::max(enoughTime_s, 2.0 * seen.duration_s))));
  more->duration_s = std::max(enoughTime_s, 2.0 * seen.duration_s);
  if (seen.electrical && !seen.currentSeen) {
    more = &add(message("Record the same motion with the current beside the voltage."));
    more->currentSeen = true;
  }
  if (seen.electrical && !seen.supplySeen) {
    more = &add(message("Record the same motion with the supply's voltage."));
    more->supplySeen = true;
  }
  return out;
}

size_t newlyShown(const std::vector<const Effect*>& unseen, const Excitation& seen) {
  return static_cast<size_t>(std::count_if(unseen.begin(), unseen.end(),
                                           [&seen](const Effect* effect) { return !effect->shapes(seen).empty(); }));
}

/// Effects without a shape that some change of the experiment would give one.
std::vector<const Effect*> unseenOnes(const Excitation& seen, const std::vector<Change>& possible) {
  std::vector<const Effect*> out;
  for (const Effect* effect : catalogue()) {
    const bool shown = !effect->shapes(seen).empty();
    const bool could = std::any_of(possible.begin(), possible.end(),
                                   [effect](const Change& one) { return !effect->shapes(one.seen).empty(); });
    if (!shown && could) out.push_back(effect);
  }
  return out;
}

NextExperiment separating(const Finding& finding, const Bench& bench, const Excitation& seen) {
  const Effect& one = *findEffect(finding.effect);
  const std::string* real = realRival(finding);
  const std::string& name = real != nullptr ? *real : finding.ambiguousWith.front();
  const Effect& other = *findEffect(name);
  NextExperiment next;
  next.separates = {finding.effect};
  next.separates.insert(next.separates.end(), finding.ambiguousWith.begin(), finding.ambiguousWith.end());
  next.sentence = message("To tell {} from {}: {}{}{}", effectName(one), effectName(other),
                          other.neededExcitation(seen), pairText(one, other), limits(bench));
  next.maneuver = other.neededManeuver(seen);
  return next;
}

/// A closer look at the place that nothing in the catalogue explains.
Message closerLook(const Place& place, const Excitation& seen) {
  const std::string slow = speedText(0.3 * seen.highSpeed, seen.axis), fast = speedText(seen.highSpeed, seen.axis);
  const Message twice = message("slowly at {} and again at {}", slow, fast);
  const auto way = [&](double x) { return travelText(x, seen.axis); };
  if (place.axis == "angle") {
    return message("Move to and fro between {} and {}, {}, ten times each: what stays at its place belongs to the rig.",
                   way(place.from), way(place.to), twice);
  }
  if (place.axis == "velocity") {
    return message("Hold five constant speeds from {} to {}, each over the same place and both ways.",
                   speedText(place.from, seen.axis), speedText(place.to, seen.axis));
  }
  if (place.axis == "acceleration") {
    return message(
        "Go from {} to {} and back, ten times within 0.1 s and ten times within 2 s: what differs depends on how fast "
        "the speed changes.",
        slow, fast);
  }
  if (place.axis == "time" || place.axis == "temperature") {
    return message(
        "Repeat the very same motion of {} twice, once cold and once warm: what comes at the same time again belongs "
        "to the rig, the rest came from outside.",
        timeText(seen.duration_s));
  }
  if (place.axis == "reversal") {
    return message("Reverse at least twenty times over ways of {} and {}, {}.", way(0.5 * place.to),
                   way(3.0 * place.to), twice);
  }
  if (place.axis == "frequency") {
    return message("Chirp the command with ±{} from {} Hz to {} Hz within 20 s, and again with half of it.",
                   digitsText(0.3 * seen.peakInput), digitsText(0.5 * place.from), digitsText(2.0 * place.to));
  }
  return message(
      "Repeat the motion at half and at full drive, ±{} and ±{}, free and with a known load: what follows the drive is "
      "in motor or electronics.",
      digitsText(0.5 * seen.peakInput), digitsText(seen.peakInput));
}

/// The same as a motion, where a board can make it.
Maneuver maneuverAt(const Place& place, const Excitation& seen) {
  const double slow = 0.3 * seen.highSpeed, fast = seen.highSpeed;
  if (place.axis == "angle") return speedsBothWays({slow, fast}, twoTurns(seen));
  if (place.axis == "reversal") return reversals(slow, 20, 0.5) + reversals(fast, 20, 0.5);
  if (place.axis == "velocity") {
    const double from = std::abs(place.from), to = std::abs(place.to), step = 0.25 * (to - from);
    return speedsBothWays({from, from + step, from + 2.0 * step, from + 3.0 * step, to}, twoTurns(seen));
  }
  return {};
}

}  // namespace

NextExperiment mostInformative(const Excitation& seen) {
  const std::vector<Change> possible = changes(seen);
  const std::vector<const Effect*> unseen = unseenOnes(seen, possible);
  if (unseen.empty()) return {};
  const auto best = std::max_element(possible.begin(), possible.end(), [&](const Change& a, const Change& b) {
    return newlyShown(unseen, a.seen) < newlyShown(unseen, b.seen);
  });
  std::vector<Message> names;
  names.reserve(unseen.size());
  for (const Effect* effect : unseen) names.push_back(effectName(*effect));
  const size_t shown = newlyShown(unseen, best->seen);
  const Message part =
      shown == unseen.size() ? Message() : message(" That would show {} of them.", std::to_string(shown));
  return {message("This recording could not show {}. {}{}", listed(names, Message(", ")), best->sentence, part),
          {},
          best->maneuver};
}

std::vector<std::string> unseenEffects(const Excitation& seen) {
  std::vector<std::string> names;
  for (const Effect* effect : unseenOnes(seen, changes(seen))) names.emplace_back(effect->name());
  return names;
}

NextExperiment nextExperiment(Verdict verdict, const std::vector<Finding>& findings, const std::vector<Place>& where,
                              const Bench& bench, const Excitation& seen) {
  const Finding* twin = nullptr;
  for (const Finding& finding : findings) {
    if (finding.ambiguousWith.empty()) continue;
    if (verdict == Verdict::ambiguous && realRival(finding) != nullptr) return separating(finding, bench, seen);
    if (verdict != Verdict::ambiguous && twin == nullptr) twin = &finding;
  }
  if (verdict == Verdict::outsideCatalogue && !where.empty())
    return {closerLook(where.front(), seen) + limits(bench), {}, maneuverAt(where.front(), seen)};
  if (twin != nullptr) return separating(*twin, bench, seen);
  if (!findings.empty()) {
    const Effect& effect = *findEffect(findings.front().effect);
    return {message("To confirm {}: {}{}", effectName(effect), effect.neededExcitation(seen), limits(bench)),
            {},
            effect.neededManeuver(seen)};
  }
  NextExperiment more = mostInformative(seen);
  if (!more.sentence.empty()) more.sentence = more.sentence + limits(bench);
  return more;
}

}  // namespace breakaway
