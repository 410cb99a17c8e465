#include "experiment/breakaway_tour.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {

constexpr size_t neighbours = 5;
constexpr size_t knownAfter = 8;  // steps, until it is known how long one takes

}  // namespace

BreakawayTour::BreakawayTour(size_t bins, size_t passes, const std::vector<BreakawayEvent>& earlier)
    : bins_(std::max<size_t>(bins, 1)), done_(2 * bins_ * std::max<size_t>(passes, 1), false) {
  for (const BreakawayEvent& event : earlier) {
    if (event.bin >= bins || event.turn >= passes || done_[stepOf(event)]) continue;
    done_[stepOf(event)] = true;
    events_.push_back(event);
  }
  skipDone();
}

size_t BreakawayTour::bin() const {
  const size_t k = step_ % bins_;
  return way() == Way::ccw ? k : bins_ - 1 - k;
}

size_t BreakawayTour::stepOf(const BreakawayEvent& event) const {
  return event.turn * 2 * bins_ + (event.way == Way::ccw ? event.bin : 2 * bins_ - 1 - event.bin);
}

void BreakawayTour::skipDone() {
  while (!ended() && done_[step_]) ++step_;
}

void BreakawayTour::advance() {
  ++step_;
  skipDone();
}

void BreakawayTour::take(BreakawayEvent event) {
  event.way = way();
  event.turn = pass();
  event.bin = bin();
  std::vector<double> before;
  for (auto one = events_.rbegin(); one != events_.rend() && before.size() < neighbours; ++one) {
    if (one->way == event.way && one->turn == event.turn) before.push_back(one->torque_Nm);
  }
  if (before.size() == neighbours) {
    const auto middle = before.begin() + neighbours / 2;
    std::nth_element(before.begin(), middle, before.end());
    event.outlier = std::abs(event.torque_Nm - *middle) > 0.5 * std::abs(*middle);
  }
  events_.push_back(event);
}

double BreakawayTour::remaining_s(double elapsed_s, double usual_s) const {
  const double each_s = step_ >= knownAfter ? elapsed_s / static_cast<double>(step_) : usual_s;
  return each_s * static_cast<double>(done_.size() - std::min(step_, done_.size()));
}

}  // namespace breakaway
