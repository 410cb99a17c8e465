// From many scored trials to the figures that say how good the diagnosis is.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "score/scored_trial.h"

namespace breakaway {

/// Whose answers are scored. The baselines give names only: no rivals, sizes or times.
enum class Method { diagnosis, stepwise, thresholded };

/// `hits` of `runs`.
struct Share {
  size_t hits = 0, runs = 0;
  void count(bool hit) {
    ++runs;
    hits += hit ? 1 : 0;
  }
  double value() const { return runs > 0 ? static_cast<double>(hits) / static_cast<double>(runs) : 0.0; }
};

struct FamilyScore {
  std::string family;
  size_t runs = 0, failed = 0, identifiable = 0;
  size_t firstRight = 0, topTwo = 0;  ///< of the identifiable ones; top two: the first name or one of its rivals
  size_t ambiguous = 0, nothingMissing = 0, outside = 0;  ///< verdicts
  size_t wrongExtras = 0;                                 ///< names that aren't concealed
};

/// Recall of concealed effects where the base model errs `from` to `to` times the floor.
struct SizeBin {
  double from = 0.0, to = 0.0;
  Share found;
};

struct Score {
  Method method = Method::diagnosis;
  std::vector<FamilyScore> families;                                 ///< in the order of trialFamilies()
  Share firstName, topTwo;                                           ///< identifiable trials with one effect
  Share firstNameAll;                                                ///< all identifiable trials with any effect
  size_t truePositives = 0, falsePositives = 0, falseNegatives = 0;  ///< names in identifiable combinations
  size_t runs = 0, wrongExtras = 0;                                  ///< of trials with effects of the catalogue
  Share falseAlarms;                                                 ///< clean trials
  Share outsideFlagged, outsideNamed;                                ///< material trials of physics outside
  Share wrongMasked, wrongWeak, wrongNoisy, wrongLow;  ///< a name that is neither right nor rivals the truth
  std::vector<SizeBin> recall;
  std::vector<double> achieved;         ///< part of the achievable gain, identifiable trials with effects
  std::vector<double> amplitudeErrors;  ///< relative, of rightly named effects in identifiable trials
  Share covered;                        ///< truths within their 95 % intervals, the same trials
  std::vector<double> named_s, elapsed_s;
  Share agreement;  ///< of first and final names, where known

  double f1() const;
};

Score scoreOf(const std::vector<ScoredTrial>& trials, Method method);

/// The table per family as Markdown.
std::string familyTable(const Score& score);
/// All else as Markdown, one column per score; the first is the diagnosis'.
std::string totalsTable(const std::vector<Score>& scores);

}  // namespace breakaway
