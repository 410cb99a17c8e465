// The plant of simulated boards and sealed trials: winding, shaft and exact stick-slip. Standing still is standing
// still: speed is exactly zero until the drive torque exceeds static friction, and the moments of breaking away and of
// coming to rest are found on the exact solution. Written apart from the search's simulator, so that an error in one of
// them can't hide in the other.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/random.h"
#include "plant/command_path.h"
#include "plant/outside.h"
#include "plant/physics.h"
#include "plant/plant_propagator.h"
#include "plant/rig.h"

namespace breakaway {

/// Between events the equations are linear with the dry torques held at their mid-step value, and are solved exactly;
/// friction moving is C(θ) + (S(θ) − C(θ))·exp(−(ω/ω_s)^δ) + B(θ)·ω (Armstrong-Hélouvry, "Control of Machines with
/// Friction", 1991), S with the scatter of the breakaway that began the motion; with bristles LuGre's on top of that
/// level (Canudas de Wit et al., "A new model for control of systems with friction", IEEE TAC 40 (1995), eqs. 2–4).
class Plant {
 public:
  /// `substep_s` is the step; 50 µs or finer, and coarsestStep_s() or finer where there is a coupling. The shaft starts
  /// at rest at PlantPhysics::startAngle_rad.
  Plant(const PlantPhysics& physics, double substep_s, uint64_t seed);
  Plant(const Rig& rig, double substep_s, uint64_t seed) : Plant(physicsOf(rig), substep_s, seed) {}

  void applyVoltage(double voltage_V) { apply(voltage_V); }
  /// The input of the physics: V, or Nm where it isn't electrical.
  void apply(double input) {
    input_ = input;
    open_ = false;
  }
  void openWindings() { open_ = true; }
  /// Holds the shaft fast, or lets it go.
  void block(bool held) { blocked_ = held; }
  /// Sets the winding's resistance to `part` of what the rig file gives.
  void scaleResistance(double part);
  void advance(int substeps);
  /// Starts it at another state, motor and load together.
  void set(double angle_rad, double velocity_rad_per_s, double current_A);

  double time_s() const { return time_s_; }
  double angle_rad() const {
    return angle_rad_;
  }  ///< of the motor, from the index; on a linear axis from the lower stop
  /// Likewise where the encoder sits: behind the coupling, or on the motor's shaft.
  double encoderAngle_rad() const { return physics_.coupling.present() ? load_rad_ : angle_rad_; }
  double loadVelocity_rad_per_s() const { return physics_.coupling.present() ? loadVelocity_ : velocity_; }
  double velocity_rad_per_s() const { return velocity_; }
  double current_A() const { return open_ ? 0.0 : current_; }
  bool standing() const { return !moving_; }

 private:
  struct Cell {  ///< torques on the angle grid, laid out for interpolation
    double static_Nm[2], coulomb_Nm[2], viscous[2], position_Nm, ripple;
  };
  struct Local {
    double static_Nm, coulomb_Nm, viscous, position_Nm, torqueConstant;
  };

  Local localAt(double angle_rad, int way) const;
  bool shaftAlone() const { return open_ || !physics_.electrical; }
  double windingVoltage() const;
  double motorTorque(const Local& here, double current_A) const;
  double warmth() const;
  double rested() const;
  double outerTorque(double angle_rad) const;
  void placeWalls();
  double stopTorque(double angle_rad, double velocity) const;
  double outsideTorque(double duration_s);
  void moveLoad(double duration_s);
  double further(const Local& here, double speed, double current_A) const;
  double threshold(const Local& here, int way, double current_A) const;
  double stand(double duration_s);
  double slide(double duration_s);
  double bristleTorque(double dry_Nm, double duration_s);
  void comeToRest();
  void heat();
  void prepare();
  Propagator propagatorFor(int way, double duration_s) const;

  PlantPhysics physics_;
  double substep_s_;
  LinearMotor motor_[2];  ///< per way, with the way's mean viscous friction
  Propagator closed_[2], opened_[2];
  std::vector<Cell> cells_;
  double cellsPerTurn_ = 0.0;
  std::optional<CommandPath> path_;
  std::optional<Outside> outside_;
  bool bent_ = false;     ///< the motor's torque isn't the mean torque constant times the current
  bool further_ = false;  ///< there is dry friction beyond static and Coulomb friction
  double loss_J_ = 0.0, heat_ = 0.0, heatDone_s_ = 0.0;
  double load_rad_ = 0.0, loadVelocity_ = 0.0;   ///< behind the coupling
  double coupled_Nm_ = 0.0, loadStop_Nm_ = 0.0;  ///< of the step that runs: through the coupling, on the load

  Noise noise_;
  double time_s_ = 0.0, angle_rad_ = 0.0, velocity_ = 0.0, current_ = 0.0, input_ = 0.0, acting_ = 0.0,
         acceleration_ = 0.0;
  bool open_ = true, moving_ = false, blocked_ = false;
  double resistancePart_ = 1.0;
  int way_ = 1;                     ///< of the motion: 0 cw, 1 ccw
  double scatter_[2] = {1.0, 1.0};  ///< of this standstill, or of the breakaway that began this motion
  double restAngle_rad_ = 1e300;    ///< where the scatter of this standstill was drawn
  double restStart_s_ = -1e9, restLeft_Nm_ = 0.0;
  double bristle_rad_ = 0.0;  ///< LuGre's z
};

/// The coarsest step with which a plant follows the coupling's swing to 1e-4 of its frequency; 50 µs without one.
double coarsestStep_s(const Rig& rig);

}  // namespace breakaway
