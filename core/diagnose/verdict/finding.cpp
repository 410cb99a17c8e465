#include "diagnose/verdict/finding.h"

#include <algorithm>

#include "diagnose/effects/catalogue.h"

namespace breakaway {

const std::string* realRival(const Finding& finding) {
  const std::string_view twin = findEffect(finding.effect)->twin();
  const auto& rivals = finding.ambiguousWith;
  const auto real = std::find_if(rivals.begin(), rivals.end(), [twin](const std::string& one) { return one != twin; });
  return real == rivals.end() ? nullptr : &*real;
}

bool errsAlike(const RivalScore& rival) {
  return rival.ratioLow95 <= 1.0 && rival.ratioHigh95 >= 1.0;
}

bool allHappenOnce(const std::vector<Finding>& findings) {
  return std::all_of(findings.begin(), findings.end(),
                     [](const Finding& one) { return findEffect(one.effect)->happensOnce(); });
}

}  // namespace breakaway
