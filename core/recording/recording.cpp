#include "recording/recording.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/exact_text.h"

namespace breakaway {

struct Recording::Sealed {
  std::string name;
  std::vector<Channel> channels;
  std::vector<std::pair<std::string, std::string>> notes;
  size_t timeIndex = 0;
  double medianStep_s = 0.0;
};

namespace {

double medianStep(const std::vector<double>& time) {
  if (time.size() < 2) return 0.0;
  std::vector<double> steps(time.size() - 1);
  for (size_t k = 0; k + 1 < time.size(); ++k) steps[k] = time[k + 1] - time[k];
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

/// ", found: a, b, c", at most a few names.
std::string foundInstead(const std::vector<Channel>& channels) {
  std::string text;
  for (size_t c = 0; c < channels.size() && c < 6; ++c) {
    text += (c == 0 ? ", found: " : ", ") + channels[c].name.substr(0, 40);
  }
  return text + (channels.size() > 6 ? ", …" : "");
}

}  // namespace

Recording::Recording(std::shared_ptr<const Sealed> sealed) : sealed_(std::move(sealed)) {
}

Result<Recording> Recording::seal(std::string name, std::vector<Channel> channels,
                                  std::vector<std::pair<std::string, std::string>> notes) {
  const auto isTime = [](const Channel& channel) { return channel.name == "time_s"; };
  const auto timeIt = std::find_if(channels.begin(), channels.end(), isTime);
  if (timeIt == channels.end()) return Error{name, "has no column time_s" + foundInstead(channels)};
  std::set<std::string> names;
  for (const Channel& channel : channels) {
    if (!names.insert(channel.name).second) return Error{name, "has the column " + channel.name + " twice"};
    if (channel.values.size() != timeIt->values.size()) {
      return Error{name + ", column " + channel.name, "has " + std::to_string(channel.values.size()) +
                                                          " values, expected " + std::to_string(timeIt->values.size())};
    }
  }
  const auto& time = timeIt->values;
  for (size_t k = 0; k < time.size(); ++k) {
    const std::string place = name + ", row " + std::to_string(k + 1) + ", column time_s";
    if (!std::isfinite(time[k])) return Error{place, "is missing or not finite, expected a time in s"};
    if (k > 0 && !(time[k] > time[k - 1])) {
      return Error{place, exactText(time[k]) + " does not increase after " + exactText(time[k - 1]) +
                              ", expected strictly increasing times"};
    }
  }
  auto sealed = std::make_shared<Sealed>();
  sealed->name = std::move(name);
  sealed->timeIndex = static_cast<size_t>(timeIt - channels.begin());
  sealed->medianStep_s = medianStep(time);
  sealed->channels = std::move(channels);
  sealed->notes = std::move(notes);
  return Recording(std::move(sealed));
}

size_t Recording::rows() const {
  return time().size();
}

const std::string& Recording::name() const {
  return sealed_->name;
}

bool Recording::has(std::string_view channel) const {
  return std::any_of(sealed_->channels.begin(), sealed_->channels.end(),
                     [channel](const Channel& one) { return one.name == channel; });
}

std::span<const double> Recording::channel(std::string_view channel) const {
  for (const Channel& one : sealed_->channels) {
    if (one.name == channel) return one.values;
  }
  return {};
}

std::span<const double> Recording::time() const {
  return sealed_->channels[sealed_->timeIndex].values;
}

const std::vector<Channel>& Recording::channels() const {
  return sealed_->channels;
}

const std::vector<std::pair<std::string, std::string>>& Recording::notes() const {
  return sealed_->notes;
}

double Recording::medianStep_s() const {
  return sealed_->medianStep_s;
}

}  // namespace breakaway
