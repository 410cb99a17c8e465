#include "identify/winding_fit.h"

namespace breakaway {

Result<WindingFit> fitWinding(const WindingTest& test) {
  const auto line = fitWindingLine(test.points());
  if (!line) return line.error();
  const auto constant = fitTimeConstant(test.squareResponse());
  if (!constant) return constant.error();
  WindingFit fit{*line, *constant};
  for (size_t way = 0; way < 2; ++way) {
    for (const double one_A : test.breakaway_A()[way]) fit.expected_A[way] = std::max(fit.expected_A[way], one_A);
  }
  return fit;
}

}  // namespace breakaway
