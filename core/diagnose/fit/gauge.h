// What no data can give: the values that a fit takes from the bench, trusted or not.
#pragma once

#include <string>
#include <vector>

#include "diagnose/effect.h"
#include "diagnose/simulate/model.h"
#include "diagnose/split.h"
#include "motor/bench.h"

namespace breakaway {

/// Names of the values that set the scale of all torques and, of a voltage's drive whose current nobody recorded, the
/// back-EMF constant, which shows only together with viscous friction.
std::vector<std::string> gauge(const Bench& bench, const std::vector<Track>& tracks);

/// The best of the base models fitted from `starts` if it is left with next to no viscous friction because the back-EMF
/// constant that it holds takes all of it: then that constant is too high, and has to be fitted. Else none.
std::vector<Model> starvedOfViscous(const std::vector<Model>& starts, const std::vector<std::string>& held,
                                    const std::vector<Track>& tracks, const Split& split, const Excitation& seen);

}  // namespace breakaway
