// What orders of the turn a curve around the rotor has.
#pragma once

#include <vector>

#include "widgets/map_curve.h"

namespace breakaway {

/// Amplitudes of the orders 1 to `most`, in the curve's unit, by the discrete Fourier sum over its points; empty unless
/// the curve is closed with at least two points an order. Points must be evenly spaced over the turn.
std::vector<double> harmonicsOf(const MapCurve& curve, int most);

/// harmonicsOf() for all of `most` orders, or for as many as so few points can show.
std::vector<double> ordersShownBy(const MapCurve& curve, int most);

/// The turns of each way together: point by point the mean of the closed curves that share colour and number of points,
/// in the order in which the colours come first.
std::vector<MapCurve> meansByColour(const std::vector<MapCurve>& curves);

}  // namespace breakaway
