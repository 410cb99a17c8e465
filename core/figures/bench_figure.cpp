#include "figures/bench_figure.h"

namespace breakaway {

const std::vector<double>& columnOf(const BenchFigure& figure, const std::string& name) {
  static const std::vector<double> none;
  for (const Channel& one : figure.columns) {
    if (one.name == name) return one.values;
  }
  return none;
}

Curve drawn(const BenchFigure& figure, const std::string& label, const std::string& x, const std::string& y,
            double yScale, double xScale) {
  Curve curve{label, columnOf(figure, x), columnOf(figure, y)};
  for (double& value : curve.x) value *= xScale;
  for (double& value : curve.y) value *= yScale;
  return curve;
}

}  // namespace breakaway
