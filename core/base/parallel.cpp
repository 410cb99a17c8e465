#include "base/parallel.h"

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

}  // namespace breakaway
