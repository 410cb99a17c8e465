#include "experiment/travel_bins.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {

/// The tick at which the stroke first passes a place, or the trace's length; `way` 1 or −1.
size_t passes(const StrokeTrace& trace, double place_m, double way, size_t from) {
  for (size_t k = from; k < trace.position_m.size(); ++k) {
    if (way * (trace.position_m[k] - place_m) >= 0.0) return k;
  }
  return trace.position_m.size();
}

double speedAt(const StrokeTrace& trace, size_t tick, size_t half) {
  const size_t from = tick > half ? tick - half : 0, to = std::min(trace.position_m.size() - 1, tick + half);
  return (trace.position_m[to] - trace.position_m[from]) / (static_cast<double>(to - from) * trace.tick_s);
}

}  // namespace

void addStroke(const StrokeTrace& trace, const TravelBins& bins, double halfSpan_s,
               std::array<std::vector<TravelBinSums>, 2>& sums) {
  for (auto& way : sums) way.resize(bins.count);
  const size_t ticks = trace.position_m.size();
  if (ticks < 16 || !(trace.tick_s > 0.0)) return;
  const double way = trace.position_m.back() > trace.position_m.front() ? 1.0 : -1.0;
  const size_t half = std::max<size_t>(2, static_cast<size_t>(std::lround(halfSpan_s / trace.tick_s)));
  const double width_m = bins.width_m();
  size_t tick = half;
  for (size_t n = 0; n < bins.count; ++n) {
    const size_t bin = way > 0.0 ? n : bins.count - 1 - n;
    const double near_m = bins.centre_m(bin) - 0.5 * way * width_m, far_m = near_m + way * width_m;
    if (way * (trace.position_m[std::min(tick, ticks - 1)] - near_m) > 0.5 * width_m) continue;  // it began beyond
    const size_t in = passes(trace, near_m, way, tick), out = passes(trace, far_m, way, in);
    if (out + half >= ticks) break;
    tick = in;
    if (out < in + 2) continue;
    TravelBinSums& sum = sums[way > 0.0 ? 1 : 0][bin];
    for (size_t k = in; k < out; ++k) sum.current_A += trace.current_A[k];
    sum.samples += out - in;
    sum.velocity_m_per_s += (trace.position_m[out] - trace.position_m[in]) / trace.tick_s;
    sum.acceleration_m_per_s2 += (speedAt(trace, out, half) - speedAt(trace, in, half)) / trace.tick_s;
  }
}

}  // namespace breakaway
