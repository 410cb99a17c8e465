// A burst: samples kept on the board at full rate, read afterwards. Freestanding, no heap.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware_link/wire/messages.h"

namespace breakaway::board {

template <std::size_t bytes>
class Burst {
 public:
  /// Returns what was accepted: at most as many samples as there is room for.
  wire::Capture start(wire::Capture wanted) {
    wanted.schema &= wire::allChannels;
    if (wanted.every == 0) wanted.every = 1;
    const std::size_t size = wire::sampleSize(wanted.schema), most = size > 0 ? bytes / size : 0;
    if (wanted.samples > most) wanted.samples = static_cast<std::uint16_t>(most);
    plan_ = wanted;
    size_ = size;
    taken_ = 0;
    wait_ = 0;
    runs_ = wanted.trigger == wire::Capture::Trigger::now;
    return wanted;
  }
  void commandCame() { runs_ = runs_ || plan_.trigger == wire::Capture::Trigger::nextCommand; }

  /// The channels that it wants of this tick's sample; none: it takes none.
  std::uint16_t wants() const { return runs_ && taken_ < plan_.samples && wait_ == 0 ? plan_.schema : 0; }

  /// Once per tick; `sample` holds what wants() said.
  void add(const wire::WireSample& sample, std::uint32_t tick, std::uint32_t time_us) {
    if (!runs_ || taken_ >= plan_.samples) return;
    if (wait_ > 0) {
      --wait_;
      return;
    }
    if (taken_ == 0) {
      firstTick_ = tick;
      firstTime_us_ = time_us;
    }
    wire::writeSample(sample, plan_.schema, kept_.data() + taken_ * size_);
    ++taken_;
    wait_ = plan_.every - 1u;
  }

  /// Appends the page that begins with sample `first`; `period_ns` is a tick's.
  bool write(std::uint16_t first, std::uint32_t period_ns, wire::Writer& out) const {
    if (first > taken_) return false;
    const std::size_t size = wire::sampleSize(plan_.schema);
    constexpr std::size_t room = wire::mostBody - 1 - 6 - wire::BatchHeader::size;
    std::size_t count = taken_ - first;
    if (size > 0 && count > room / size) count = room / size;
    wire::BatchHeader header;
    header.schema = plan_.schema;
    header.samples = static_cast<std::uint8_t>(count);
    header.every = plan_.every;
    header.tick = firstTick_ + static_cast<std::uint32_t>(first) * plan_.every;
    header.period_ns = period_ns * plan_.every;
    header.time_us = firstTime_us_ + static_cast<std::uint32_t>(std::uint64_t(header.period_ns) * first / 1000u);
    out(wire::CapturePage{taken_, plan_.samples, first});
    out(header);
    for (std::size_t k = 0; k < count * size; ++k) out(kept_[first * size + k]);
    return out.ok();
  }

 private:
  wire::Capture plan_;
  std::size_t size_ = 0;  ///< of a sample
  std::uint16_t taken_ = 0;
  std::uint32_t wait_ = 0;  ///< ticks until the next sample
  std::uint32_t firstTick_ = 0, firstTime_us_ = 0;
  bool runs_ = false;
  std::array<std::uint8_t, bytes> kept_{};
};

}  // namespace breakaway::board
