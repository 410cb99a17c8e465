// Independent work on all cores.
#pragma once

#include <cstddef>
#include <functional>

namespace breakaway {

/// work(0) … work(count − 1), several at once on the cores that the process may use; returns when all is done. Each may
/// change only what belongs to its own number, so that the outcome is the same on one core.
void inParallel(size_t count, const std::function<void(size_t)>& work);

/// Runs `work` once on each of `jobs` threads, from 1 on, and returns when all have ended. What one of them gives to
/// inParallel() it does alone, until others have ended: they help with it. So no more than `jobs` cores are busy.
void onThreads(size_t jobs, const std::function<void()>& work);

}  // namespace breakaway
