// Where a function changes its sign, by false position that doesn't get stuck.
#pragma once

namespace breakaway {

/// The Illinois rule: an end of the bracket that stays twice in a row counts half (M. Dowell, P. Jarratt, 'A modified
/// regula falsi method for computing the root of an equation', BIT 11, 1971). Precondition: the values at the two ends
/// differ in sign.
class FalsePosition {
 public:
  FalsePosition(double low, double atLow, double high, double atHigh)
      : low_(low), high_(high), atLow_(atLow), atHigh_(atHigh) {}

  double width() const { return high_ - low_; }
  double middle() const { return 0.5 * (low_ + high_); }
  bool flat() const { return atHigh_ == atLow_; }
  /// Where to look next. Precondition: !flat().
  double next() const { return (low_ * atHigh_ - high_ * atLow_) / (atHigh_ - atLow_); }
  /// What was found there.
  void narrow(double at, double value) {
    if ((value > 0.0) == (atHigh_ > 0.0)) {
      high_ = at;
      atHigh_ = value;
      if (kept_ == -1) atLow_ *= 0.5;
      kept_ = -1;
    } else {
      low_ = at;
      atLow_ = value;
      if (kept_ == 1) atHigh_ *= 0.5;
      kept_ = 1;
    }
  }

 private:
  double low_, high_, atLow_, atHigh_;
  int kept_ = 0;  ///< which end stayed last
};

}  // namespace breakaway
