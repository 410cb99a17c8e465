// Columns of the linear rig that a search has asked for already: it comes back to most of them.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>

#include "diagnose/model/effect.h"

namespace breakaway {

/// Keeps columns by what they are of, at most some 32 MB of them. Not for several threads.
class ColumnMemo {
 public:
  using Key = std::tuple<const Effect*, Shape, size_t>;  ///< of which track

  /// The columns of `key`, by `make` where they aren't known.
  template <typename Make>
  const Eigen::MatrixXd& get(Key key, Make make) {
    const auto known = columns_.find(key);
    if (known != columns_.end()) return known->second;
    Eigen::MatrixXd own = make();
    kept_ += own.size();
    if (kept_ > mostKept) {
      columns_.clear();
      kept_ = own.size();
    }
    return columns_.emplace(std::move(key), std::move(own)).first->second;
  }

 private:
  static constexpr Eigen::Index mostKept = Eigen::Index{4} << 20;  ///< numbers

  std::map<Key, Eigen::MatrixXd> columns_;
  Eigen::Index kept_ = 0;
};

}  // namespace breakaway
