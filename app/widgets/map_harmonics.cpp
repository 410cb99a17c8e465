#include "widgets/map_harmonics.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace breakaway {

std::vector<double> harmonicsOf(const MapCurve& curve, int most) {
  const size_t count = curve.points.size();
  if (!curve.closed || count < 2 * static_cast<size_t>(most) + 1) return {};
  std::vector<double> amplitudes;
  for (int order = 1; order <= most; ++order) {
    std::complex<double> sum = 0.0;
    for (const MapPoint& point : curve.points) sum += std::polar(point.value, -order * point.at);
    amplitudes.push_back(2.0 * std::abs(sum) / static_cast<double>(count));
  }
  return amplitudes;
}

std::vector<double> ordersShownBy(const MapCurve& curve, int most) {
  const int shown = std::min(most, (static_cast<int>(curve.points.size()) - 1) / 2);
  return shown > 0 ? harmonicsOf(curve, shown) : std::vector<double>();
}

std::vector<MapCurve> meansByColour(const std::vector<MapCurve>& curves) {
  std::vector<MapCurve> means;
  std::vector<double> counts;
  for (const MapCurve& curve : curves) {
    if (!curve.closed) continue;
    size_t at = 0;
    while (at < means.size() && (means[at].colour != curve.colour || means[at].points.size() != curve.points.size()))
      ++at;
    if (at == means.size()) {
      means.push_back(curve);
      counts.push_back(1.0);
      continue;
    }
    counts[at] += 1.0;
    for (size_t k = 0; k < curve.points.size(); ++k)
      means[at].points[k].value += (curve.points[k].value - means[at].points[k].value) / counts[at];
  }
  return means;
}

}  // namespace breakaway
