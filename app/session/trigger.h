// An oscilloscope's trigger over one channel: where the view stands still.
#pragma once

#include <optional>

namespace breakaway {

struct TriggerOptions {
  double level = 0.0;
  bool rising = true;
  double hysteresis = 0.0;  ///< so far the channel must have been on the other side before: noise is no edge
  double after_s = 1.0;     ///< that is to be seen after the edge
  bool once = false;        ///< else the next edge follows as soon as this one is whole
};

class Trigger {
 public:
  explicit Trigger(const TriggerOptions& options) : options_(options) {}

  /// Every sample in turn. A clock that goes back begins anew.
  void take(double time_s, double value);
  /// The last edge after which all that is to be seen has come, between the two samples around the level.
  const std::optional<double>& shown_s() const { return shown_s_; }
  /// The one edge that was asked for is shown.
  bool done() const { return options_.once && shown_s_.has_value(); }

 private:
  TriggerOptions options_;
  std::optional<double> shown_s_, coming_s_, last_s_;
  double lastBeyond_ = 0.0;
  bool armed_ = false;
};

}  // namespace breakaway
