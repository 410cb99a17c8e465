#include "base/message.h"

#include <fmt/format.h>
#include <charconv>

#include "base/catalogue.h"

namespace breakaway {

namespace {

/// Each place of `text`, "{}", "{:.3g}" or "{2}", by what `value` gives for its number, counted from 0.
template <typename Value>
std::string filled(std::string_view text, const Value& value) {
  std::string out;
  size_t next = 0;
  for (size_t open = text.find('{'); open != std::string_view::npos; open = text.find('{')) {
    const size_t close = text.find('}', open);
    if (close == std::string_view::npos) break;
    size_t place = next;
    std::from_chars(text.data() + open + 1, text.data() + close, place);
    out += text.substr(0, open);
    out += value(place);
    next = place + 1;
    text.remove_prefix(close + 1);
  }
  return out += text;
}

}  // namespace

Message::Message(std::string_view text, std::vector<Message> values) : text_(text), values_(std::move(values)) {
  english_ = filled(text, [this](size_t place) { return values_[place].english(); });
}

std::string Message::in(const Catalogue& catalogue) const {
  if (text_.empty()) return english_;
  const std::string* other = catalogue.find(text_);
  return filled(other != nullptr ? std::string_view(*other) : text_,
                [&](size_t place) { return place < values_.size() ? values_[place].in(catalogue) : std::string(); });
}

Message Message::together(const Message& one, const Message& other) {
  if (one.empty()) return other;
  if (other.empty()) return one;
  return Message("{}{}", {one, other});
}

Message placed(std::string_view place, double value) {
  return Message(fmt::format(fmt::runtime(place), value));
}

Message placed(std::string_view place, long long value) {
  return Message(fmt::format(fmt::runtime(place), value));
}

Message placed(std::string_view place, std::string_view value) {
  return Message(fmt::format(fmt::runtime(place), value));
}

std::string_view placeIn(std::string_view text, size_t number) {
  size_t open = text.find('{');
  for (; number > 0; --number) open = text.find('{', open + 1);
  return text.substr(open, text.find('}', open) + 1 - open);
}

Message listed(const std::vector<Message>& items, const Message& between) {
  Message out;
  for (size_t k = 0; k < items.size(); ++k) {
    if (k > 0) out = k + 1 == items.size() ? out + between : out + ", ";
    out = out + items[k];
  }
  return out;
}

}  // namespace breakaway
