// Independent work on all cores.
#pragma once

#include <cstddef>
#include <functional>

namespace breakaway {

/// work(0) … work(count − 1), several at once on the cores that the process may use; returns when all is done. Each may
/// change only what belongs to its own number, so that the outcome is the same on one core.
void inParallel(size_t count, const std::function<void(size_t)>& work);

}  // namespace breakaway
