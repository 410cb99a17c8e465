#include "stability/reach.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

Reach farthest(double lowest, double highest, const std::function<std::string(double)>& loss) {
  Reach reach;
  double lost = highest;
  for (double one = lowest; one < highest * 1.4; one *= 1.4) {
    const double tried = std::min(one, highest);
    const std::string why = loss(tried);
    if (why.empty()) {
      reach = {tried, {}};
      continue;
    }
    reach.heldBy = why;
    if (reach.most > 0.0) {
      lost = tried;
      break;
    }
  }
  if (!(reach.most > 0.0) || reach.heldBy.empty()) return reach;
  while (lost > 1.002 * reach.most) {
    const double middle = std::sqrt(lost * reach.most);
    const std::string why = loss(middle);
    if (why.empty()) {
      reach.most = middle;
    } else {
      lost = middle;
      reach.heldBy = why;
    }
  }
  return reach;
}

}  // namespace breakaway
