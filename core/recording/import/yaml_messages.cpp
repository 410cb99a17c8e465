#include "recording/import/yaml_messages.h"

#include <yaml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "recording/import/text_layout.h"

namespace breakaway {

namespace {

constexpr int deepest = 50;
constexpr size_t mostMessageColumns = 10000, longestDocument = 10'000'000;
constexpr size_t fewValues = 1'000'000;

struct Node {
  enum class Kind { number, text, list, mapping } kind = Kind::text;
  double value = NAN;
  std::string text;               ///< of a text
  std::vector<std::string> keys;  ///< of a mapping's items
  std::vector<Node> items;
};

/// A plain scalar's number; true and false are 1 and 0, null is a missing one.
bool readsNumber(std::string_view text, double& value) {
  if (text == "true" || text == "True") return value = 1.0, true;
  if (text == "false" || text == "False") return value = 0.0, true;
  if (text.empty() || text == "null" || text == "~" || text == ".nan" || text == ".NaN" || text == "nan" ||
      text == ".inf" || text == "-.inf" || text == "inf" || text == "-inf")
    return value = NAN, true;
  if (text.front() == '+') text.remove_prefix(1);
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  return fault == std::errc() && end == text.data() + text.size() && std::isfinite(value);
}

/// The events of one document, which the library tells one by one.
class Document {
 public:
  explicit Document(std::string_view text) {
    good_ = yaml_parser_initialize(&parser_) == 1;
    if (good_) yaml_parser_set_input_string(&parser_, reinterpret_cast<const unsigned char*>(text.data()), text.size());
  }
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;
  ~Document() {
    drop();
    yaml_parser_delete(&parser_);
  }

  /// The document's mapping; nothing when it is none, or no YAML.
  std::optional<Node> read() {
    if (!next() || event_.type != YAML_STREAM_START_EVENT) return std::nullopt;
    if (!next() || event_.type != YAML_DOCUMENT_START_EVENT) return std::nullopt;
    Node node;
    if (!next() || event_.type != YAML_MAPPING_START_EVENT || !take(node, 0)) return std::nullopt;
    if (!next() || event_.type != YAML_DOCUMENT_END_EVENT) return std::nullopt;
    return next() && event_.type == YAML_STREAM_END_EVENT ? std::optional(std::move(node)) : std::nullopt;
  }

 private:
  void drop() {
    if (std::exchange(held_, false)) yaml_event_delete(&event_);
  }
  bool next() {
    drop();
    held_ = good_ = good_ && yaml_parser_parse(&parser_, &event_) == 1;
    return good_;
  }
  std::string_view scalar() const {
    return {reinterpret_cast<const char*>(event_.data.scalar.value), event_.data.scalar.length};
  }

  /// Takes what begins with the present event.
  bool take(Node& node, int depth) {
    switch (event_.type) {
      case YAML_SCALAR_EVENT:
        if (event_.data.scalar.style == YAML_PLAIN_SCALAR_STYLE && readsNumber(scalar(), node.value)) {
          node.kind = Node::Kind::number;
        } else {
          node.text = scalar();
        }
        return true;
      case YAML_ALIAS_EVENT:
        return true;
      case YAML_SEQUENCE_START_EVENT:
        return takeList(node, depth);
      case YAML_MAPPING_START_EVENT:
        return takeMapping(node, depth);
      default:
        return false;
    }
  }

  bool takeList(Node& node, int depth) {
    node.kind = Node::Kind::list;
    if (depth > deepest) return false;
    while (next() && event_.type != YAML_SEQUENCE_END_EVENT) {
      if (!take(node.items.emplace_back(), depth + 1)) return false;
    }
    return good_;
  }

  bool takeMapping(Node& node, int depth) {
    node.kind = Node::Kind::mapping;
    if (depth > deepest) return false;
    while (next() && event_.type != YAML_MAPPING_END_EVENT) {
      if (event_.type != YAML_SCALAR_EVENT) return false;
      node.keys.emplace_back(scalar());
      if (!next() || !take(node.items.emplace_back(), depth + 1)) return false;
    }
    return good_;
  }

  yaml_parser_t parser_{};
  yaml_event_t event_{};
  bool good_ = false, held_ = false;
};

bool areTexts(const Node& node) {
  return node.kind == Node::Kind::list && !node.items.empty() &&
         std::all_of(node.items.begin(), node.items.end(),
                     [](const Node& item) { return item.kind == Node::Kind::text; });
}

/// A field's list of names, for the lists beside it that are as long.
struct Names {
  const Node* list = nullptr;
  const Names* outer = nullptr;

  const Node* ofLength(size_t length) const {
    for (const Names* names = this; names != nullptr; names = names->outer) {
      if (names->list != nullptr && names->list->items.size() == length) return names->list;
    }
    return nullptr;
  }
};

/// Rows whose columns come as they are met.
class Rows {
 public:
  void begin() {
    ++rows_;
    filled_ = 0;
  }

  /// "axis" stands before all keys, as "elbow/position".
  void add(const Node& node, const std::string& axis, const std::string& path, const Names* names) {
    switch (node.kind) {
      case Node::Kind::number:
        return put(axis + path, node.value);
      case Node::Kind::text:
        cutLists_ = cutLists_ || node.text == "...";
        return;
      case Node::Kind::list:
        return addList(node, axis, path, names);
      case Node::Kind::mapping:
        return addMapping(node, axis, path, names);
    }
  }

  size_t filled() const { return filled_; }
  size_t rows() const { return rows_; }
  size_t columns() const { return columns_.size(); }
  bool cutLists() const { return cutLists_; }

  void takeBack() {
    --rows_;
    for (RawColumn& column : columns_) column.channel.values.resize(std::min(rows_, column.channel.values.size()));
  }

  /// Whole stamps beyond a million are counted from the first, so that no digit is lost when a fraction is added.
  std::vector<RawColumn> take() {
    std::erase_if(columns_, [](const RawColumn& column) { return column.channel.values.empty(); });
    for (RawColumn& column : columns_) {
      auto& values = column.channel.values;
      values.resize(rows_, NAN);
      const double first = values.front();
      if (!(std::abs(first) > 1e6) || first != std::round(first)) continue;
      column.origin = first;
      for (double& value : values) value -= first;
    }
    return std::move(columns_);
  }

 private:
  void addList(const Node& node, const std::string& axis, const std::string& path, const Names* names) {
    const Node* called = names != nullptr ? names->ofLength(node.items.size()) : nullptr;
    if (called == &node) return;
    for (size_t k = 0; k < node.items.size(); ++k) {
      if (called != nullptr) {
        add(node.items[k], axis + called->items[k].text + "/", path, nullptr);
      } else {
        add(node.items[k], axis, node.items.size() == 1 ? path : path + "[" + std::to_string(k) + "]", names);
      }
    }
  }

  void addMapping(const Node& node, const std::string& axis, const std::string& path, const Names* outer) {
    Names names{nullptr, outer};
    for (size_t k = 0; k < node.items.size(); ++k) {
      if (node.keys[k].find("name") != std::string::npos && areTexts(node.items[k])) names.list = &node.items[k];
    }
    for (size_t f = 0; f < node.items.size(); ++f) {
      const std::string& key = node.keys[f];
      const Node& value = node.items[f];
      // The names of values say what they are: no word of theirs is needed.
      const bool unsaid = names.list != nullptr && (key == "values" || key == "value" || key == "data") &&
                          value.items.size() == names.list->items.size();
      if (unsaid) {
        for (size_t k = 0; k < value.items.size(); ++k)
          add(value.items[k], axis, (path.empty() ? "" : path + ".") + names.list->items[k].text, nullptr);
      } else {
        add(value, axis, path.empty() ? key : path + "." + key, &names);
      }
    }
  }

  void put(const std::string& name, double value) {
    // Messages are alike: the column is mostly the next one.
    size_t c = next_ < columns_.size() && columns_[next_].channel.name == name ? next_ : placeOf(name);
    if (c == mostMessageColumns) return;
    auto& values = columns_[c].channel.values;
    if (values.size() >= rows_) return;
    values.resize(rows_ - 1, NAN);
    values.push_back(value);
    ++filled_;
    next_ = c + 1 < columns_.size() ? c + 1 : 0;
  }

  size_t placeOf(const std::string& name) {
    const auto known = places_.find(name);
    if (known != places_.end()) return known->second;
    if (columns_.size() >= mostMessageColumns) return mostMessageColumns;
    columns_.push_back({{name, {}}, {}});
    return places_[name] = columns_.size() - 1;
  }

  std::vector<RawColumn> columns_;
  std::map<std::string, size_t> places_;
  size_t rows_ = 0, filled_ = 0, next_ = 0;
  bool cutLists_ = false;
};

/// Takes the next document off `text`; `ended`: by dashes, which may stand behind what the printer said in between.
std::string_view takeDocument(std::string_view& text, bool& ended) {
  const std::string_view all = text;
  ended = false;
  while (!text.empty() && !ended) {
    const std::string_view line = withoutBlanks(takeLine(text, '\n'));
    ended = line.ends_with("---");
    if (ended) return all.substr(0, static_cast<size_t>(line.data() - all.data()) + line.size() - 3);
  }
  return all;
}

bool isBlank(std::string_view document) {
  return document.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

/// Two of the first documents are mappings with numbers.
bool beginsWithMessages(std::string_view text) {
  constexpr size_t searched = 200000;
  constexpr int looksAt = 6;
  const std::string_view head = text.substr(0, searched);
  if (head.find("---\n") == std::string_view::npos && head.find("---\r") == std::string_view::npos) return false;
  int messages = 0;
  for (int k = 0; k < looksAt && !text.empty() && messages < 2; ++k) {
    bool ended = false;
    const std::string_view document = takeDocument(text, ended);
    if (document.size() > searched) return false;
    const auto node = Document(document).read();
    if (!node) continue;
    Rows rows;
    rows.begin();
    rows.add(*node, {}, {}, nullptr);
    messages += rows.filled() > 0 ? 1 : 0;
  }
  return messages == 2;
}

Message inWords(size_t count) {
  return count == 1 ? message("1 document is no message and was left out")
                    : message("{} documents are no messages and were left out", count);
}

}  // namespace

std::optional<Result<RawTable>> readYamlMessages(std::string_view text, const std::string& name) {
  if (!beginsWithMessages(text)) return std::nullopt;
  const size_t size = text.size();
  Rows rows;
  RawTable table;
  size_t others = 0, before = 0;
  while (!text.empty()) {
    bool ended = false;
    const std::string_view document = takeDocument(text, ended);
    if (isBlank(document)) continue;
    const auto node = document.size() > longestDocument ? std::nullopt : Document(document).read();
    if (node) {
      before = rows.filled();
      rows.begin();
      rows.add(*node, {}, {}, nullptr);
      if (rows.filled() > 0 && (ended || (document.back() == '\n' && rows.filled() >= before))) continue;
      rows.takeBack();
    }
    if (ended) {
      ++others;
    } else {
      table.remarks.push_back(message("the last message is cut short and was left out"));
    }
  }
  if (others > 0) table.remarks.push_back(inWords(others));
  if (rows.cutLists())
    table.remarks.push_back(message("lists end in \"...\": `ros2 topic echo --full-length` prints them whole"));
  if (rows.rows() < 2) return Error{name, message("holds one message only, expected several over time")};
  // Each number takes a byte at least: a table that is larger is mostly empty.
  if (rows.columns() > std::max(fewValues, size) / rows.rows())
    return Error{name,
                 message("holds messages of too many kinds: {} numbers over {} messages", rows.columns(), rows.rows())};
  table.columns = rows.take();
  table.remarks.push_back(message("messages as YAML, {} of them", table.rows()));
  return table;
}

}  // namespace breakaway
