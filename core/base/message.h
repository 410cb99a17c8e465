// Sentences for people, built of a message and values, so that they can be said in another language, too.
#pragma once

#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace breakaway {

class Catalogue;

/// An English text with a place for each of so many values, "{}" or as fmt has it, "{:.3g}". Only a literal is one, and
/// its places are counted when it is compiled: it is what the message is known by in other languages.
template <size_t values>
struct MessageText {
  consteval MessageText(const char* literal) : text(literal) {
    size_t places = 0;
    for (const char one : text) places += one == '{' ? 1 : 0;
    if (places != values) throw "as many places as values";
  }
  std::string_view text;
};

/// What is said to a person: English where nothing else is asked for, as in files and on the command line. Text alone
/// doesn't turn into one by itself, so that none is forgotten: message() makes those that can be translated.
class Message {
 public:
  Message() = default;
  /// The same in every language: a name, a number with its unit, a line of a file.
  explicit Message(std::string asItIs) : english_(std::move(asItIs)) {}
  explicit Message(std::string_view asItIs) : english_(asItIs) {}
  explicit Message(const char* asItIs) : english_(asItIs) {}
  /// `text` lives for ever.
  Message(std::string_view text, std::vector<Message> values);

  bool empty() const { return english_.empty(); }
  const std::string& english() const { return english_; }
  operator const std::string&() const { return english_; }
  // As of the English text.
  const char* c_str() const { return english_.c_str(); }
  size_t find(std::string_view part) const { return english_.find(part); }
  bool starts_with(std::string_view part) const { return english_.starts_with(part); }
  bool ends_with(std::string_view part) const { return english_.ends_with(part); }
  friend bool operator==(const Message& one, const std::string& english) { return one.english_ == english; }
  /// In the language of the catalogue; what that lacks stays English.
  std::string in(const Catalogue& catalogue) const;

  /// One after the other, each in its language.
  friend Message operator+(const Message& one, const Message& other) { return together(one, other); }
  /// With punctuation, or what else is the same in every language.
  friend Message operator+(const Message& one, std::string_view asItIs) { return together(one, Message(asItIs)); }
  friend Message operator+(std::string_view asItIs, const Message& other) { return together(Message(asItIs), other); }
  bool operator==(const Message&) const = default;

 private:
  static Message together(const Message& one, const Message& other);

  std::string english_;
  std::string_view text_;  ///< empty: as it is
  std::vector<Message> values_;
};

/// What errors and procedures hold: a message, or plain text, which is English in every language.
class Saying : public Message {
 public:
  Saying() = default;
  Saying(Message message) : Message(std::move(message)) {}
  Saying(std::string plain) : Message(std::move(plain)) {}
  Saying(const char* plain) : Message(plain) {}
};

/// A value as `place`, "{:.3g}", asks for it.
Message placed(std::string_view place, double value);
Message placed(std::string_view place, long long value);
Message placed(std::string_view place, std::string_view value);
inline Message placed(std::string_view place, const std::string& value) {
  return placed(place, std::string_view(value));
}
inline Message placed(std::string_view place, const char* value) {
  return placed(place, std::string_view(value));
}
inline Message placed(std::string_view, const Message& value) {
  return value;
}
template <std::integral Value>
Message placed(std::string_view place, Value value) {
  return placed(place, static_cast<long long>(value));
}
/// The place of that number in `text`, counted from 0.
std::string_view placeIn(std::string_view text, size_t number);

/// `text` with the values in its places: message("{} rows were left out", 12).
template <typename... Values>
Message message(MessageText<sizeof...(Values)> text, const Values&... values) {
  [[maybe_unused]] size_t next = 0;
  return Message(text.text, std::vector<Message>{placed(placeIn(text.text, next++), values)...});
}

/// "a", "a or b", "a, b or c" with " or " between the last two.
Message listed(const std::vector<Message>& items, const Message& between);

/// For files, which stay English.
template <typename Json>
void to_json(Json& json, const Message& one) {
  json = one.english();
}

}  // namespace breakaway
