#include "base/json_object.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/json_text.h"

namespace breakaway {

using Json = nlohmann::json;

namespace {

struct Faults {
  std::optional<Error> first;
};

std::string kindOf(const Json& value) {
  if (value.is_number()) return "the number " + value.dump();
  if (value.is_string()) return "the text " + value.dump();
  return std::string("a value of type ") + value.type_name();
}

/// Counts insertions, deletions, changes and swaps of neighbours (optimal string alignment).
size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<size_t> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    before.swap(above);
    above.swap(row);
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

struct JsonObject::Node {
  Json json;
  std::string place;
  std::shared_ptr<Faults> faults;
  std::vector<std::string> known;
  std::vector<std::shared_ptr<Node>> children;

  void fault(const std::string& where, const std::string& fact) {
    if (!faults->first) faults->first = Error{where, fact};
  }
  const Json* find(std::string_view name) {
    known.emplace_back(name);
    const auto it = json.find(std::string(name));
    return it == json.end() ? nullptr : &*it;
  }
};

JsonObject::JsonObject(std::shared_ptr<Node> node) : node_(std::move(node)) {
}

Result<JsonObject> JsonObject::fromFile(const std::string& path) {
  auto content = readFile(path);
  if (!content) return content.error();
  return fromText(*content, path);
}

Result<JsonObject> JsonObject::fromText(const std::string& text, const std::string& place) {
  if (text.empty()) return Error{place, "is empty, expected a JSON object"};
  if (auto fault = jsonFault(text, place)) return *fault;
  auto node = std::make_shared<Node>();
  node->place = place;
  node->faults = std::make_shared<Faults>();
  node->json = Json::parse(text);
  if (!node->json.is_object()) return Error{place, "expected a JSON object"};
  return JsonObject(std::move(node));
}

std::string JsonObject::place(std::string_view name) const {
  const bool nested = node_->place.find(", field ") != std::string::npos;
  return node_->place + (nested ? "." : ", field ") + std::string(name);
}

bool JsonObject::has(std::string_view name) const {
  return node_->json.contains(std::string(name));
}

std::optional<double> JsonObject::optionalNumber(std::string_view name, Allowed allowed) {
  const Json* value = node_->find(name);
  if (value == nullptr) return std::nullopt;
  const char* expected = allowed == Allowed::positive      ? "a positive number"
                         : allowed == Allowed::nonNegative ? "a number that is not negative"
                                                           : "a number";
  const bool number = value->is_number() && std::isfinite(value->get<double>());
  const double got = number ? value->get<double>() : 0.0;
  const bool good = number && (allowed == Allowed::any || got > 0.0 || (allowed == Allowed::nonNegative && got == 0.0));
  if (!good) {
    node_->fault(place(name), std::string("expected ") + expected + ", found " + kindOf(*value));
    return std::nullopt;
  }
  return got;
}

double JsonObject::number(std::string_view name, Allowed allowed) {
  if (!has(name)) {
    node_->known.emplace_back(name);
    node_->fault(place(name), "is missing, expected a number");
    return 0.0;
  }
  return optionalNumber(name, allowed).value_or(0.0);
}

double JsonObject::number(std::string_view name, double otherwise, Allowed allowed) {
  return optionalNumber(name, allowed).value_or(otherwise);
}

std::string JsonObject::text(std::string_view name) {
  const Json* value = node_->find(name);
  if (value == nullptr) {
    node_->fault(place(name), "is missing, expected a text");
    return {};
  }
  if (!value->is_string()) {
    node_->fault(place(name), "expected a text, found " + kindOf(*value));
    return {};
  }
  return value->get<std::string>();
}

std::string JsonObject::text(std::string_view name, std::string otherwise) {
  return has(name) ? text(name) : (node_->known.emplace_back(name), std::move(otherwise));
}

bool JsonObject::flag(std::string_view name, bool otherwise) {
  const Json* value = node_->find(name);
  if (value == nullptr) return otherwise;
  if (!value->is_boolean()) {
    node_->fault(place(name), "expected true or false, found " + kindOf(*value));
    return otherwise;
  }
  return value->get<bool>();
}

JsonObject JsonObject::object(std::string_view name, bool required) {
  auto child = std::make_shared<Node>();
  child->place = place(name);
  child->faults = node_->faults;
  child->json = Json::object();
  const Json* value = node_->find(name);
  if (value == nullptr) {
    if (required) node_->fault(place(name), "is missing, expected an object");
  } else if (!value->is_object()) {
    node_->fault(place(name), "expected an object, found " + kindOf(*value));
  } else {
    child->json = *value;
  }
  node_->children.push_back(child);
  return JsonObject(std::move(child));
}

std::vector<JsonObject> JsonObject::objects(std::string_view name) {
  std::vector<JsonObject> result;
  const Json* value = node_->find(name);
  if (value == nullptr) return result;
  if (!value->is_array()) {
    node_->fault(place(name), "expected an array of objects, found " + kindOf(*value));
    return result;
  }
  for (size_t i = 0; i < value->size(); ++i) {
    const Json& item = (*value)[i];
    auto child = std::make_shared<Node>();
    child->place = place(name) + "[" + std::to_string(i) + "]";
    child->faults = node_->faults;
    child->json = Json::object();
    if (item.is_object()) {
      child->json = item;
    } else {
      node_->fault(child->place, "expected an object, found " + kindOf(item));
    }
    node_->children.push_back(child);
    result.push_back(JsonObject(std::move(child)));
  }
  return result;
}

std::vector<std::string> JsonObject::texts(std::string_view name) {
  std::vector<std::string> result;
  const Json* value = node_->find(name);
  if (value == nullptr) return result;
  const bool good =
      value->is_array() && std::all_of(value->begin(), value->end(), [](const Json& item) { return item.is_string(); });
  if (!good) {
    node_->fault(place(name), "expected an array of texts, found " + kindOf(*value));
    return result;
  }
  for (const Json& item : *value) result.push_back(item.get<std::string>());
  return result;
}

std::vector<std::vector<double>> JsonObject::rows(std::string_view name, size_t width) {
  std::vector<std::vector<double>> result;
  const Json* value = node_->find(name);
  if (value == nullptr) return result;
  const auto goodRow = [width](const Json& row) {
    return row.is_array() && row.size() == width &&
           std::all_of(row.begin(), row.end(), [](const Json& item) { return item.is_number(); });
  };
  if (!value->is_array() || !std::all_of(value->begin(), value->end(), goodRow)) {
    node_->fault(place(name), "expected an array of rows of " + std::to_string(width) + " numbers");
    return result;
  }
  for (const Json& row : *value) result.push_back(row.get<std::vector<double>>());
  return result;
}

std::vector<double> JsonObject::numbersIn(std::string_view name) {
  const Json* value = node_->find(name);
  if (value == nullptr) return {};
  const bool good =
      value->is_array() && std::all_of(value->begin(), value->end(), [](const Json& item) { return item.is_number(); });
  if (!good) {
    node_->fault(place(name), "expected an array of numbers, found " + kindOf(*value));
    return {};
  }
  return value->get<std::vector<double>>();
}

std::vector<std::string> JsonObject::objectNames() const {
  std::vector<std::string> names;
  for (const auto& [name, value] : node_->json.items()) {
    if (value.is_object()) names.push_back(name);
  }
  return names;
}

std::vector<std::pair<std::string, double>> JsonObject::numbers() {
  std::vector<std::pair<std::string, double>> result;
  for (const auto& [name, value] : node_->json.items()) {
    if (!value.is_number()) continue;
    node_->known.push_back(name);
    result.emplace_back(name, value.get<double>());
  }
  return result;
}

void JsonObject::fault(std::string_view name, const std::string& fact) {
  node_->fault(place(name), fact);
}

Result<void> JsonObject::finishPart() const {
  if (node_->faults->first) return *node_->faults->first;
  return {};
}

Result<void> JsonObject::finish() {
  for (const auto& [name, value] : node_->json.items()) {
    const bool known = std::find(node_->known.begin(), node_->known.end(), name) != node_->known.end();
    if (known || name == "comment" || name == "made") continue;
    const auto suggestion = nearestName(name, node_->known);
    std::string all;
    for (const auto& one : node_->known) all += (all.empty() ? "" : ", ") + one;
    node_->fault(place(name), suggestion ? "is an unknown field, did you mean " + *suggestion + "?"
                                         : "is an unknown field, expected one of: " + all);
  }
  for (const auto& child : node_->children) {
    if (const auto done = JsonObject(child).finish(); !done) break;
  }
  return finishPart();
}

std::optional<std::string> nearestName(std::string_view name, const std::vector<std::string>& candidates) {
  std::optional<std::string> best;
  size_t bestDistance = std::max<size_t>(2, name.size() / 2);
  for (const auto& candidate : candidates) {
    const size_t distance = editDistance(name, candidate);
    if (distance < bestDistance) {
      bestDistance = distance;
      best = candidate;
    }
  }
  return best;
}

}  // namespace breakaway
