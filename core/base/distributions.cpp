#include "base/distributions.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace breakaway {

double student95(double freedom) {
  return boost::math::quantile(boost::math::students_t(std::max(freedom, 1.0)), 0.975);
}

double deviationsOf(double chance) {
  return boost::math::quantile(boost::math::complement(boost::math::normal(), 0.5 * chance));
}

double upperBound95(std::size_t hits, std::size_t runs) {
  if (hits >= runs) return 1.0;
  return boost::math::binomial::find_upper_bound_on_p(static_cast<double>(runs), static_cast<double>(hits), 0.05);
}

double chiSquareTail(double value, double freedom) {
  return boost::math::cdf(boost::math::complement(boost::math::chi_squared(freedom), value));
}

}  // namespace breakaway
