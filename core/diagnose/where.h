// Where simulation and recording part: the torque that the model can't explain, mapped over time, angle, velocity and
// more.
#pragma once

#include <string>
#include <vector>

#include "diagnose/diagnosis.h"
#include "diagnose/simulate/model.h"
#include "diagnose/simulate/track.h"

namespace breakaway {

/// Mean unexplained torque over one axis; bins without data are NaN.
struct ResidualMap {
  std::string axis;
  std::string unit;
  std::vector<double> centre;    ///< bin centres in `unit`
  std::vector<double> mean_Nm;   ///< torque (N on a linear axis) that the drive gave beyond what the model needs
  std::vector<double> error_Nm;  ///< standard error of that mean, from stretches of one second
  std::vector<double> count;
  double share = 0.0;  ///< part of the unexplained squared torque that lies in these means
  double pValue = 1.0;
};

/// Maps over every axis that the tracks show. Significance by sign flips of whole seconds, maximum over bins.
std::vector<ResidualMap> residualMaps(const Model& model, const std::vector<Track>& tracks, std::uint64_t seed);

/// The stretches of the significant maps where it is worst, the largest share first.
std::vector<Place> places(const std::vector<ResidualMap>& maps, const Model& model);

}  // namespace breakaway
