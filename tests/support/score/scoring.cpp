#include "score/scoring.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "diagnose/effects/catalogue.h"

namespace breakaway {

namespace {

struct Answer {
  std::string verdict;
  std::vector<ScoredName> names;
};

Answer answerOf(const ScoredTrial& trial, Method method) {
  if (method == Method::diagnosis) return {trial.verdict, trial.answer};
  Answer answer;
  for (const std::string& name : method == Method::stepwise ? trial.stepwise : trial.thresholded)
    answer.names.push_back({name, {}});
  answer.verdict = nameOf(answer.names.empty() ? Verdict::nothingMissing : Verdict::named);
  return answer;
}

std::set<std::string> truthOf(const ScoredTrial& trial) {
  std::set<std::string> truth;
  for (const std::string& one : trial.truth) truth.insert(countedAs(one));
  return truth;
}

bool rivalsTruth(const ScoredName& name, const std::set<std::string>& truth) {
  return std::any_of(name.rivals.begin(), name.rivals.end(),
                     [&truth](const std::string& rival) { return truth.contains(countedAs(rival)); });
}

FamilyScore& familyIn(Score& score, const std::string& family) {
  const auto found = std::find_if(score.families.begin(), score.families.end(),
                                  [&family](const FamilyScore& one) { return one.family == family; });
  return found != score.families.end() ? *found : score.families.emplace_back(FamilyScore{.family = family});
}

/// What one answer does to the counts.
struct Marks {
  bool firstRight = false, topTwo = false;
  bool wrong = false;  ///< a name that is neither right nor rivals the truth
  size_t right = 0;    ///< concealed effects that were named
  size_t extras = 0;   ///< names that aren't concealed
};

Marks marksOf(const Answer& answer, const std::set<std::string>& truth) {
  Marks marks;
  std::set<std::string> named;
  for (const ScoredName& one : answer.names) {
    const bool right = truth.contains(countedAs(one.effect)), first = &one == answer.names.data();
    if (first) {
      marks.firstRight = right;
      marks.topTwo = right || rivalsTruth(one, truth);
    }
    if (!named.insert(countedAs(one.effect)).second) continue;
    marks.right += right ? 1 : 0;
    marks.extras += right ? 0 : 1;
    marks.wrong = marks.wrong || (!right && !rivalsTruth(one, truth));
  }
  return marks;
}

void countOutside(Score& score, const ScoredTrial& trial, const Answer& answer) {
  if (!trial.identifiable) return;
  const bool flagged = answer.verdict == nameOf(Verdict::outsideCatalogue);
  score.outsideFlagged.count(flagged);
  score.outsideNamed.count(!flagged && !answer.names.empty());
}

void countSizes(Score& score, const ScoredTrial& trial) {
  if (trial.achievable > 0.0 && trial.before > trial.achievable)
    score.achieved.push_back((trial.before - trial.after) / (trial.before - trial.achievable));
  for (const ScoredParameter& one : trial.parameters) {
    const double error = std::abs(one.value - one.truth);
    if (one.amplitude && one.truth != 0.0) score.amplitudeErrors.push_back(error / std::abs(one.truth));
    if (one.low95 < one.high95) score.covered.count(one.low95 <= one.truth && one.truth <= one.high95);
  }
}

void countConcealed(Score& score, const ScoredTrial& trial, const Marks& marks, const std::set<std::string>& truth) {
  ++score.runs;
  score.wrongExtras += marks.extras;
  if (trial.family == "masked") score.wrongMasked.count(marks.wrong);
  if (trial.family == "weak") score.wrongWeak.count(marks.wrong);
  if (trial.family == "noisy") score.wrongNoisy.count(marks.wrong);
  if (trial.family == "low") score.wrongLow.count(marks.wrong);
  for (SizeBin& bin : score.recall) {
    if (trial.size <= 0.0 || trial.size < bin.from || trial.size >= bin.to) continue;  // 0: not known
    bin.found.hits += marks.right;
    bin.found.runs += truth.size();
  }
  if (!trial.identifiable) return;
  score.firstNameAll.count(marks.firstRight);
  if (truth.size() == 1) {
    score.firstName.count(marks.firstRight);
    score.topTwo.count(marks.topTwo);
  } else {
    score.truePositives += marks.right;
    score.falsePositives += marks.extras;
    score.falseNegatives += truth.size() - marks.right;
  }
  if (score.method == Method::diagnosis) countSizes(score, trial);
}

void countTrial(Score& score, const ScoredTrial& trial) {
  const Answer answer = answerOf(trial, score.method);
  const auto truth = truthOf(trial);
  const Marks marks = marksOf(answer, truth);
  FamilyScore& family = familyIn(score, trial.family);
  ++family.runs;
  family.failed += trial.error.empty() ? 0 : 1;
  family.identifiable += trial.identifiable ? 1 : 0;
  if (trial.identifiable) {
    family.firstRight += marks.firstRight ? 1 : 0;
    family.topTwo += marks.topTwo ? 1 : 0;
  }
  family.ambiguous += answer.verdict == nameOf(Verdict::ambiguous) ? 1 : 0;
  family.nothingMissing += answer.verdict == nameOf(Verdict::nothingMissing) ? 1 : 0;
  family.outside += answer.verdict == nameOf(Verdict::outsideCatalogue) ? 1 : 0;
  family.wrongExtras += marks.extras;
  if (!trial.outside.empty()) {
    countOutside(score, trial, answer);
  } else if (truth.empty()) {
    score.falseAlarms.count(trial.error.empty() && answer.verdict != nameOf(Verdict::nothingMissing));
  } else {
    countConcealed(score, trial, marks, truth);
  }
  if (score.method != Method::diagnosis || !trial.error.empty()) return;
  score.named_s.push_back(trial.named_s);
  score.elapsed_s.push_back(trial.elapsed_s);
  if (trial.agreementKnown) score.agreement.count(trial.agrees);
}

}  // namespace

double Score::f1() const {
  const auto wrong = static_cast<double>(falsePositives + falseNegatives), right = static_cast<double>(truePositives);
  return right > 0.0 ? 2.0 * right / (2.0 * right + wrong) : 0.0;
}

Score scoreOf(const std::vector<ScoredTrial>& trials, Method method) {
  Score score;
  score.method = method;
  const double edges[]{0.0, 1.2, 1.6, 2.5, 4.0, 8.0, 1e300};
  for (size_t k = 0; k + 1 < std::size(edges); ++k) score.recall.push_back({edges[k], edges[k + 1], {}});
  const std::set<std::string> present = [&trials] {
    std::set<std::string> families;
    for (const ScoredTrial& trial : trials) families.insert(trial.family);
    return families;
  }();
  for (const std::string& family : trialFamilies()) {
    if (present.contains(family)) familyIn(score, family);
  }
  for (const ScoredTrial& trial : trials) countTrial(score, trial);
  return score;
}

}  // namespace breakaway
