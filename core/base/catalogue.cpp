#include "base/catalogue.h"

#include <nlohmann/json.hpp>
#include <set>

namespace breakaway {

namespace {

/// The numbers of the places: "{}" and "{:.3g}" count on from the one before.
std::multiset<std::string> placesOf(const std::string& text) {
  std::multiset<std::string> places;
  size_t next = 0;
  for (size_t at = text.find('{'); at != std::string::npos; at = text.find('{', at + 1)) {
    const size_t close = text.find('}', at);
    if (close == std::string::npos) break;
    const std::string number = text.substr(at + 1, close - at - 1);
    places.insert(number.empty() || number.front() == ':' ? std::to_string(next++) : number);
  }
  return places;
}

}  // namespace

Result<Catalogue> Catalogue::read(std::string_view json) {
  const auto parsed = nlohmann::json::parse(json, nullptr, false);
  if (!parsed.is_object()) return Error{"catalogue", "not a JSON object"};
  Catalogue catalogue;
  for (const auto& [english, other] : parsed.items()) {
    if (!other.is_string()) return Error{"catalogue, " + english, "not a text"};
    const auto& text = other.get_ref<const std::string&>();
    if (placesOf(english) != placesOf(text)) return Error{"catalogue, " + english, "other places: " + text};
    catalogue.texts_.emplace(english, text);
  }
  return catalogue;
}

const std::string* Catalogue::find(std::string_view english) const {
  const auto found = texts_.find(english);
  return found == texts_.end() ? nullptr : &found->second;
}

}  // namespace breakaway
