#include "diagnose/diagnosis.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <optional>

#include "diagnose/effects/catalogue.h"
#include "diagnose/effects/wording.h"
#include "diagnose/fit/inverse_fit.h"
#include "diagnose/fit/preparation.h"
#include "diagnose/fit/shared_rows.h"
#include "diagnose/fit/windowed_fit.h"
#include "diagnose/screen/linear_rig.h"
#include "diagnose/search/foresight.h"
#include "diagnose/search/search.h"
#include "diagnose/simulate/physics.h"
#include "diagnose/verdict/judge.h"
#include "diagnose/verdict/next_experiment.h"
#include "diagnose/verdict/remainder.h"
#include "diagnose/verdict/where.h"

namespace breakaway {

namespace {

constexpr size_t fewestFarOff = 2;  ///< held-out windows that tell of something that the others don't show

Message heldoutRemark(size_t far, size_t windows, const Criteria& criteria) {
  return message(
      "{} of {} held-out windows err more than {} as much as sensors and friction explain. They show something that "
      "the data to learn from don't: learn from a recording that moves like these",
      std::to_string(far), std::to_string(windows), farOffText(criteria));
}

/// Why a base model that ran away isn't to be believed, or nothing.
std::optional<Message> runAwayText(const Model& base, const Model& inverse, const Criteria& criteria) {
  const auto ratio = runAway(base, inverse, criteria);
  if (!ratio) return std::nullopt;
  const double shown = inverse.baseValue(motorNames(base.axis).inertia).value_or(0.0);
  return message(
      "friction changes along the way by more than the base model knows, and the motion is too slow to be foreseen "
      "beside that: fitted to windows of it, the inertia would be {} times the {} that torque and acceleration show. "
      "The base parameters are by these; reverse harder to see more",
      digitsText(*ratio), inertiaText(shown, base.axis));
}

Message cutRemark() {
  return message("the time was over before all was looked for: there may be more");
}

Message unweighedRemark() {
  return message("the time was over before all rivals were tried: those that weren't are listed, too");
}

Message inTorqueRemark(Axis axis) {
  return message(
      "the motion can't be foreseen from what drove it: errors are counted in the {} that it took, along the recorded "
      "motion. What the drive's own {} changes, what is late, and what happens at standstill can't be told so",
      torqueWord(axis), torqueWord(axis));
}

using Clock = std::chrono::steady_clock;

/// Of all threads of the process.
double processorTime_s() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Attempt {
  Diagnosis diagnosis;
  /// Held-out windows that are far off, where the other parts of the same recordings show nothing, or what happens
  /// once.
  size_t farOff = 0;
  std::optional<Message> runAway;  ///< the base model did, and nothing was found
  bool cut = false;                ///< SearchResult::cut
};

/// One diagnosis, with its clocks running.
class Diagnoser {
 public:
  Diagnoser(const Bench& bench, const std::vector<Recording>& recordings, const std::vector<Recording>& heldout,
            const DiagnoseOptions& options)
      : bench_(bench), recordings_(recordings), heldout_(heldout), options_(options) {}

  /// By errors in motion, unless these would lead astray.
  Result<Attempt> attempt(HeldOut part) const { return attempt(part, {ErrorIn::motion, options_.window_s}, true); }

  Result<Attempt> attempt(HeldOut part, const Counting& counting, bool mayChange) const {
    const auto prepared =
        prepare(bench_, recordings_, heldout_, counting.window_s, part, counting.errorIn, options_.criteria);
    if (!prepared) return prepared.error();
    std::optional<double> named_s;
    std::vector<std::string> firstNames;
    SearchInput input = inputFor(*prepared);
    input.mayShorten = mayChange;
    input.mayTurnToTorque =
        mayChange && !prepared->tracks.front().speedAlone() && !bench_.servo && !bench_.electrical();
    input.named = [&](const std::vector<const Effect*>& effects) {
      named_s = elapsed_s();
      for (const Effect* effect : effects) firstNames.emplace_back(effect->name());
    };
    const auto found = searchEffects(input, prepared->starts);
    if (!found) return found.error();
    if (found->counting) {
      auto otherwise = attempt(part, *found->counting, false);
      return otherwise ? std::move(otherwise) : attempt(part, counting, false);
    }

    Attempt made;
    Diagnosis& diagnosis = made.diagnosis;
    made.cut = diagnosis.cutShort = found->cut;
    if (found->cut && found->chosen.empty()) return made;  // nothing to prove
    const Model& base = found->base.model;
    input.seen.inertia = base.baseValue(motorNames(base.axis).inertia).value_or(input.seen.inertia);  // as the search
    input.say(0.92, message("proving on held-out data"));
    Remainder rest = take(diagnosis, judge(bench_, *prepared, input, *found), *prepared);
    if (!named_s) {
      for (const Finding& finding : diagnosis.findings) firstNames.push_back(finding.effect);
    }
    diagnosis.firstNames = std::move(firstNames);
    diagnosis.named_s = named_s ? *named_s : elapsed_s();
    findPlaces(rest, diagnosis.model, *prepared, options_.seed);
    // What wasn't looked for may well be in the catalogue.
    diagnosis.verdict = verdictOf(diagnosis.findings, rest.outside() && !found->cut);
    if (found->cut) diagnosis.remarks.push_back(cutRemark());
    if (found->unweighed) diagnosis.remarks.push_back(unweighedRemark());
    addPlaces(diagnosis, rest, *prepared);
    made.farOff = farOff(diagnosis, *prepared);
    if (diagnosis.verdict == Verdict::outsideCatalogue && diagnosis.findings.empty())
      made.runAway = runAwayText(diagnosis.base, prepared->starts.front(), options_.criteria);
    NextExperiment next =
        nextExperiment(diagnosis.verdict, diagnosis.findings, diagnosis.where, bench_, prepared->seen);
    diagnosis.nextSentence = std::move(next.sentence);
    diagnosis.nextSeparates = std::move(next.separates);
    diagnosis.nextManeuver = std::move(next.maneuver);
    stop(diagnosis);
    return made;
  }

  /// The base model fitted to all there is, for recordings of which nothing can be held out; or by torque and
  /// acceleration, where no window of them can be foreseen.
  Result<Diagnosis> undecided(const std::vector<Message>& why, bool foreseeable = true) const {
    auto prepared =
        prepare(bench_, recordings_, {}, options_.window_s, HeldOut::none, ErrorIn::motion, options_.criteria);
    if (!prepared) return prepared.error();
    prepared->split.heldoutScore = prepared->split.trainScore;
    const SearchInput input = inputFor(*prepared);
    SearchResult found;
    if (foreseeable) {
      found.base = fitBase(input, prepared->starts);
      found.base = polishModel(input, found.base.model, polishWeights(input, found.base.model, found.base.model));
    } else {
      const auto inverse = fitInverse(prepared->starts.front(), prepared->training);
      if (!inverse) return inverse.error();
      found.base = fitModel(input, inverse->model, 0);
      found.base.model = inverse->model;
      // Friction that falls with speed looks like a negative one, beside which no motion is stable.
      for (Parameter& one : found.base.model.base) {
        if (one.name == motorNames(bench_.axis).viscous)
          one = {one.name, std::max(one.value, 0.0), std::max(one.low95, 0.0), std::max(one.high95, 0.0)};
      }
    }
    found.best = found.base;
    found.left = found.leftByBase =
        LinearRig(found.base.model, input.tracks, input.split.train, Torque::wandering).wander();
    Diagnosis diagnosis;
    take(diagnosis, judge(bench_, *prepared, input, found), *prepared);
    diagnosis.verdict = Verdict::undecided;
    diagnosis.remarks.insert(diagnosis.remarks.begin(), why.begin(), why.end());
    NextExperiment next = mostInformative(prepared->seen);
    diagnosis.nextSentence = std::move(next.sentence);
    diagnosis.nextManeuver = std::move(next.maneuver);
    if (!foreseeable && diagnosis.nextSentence.empty()) {
      const double speed = 2.0 * prepared->seen.highSpeed;
      diagnosis.nextSentence =
          message("Reverse at least twenty times at {}, as hard as the drive can.", speedText(speed, bench_.axis));
      diagnosis.nextManeuver = reversals(speed, 20, 0.5);
    }
    diagnosis.named_s = elapsed_s();
    stop(diagnosis);
    return diagnosis;
  }

 private:
  double elapsed_s() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }
  void stop(Diagnosis& diagnosis) const {
    diagnosis.elapsed_s = elapsed_s();
    diagnosis.cpu_s = processorTime_s() - cpuBegin_s_;
  }

  SearchInput inputFor(const Preparation& prepared) const {
    SearchInput input(prepared, options_.seed);
    input.stop = options_.stop;
    input.time = options_.time;
    input.progress = options_.progress;
    return input;
  }

  Remainder take(Diagnosis& diagnosis, Judgement judged, const Preparation& prepared) const {
    diagnosis.remarks = prepared.remarks;
    diagnosis.criteria = options_.criteria;
    diagnosis.base = std::move(judged.base);
    diagnosis.model = std::move(judged.model);
    diagnosis.findings = std::move(judged.findings);
    diagnosis.fit = judged.fit;
    diagnosis.fit.window_s = prepared.split.window_s;
    diagnosis.proof = std::move(judged.proof);
    diagnosis.heldoutRows = prepared.split.heldoutRows;
    diagnosis.wander = judged.rest.wander;
    if (diagnosis.fit.inTorque()) diagnosis.remarks.push_back(inTorqueRemark(bench_.axis));
    if (judged.rest.wander.rms > 0.0 && judged.rest.wander.rms < prepared.seen.peakTorque)
      diagnosis.remarks.push_back(
          wanderRemark(judged.rest.wander, physicsOf(diagnosis.model).coulomb, prepared.seen, options_.criteria));
    return std::move(judged.rest);
  }

  void addPlaces(Diagnosis& diagnosis, const Remainder& rest, const Preparation& prepared) const {
    if (rest.outside()) {
      diagnosis.unexplainedShare = rest.part;
      diagnosis.unexplainedPValue = rest.pValue;
    }
    if (!diagnosis.findings.empty() || rest.outside()) {
      diagnosis.where = places(residualMaps(diagnosis.base, prepared.training, options_.seed, heldoutTracks(prepared)),
                               diagnosis.base, options_.criteria);
      if (!diagnosis.findings.empty())
        preferAxis(diagnosis.where, findEffect(diagnosis.findings.front().effect)->drawnOver(), options_.criteria);
    }
    // Beside findings that leave hardly anything, what they lack comes last.
    const auto at = rest.outside() ? diagnosis.where.begin() : diagnosis.where.end();
    diagnosis.where.insert(at, rest.where.begin(), rest.where.end());
  }

  /// Attempt::farOff; says so where nothing was found. Of windows that train, as many may be far off.
  size_t farOff(Diagnosis& diagnosis, const Preparation& prepared) const {
    const bool nothing = diagnosis.verdict == Verdict::nothingMissing;
    if (!nothing && (diagnosis.findings.empty() || !allHappenOnce(diagnosis.findings))) return 0;
    const auto far = [&](const std::vector<Window>& windows) {
      return farOffWindows(diagnosis.model, prepared, windows, options_.seed, diagnosis.wander);
    };
    const std::vector<Window>&heldout = prepared.split.heldoutScore, &train = prepared.split.trainScore;
    const size_t kept = far(heldout);
    if (kept == 0 || far(train) * heldout.size() >= kept * train.size()) return 0;
    if (nothing) diagnosis.remarks.push_back(heldoutRemark(kept, heldout.size(), options_.criteria));
    return prepared.split.blocks ? kept : 0;
  }

  const Bench& bench_;
  const std::vector<Recording>&recordings_, &heldout_;
  const DiagnoseOptions& options_;
  Clock::time_point begin_ = Clock::now();
  double cpuBegin_s_ = processorTime_s();
};

/// Recordings whose columns hold what they say.
Result<Diagnosis> diagnoseAsRead(const Bench& bench, const std::vector<Recording>& recordings,
                                 const std::vector<Recording>& heldout, const DiagnoseOptions& options) {
  const Diagnoser diagnoser(bench, recordings, heldout, options);
  auto usual = diagnoser.attempt(HeldOut::last);
  if (!usual) {
    // What can be fitted, but not proved, is worth its base parameters.
    auto fitted = diagnoser.undecided({usual.error().said()});
    return fitted ? std::move(fitted) : usual.error();
  }
  if (usual->runAway) {
    auto fitted = diagnoser.undecided({*usual->runAway}, false);
    return fitted ? std::move(fitted) : std::move(usual->diagnosis);
  }
  if (usual->cut && usual->diagnosis.findings.empty()) {
    auto fitted = diagnoser.undecided({message("the time was over before all was looked for: give it more")});
    if (!fitted) return fitted.error();
    fitted->cutShort = true;
    return fitted;
  }
  if (usual->farOff < fewestFarOff || options.time.over(partToSearch)) return std::move(usual->diagnosis);
  // What happens once may lie in the very part that is kept for the proof.
  auto other = diagnoser.attempt(HeldOut::middle);
  if (!other || other->diagnosis.verdict == Verdict::nothingMissing || other->farOff >= usual->farOff)
    return std::move(usual->diagnosis);
  other->diagnosis.remarks.push_back(message(
      "the part that is usually kept for the proof shows something that the others don't: another part was kept"));
  return std::move(other->diagnosis);
}

/// The base model of the recordings with what was misread put right.
Result<Diagnosis> misread(const Bench& bench, const std::vector<Recording>& recordings, const DiagnoseOptions& options,
                          const Misreading& what) {
  const Bench right = mended(bench, what);
  const std::vector<Recording> read = mended(recordings, std::optional(what));
  const Diagnoser diagnoser(right, read, {}, options);
  auto diagnosis = diagnoser.undecided(
      {what.sentence, message("base and model are of {}: put it right, and diagnose again", what.mended)});
  if (!diagnosis) return Error{"", what.sentence + " (" + diagnosis.error().said() + ")"};
  diagnosis->misread = what;
  return diagnosis;
}

}  // namespace

Result<Diagnosis> diagnose(const Bench& bench, const std::vector<Recording>& recordings,
                           const std::vector<Recording>& heldout, const DiagnoseOptions& options) {
  if (const auto apart = checkSharedRows(bench, recordings, heldout); !apart) return apart.error();
  const auto scales = checkScales(bench, recordings, options.criteria);
  if (!scales) return scales.error();
  if (scales->misread) return misread(bench, recordings, options, *scales->misread);
  auto diagnosis = diagnoseAsRead(bench, recordings, heldout, options);
  if (diagnosis) diagnosis->remarks.insert(diagnosis->remarks.begin(), scales->remarks.begin(), scales->remarks.end());
  return diagnosis;
}

}  // namespace breakaway
