#include "firmware_link/vesc/vesc_line.h"

#include <algorithm>

namespace breakaway {

void VescLine::say(const VescPayload& payload) {
  if (broken_) return;
  if (auto written = stream_->write(vescFrame(payload)); !written) broken_ = written.error();
}

std::optional<VescPayload> VescLine::hear(Clock::time_point end) {
  for (;;) {
    if (auto payload = decoder_.next()) return payload;
    if (broken_) return {};
    const double left_s = std::chrono::duration<double>(end - Clock::now()).count();
    fresh_.clear();
    if (auto read = stream_->read(fresh_, std::max(0.0, left_s)); !read) broken_ = read.error();
    decoder_.add(fresh_);
    if (fresh_.empty() && left_s <= 0.0) return {};
  }
}

}  // namespace breakaway
