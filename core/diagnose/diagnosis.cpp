#include "diagnose/diagnosis.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "base/statistics.h"
#include "diagnose/catalogue.h"
#include "diagnose/effects/wording.h"
#include "diagnose/fit/inverse_fit.h"
#include "diagnose/next_experiment.h"
#include "diagnose/noise_floor.h"
#include "diagnose/preparation.h"
#include "diagnose/proof.h"
#include "diagnose/remainder.h"
#include "diagnose/search/search.h"
#include "diagnose/simulate/physics.h"
#include "diagnose/where.h"

namespace breakaway {

namespace {

constexpr double leastShare = 0.03;
constexpr double muchIsLeft = 0.4;  ///< of the base model's excess error
constexpr double mostIsExplained = 0.5;
constexpr double glaringShare = 0.8;
constexpr double leastOfCurrent = 0.2;   ///< of the current's squared error
constexpr double worseOnHeldout = 1.02;  ///< times the base model's error: what does worse is refused
constexpr double muchWorseOnHeldout = 1.25, clearFallOnHeldout = 0.9;
constexpr double hardlyLessOnHeldout = 0.95, muchFloors = 2.5;
constexpr double leastFall = 0.98;  ///< of the error over the training windows: less is none

double meanSquare(const Model& model, const std::vector<Track>& tracks, const std::vector<Window>& windows) {
  return mean(scoreWindows(model, tracks, windows));
}

FitScore scoreFit(const Bench& bench, const Model& base, const Model& best, const std::vector<Track>& tracks,
                  const Split& split, const DiagnoseOptions& options, Proof& proof) {
  FitScore fit;
  fit.channel = bench.positionChannel();
  fit.window_s = options.window_s;
  fit.separateRecording = split.separateRecording;
  fit.trainBefore = std::sqrt(meanSquare(base, tracks, split.trainScore));
  fit.trainAfter = std::sqrt(meanSquare(best, tracks, split.trainScore));
  const auto before = scoreWindows(base, tracks, split.heldoutScore),
             after = scoreWindows(best, tracks, split.heldoutScore);
  fit.heldoutBefore = std::sqrt(mean(before));
  fit.heldoutAfter = std::sqrt(mean(after));
  const Interval interval = bootstrap(before.size(), 2000, options.seed, [&](std::span<const size_t> blocks) {
    double sumBefore = 0.0, sumAfter = 0.0;
    for (const size_t block : blocks) {
      sumBefore += before[block];
      sumAfter += after[block];
    }
    return 1.0 - std::sqrt(sumAfter / std::max(sumBefore, 1e-300));
  });
  fit.improvementLow95 = interval.low;
  fit.improvementHigh95 = interval.high;
  fit.floor = noiseFloor(best, tracks, split.heldoutScore, options.seed);
  proof = proofOf(best, tracks, split.heldoutScore, before, after, fit);
  return fit;
}

/// The findings, with shares of the excess that add up to what the extended model takes away.
std::vector<Finding> findingsOf(const SearchResult& result, const Model& model, const SearchInput& input,
                                double explained) {
  double marginals = 0.0;
  for (const Chosen& chosen : result.chosen) marginals += chosen.marginal;
  std::vector<Finding> findings;
  for (const Chosen& chosen : result.chosen) {
    Finding finding;
    finding.effect = chosen.effect->name();
    finding.share = marginals > 0.0 ? std::clamp(explained * chosen.marginal / marginals, 0.0, 1.0) : 0.0;
    finding.pValue = chosen.pValue;
    for (const Effect* rival : chosen.rivals) finding.ambiguousWith.emplace_back(rival->name());
    for (const EffectTerm& term : model.effects) {
      if (term.effect != finding.effect) continue;
      finding.parameters = term.parameters;
      finding.sentence = chosen.effect->sentence(valuesOf(term), input.seen);
      if (!term.recording.empty() && input.tracks.size() > 1)
        finding.sentence = "In " + term.recording + ": " + finding.sentence;
    }
    findings.push_back(std::move(finding));
  }
  return findings;
}

bool hasRealRivals(const Finding& finding) {
  const Effect* effect = findEffect(finding.effect);
  return std::any_of(finding.ambiguousWith.begin(), finding.ambiguousWith.end(),
                     [effect](const std::string& rival) { return rival != effect->twin(); });
}

/// Whether something in the model changes what the current sensor shows, which moves nothing.
bool changesReadings(const Model& model) {
  return std::any_of(model.effects.begin(), model.effects.end(), [](const EffectTerm& term) {
    return findEffect(term.effect)->sensed(valuesOf(term), 1.0, 1000.0) != 1.0;
  });
}

bool allHappenOnce(const std::vector<Finding>& findings) {
  return std::all_of(findings.begin(), findings.end(),
                     [](const Finding& one) { return findEffect(one.effect)->happensOnce(); });
}

/// A single finding that explains the smaller part of the error, and nobody can tell that there is any of it.
bool isVague(const std::vector<Finding>& findings) {
  if (findings.size() != 1 || findings.front().share > mostIsExplained) return false;
  const Parameter& amplitude = findings.front().parameters.front();
  return amplitude.low95 < 0.0 && amplitude.high95 > 0.0;
}

/// Where the training data lack nothing, what the held-out data nevertheless show.
void remarkOnHeldout(Diagnosis& diagnosis, const Preparation& prepared, std::uint64_t seed, const TorqueNoise& left) {
  const auto& windows = prepared.split.heldoutScore;
  const Floors floors = floorsOf(diagnosis.model, prepared, windows, seed, left);
  const size_t far = farOffWindows(scoreWindows(diagnosis.model, prepared.tracks, windows), floors.tolerated);
  if (far == 0) return;
  diagnosis.remarks.push_back(std::to_string(far) + " of " + std::to_string(windows.size()) +
                              " held-out windows err more than " + farOffText() +
                              " as much as sensors and friction explain. They show something that the data to "
                              "learn from don't: learn from a recording that moves like these");
}

}  // namespace

Result<Diagnosis> diagnose(const Bench& bench, const std::vector<Recording>& recordings,
                           const std::vector<Recording>& heldout, const DiagnoseOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  const auto elapsed = [begin] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  const auto prepared = prepare(bench, recordings, heldout, options.window_s, false);
  if (!prepared) return prepared.error();
  std::optional<double> named_s;
  std::vector<std::string> firstNames;
  const auto named = [&](const std::vector<const Effect*>& effects) {
    named_s = elapsed();
    for (const Effect* effect : effects) firstNames.emplace_back(effect->name());
  };
  const SearchInput input{prepared->tracks, prepared->split, prepared->held,
                          prepared->seen,   options.seed,    options.stop,
                          options.progress, named,           {}};
  const auto found = searchEffects(input, prepared->starts);
  if (!found) return found.error();

  Diagnosis diagnosis;
  diagnosis.remarks = prepared->remarks;
  if (options.progress) options.progress(0.92, "proving on held-out data");
  diagnosis.base = withDoubts(found->base.model, *prepared);
  diagnosis.model = withDoubts(found->best.model, *prepared);
  diagnosis.heldoutRows = prepared->split.heldoutRows;
  // Decisions rest on training windows; the worst tenth, which a restart at the edge of standstill may rule, left out.
  const auto& windows = prepared->split.trainScore;
  const auto errorsBefore = scoreWindows(diagnosis.base, prepared->tracks, windows);
  const auto errorsAfter = scoreWindows(diagnosis.model, prepared->tracks, windows);
  TorqueNoise left = found->left;
  Remainder rest =
      remainderOf(diagnosis.model, !found->chosen.empty(), *prepared, {errorsBefore, errorsAfter}, left, options.seed);
  const auto giveUp = [&] {
    diagnosis.findings.clear();
    diagnosis.model = diagnosis.base;
    left = found->leftByBase;
    rest = remainderOf(diagnosis.base, false, *prepared, {errorsBefore, errorsBefore}, left, options.seed);
  };
  const double before = typicalSquare(errorsBefore);
  const double excess = std::max(before - rest.floors.perfect * rest.floors.perfect, 1e-300);
  double explained = (before - typicalSquare(errorsAfter)) / excess;
  // What lives in a few windows only shows in the plain mean.
  const double ofAll = 1.0 - mean(errorsAfter) / std::max(mean(errorsBefore), 1e-300);
  if (ofAll > glaringShare) explained = std::max(explained, ofAll);
  explained = std::clamp(explained, 0.0, 1.0);
  const bool currentToo = found->best.currentSquares < (1.0 - leastOfCurrent) * found->base.currentSquares;
  if (explained >= leastShare || currentToo) {
    diagnosis.findings = findingsOf(*found, diagnosis.model, input, explained);
  } else if (!found->chosen.empty()) {
    giveUp();
  }
  const double fitted = 1.0 - mean(found->best.windowSquares) / std::max(mean(found->base.windowSquares), 1e-300);
  if (rest.share > muchIsLeft && !diagnosis.findings.empty() && std::max(explained, fitted) < mostIsExplained &&
      !(currentToo && changesReadings(diagnosis.model))) {
    giveUp();  // what explains the smaller part of something unknown has borrowed its name
  }
  diagnosis.fit =
      scoreFit(bench, diagnosis.base, diagnosis.model, prepared->tracks, prepared->split, options, diagnosis.proof);
  // Held-out data chose nothing, but they may refuse: what makes them worse is not there, unless it is all that the
  // training data show, as a push in one recording is, and then they may only be somewhat worse.
  const double held = diagnosis.fit.heldoutAfter / diagnosis.fit.heldoutBefore;
  // Where they show much, a finding that takes hardly any of it away explains something else.
  const bool muchHeld = diagnosis.fit.heldoutBefore > muchFloors * diagnosis.fit.floor;
  // In few windows, or in a current that moves nothing.
  const bool elsewhere = currentToo || (ofAll >= glaringShare && (!muchHeld || allHappenOnce(diagnosis.findings)));
  const bool refused = held > (elsewhere ? muchWorseOnHeldout : muchHeld ? hardlyLessOnHeldout : worseOnHeldout);
  // A load that swings may run away in single windows after a restart and still be right in most; then the held-out
  // data have to show it.
  const bool usually = typicalSquare(errorsAfter) <= std::pow(leastFall, 2) * before && held < clearFallOnHeldout;
  const bool idle = !currentToo && diagnosis.fit.trainAfter > leastFall * diagnosis.fit.trainBefore && !usually;
  if (!diagnosis.findings.empty() && (refused || idle || isVague(diagnosis.findings))) {
    giveUp();
    diagnosis.fit =
        scoreFit(bench, diagnosis.base, diagnosis.model, prepared->tracks, prepared->split, options, diagnosis.proof);
  }
  if (!named_s) {
    for (const Finding& finding : diagnosis.findings) firstNames.push_back(finding.effect);
  }
  diagnosis.firstNames = std::move(firstNames);
  diagnosis.named_s = named_s ? *named_s : elapsed();
  const std::vector<Track>& training = prepared->training;
  if (rest.material) findPlaces(rest, diagnosis.model, *prepared, options.seed);
  const bool outside = rest.material;
  diagnosis.unexplainedShare = rest.share;
  diagnosis.unexplainedPValue = rest.pValue;
  if (!diagnosis.findings.empty() || outside) {
    diagnosis.where = places(residualMaps(diagnosis.base, training, options.seed), diagnosis.base);
    if (!diagnosis.findings.empty())
      preferAxis(diagnosis.where, findEffect(diagnosis.findings.front().effect)->drawnOver());
  }
  if (outside) {
    diagnosis.where.insert(diagnosis.where.begin(), rest.where.begin(), rest.where.end());
    diagnosis.verdict = Verdict::outsideCatalogue;
  } else if (diagnosis.findings.empty()) {
    diagnosis.verdict = Verdict::nothingMissing;
    remarkOnHeldout(diagnosis, *prepared, options.seed, left);
    diagnosis.unexplainedShare = 0.0;  // whatever is left has no place of its own
  } else {
    const bool rivals = std::any_of(diagnosis.findings.begin(), diagnosis.findings.end(), hasRealRivals);
    diagnosis.verdict = rivals ? Verdict::ambiguous : Verdict::named;
  }
  if ((outside || rest.wanders) && left.rms > 0.0 && left.rms < prepared->seen.peakTorque)
    diagnosis.remarks.push_back(wanderRemark(left, physicsOf(diagnosis.model).coulomb, prepared->seen));
  NextExperiment next = nextExperiment(diagnosis, bench, prepared->seen);
  diagnosis.nextSentence = std::move(next.sentence);
  diagnosis.nextSeparates = std::move(next.separates);
  diagnosis.elapsed_s = elapsed();
  return diagnosis;
}

}  // namespace breakaway
