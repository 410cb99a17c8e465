// A model's free parameters as a vector for the fit: scales, bounds and ties in one place.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/model/model.h"
#include "motor/bench.h"

namespace breakaway {

/// What bench and recordings leave to a fit of the base parameters.
struct Freedom {
  std::vector<std::string> held;   ///< trusted, and those that set the scale
  double leastInductance_H = 0.0;  ///< beyond these, something else is late
  double mostInductance_H = std::numeric_limits<double>::infinity();
  /// How much later than it acted a drive may be recorded; negative: earlier.
  double leastLate_s = 0.0;
  double mostLate_s = 0.0;
  double row_s = 0.0;  ///< the usual row, by which effects that move the drive in time hold it

  double mostBias = 0.0;  ///< a larger constant load is an effect, Nm

  std::optional<size_t> heldSize;  ///< the effect of the model whose size, its first parameter, stays as it is

  bool mayBeLate() const { return leastLate_s < mostLate_s; }
  bool holds(const std::string& name) const;
};

/// Positive base quantities enter as logarithms, all others divided by a typical size, so that every entry is of order
/// one.
class ParameterVector {
 public:
  /// All parameters of `model` except those that are held and those their effect holds. The back-EMF constant keeps
  /// its ratio to the torque constant unless either is held. `torqueSize` and `speedSize` are typical for the
  /// recordings.
  ParameterVector(const Model& model, const Freedom& freedom, double torqueSize, double speedSize, bool last = false);

  Eigen::Index size() const { return static_cast<Eigen::Index>(slots_.size()); }
  Eigen::VectorXd start() const;
  double lower(Eigen::Index k) const { return slots_[static_cast<size_t>(k)].lower; }
  double upper(Eigen::Index k) const { return slots_[static_cast<size_t>(k)].upper; }
  /// A positive base quantity: one that a gauge may leave free.
  bool logarithmic(Eigen::Index k) const { return slots_[static_cast<size_t>(k)].logarithmic; }
  const std::string& name(Eigen::Index k) const { return slots_[static_cast<size_t>(k)].name; }
  /// The entry that is the size of the model's effect of that number; nothing if it is held.
  std::optional<Eigen::Index> sizeOf(size_t effect) const;

  /// The model at `x`.
  Model at(const Eigen::VectorXd& x) const;
  /// The model at `x` with intervals of `errors` standard errors each way from the covariance of x.
  Model withIntervals(const Eigen::VectorXd& x, const Eigen::MatrixXd& covariance, double errors) const;

 private:
  struct Slot {
    std::string name;
    size_t effect = 0;  ///< index of the effect plus one; 0: base
    size_t index = 0;
    bool logarithmic = false;
    bool bounded = false;  ///< the interval, too
    double scale = 1.0;
    double lower = -1e300;
    double upper = 1e300;
  };
  static Parameter& parameter(Model& model, const Slot& slot);
  Eigen::MatrixXd withinBounds(Eigen::MatrixXd covariance) const;

  Model model_;
  std::vector<Slot> slots_;
  double emfRatio_ = 0.0;  ///< Ke/Kt when tied; 0: not tied
};

/// A typical size of a quantity, by the unit at the end of its name.
double typicalSize(const std::string& name, double torqueSize, double speedSize);

}  // namespace breakaway
