// A figure of the bench with the numbers behind it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "draw/svg_plot.h"
#include "recording/recording.h"

namespace breakaway {

struct BenchFigure {
  std::string name;  ///< of its files, without ending
  std::string says;  ///< what it shows and how it was measured, a few sentences
  Figure figure;
  std::vector<Channel> columns;                                 ///< the numbers behind it, equally long, all finite
  std::vector<std::pair<std::string, double>> keyNumbers = {};  ///< name with unit, and value
};

/// The values of a figure's column; empty when there is none of that name.
const std::vector<double>& columnOf(const BenchFigure& figure, const std::string& name);

/// A curve drawn from two of the figure's columns, times `yScale`.
Curve drawn(const BenchFigure& figure, const std::string& label, const std::string& x, const std::string& y,
            double yScale = 1.0, double xScale = 1.0);

}  // namespace breakaway
