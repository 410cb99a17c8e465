#include "widgets/envelope.h"

#include <limits>

namespace breakaway {

void Envelope::add(double time_s, double value, std::vector<TracePoint>& points) {
  const TracePoint point{time_s, value};
  if (least_ && time_s - last_s_ > gap_s_) {
    const double middle = 0.5 * (last_s_ + time_s);
    close(points);
    points.push_back({middle, std::numeric_limits<double>::quiet_NaN()});
  } else if (least_ && time_s - start_s_ >= bucket_s_) {
    close(points);
  }
  if (!least_) {
    start_s_ = time_s;
    least_ = greatest_ = point;
  } else {
    if (value < least_->value) least_ = point;
    if (value > greatest_->value) greatest_ = point;
  }
  last_s_ = time_s;
}

void Envelope::reset() {
  least_.reset();
  greatest_.reset();
}

void Envelope::close(std::vector<TracePoint>& points) {
  const bool leastFirst = least_->time_s <= greatest_->time_s;
  points.push_back(leastFirst ? *least_ : *greatest_);
  if (least_->time_s != greatest_->time_s) points.push_back(leastFirst ? *greatest_ : *least_);
  reset();
}

}  // namespace breakaway
