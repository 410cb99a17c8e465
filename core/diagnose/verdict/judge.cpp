#include "diagnose/verdict/judge.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "base/statistics.h"
#include "diagnose/effects/catalogue.h"
#include "diagnose/fit/noise_floor.h"
#include "diagnose/fit/seen_span.h"
#include "diagnose/fit/windowed_fit.h"
#include "diagnose/search/swinging_load.h"
#include "diagnose/simulate/physics.h"
#include "diagnose/verdict/proof.h"
#include "diagnose/verdict/rival_scores.h"
#include "diagnose/verdict/worth_saying.h"

namespace breakaway {

namespace {

double meanSquare(const Model& model, const std::vector<Track>& tracks, const std::vector<Window>& windows) {
  return mean(scoreWindows(model, tracks, windows));
}

FitScore scoreFit(const Bench& bench, const Model& base, const Model& best, const Preparation& prepared,
                  const TorqueNoise& left, std::uint64_t seed, Proof& proof) {
  const std::vector<Track>& tracks = prepared.tracks;
  const Split& split = prepared.split;
  FitScore fit;
  fit.channel = split.heldoutScore.front().errorIn == ErrorIn::torque ? bench.torqueChannel()
                : tracks.front().speedAlone()                         ? bench.velocityChannel()
                                                                      : bench.positionChannel();
  fit.separateRecording = split.separateRecording;
  fit.trainBefore = std::sqrt(meanSquare(base, tracks, split.trainScore));
  fit.trainAfter = std::sqrt(meanSquare(best, tracks, split.trainScore));
  const auto before = scoreWindows(base, tracks, split.heldoutScore),
             after = scoreWindows(best, tracks, split.heldoutScore);
  fit.heldoutBefore = std::sqrt(mean(before));
  fit.heldoutAfter = std::sqrt(mean(after));
  fit.before95 = errorInterval(before, seed);
  fit.after95 = errorInterval(after, seed);
  const Interval interval = bootstrap(before.size(), 2000, seed, [&](std::span<const size_t> blocks) {
    double sumBefore = 0.0, sumAfter = 0.0;
    for (const size_t block : blocks) {
      sumBefore += before[block];
      sumAfter += after[block];
    }
    return 1.0 - std::sqrt(sumAfter / std::max(sumBefore, 1e-300));
  });
  fit.improvementLow95 = interval.low;
  fit.improvementHigh95 = interval.high;
  const Floors floors = floorsOf(best, prepared, split.heldoutScore, seed, left);
  fit.floor = floors.perfect;
  fit.floorWithWander = floors.withWander;
  proof = proofOf(best, tracks, split.heldoutScore, before, after, fit);
  return fit;
}

/// The effect's terms, that of the largest amplitude first.
std::vector<EffectTerm> largestTerms(const Model& model, const std::string& effect) {
  std::vector<EffectTerm> terms;
  for (const EffectTerm& term : model.effects) {
    if (term.effect == effect) terms.push_back(term);
  }
  std::stable_sort(terms.begin(), terms.end(), [](const EffectTerm& a, const EffectTerm& b) {
    return std::abs(a.parameters.front().value) > std::abs(b.parameters.front().value);
  });
  return terms;
}

/// An effect's second wave has `amplitude2_Nm`, `phase2_rad`, `order2`, and so on.
Parameter numbered(Parameter parameter, size_t number) {
  if (number > 1)
    parameter.name.insert(std::min(parameter.name.find('_'), parameter.name.size()), std::to_string(number));
  return parameter;
}

/// Those that are there, and whose interval says something.
std::vector<Parameter> knownParameters(const EffectTerm& term, Axis axis, const Criteria& limits) {
  std::vector<Parameter> known = presentParameters(term, axis);
  std::erase_if(known, [&](const Parameter& one) {
    const auto place = std::find_if(term.parameters.begin(), term.parameters.end(),
                                    [&one](const Parameter& other) { return other.name == one.name; });
    return place != term.parameters.end() &&
           !isKnown(term, static_cast<size_t>(place - term.parameters.begin()), axis, limits);
  });
  return known;
}

/// The findings, with shares of the excess that add up to what the extended model takes away.
std::vector<Finding> findingsOf(const SearchResult& result, const Model& model, const SearchInput& input,
                                double explained, const std::function<bool(const EffectTerm&)>& worth) {
  double marginals = 0.0;
  for (const Chosen& chosen : result.chosen) marginals += chosen.marginal;
  std::vector<Finding> findings;
  for (const Chosen& chosen : result.chosen) {
    Finding finding;
    finding.effect = chosen.effect->name();
    finding.share = marginals > 0.0 ? std::clamp(explained * chosen.marginal / marginals, 0.0, 1.0) : 0.0;
    finding.pValue = chosen.pValue;
    for (const Effect* rival : chosen.rivals) finding.ambiguousWith.emplace_back(rival->name());
    std::vector<EffectTerm> terms = largestTerms(model, finding.effect);
    if (!terms.empty()) {
      terms.erase(std::remove_if(terms.begin() + 1, terms.end(), [&](const EffectTerm& one) { return !worth(one); }),
                  terms.end());
      finding.saysSomething = worth(terms.front());
      const EffectTerm& first = terms.front();
      std::vector<std::vector<double>> further;
      for (size_t k = 1; k < terms.size(); ++k) further.push_back(valuesOf(terms[k]));
      const std::vector<double> largest = valuesOf(first);
      finding.sentence = chosen.effect->sentence(largest, input.seen);
      if (!first.recording.empty() && input.tracks.size() > 1)
        finding.sentence = message("In {}: {}", first.recording, finding.sentence);
      finding.sentence = finding.sentence + chosen.effect->furtherSentence(largest, further, input.seen);
    }
    for (size_t k = 0; k < terms.size(); ++k) {
      const auto shown = finding.saysSomething ? knownParameters(terms[k], model.axis, input.criteria)
                                               : presentParameters(terms[k], model.axis);
      for (const Parameter& one : shown) finding.parameters.push_back(numbered(one, k + 1));
    }
    findings.push_back(std::move(finding));
  }
  return findings;
}

/// Whether something in the model changes what the current sensor shows, which moves nothing.
bool changesReadings(const Model& model) {
  return std::any_of(model.effects.begin(), model.effects.end(),
                     [](const EffectTerm& term) { return findEffect(term.effect)->currentSensor() != nullptr; });
}

bool showsInCurrent(const SearchResult& result, const Criteria& limits) {
  return result.best.currentSquares < limits.clearlyLess * result.base.currentSquares;
}

/// The part of the squared held-out error that is left.
double squaredPart(const FitScore& fit) {
  return std::pow(fit.heldoutAfter / fit.heldoutBefore, 2);
}

/// Whether the interval of its amplitude includes zero.
bool mayBeNothing(const Finding& finding) {
  const Parameter& amplitude = finding.parameters.front();
  return amplitude.low95 < 0.0 && amplitude.high95 > 0.0;
}

/// Whether the only finding explains less than half of the error and may be zero.
bool isVague(const std::vector<Finding>& findings, const Criteria& limits) {
  return findings.size() == 1 && findings.front().share <= limits.half && mayBeNothing(findings.front());
}

/// Whether it happens once and is no larger than the scatter of the friction.
bool isScatter(const Finding& finding, double coulomb, const Criteria& limits) {
  const bool small = std::abs(finding.parameters.front().value) < limits.farApart * limits.immaterial * coulomb;
  return small && findEffect(finding.effect)->happensOnce();
}

/// Whether a finding beside others takes hardly anything away and may be zero, or takes little away and may be the
/// friction's scatter.
bool isIdle(const Finding& finding, double coulomb, const Criteria& limits) {
  return (finding.share < limits.hardlyAny && mayBeNothing(finding)) ||
         (finding.share < limits.little && isScatter(finding, coulomb, limits));
}

/// Whether a rig that lacks nothing might seem to have it, if the base model errs by little more than its sensors.
bool isFaint(const Finding& finding, double coulomb, const Criteria& limits) {
  return mayBeNothing(finding) || isScatter(finding, coulomb, limits);
}

class Judge {
 public:
  Judge(const Bench& bench, const Preparation& prepared, const SearchInput& input, const SearchResult& found)
      : bench_(bench),
        prepared_(prepared),
        input_(input),
        limits_(input.criteria),
        found_(found),
        base_(withDoubts(found.base.model, prepared)),
        errorsBefore_(scoreWindows(base_, prepared.tracks, prepared.split.trainScore)) {}

  Judgement judged() {
    if (auto one = standing(found_)) return std::move(*one);
    for (auto before = found_.displaced.rbegin(); found_.chosen.size() == 1 && before != found_.displaced.rend();
         ++before) {
      SearchResult candidate = found_;
      candidate.chosen = {before->first};
      refine(candidate, before->second.model);
      if (auto one = standing(std::move(candidate))) return std::move(*one);
    }
    return nothing();
  }

 private:
  using Members = std::vector<Chosen>;
  enum class Opinion { stands, falls, heldoutRefuses };

  /// What of the candidate stands; nothing if none of it does.
  std::optional<Judgement> standing(SearchResult candidate) const {
    bool refused = false;
    while (!candidate.chosen.empty()) {
      Judgement judgement;
      Opinion opinion = judge(candidate, judgement);
      // What held-out data refused with more waves, they have to show with fewer.
      if (refused && opinion == Opinion::stands && squaredPart(judgement.fit) > limits_.hardlyLess)
        opinion = Opinion::heldoutRefuses;
      if (const auto idle = superfluous(candidate, judgement)) {
        if (candidate.chosen.size() == 1) break;
        drop(candidate, candidate.chosen.begin() + *idle);
        continue;
      }
      if (opinion == Opinion::stands) return withRivals(std::move(judgement), candidate);
      if (opinion == Opinion::falls) break;
      if (dropSmallestWave(candidate)) {
        refused = true;
        continue;
      }
      if (candidate.chosen.size() == 1) break;
      drop(candidate, leastOf(candidate));
    }
    return std::nullopt;
  }

  Judgement withRivals(Judgement judgement, const SearchResult& candidate) const {
    for (size_t k = 0; k < judgement.findings.size(); ++k)
      judgement.findings[k].rivals = rivalScores(candidate.chosen[k], candidate, judgement.model, prepared_, input_);
    return judgement;
  }

  double before() const { return typicalSquare(errorsBefore_); }

  /// A finding that is idle beside others, or faint where the base model is near the floor; nothing if there is none.
  std::optional<std::ptrdiff_t> superfluous(const SearchResult& candidate, const Judgement& judged) const {
    const bool near = mean(errorsBefore_) < std::pow(limits_.nearFloor * judged.rest.floors.perfect, 2) &&
                      !showsInCurrent(candidate, limits_);
    const double coulomb = physicsOf(judged.model).coulomb;
    const auto& all = judged.findings;
    const auto one = std::find_if(all.begin(), all.end(), [&](const Finding& finding) {
      return !finding.saysSomething || (all.size() > 1 && isIdle(finding, coulomb, limits_)) ||
             (near && isFaint(finding, coulomb, limits_));
    });
    if (one == all.end()) return std::nullopt;
    return one - all.begin();
  }

  Judgement nothing() const {
    Judgement out;
    out.base = out.model = base_;
    out.rest = remainderOf(base_, prepared_, {errorsBefore_, errorsBefore_}, found_.leftByBase, input_.seed);
    out.fit = scoreFit(bench_, base_, base_, prepared_, out.rest.wander, input_.seed, out.proof);
    return out;
  }

  Opinion judge(const SearchResult& candidate, Judgement& out) const {
    out.base = base_;
    out.model = withDoubts(withinSeen(candidate.best.model, prepared_.tracks, prepared_.split), prepared_);
    const auto errorsAfter = scoreWindows(out.model, prepared_.tracks, prepared_.split.trainScore);
    out.rest = remainderOf(out.model, prepared_, {errorsBefore_, errorsAfter}, candidate.left, input_.seed);
    const double excess = std::max(before() - out.rest.floors.perfect * out.rest.floors.perfect, 1e-300);
    double explained = (before() - typicalSquare(errorsAfter)) / excess;
    // The typical error leaves out the worst windows. If an effect acts in few windows, only the plain mean shows it.
    const double ofAll = 1.0 - mean(errorsAfter) / std::max(mean(errorsBefore_), 1e-300);
    if (ofAll > limits_.clearlyLess) explained = std::max(explained, ofAll);
    explained = std::clamp(explained, 0.0, 1.0);
    const bool currentToo = showsInCurrent(candidate, limits_);
    if (explained < limits_.hardlyAny && !currentToo) return Opinion::falls;
    const double fitted =
        1.0 - mean(candidate.best.windowSquares) / std::max(mean(candidate.base.windowSquares), 1e-300);
    // If much is left and the findings explain less than half, something unknown borrows their names.
    if (out.rest.share > limits_.half && std::max(explained, fitted) < limits_.half &&
        !(currentToo && changesReadings(out.model)))
      return Opinion::falls;
    out.findings = findingsOf(candidate, out.model, input_, explained, [&](const EffectTerm& term) {
      // A few pushes would explain any wander, and so would what goes along with time: they are held against what there
      // is without them.
      const Effect& effect = *findEffect(term.effect);
      const bool inTime = effect.happensOnce() || effect.drawnOver() == "time";
      return worthSaying(term, out.model, input_.seen, inTime ? candidate.leftByBase : out.rest.wander, limits_) &&
             (!effect.happensOnce() || isSeen(term));
    });
    out.fit = scoreFit(bench_, base_, out.model, prepared_, out.rest.wander, input_.seed, out.proof);
    // If held-out data get worse, the effect isn't there. If it acts only where the training data are, as a push in one
    // recording does, held-out data may get somewhat worse.
    const double inAll = squaredPart(out.fit);
    const bool singly = growsAtRest(out.model) || swings(out.model);
    const double held = singly ? std::min(inAll, typicallyHeld(out.model)) : inAll;
    // If held-out data err by much and the findings take hardly any of it away, they explain something else.
    const bool once = allHappenOnce(out.findings);
    // A push explains its own stretch alone. If the others, which it leaves as they are, still show that something is
    // missing, it has taken up what that does there, unless its stretch errs by far more than they do.
    const double foreseen = std::max(out.fit.floor, out.fit.floorWithWander);
    const bool restErrs = out.fit.heldoutAfter > limits_.settled * foreseen && !standsOut(out.model);
    if (once && (restErrs || out.rest.share > 0.0 || out.rest.wanders)) return Opinion::falls;
    // One no larger than what any rig's friction wanders by has to leave nothing but what sensors explain.
    if (once && out.rest.aboveFloor && !exceedsWander(out.findings, physicsOf(out.model).coulomb))
      return Opinion::falls;
    const bool muchHeld = out.fit.heldoutBefore > (once ? limits_.material : limits_.atFloor) * out.fit.floor;
    // It acts elsewhere: in few windows, or in a current's reading, which moves nothing. A load swings in all windows.
    const bool inFew = ofAll >= limits_.clearlyLess && !swings(out.model);
    const bool elsewhere = currentToo || (inFew && (!muchHeld || once));
    if (held > (elsewhere ? limits_.clearlyMore() : muchHeld ? limits_.hardlyLess : limits_.hardlyMore()))
      return Opinion::heldoutRefuses;
    // A gain that may be none proves nothing, but where held-out data need not show one, or single windows that run
    // away make its interval: then the training windows have to show it, all of them together.
    const double trained = std::pow(out.fit.trainAfter / out.fit.trainBefore, 2);
    // Windows drawn without the few in which it acts show no gain, and no loss.
    const bool rarely = inFew && held < limits_.half && out.fit.improvementLow95 > -limits_.hardlyAny;
    if (!elsewhere && out.fit.improvementLow95 <= 0.0 && !((singly || rarely) && trained < limits_.half))
      return Opinion::heldoutRefuses;
    // After a restart a load that swings may run away in single windows, although the model is right. Then the typical
    // window decides, and held-out data have to show the gain.
    const bool usually = typicalSquare(errorsAfter) <= limits_.hardlyLess * before() && held < limits_.clearlyLess;
    const bool idle = !currentToo && trained > limits_.hardlyLess && !usually;
    // A push can take up whatever a few windows err by. It counts only if it takes most of all error away.
    const bool stray = once && ofAll < limits_.half;
    return idle || stray || isVague(out.findings, limits_) ? Opinion::falls : Opinion::stands;
  }

  /// Whether what happens once does so in this window.
  bool happensIn(const EffectTerm& term, const Window& window) const {
    const OncePart& once = *findEffect(term.effect)->once();
    const double from = term.parameters[once.start].value, to = from + term.parameters[once.duration].value;
    const Track& track = prepared_.tracks[window.track];
    const bool here = term.recording.empty() || term.recording == fileNameOf(track.name);
    return here && track.time[window.last] > from && track.time[window.first] < to;
  }

  /// Whether any of the pushes is larger than what a sound rig's friction wanders by.
  bool exceedsWander(const std::vector<Finding>& pushes, double coulomb) const {
    const double usual = mostWander(coulomb, input_.seen.peakTorque, limits_);
    return std::any_of(pushes.begin(), pushes.end(),
                       [usual](const Finding& one) { return std::abs(one.parameters.front().value) > usual; });
  }

  /// Whether the windows in which something happens once err by far more without it than all others do, under the same
  /// base model.
  bool standsOut(const Model& model) const {
    Model rest = model;
    std::vector<EffectTerm> pushes;
    std::erase_if(rest.effects, [&pushes](const EffectTerm& term) {
      const bool once = findEffect(term.effect)->happensOnce();
      if (once) pushes.push_back(term);
      return once;
    });
    const auto errors = scoreWindows(rest, prepared_.tracks, prepared_.split.trainScore);
    std::vector<double> here, elsewhere;
    for (size_t w = 0; w < errors.size(); ++w) {
      const bool pushed = std::any_of(pushes.begin(), pushes.end(), [&](const EffectTerm& push) {
        return happensIn(push, prepared_.split.trainScore[w]);
      });
      (pushed ? here : elsewhere).push_back(errors[w]);
    }
    return !here.empty() && !elsewhere.empty() && mean(here) > limits_.farMore() * mean(elsewhere);
  }

  /// Whether the windows in which something happens once err more without it than such windows do by their restarts.
  bool isSeen(const EffectTerm& term) const {
    std::vector<Window> windows;
    double errs = 0.0;
    for (size_t w = 0; w < errorsBefore_.size(); ++w) {
      const Window& window = prepared_.split.trainScore[w];
      if (!happensIn(term, window)) continue;
      windows.push_back(window);
      errs += errorsBefore_[w];
    }
    const auto usual = usualSquares(base_, prepared_.tracks, windows, input_.seed, {});
    return errs > std::pow(limits_.atFloor, 2) * mean(usual) * static_cast<double>(windows.size());
  }

  /// The part of the squared held-out error that is left, without the worst tenth of the windows: if an axis breaks
  /// away a moment too late, or a load runs away, a whole window is off.
  double typicallyHeld(const Model& model) const {
    const auto& windows = prepared_.split.heldoutScore;
    const double before = typicalSquare(scoreWindows(base_, prepared_.tracks, windows));
    return typicalSquare(scoreWindows(model, prepared_.tracks, windows)) / std::max(before, 1e-300);
  }

  static Members::iterator leastOf(SearchResult& candidate) {
    return std::min_element(candidate.chosen.begin(), candidate.chosen.end(),
                            [](const Chosen& a, const Chosen& b) { return a.marginal < b.marginal; });
  }

  void drop(SearchResult& candidate, Members::iterator one) const {
    refine(candidate, without(candidate.best.model, *one->effect));
    candidate.chosen.erase(one);
  }

  /// The smallest of waves beside a larger one of the same effect: too many of them follow the training data where they
  /// are, and lead astray elsewhere. Whether there was one.
  bool dropSmallestWave(SearchResult& candidate) const {
    Model rest = candidate.best.model;
    std::vector<EffectTerm>& terms = rest.effects;
    const auto size = [](const EffectTerm& term) { return std::abs(term.parameters.front().value); };
    const auto ofLargest = [&](const EffectTerm& term) {
      double largest = 0.0;
      for (const EffectTerm& other : terms) {
        if (other.effect == term.effect && other.recording == term.recording) largest = std::max(largest, size(other));
      }
      return size(term) / largest;
    };
    const auto smallest = std::min_element(terms.begin(), terms.end(), [&](const EffectTerm& a, const EffectTerm& b) {
      return ofLargest(a) < ofLargest(b);
    });
    if (smallest == terms.end() || ofLargest(*smallest) >= 1.0) return false;
    terms.erase(smallest);
    refine(candidate, rest);
    return true;
  }

  void refine(SearchResult& candidate, const Model& rest) const {
    SearchInput input = input_;
    input.adequate = candidate.adequate;
    candidate.best = polishModel(input, rest, polishWeights(input, candidate.base.model, rest));
  }

  const Bench& bench_;
  const Preparation& prepared_;
  const SearchInput& input_;
  const Criteria& limits_;
  const SearchResult& found_;
  Model base_;
  std::vector<double> errorsBefore_;
};

}  // namespace

Judgement judge(const Bench& bench, const Preparation& prepared, const SearchInput& input, const SearchResult& found) {
  return Judge(bench, prepared, input, found).judged();
}

}  // namespace breakaway
