// Student's distribution: how much wider an interval is that rests on few independent pieces.
#pragma once

namespace breakaway {

/// Its 97.5 % quantile for `freedom` ≥ 1 degrees: half a 95 % interval in standard errors. Asymptotic expansion (M.
/// Abramowitz, I. A. Stegun, 'Handbook of Mathematical Functions', 26.7.5); within 0.1 % from 6 degrees on, 3 % low
/// at 2.
double student95(double freedom);

}  // namespace breakaway
