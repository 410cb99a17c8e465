#include "diagnose/verdict/explained.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "dense/dense_solve.h"
#include "diagnose/verdict/instants.h"

namespace breakaway {

namespace {

constexpr size_t fewestParts = 96;  ///< of the whole axis
constexpr double fewest = 5.0;      ///< instants in a part

/// What `without` lacks at each instant, less what a base model would take up.
std::vector<double> lawAt(const Instants& without, const Instants& with) {
  const auto rows = static_cast<Eigen::Index>(without.value.size());
  Eigen::MatrixXd base(rows, 3);
  Eigen::VectorXd law(rows);
  for (Eigen::Index row = 0; row < rows; ++row) {
    const auto k = static_cast<size_t>(row);
    law[row] = without.value[k] - with.value[k];
    base.row(row) << without.way[k], without.along[byVelocity][k], without.along[byAcceleration][k];
  }
  const Eigen::VectorXd taken = leastSquares(base, law);
  law -= base.leftCols(2) * taken.head(2);
  // What the inertia takes up has no place on other axes: accelerations of both signs meet in a cell.
  return {law.begin(), law.end()};
}

}  // namespace

Course explainedOver(const ResidualMap& map, const Model& without, const Model& model,
                     const std::vector<Track>& tracks) {
  Course course;
  if (map.along == alongs || map.centre.empty()) return course;
  const AllInstants before = instantsOf(without, tracks), after = instantsOf(model, tracks, &before);
  const Instants &one = before.of(map.shows), &other = after.of(map.shows);
  if (one.value.empty() || one.value.size() != other.value.size()) return course;
  const std::vector<double> law = lawAt(one, other);
  const size_t cells = map.centre.size(), partsOfCell = std::max<size_t>(1, fewestParts / cells);
  std::vector<double> sum(cells * partsOfCell, 0.0), count(sum.size(), 0.0);
  for (size_t k = 0; k < one.value.size(); ++k) {
    const double place = one.place(k, map.along, map.shows);
    const auto next = std::lower_bound(map.centre.begin(), map.centre.end(), place);
    auto cell = static_cast<size_t>(next - map.centre.begin());
    if (cell == cells || (cell > 0 && place < map.centre[cell] - 0.5 * map.width[cell])) --cell;
    const double within = (place - map.centre[cell]) / map.width[cell] + 0.5;
    if (!(within >= 0.0 && within < 1.0)) continue;
    const size_t part = partsOfCell * cell + static_cast<size_t>(within * static_cast<double>(partsOfCell));
    sum[part] += map.shows == Unknown::friction ? one.way[k] * law[k] : law[k];
    count[part] += 1.0;
  }
  for (size_t part = 0; part < sum.size(); ++part) {
    const size_t cell = part / partsOfCell;
    const double within = (static_cast<double>(part % partsOfCell) + 0.5) / static_cast<double>(partsOfCell) - 0.5;
    if (!std::isfinite(map.mean[cell])) {  // one gap for all that is unknown
      if (!course.value.empty() && std::isfinite(course.value.back())) {
        course.at.push_back(map.centre[cell]);
        course.value.push_back(std::nan(""));
      }
    } else if (count[part] >= fewest) {
      course.at.push_back(map.centre[cell] + within * map.width[cell]);
      course.value.push_back(sum[part] / count[part]);
    }
  }
  return course;
}

}  // namespace breakaway
