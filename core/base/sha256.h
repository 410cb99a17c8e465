// SHA-256 of what comes in pieces, or is too large to be held at once.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "base/result.h"

namespace breakaway {

/// FIPS 180-4.
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(Sha256&&) noexcept;
  Sha256& operator=(Sha256&&) noexcept;

  void add(std::string_view content);
  /// Of all that was added, in hexadecimal. More may be added afterwards.
  std::string text() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Of the file at `path`, read piece by piece; it is no input of the run (made.h). Error: it can't be read.
Result<std::string> sha256OfFile(const std::string& path);

}  // namespace breakaway
