#include "experiment/square_response.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

void SquareResponse::take(const Sample& sample) {
  // Bridges may ask for nothing in between; an edge is a change of sign.
  const bool high = sample.voltage_V == 0.0 ? high_ : sample.voltage_V > 0.0;
  const bool gap = begun_ && sample.time_s - last_s_ > 1.5 * tick_s_;
  if (!begun_ || gap) edges_ = 0;
  const bool edge = begun_ && !gap && high != high_;
  if (edge && edges_ > 0) {
    halves_s_ += sample.time_s - edge_s_;
    ++halves_;
  }
  if (edge) {
    edge_s_ = sample.time_s;
    ++edges_;
  }
  begun_ = true;
  high_ = high;
  last_s_ = sample.time_s;
  if (edges_ < 2) return;  // the half period before it is the beginning's transient, or wasn't seen
  // The voltage of a sample acts from its tick on, so that the current of the edge's own sample is the response's
  // first.
  const auto since = static_cast<size_t>(std::lround((sample.time_s - edge_s_) / tick_s_));
  const size_t ticks = sums_.size() / 2;
  if (since >= ticks) return;
  const size_t slot = since + (high ? 0 : ticks);
  sums_[slot] += sample.current_A;
  ++counts_[slot];
}

std::vector<double> SquareResponse::current_A() const {
  std::vector<double> response;
  const size_t ticks = sums_.size() / 2;
  for (size_t k = 0; k < ticks && counts_[k] > 0 && counts_[k + ticks] > 0; ++k) {
    response.push_back(0.5 * (sums_[k] / static_cast<double>(counts_[k]) -
                              sums_[k + ticks] / static_cast<double>(counts_[k + ticks])));
  }
  return response;
}

Result<Estimate> fitTimeConstant(const SquareResponse& square) {
  const std::vector<double> response = square.current_A();
  const double tick_s = square.tick_s(), half_s = square.halfPeriod_s();
  if (response.size() < 4 || half_s <= 0.0)
    return Error{"winding", message("has fewer than 4 ticks in half a square wave")};
  double scale = 0.0;
  const auto shape = [half_s](double t, double tau) {
    return 1.0 - 2.0 * std::exp(-t / tau) / (1.0 + std::exp(-half_s / tau));
  };
  const auto squaresFor = [&](double tau) {
    double xx = 0.0, xy = 0.0, yy = 0.0;
    for (size_t k = 0; k < response.size(); ++k) {
      const double x = shape(static_cast<double>(k) * tick_s, tau);
      xx += x * x, xy += x * response[k], yy += response[k] * response[k];
    }
    scale = xy / xx;
    return yy - xy * xy / xx;
  };
  const double low = std::log(0.05 * tick_s), high = std::log(2.0 * half_s);
  double best = low, bestSquares = squaresFor(std::exp(low));
  double from = low, to = high;
  for (int round = 0; round < 8; ++round) {
    const double step = (to - from) / 20.0;
    for (int k = 0; k <= 20; ++k) {
      const double squares = squaresFor(std::exp(from + k * step));
      if (squares < bestSquares) bestSquares = squares, best = from + k * step;
    }
    from = std::max(low, best - step);
    to = std::min(high, best + step);
  }
  const double tau = std::exp(best);
  bestSquares = squaresFor(tau);
  const double amplitude = scale, variance = bestSquares / static_cast<double>(response.size() - 2);
  if (!(std::abs(amplitude) > 3.0 * std::sqrt(variance)))
    return Error{"winding", message("shows no step response above the noise")};
  double information = 0.0;
  for (size_t k = 0; k < response.size(); ++k) {
    const double t = static_cast<double>(k) * tick_s;
    const double slope = amplitude * (shape(t, 1.001 * tau) - shape(t, 0.999 * tau)) / (0.002 * tau);
    information += slope * slope;
  }
  return Estimate{tau, information > 0.0 ? std::sqrt(variance / information) : tau};
}

}  // namespace breakaway
