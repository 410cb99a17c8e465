#include "base/json_text.h"

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

namespace breakaway {

namespace {

using Json = nlohmann::json;

std::string lineAt(std::string_view text, size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  return std::to_string(1 + std::count(text.begin(), end, '\n'));
}

/// Follows the parser without keeping any value; false ends the parsing.
struct Checker : nlohmann::json_sax<Json> {
  std::vector<std::set<std::string>> fields;  ///< of each object that is open
  std::string fact;
  std::size_t byte = 0;

  bool null() override { return true; }
  bool boolean(bool /*value*/) override { return true; }
  bool number_integer(number_integer_t /*value*/) override { return true; }
  bool number_unsigned(number_unsigned_t /*value*/) override { return true; }
  bool number_float(number_float_t /*value*/, const string_t& /*text*/) override { return true; }
  bool string(string_t& /*value*/) override { return true; }
  bool binary(binary_t& /*value*/) override { return true; }
  bool start_object(std::size_t /*elements*/) override {
    fields.emplace_back();
    return true;
  }
  bool end_object() override {
    fields.pop_back();
    return true;
  }
  bool start_array(std::size_t /*elements*/) override { return true; }
  bool end_array() override { return true; }
  bool key(string_t& name) override {
    if (fields.back().insert(name).second) return true;
    fact = "has the field " + name + " twice in one object";
    return false;
  }
  bool parse_error(std::size_t at, const std::string& /*token*/, const nlohmann::detail::exception& error) override {
    byte = at;
    fact = error.id == 406 ? "holds a number that is beyond all that can be computed with" : "is not valid JSON";
    return false;
  }
};

}  // namespace

bool nestsTooDeep(std::string_view text) {
  int depth = 0;
  bool quoted = false;
  for (size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (quoted) {
      if (c == '\\') ++k;
      if (c == '"') quoted = false;
    } else if (c == '"') {
      quoted = true;
    } else if (c == '{' || c == '[') {
      if (++depth > deepestJson) return true;
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
  return false;
}

std::optional<Error> jsonFault(std::string_view text, const std::string& place) {
  if (nestsTooDeep(text))
    return Error{place, "nests deeper than " + std::to_string(deepestJson) + " levels, which is not read"};
  Checker checker;
  if (Json::sax_parse(text.begin(), text.end(), &checker)) return std::nullopt;
  if (checker.byte == 0) return Error{place, checker.fact};
  const bool invalid = checker.fact == "is not valid JSON";
  return Error{invalid ? place + ", line " + lineAt(text, checker.byte - 1) : place, checker.fact};
}

std::string asUtf8(const std::string& text) {
  return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
}

}  // namespace breakaway
