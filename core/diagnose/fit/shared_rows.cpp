#include "diagnose/fit/shared_rows.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>

#include "diagnose/simulate/recorded_input.h"

namespace breakaway {

namespace {

constexpr size_t leastStretch = 100;  ///< rows
constexpr size_t part = 20;           ///< of the shortest recording: motions begin alike, encoders are coarse
constexpr size_t tellingPart = 4;     ///< of a stretch's rows, that change otherwise than the row before
constexpr uint64_t base = 0x9e3779b97f4a7c15;

/// What two recordings would have in common.
struct Trace {
  std::span<const double> measured, drive;

  size_t rows() const { return measured.size(); }
  uint64_t row(size_t k) const {
    const uint64_t mixed =
        (std::bit_cast<uint64_t>(measured[k] + 0.0) ^ std::rotl(std::bit_cast<uint64_t>(drive[k] + 0.0) * base, 29)) *
        base;
    return mixed ^ (mixed >> 31);
  }
  /// Nothing repeats such rows by chance; a steady run with a coarse encoder has none.
  bool surprises(size_t k) const {
    return k >= 2 && measured[k] - measured[k - 1] != measured[k - 1] - measured[k - 2];
  }
};

Trace traceOf(const Recording& recording, const Bench& bench) {
  auto measured = recording.channel(bench.positionChannel());
  if (measured.empty()) measured = recording.channel(bench.velocityChannel());
  const auto drive = recording.channel(recordedInput(recording, bench));
  if (drive.empty() || measured.empty()) return {};
  return {measured, drive};
}

/// Calls `take` with the first row and the hash of every stretch of so many rows (or every `stretch`-th one) that tells
/// enough.
template <typename Take>
void eachStretch(const Trace& trace, size_t stretch, bool apart, Take take) {
  const size_t telling = stretch / tellingPart;
  uint64_t hash = 0, leaving = 1;
  for (size_t k = 0; k < stretch; ++k) leaving *= base;
  size_t surprises = 0;
  for (size_t k = 0; k < trace.rows(); ++k) {
    hash = hash * base + trace.row(k);
    surprises += trace.surprises(k) ? 1 : 0;
    if (k >= stretch) {
      hash -= leaving * trace.row(k - stretch);
      surprises -= trace.surprises(k - stretch) ? 1 : 0;
    }
    const size_t first = k + 1 - std::min(k + 1, stretch);
    if (k + 1 >= stretch && surprises >= telling && (!apart || first % stretch == 0)) take(first, hash);
  }
}

}  // namespace

Result<void> checkSharedRows(const Bench& bench, const std::vector<Recording>& recordings,
                             const std::vector<Recording>& heldout) {
  struct Place {
    const Recording* recording;
    bool proves;
  };
  size_t shortest = SIZE_MAX;
  for (const auto* group : {&recordings, &heldout}) {
    for (const Recording& one : *group) shortest = std::min(shortest, one.rows());
  }
  const size_t stretch = std::max(leastStretch, shortest / part);
  std::unordered_map<uint64_t, Place> seen;  // stretches of all recordings before, side by side
  for (const auto* group : {&recordings, &heldout}) {
    const bool proves = group == &heldout;
    for (const Recording& one : *group) {
      const Trace trace = traceOf(one, bench);
      std::optional<Error> shared;
      eachStretch(trace, stretch, false, [&](size_t first, uint64_t hash) {
        const auto it = shared ? seen.end() : seen.find(hash);
        if (it == seen.end()) return;
        const std::string where = ", from row " + std::to_string(first + 1) + " on; ";
        const std::string other = it->second.recording->name();
        shared = Error{one.name(), proves && !it->second.proves
                                       ? "is held out, but shares rows with " + other + ", which is learned from" +
                                             where + "expected another measurement"
                                       : "shares rows with " + other + where + "expected each recording once"};
      });
      if (shared) return *shared;
      eachStretch(trace, stretch, true, [&](size_t, uint64_t hash) { seen.emplace(hash, Place{&one, proves}); });
    }
  }
  return {};
}

}  // namespace breakaway
