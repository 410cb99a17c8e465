// What messages are in another language.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "base/result.h"

namespace breakaway {

/// By the English text of the message. Empty: English.
class Catalogue {
 public:
  Catalogue() = default;

  /// Of the text of a JSON object, English to other (resources/lang). Errors: not that; a message whose places are
  /// others than those of its English text.
  static Result<Catalogue> read(std::string_view json);

  /// Null: not translated.
  const std::string* find(std::string_view english) const;
  const std::map<std::string, std::string, std::less<>>& all() const { return texts_; }

 private:
  std::map<std::string, std::string, std::less<>> texts_;
};

}  // namespace breakaway
