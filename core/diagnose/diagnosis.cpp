#include "diagnose/diagnosis.h"

#include <algorithm>
#include <chrono>
#include <optional>

#include "diagnose/effects/catalogue.h"
#include "diagnose/fit/preparation.h"
#include "diagnose/fit/shared_rows.h"
#include "diagnose/fit/windowed_fit.h"
#include "diagnose/search/search.h"
#include "diagnose/simulate/physics.h"
#include "diagnose/verdict/judge.h"
#include "diagnose/verdict/next_experiment.h"
#include "diagnose/verdict/remainder.h"
#include "diagnose/verdict/where.h"

namespace breakaway {

namespace {

constexpr size_t fewestFarOff = 2;  ///< held-out windows that tell of something that the others don't show

std::string heldoutRemark(size_t far, size_t windows) {
  return std::to_string(far) + " of " + std::to_string(windows) + " held-out windows err more than " + farOffText() +
         " as much as sensors and friction explain. They show something that the data to learn from don't: learn from "
         "a recording that moves like these";
}

using Clock = std::chrono::steady_clock;

struct Attempt {
  Diagnosis diagnosis;
  /// Held-out windows that are far off, where the other parts of the same recordings show nothing, or what happens
  /// once.
  size_t farOff = 0;
};

Result<Attempt> diagnoseParts(const Bench& bench, const std::vector<Recording>& recordings,
                              const std::vector<Recording>& heldout, const DiagnoseOptions& options, HeldOut part,
                              Clock::time_point begin) {
  const auto elapsed = [begin] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
  const auto prepared = prepare(bench, recordings, heldout, options.window_s, part);
  if (!prepared) return prepared.error();
  std::optional<double> named_s;
  std::vector<std::string> firstNames;
  const auto named = [&](const std::vector<const Effect*>& effects) {
    named_s = elapsed();
    for (const Effect* effect : effects) firstNames.emplace_back(effect->name());
  };
  SearchInput input(*prepared, options.seed);
  input.stop = options.stop;
  input.progress = options.progress;
  input.named = named;
  const auto found = searchEffects(input, prepared->starts);
  if (!found) return found.error();

  Attempt attempt;
  Diagnosis& diagnosis = attempt.diagnosis;
  diagnosis.remarks = prepared->remarks;
  if (options.progress) options.progress(0.92, "proving on held-out data");
  Judgement judged = judge(bench, *prepared, input, *found);
  diagnosis.base = std::move(judged.base);
  diagnosis.model = std::move(judged.model);
  diagnosis.findings = std::move(judged.findings);
  diagnosis.fit = judged.fit;
  diagnosis.fit.window_s = options.window_s;
  diagnosis.proof = std::move(judged.proof);
  diagnosis.heldoutRows = prepared->split.heldoutRows;
  Remainder& rest = judged.rest;
  const TorqueNoise& left = judged.left;
  if (!named_s) {
    for (const Finding& finding : diagnosis.findings) firstNames.push_back(finding.effect);
  }
  diagnosis.firstNames = std::move(firstNames);
  diagnosis.named_s = named_s ? *named_s : elapsed();
  const std::vector<Track>& training = prepared->training;
  if (rest.material) findPlaces(rest, diagnosis.model, *prepared, options.seed);
  const bool outside = rest.material;
  const bool nothing = diagnosis.findings.empty() && !outside;
  if (nothing || (!diagnosis.findings.empty() && allHappenOnce(diagnosis.findings))) {
    const size_t far = farOffWindows(diagnosis.model, *prepared, prepared->split.heldoutScore, options.seed, left);
    if (nothing && far > 0) diagnosis.remarks.push_back(heldoutRemark(far, prepared->split.heldoutScore.size()));
    if (prepared->split.blocks) attempt.farOff = far;
  }
  diagnosis.unexplainedShare = rest.share;
  diagnosis.unexplainedPValue = rest.pValue;
  if (!diagnosis.findings.empty() || outside) {
    diagnosis.where = places(residualMaps(diagnosis.base, training, options.seed), diagnosis.base);
    if (!diagnosis.findings.empty())
      preferAxis(diagnosis.where, findEffect(diagnosis.findings.front().effect)->drawnOver());
  }
  diagnosis.verdict = verdictOf(diagnosis.findings, outside);
  if (outside) diagnosis.where.insert(diagnosis.where.begin(), rest.where.begin(), rest.where.end());
  if (nothing) diagnosis.unexplainedShare = 0.0;  // whatever is left has no place of its own
  if ((outside || rest.wanders) && left.rms > 0.0 && left.rms < prepared->seen.peakTorque)
    diagnosis.remarks.push_back(wanderRemark(left, physicsOf(diagnosis.model).coulomb, prepared->seen));
  NextExperiment next = nextExperiment(diagnosis.verdict, diagnosis.findings, diagnosis.where, bench, prepared->seen);
  diagnosis.nextSentence = std::move(next.sentence);
  diagnosis.nextSeparates = std::move(next.separates);
  diagnosis.elapsed_s = elapsed();
  return attempt;
}

}  // namespace

Result<Diagnosis> diagnose(const Bench& bench, const std::vector<Recording>& recordings,
                           const std::vector<Recording>& heldout, const DiagnoseOptions& options) {
  const Clock::time_point begin = Clock::now();
  if (const auto apart = checkSharedRows(bench, recordings, heldout); !apart) return apart.error();
  auto usual = diagnoseParts(bench, recordings, heldout, options, HeldOut::last, begin);
  if (!usual) return usual.error();
  if (usual->farOff < fewestFarOff) return std::move(usual->diagnosis);
  // What happens once may lie in the very part that is kept for the proof.
  auto other = diagnoseParts(bench, recordings, heldout, options, HeldOut::middle, begin);
  if (!other || other->diagnosis.verdict == Verdict::nothingMissing || other->farOff >= usual->farOff)
    return std::move(usual->diagnosis);
  other->diagnosis.remarks.emplace_back(
      "the part that is usually kept for the proof shows something that the others don't: another part was kept");
  return std::move(other->diagnosis);
}

}  // namespace breakaway
