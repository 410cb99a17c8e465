#include "diagnose/verdict/unsealed.h"

#include <algorithm>

#include "diagnose/effects/catalogue.h"

namespace breakaway {

Unsealed unseal(const std::vector<std::string>& concealed, bool outside, const std::vector<std::string>& named,
                Verdict verdict) {
  Unsealed out;
  if (outside) {
    (verdict == Verdict::outsideCatalogue ? out.right : out.missed) = concealed;
    out.wrong = named;
  } else {
    out.missed = concealed;
    for (const std::string& name : named) {
      const auto found = std::find_if(out.missed.begin(), out.missed.end(),
                                      [&name](const std::string& one) { return countedAs(one) == countedAs(name); });
      if (found == out.missed.end()) {
        out.wrong.push_back(name);
        continue;
      }
      out.right.push_back(*found);
      out.missed.erase(found);
    }
  }
  out.isRight = out.missed.empty() && out.wrong.empty() && (!concealed.empty() || verdict == Verdict::nothingMissing);
  return out;
}

}  // namespace breakaway
