// Logs whose rows speak of several motors one after the other.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "recording/import/raw_table.h"

namespace breakaway {

/// Which axis each row speaks of, by a column's texts or whole numbers: 0 where it tells nothing, else from 1 on, in
/// the order of `names`. Nothing when there are more than 64 of them.
struct RowKinds {
  std::vector<std::string> names;
  std::vector<size_t> of;
};
std::optional<RowKinds> rowKinds(const RawColumn& column);

/// The column that tells which of several axes a row speaks of: within each of its values `motion`, an angle or a
/// speed, goes on far more smoothly than from row to row; or `time` begins anew with each. Numbers count only where
/// their name tells that they number axes, or several rows have the same stamp. So does one that tells what was sent
/// and what came back ("tx", "rx"), whatever moves. `free`: the columns that may be it.
struct AxesInTurn {
  size_t column = 0;
  std::vector<std::string> names;
  bool messages = false;  ///< sent and received
};
std::optional<AxesInTurn> axesInTurn(const RawTable& table, const std::vector<bool>& free, size_t motion,
                                     std::optional<size_t> time);

}  // namespace breakaway
