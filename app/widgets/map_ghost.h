// An earlier map beneath the one that is shown, and around them how the two differ.
#pragma once

#include "friction/friction_map.h"
#include "widgets/map_views.h"

namespace breakaway {

/// Puts the earlier map's curves of the view under those of `picture`, and, where there is a map `now` and the view has
/// a quantity of both ways, a ring outside: after − before, the mean of both ways, on the same scale. Nothing where the
/// two are of different kinds of axis. A picture without curves becomes the earlier map's.
void layBeneath(const FrictionMap& earlier, const FrictionMap* now, MapView view, MapPicture& picture);

}  // namespace breakaway
