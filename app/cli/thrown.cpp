#include "cli/thrown.h"

#include <new>
#include <stdexcept>
#include <string>

namespace breakaway::cli {

Error thrown(const std::exception& exception) {
  const bool memory = dynamic_cast<const std::bad_alloc*>(&exception) != nullptr ||
                      dynamic_cast<const std::length_error*>(&exception) != nullptr;
  if (memory) return Error{"", "there is not enough memory for this input"};
  return Error{"", std::string("cannot go on with this input: ") + exception.what()};
}

}  // namespace breakaway::cli
