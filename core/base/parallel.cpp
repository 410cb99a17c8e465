#include "base/parallel.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <execution>
#include <numeric>
#include <vector>

namespace breakaway {

void inParallel(size_t count, const std::function<void(size_t)>& work) {
  std::vector<size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), size_t{0});
  std::for_each(std::execution::par, numbers.begin(), numbers.end(), work);
}

void onThreads(size_t jobs, const std::function<void()>& work) {
  using Limit = tbb::global_control;
  const Limit threads(Limit::max_allowed_parallelism, jobs);
  const Limit stack(Limit::thread_stack_size, size_t{8} << 20);
  tbb::task_arena arena(static_cast<int>(jobs));
  arena.execute([&] {
    tbb::task_group all;
    // Isolated: one that waits for its own part of inParallel() begins nobody else's work meanwhile.
    const auto one = [&work] { tbb::this_task_arena::isolate(work); };
    for (size_t k = 1; k < jobs; ++k) all.run(one);
    all.run_and_wait(one);
  });
}

}  // namespace breakaway
