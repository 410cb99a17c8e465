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
std::string signOf(const Effect& effect) {
  const std::string_view over = effect.drawnOver();
  if (over == "velocity") return "follows the speed";
  if (over == "angle") return "comes back at the same place";
  if (over == "time") return "comes with time, whatever the motion";
  if (over == "current") return "grows with what the motor gives";
  if (over == "travel") return "shows right after each reversal";
  if (over == "frequency") return "grows with how fast the command changes";
  return {};
}

/// How an effect gives itself away beside another: as the two say of each other, or else by its axis.
std::string signBeside(const Effect& effect, const Effect& other) {
  for (const Tell& tell : effect.tells()) {
    if (tell.beside == other.name()) return std::string(tell.sign);
  }
  return signOf(effect);
}

std::string pairText(const Effect& one, const Effect& other) {
  const std::string first = signBeside(one, other), second = signBeside(other, one);
  if (first.empty() || second.empty() || first == second) return {};
  return " What " + first + " is " + std::string(one.name()) + "; what " + second + " is " + std::string(other.name()) +
         ".";
}

/// What must not be exceeded, where the bench says so.
std::string limits(const Bench& bench) {
  std::string out;
  if (bench.controller.currentLimit_A > 0.0) out = quantityText(bench.controller.currentLimit_A, "A");
  if (bench.electrical() && bench.supply_V.value_or(0.0) > 0.0)
    out += (out.empty() ? "" : " and ") + quantityText(*bench.supply_V, "V");
  return out.empty() ? out : " Stay within " + out + ".";
}

/// A change of the experiment, and what the recording would then have seen.
struct Change {
  std::string sentence;
  Excitation seen;
  Maneuver maneuver = {};
};

std::vector<Change> changes(const Excitation& seen) {
  std::vector<Change> out;
  const bool rotary = seen.axis == Axis::rotary;
  const auto add = [&](std::string sentence, Maneuver maneuver = {}) -> Excitation& {
    out.push_back({std::move(sentence), seen, std::move(maneuver)});
    return out.back().seen;
  };
  Excitation* more = &add("Reverse at least twenty times at speeds up to " + speedText(seen.highSpeed, seen.axis) +
                              ", as long one way as the other.",
                          reversals(seen.highSpeed, static_cast<int>(fewRepeats), 1.0));
  more->bothWays = true;
  more->reversals = std::max(seen.reversals, static_cast<int>(fewRepeats));
  more->starts = std::max(seen.starts, static_cast<int>(fewRepeats));
  if (rotary) {
    more = &add("Turn over two whole turns, both ways, at " + speedText(0.3 * seen.highSpeed, seen.axis) + " and at " +
                    speedText(seen.highSpeed, seen.axis) + ".",
                speedsBothWays({0.3 * seen.highSpeed, seen.highSpeed}, twoTurns(seen)));
    more->highest = std::max(seen.highest, seen.lowest + 4.0 * std::numbers::pi);
    more->travel = more->highest - more->lowest;
    more->bothWays = true;
    more->lowSpeed = std::min(seen.lowSpeed, 0.3 * seen.highSpeed);
    more->reversals = std::max(seen.reversals, 4);
  }
  more = &add("Hold constant speeds of " + speedText(0.1 * seen.highSpeed, seen.axis) + ", " +
                  speedText(0.3 * seen.highSpeed, seen.axis) + " and " + speedText(seen.highSpeed, seen.axis) +
                  ", both ways.",
              speedsBothWays({0.1 * seen.highSpeed, 0.3 * seen.highSpeed, seen.highSpeed}, twoTurns(seen)));
  more->bothWays = true;
  more->lowSpeed = std::min(seen.lowSpeed, 0.1 * seen.highSpeed);
  more = &add("Stop at least " + digitsText(fewRepeats) +
                  " times, rest between 0.5 s and 10 s, and start slowly again, up to " +
                  torqueText(seen.peakTorque, seen.axis) + ".",
              startsFromRest(0.2 * seen.highSpeed, {0.5, 2.0, 10.0}, static_cast<int>(fewRepeats)));
  more->starts = std::max(seen.starts, static_cast<int>(fewRepeats));
  more->longestRest_s = std::max(seen.longestRest_s, 10.0);
  more->reversals = std::max(seen.reversals, 4);
  more = &add("Start cold and record the same motion for " + timeText(std::max(enoughTime_s, 2.0 * seen.duration_s)) +
              ".");
  more->duration_s = std::max(enoughTime_s, 2.0 * seen.duration_s);
  if (seen.electrical && !seen.currentSeen) {
    more = &add("Record the same motion with the current beside the voltage.");
    more->currentSeen = true;
  }
  if (seen.electrical && !seen.supplySeen) {
    more = &add("Record the same motion with the supply's voltage.");
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
  next.sentence = "To tell " + finding.effect + " from " + name + ": " + other.neededExcitation(seen) +
                  pairText(one, other) + limits(bench);
  next.maneuver = other.neededManeuver(seen);
  return next;
}

/// A closer look at the place that nothing in the catalogue explains.
std::string closerLook(const Place& place, const Excitation& seen) {
  const std::string slow = speedText(0.3 * seen.highSpeed, seen.axis), fast = speedText(seen.highSpeed, seen.axis);
  const std::string twice = "slowly at " + slow + " and again at " + fast;
  const auto way = [&](double x) { return travelText(x, seen.axis); };
  if (place.axis == "angle") {
    return "Move to and fro between " + way(place.from) + " and " + way(place.to) + ", " + twice +
           ", ten times each: what stays at its place belongs to the rig.";
  }
  if (place.axis == "velocity") {
    return "Hold five constant speeds from " + speedText(place.from, seen.axis) + " to " +
           speedText(place.to, seen.axis) + ", each over the same place and both ways.";
  }
  if (place.axis == "time" || place.axis == "temperature") {
    return "Repeat the very same motion of " + timeText(seen.duration_s) +
           " twice, once cold and once warm: what comes at the same time again belongs to the rig, the rest came from "
           "outside.";
  }
  if (place.axis == "reversal") {
    return "Reverse at least twenty times over ways of " + way(0.5 * place.to) + " and " + way(3.0 * place.to) + ", " +
           twice + ".";
  }
  if (place.axis == "frequency") {
    return "Chirp the command with ±" + digitsText(0.3 * seen.peakInput) + " from " + digitsText(0.5 * place.from) +
           " Hz to " + digitsText(2.0 * place.to) + " Hz within 20 s, and again with half of it.";
  }
  return "Repeat the motion at half and at full drive, ±" + digitsText(0.5 * seen.peakInput) + " and ±" +
         digitsText(seen.peakInput) +
         ", free and with a known load: what follows the drive is in motor or electronics.";
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
  std::string names;
  for (const Effect* effect : unseen) names += (names.empty() ? "" : ", ") + std::string(effect->name());
  return {"This recording could not show " + names + ". " + best->sentence +
              (newlyShown(unseen, best->seen) == unseen.size()
                   ? ""
                   : " That would show " + std::to_string(newlyShown(unseen, best->seen)) + " of them."),
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
    return {"To confirm " + std::string(effect.name()) + ": " + effect.neededExcitation(seen) + limits(bench),
            {},
            effect.neededManeuver(seen)};
  }
  NextExperiment more = mostInformative(seen);
  if (!more.sentence.empty()) more.sentence += limits(bench);
  return more;
}

}  // namespace breakaway
