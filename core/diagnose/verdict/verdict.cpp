#include "diagnose/verdict/verdict.h"

#include <algorithm>

namespace breakaway {

Verdict verdictOf(const std::vector<Finding>& findings, bool outside) {
  if (outside) return Verdict::outsideCatalogue;
  if (findings.empty()) return Verdict::nothingMissing;
  const bool rivals =
      std::any_of(findings.begin(), findings.end(), [](const Finding& one) { return realRival(one) != nullptr; });
  return rivals ? Verdict::ambiguous : Verdict::named;
}

std::string nameOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::nothingMissing:
      return "nothing_missing";
    case Verdict::named:
      return "named";
    case Verdict::ambiguous:
      return "ambiguous";
    case Verdict::outsideCatalogue:
      return "outside_catalogue";
    case Verdict::undecided:
      return "undecided";
  }
  return {};
}

}  // namespace breakaway
