// The inverse of the bridge's duty curve, as a feed-forward behind every mode. Freestanding; the board runs it too.
#pragma once

namespace breakaway {

/// Output duty over input duty, straight between its points, of slope one beyond the last, odd. The first point is the
/// dead zone's end with an output of zero; both rise strictly.
template <typename Scalar>
struct DutyTable {
  static constexpr int mostPoints = 16;

  int points = 0;  ///< 0: the bridge gives what it is asked for
  Scalar input[mostPoints] = {};
  Scalar output[mostPoints] = {};

  /// The duty to ask for so that the windings get `wanted`; 0 for 0.
  Scalar inputFor(Scalar wanted) const {
    if (points <= 0 || wanted == Scalar(0)) return wanted;
    const bool falls = wanted < Scalar(0);
    const Scalar size = falls ? -wanted : wanted;
    Scalar asked = input[points - 1] + size - output[points - 1];
    for (int k = 1; k < points; ++k) {
      if (size > output[k]) continue;
      asked = input[k - 1] + (size - output[k - 1]) * (input[k] - input[k - 1]) / (output[k] - output[k - 1]);
      break;
    }
    return falls ? -asked : asked;
  }
};

}  // namespace breakaway
