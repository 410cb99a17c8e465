// Texts of tables that become messages.
#pragma once

#include "base/message.h"

namespace breakaway {

/// A message's text that stands in a table: message(text) says it.
consteval MessageText<0> marked(const char* text) {
  return text;
}

}  // namespace breakaway
