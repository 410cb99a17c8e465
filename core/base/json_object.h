// Strict reading of a JSON object's fields: every wrong, missing or unknown field becomes one clear line.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace breakaway {

/// What a number may be; the words appear in the error ("must be positive").
enum class Allowed { any, nonNegative, positive };

/// Reads one JSON object field by field and remembers the first fault. Nested objects and arrays share that memory, so
/// that a reader reads everything it knows and asks `finish()` once. Fields nobody asked for are faults, with the
/// nearest known name as a suggestion. `comment` and `made` (made.h) are allowed everywhere.
class JsonObject {
 public:
  /// The object that is the whole file at `path`.
  static Result<JsonObject> fromFile(const std::string& path);
  /// The object in `text`; `place` stands in the errors.
  static Result<JsonObject> fromText(const std::string& text, const std::string& place);

  bool has(std::string_view name) const;
  double number(std::string_view name, Allowed allowed = Allowed::any);
  double number(std::string_view name, double otherwise, Allowed allowed = Allowed::any);
  std::optional<double> optionalNumber(std::string_view name, Allowed allowed = Allowed::any);
  std::string text(std::string_view name);
  std::string text(std::string_view name, std::string otherwise);
  bool flag(std::string_view name, bool otherwise);
  /// A nested object; an empty one when the field is missing and `required` is false.
  JsonObject object(std::string_view name, bool required = true);
  std::vector<JsonObject> objects(std::string_view name);
  std::vector<std::string> texts(std::string_view name);
  /// Rows of numbers, e.g. [[1, 0.2, 0.4], …]; each row must have `width` numbers.
  std::vector<std::vector<double>> rows(std::string_view name, size_t width);
  /// A flat array of numbers; empty when the field is missing.
  std::vector<double> numbersIn(std::string_view name);
  /// Names of all fields that hold objects.
  std::vector<std::string> objectNames() const;
  /// All number fields of this object, whatever their names.
  std::vector<std::pair<std::string, double>> numbers();

  /// Reports a fault of the reader's own at field `name`.
  void fault(std::string_view name, const std::string& fact);
  /// The first fault of this object and of all that were taken from it; unknown fields are faults.
  Result<void> finish();
  /// The same for a reader that takes only a part of the file: what nobody asked for is left alone.
  Result<void> finishPart() const;
  /// The place of field `name`, as it stands in errors.
  std::string place(std::string_view name) const;

 private:
  struct Node;
  explicit JsonObject(std::shared_ptr<Node> node);
  std::shared_ptr<Node> node_;
};

/// The candidate nearest to `name` by edit distance, or nothing when none is near.
std::optional<std::string> nearestName(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace breakaway
