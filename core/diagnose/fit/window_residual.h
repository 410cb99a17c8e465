// One restarted window's residuals, their initial state eliminated: what the fit minimises.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "diagnose/fit/torque_residual.h"
#include "diagnose/fit/window.h"
#include "diagnose/simulate/simulator.h"

namespace breakaway {

/// How the residuals of each channel are weighed: one over a typical residual.
struct Weights {
  double position = 1.0;
  double current = 0.0;
};

/// Of a window whose errors are in torque: what TorqueResidual says, in the place of positions, and no state. Else
/// residuals of positions, or of speeds where they alone were measured (and of currents where the track has them). The
/// window's initial position and velocity (and those of a load that swings) are free, held to what the restart's
/// observer saw as firmly as its noise allows, and eliminated by variable projection (G. Golub, V. Pereyra, SIAM J.
/// Numer. Anal. 10(2), 1973).
class WindowResidual {
 public:
  WindowResidual(const Track& track, const Window& window, Weights weights);

  /// Positions first, then currents, then rows for the state: two, and two for each load that swings (known once fit()
  /// ran).
  Eigen::Index rows() const { return positions_ + (torque_ ? 0 : currents_ + 2 + loadRows_); }
  Eigen::Index positions() const { return positions_; }
  Eigen::Index currents() const { return currents_; }

  /// The weighted residuals of `model`, with the best initial state (one step from that of the call before). `hidden`
  /// is what measurements don't tell of the state. The observer's view of the start is taken at the first call and
  /// kept.
  void fit(const Model& model, const MotionState& hidden);
  const Eigen::VectorXd& residual() const { return residual_; }
  /// Other weights, from the next fit() on.
  void reweigh(Weights weights) { weights_ = weights; }
  /// The change of the residuals per unit of a variant, (variant − model)/step, with the initial state's share taken
  /// out: by simulating the variant, or by the linearised motion, which is several times faster and not quite as
  /// exact where the motion stops or effects carry hidden states.
  Eigen::VectorXd column(const Model& variant, const MotionState& hidden, double step) const;
  /// The variant differs in one parameter.
  Eigen::VectorXd linearColumn(const Model& variant, double step) const;
  /// Whether linearColumn() leaves out hidden states.
  bool remembers() const { return !torque_ && simulator_->stepper().remembers(); }
  /// Whether impacts may make the residual rough.
  bool swings() const { return !torque_ && simulator_->stepper().swings(); }

 private:
  /// How a small change passes through one row, and what the model's torques are there.
  struct Passage {
    double velocity = 0.0;    ///< change of velocity after per change before
    double gain = 0.0;        ///< … per unit of torque
    double stiffness = 0.0;   ///< torque per change of position
    double net = 0.0;         ///< drive less all resistance, Nm
    double resistance = 0.0;  ///< of load and dry friction, Nm
    double drive = 0.0;       ///< Nm
    double input = 0.0;       ///< V, A or Nm
    double current = 0.0;     ///< A
    double lost = 0.0;        ///< V
  };
  bool useCurrent(size_t row) const;
  void simulate(Simulator& simulator, MotionState state, Eigen::VectorXd& out, std::vector<MotionState>* keep) const;
  void evaluate(Simulator& simulator, const MotionState& from, Eigen::VectorXd& out,
                std::vector<MotionState>* keep = nullptr) const;
  /// Position and velocity, and of each load that swings place and speed relative to the motor.
  Eigen::VectorXd startOf(const MotionState& state) const;
  MotionState startAt(const Eigen::VectorXd& start, const MotionState& hidden) const;
  /// The residuals' change with each number of the start.
  Eigen::MatrixXd startColumns(const MotionState& hidden);
  /// With `parts` of the model's terms there, of which those marked in `changed` are evaluated anew.
  Passage torquesAt(Simulator& simulator, size_t row, std::span<const char> changed, std::span<Term> parts) const;
  /// Which terms of a variant differ from the model's; all where it changes what drives them.
  std::vector<char> changedTerms(const Stepper& variant) const;
  std::span<const Term> partsOf(size_t k) const;
  void linearise();
  /// Whether standstill ends within row k of the run.
  bool startsAt(size_t k) const;
  /// Change of velocity after a start per unit of torque: more friction makes it start later, at the acceleration that
  /// follows.
  double startGain(size_t k) const;
  /// The response of all residuals to a change of the start and of the torque (and current) in each row.
  Eigen::VectorXd respond(double position, double velocity, const std::vector<double>* torque,
                          const std::vector<double>* current) const;
  Eigen::VectorXd projected(const Eigen::VectorXd& change) const {
    return change - basis_ * (basis_.transpose() * change);
  }

  Eigen::VectorXd torqueColumn(const Model& variant, double step) const {
    return (weights_.position * torque_->of(variant) - residual_) / step;
  }

  const Track& track_;
  Window window_;
  std::optional<TorqueResidual> torque_;
  Weights weights_;
  double length_ = 0.0;
  Eigen::Index positions_ = 0, currents_ = 0, loadRows_ = 0;
  bool observedYet_ = false;
  MotionState observed_;                 ///< what the observer saw
  Eigen::VectorXd seen_, start_, next_;  ///< the start that it saw, of the nominal run, of the next one
  Eigen::VectorXd firm_;                 ///< with which the start is held to what was seen
  std::optional<Simulator> simulator_;
  std::vector<MotionState> states_;  ///< of the nominal run, one per row
  std::vector<Passage> passages_;    ///< one per row but the last
  std::vector<Term> parts_;          ///< of each passage, one per term
  Eigen::VectorXd nominal_, residual_;
  Eigen::MatrixXd basis_;
};

/// Weights of windows fitted with weights 1: one over the root mean square of each channel's residual.
Weights weightsOf(const std::vector<WindowResidual>& residuals, const std::vector<Track>& tracks,
                  const std::vector<Window>& windows);

}  // namespace breakaway
