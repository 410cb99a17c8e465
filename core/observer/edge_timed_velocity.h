// Speed from the times of encoder edges, the M/T method. Freestanding; a board with a capture timer runs it too.
#pragma once

namespace breakaway {

/// Way between two edges over the time between them: M edges counted, T timed. The encoder's rounding falls out,
/// because an edge's place is known exactly; what is left is the timer's step and the mean over the window. Between
/// edges the estimate can't be more than one count over the time since the last one, and is held to that. Source:
/// Ohmae, Matsuda, Kamiyama, Tachikawa, "A microprocessor-controlled high-accuracy wide-range speed regulator for motor
/// drives", IEEE Trans. Industrial Electronics 29(3), 1982.
template <typename Scalar>
class EdgeTimedVelocity {
 public:
  /// `count_rad` is one count; `window_s` the least time between the two edges, 0: every two edges.
  void configure(Scalar count_rad, Scalar window_s) {
    count_rad_ = count_rad;
    window_s_ = window_s;
  }

  void reset() {
    begun_ = false;
    velocity_ = 0;
  }

  /// Once per tick. `edge_rad` is the place of the last edge that was passed, `sinceEdge_s` how long ago, in the same
  /// units of time as `tick_s`. Returns rad/s, 0 until two edges have been passed.
  Scalar step(Scalar edge_rad, Scalar sinceEdge_s, Scalar tick_s) {
    sinceFirst_s_ += tick_s;
    const bool fresh = sinceEdge_s < tick_s;
    if (fresh && !begun_) {
      begin(edge_rad, sinceEdge_s);
      return velocity_;
    }
    const Scalar between_s = sinceFirst_s_ - sinceEdge_s;
    if (fresh && between_s >= window_s_ && between_s > Scalar(0)) {
      velocity_ = (edge_rad - first_rad_) / between_s;
      begin(edge_rad, sinceEdge_s);
    } else if (sinceEdge_s > window_s_) {
      const Scalar most = count_rad_ / sinceEdge_s;
      velocity_ = velocity_ > most ? most : velocity_ < -most ? -most : velocity_;
    }
    return velocity_;
  }

 private:
  void begin(Scalar edge_rad, Scalar sinceEdge_s) {
    begun_ = true;
    first_rad_ = edge_rad;
    sinceFirst_s_ = sinceEdge_s;
  }

  Scalar count_rad_ = 0, window_s_ = 0, first_rad_ = 0, sinceFirst_s_ = 0, velocity_ = 0;
  bool begun_ = false;
};

}  // namespace breakaway
