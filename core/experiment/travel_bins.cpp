#include "experiment/travel_bins.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {

/// The tick at which the stroke is nearest to a place that it passes, or the trace's length; `way` 1 or −1. The first
/// one beyond it would be half a tick late on average, and what cogging asks for there is another force, the faster it
/// goes.
size_t passes(const StrokeTrace& trace, double place_m, double way, size_t from) {
  for (size_t k = from; k < trace.position_m.size(); ++k) {
    const double beyond_m = way * (trace.position_m[k] - place_m);
    if (beyond_m < 0.0) continue;
    const bool before = k > from && way * (place_m - trace.position_m[k - 1]) < beyond_m;
    return before ? k - 1 : k;
  }
  return trace.position_m.size();
}

double differenceAt(const StrokeTrace& trace, size_t tick, size_t half) {
  const size_t from = tick > half ? tick - half : 0, to = std::min(trace.position_m.size() - 1, tick + half);
  return (trace.position_m[to] - trace.position_m[from]) / (static_cast<double>(to - from) * trace.tick_s);
}

double speedAt(const StrokeTrace& trace, size_t tick, size_t half) {
  const double near = differenceAt(trace, tick, half);
  return trace.reachesFar ? (4.0 * near - differenceAt(trace, tick, 2 * half)) / 3.0 : near;
}

/// Of the later of two samples in the current's mean between them: the voltage is constant meanwhile, and the current
/// follows it by 1 − e^(−t/τ). A half where a tick is short against L/R, all of it where the current is there at once.
double laterPart(double tick_s, double windingTime_s) {
  const double ratio = tick_s / std::max(1e-12, windingTime_s);
  if (ratio < 1e-3) return 0.5;
  const double reached = -std::expm1(-ratio);
  return (1.0 - reached / ratio) / reached;
}

constexpr double steadyPart = 0.35;  // part of its speed by which a stroke may swing about it

/// Root mean square over the ticks [in, out) of ∫(i − a − b·t)dt, with the line a + b·t fitted to the current, without
/// what white noise makes of it: a fifteenth of its variance a tick.
double swing_A_s(const StrokeTrace& trace, size_t in, size_t out, double noiseRms_A) {
  const auto n = static_cast<double>(out - in);
  const double middle = 0.5 * (n - 1.0);
  double mean = 0.0, moment = 0.0;
  for (size_t k = in; k < out; ++k) {
    mean += trace.current_A[k] / n;
    moment += (static_cast<double>(k - in) - middle) * trace.current_A[k];
  }
  const double slope = moment / (n * (n * n - 1.0) / 12.0);
  double integral = 0.0, squares = 0.0;
  for (size_t k = in; k < out; ++k) {
    integral += (trace.current_A[k] - mean - slope * (static_cast<double>(k - in) - middle)) * trace.tick_s;
    squares += integral * integral;
  }
  return std::sqrt(std::max(0.0, squares / n - std::pow(noiseRms_A * trace.tick_s, 2) * n / 15.0));
}

}  // namespace

void addStroke(const StrokeTrace& trace, const TravelBins& bins, double halfSpan_s, const Steadiness& steadiness,
               std::array<std::vector<TravelBinSums>, 2>& sums) {
  for (auto& way : sums) way.resize(bins.count);
  const size_t ticks = trace.position_m.size();
  if (ticks < 16 || !(trace.tick_s > 0.0)) return;
  const double way = trace.position_m.back() > trace.position_m.front() ? 1.0 : -1.0;
  const size_t half = std::max<size_t>(2, static_cast<size_t>(std::lround(halfSpan_s / trace.tick_s)));
  const double width_m = bins.width_m();
  const double later = laterPart(trace.tick_s, trace.windingTime_s);
  const size_t reach = trace.reachesFar ? 2 * half : half;
  size_t tick = reach;
  for (size_t n = 0; n < bins.count; ++n) {
    const size_t bin = way > 0.0 ? n : bins.count - 1 - n;
    const double near_m = bins.centre_m(bin) - 0.5 * way * width_m, far_m = near_m + way * width_m;
    if (way * (trace.position_m[std::min(tick, ticks - 1)] - near_m) > 0.5 * width_m) continue;  // it began beyond
    const size_t in = passes(trace, near_m, way, tick), out = passes(trace, far_m, way, in);
    if (out + reach >= ticks) break;
    tick = in;
    if (out < in + 2) continue;
    const double speed = width_m / (static_cast<double>(out - in) * trace.tick_s);
    if (steadiness.perAmpere_m_per_s2 * swing_A_s(trace, in, out, steadiness.noiseRms_A) > steadyPart * speed) continue;
    TravelBinSums& sum = sums[way > 0.0 ? 1 : 0][bin];
    // From tick to tick, as the speed's growth is: a half of one off, and what cogging asks of the current at each
    // place would look like friction that grows with speed.
    for (size_t k = in; k < out; ++k)
      sum.current_A += (1.0 - later) * trace.current_A[k] + later * trace.current_A[k + 1];
    sum.samples += out - in;
    sum.velocity_m_per_s += (trace.position_m[out] - trace.position_m[in]) / trace.tick_s;
    sum.acceleration_m_per_s2 += (speedAt(trace, out, half) - speedAt(trace, in, half)) / trace.tick_s;
  }
}

}  // namespace breakaway
