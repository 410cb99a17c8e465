// Figures around a turn: the angle counter-clockwise, the radius outwards.
#pragma once

#include <string>

#include "draw/svg_plot.h"

namespace breakaway {

/// toSvg() for a polar figure. A line whose ends meet after a whole turn is closed.
std::string toPolarSvg(const Figure& figure, int width_px, int height_px);

}  // namespace breakaway
