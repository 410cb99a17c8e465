#include "diagnose/fit/seen_span.h"

#include <algorithm>
#include <optional>

#include "diagnose/effects/catalogue.h"
#include "diagnose/simulate/physics.h"

namespace breakaway {

namespace {

struct Span {
  double from_s = 0.0, to_s = 0.0;
};

/// Times of a track that lie in training windows, in order and apart.
std::vector<Span> seenSpans(const Track& track, size_t number, const Split& split) {
  std::vector<Span> all, merged;
  for (const auto* windows : {&split.train, &split.polish}) {
    for (const Window& one : *windows) {
      if (one.track == number) all.push_back({track.time[one.first], track.time[one.last]});
    }
  }
  std::sort(all.begin(), all.end(), [](const Span& a, const Span& b) { return a.from_s < b.from_s; });
  for (const Span& one : all) {
    if (!merged.empty() && one.from_s <= merged.back().to_s) {
      merged.back().to_s = std::max(merged.back().to_s, one.to_s);
    } else {
      merged.push_back(one);
    }
  }
  return merged;
}

/// The time between two spans, or after the last, in which `t` lies.
std::optional<Span> unseenAround(const std::vector<Span>& seen, double t, double end_s) {
  for (size_t k = 1; k < seen.size(); ++k) {
    if (t > seen[k - 1].to_s && t < seen[k].from_s) return Span{seen[k - 1].to_s, seen[k].from_s};
  }
  if (seen.empty() || t <= seen.back().to_s) return std::nullopt;
  return Span{seen.back().to_s, std::max(seen.back().to_s, end_s)};
}

void keepWithin(Parameter& start, Parameter& duration, const std::vector<Span>& seen, double end_s) {
  const double end = start.value + duration.value;
  const auto before = unseenAround(seen, start.value, end_s), after = unseenAround(seen, end, end_s);
  const double from = before ? before->to_s : start.value, to = after ? after->from_s : end;
  if (from >= to || (!before && !after)) return;
  const double shorter = duration.value - duration.low95, longer = duration.high95 - duration.value;
  if (before) start = {start.name, from, std::min(start.low95, before->from_s), std::max(start.high95, from)};
  const double earliest = before ? before->from_s : from, latest = after ? after->to_s : to;
  duration = {duration.name, to - from, std::max(to - from - shorter, 0.0),
              std::max(latest - earliest, to - from + longer)};
}

}  // namespace

Model withinSeen(Model model, const std::vector<Track>& tracks, const Split& split) {
  for (EffectTerm& term : model.effects) {
    const OncePart* once = findEffect(term.effect)->once();
    if (once == nullptr) continue;
    for (size_t k = 0; k < tracks.size(); ++k) {
      if (term.recording.empty() || term.recording == fileNameOf(tracks[k].name)) {
        keepWithin(term.parameters[once->start], term.parameters[once->duration], seenSpans(tracks[k], k, split),
                   tracks[k].time.back());
        break;
      }
    }
  }
  return model;
}

}  // namespace breakaway
