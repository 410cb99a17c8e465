#include "base/shard.h"

#include <cstdio>

namespace breakaway {

Result<Shard> parseShard(const std::string& text) {
  Shard shard;
  int used = 0;
  const bool read = std::sscanf(text.c_str(), "%6zu/%6zu%n", &shard.index, &shard.count, &used) == 2 &&
                    static_cast<size_t>(used) == text.size();
  if (!read || shard.index < 1 || shard.index > shard.count)
    return Error{"--shard", "expected I/N with I from 1 to N, found \"" + text + "\""};
  return shard;
}

}  // namespace breakaway
