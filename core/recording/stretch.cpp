#include "recording/stretch.h"

#include <algorithm>

#include "base/exact_text.h"

namespace breakaway {

Result<Recording> stretchOf(const Recording& recording, double from_s, double to_s) {
  const auto time = recording.time();
  const auto begin = std::lower_bound(time.begin(), time.end(), from_s);
  const auto end = std::upper_bound(begin, time.end(), to_s);
  if (end - begin < 2)
    return Error{recording.name(),
                 "has fewer than two rows between " + exactText(from_s) + " s and " + exactText(to_s) + " s"};
  std::vector<Channel> channels;
  channels.reserve(recording.channels().size());
  for (const Channel& channel : recording.channels())
    channels.push_back(
        {channel.name,
         {channel.values.begin() + (begin - time.begin()), channel.values.begin() + (end - time.begin())}});
  auto notes = recording.notes();
  notes.emplace_back("cut_from", recording.name());
  return Recording::seal(recording.name(), std::move(channels), std::move(notes));
}

}  // namespace breakaway
