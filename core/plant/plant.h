// The simulated rig's physics: winding, shaft and exact stick-slip. Standing still is standing still: speed is exactly
// zero until the drive torque exceeds static friction, and the moments of breaking away and of coming to rest are found
// on the exact solution.
#pragma once

#include <cstdint>
#include <vector>

#include "base/random.h"
#include "plant/plant_propagator.h"
#include "plant/rig.h"

namespace breakaway {

/// A motor on its rig. Between events the equations are linear with the dry torques held at their mid-step value, and
/// are solved exactly; friction moving is C(θ) + (S(θ) − C(θ))·exp(−(ω/ω_s)²) + B(θ)·ω (Armstrong-Hélouvry, "Control of
/// Machines with Friction", 1991, the Gaussian form), S with the scatter of the breakaway that began the motion.
class Plant {
 public:
  /// `substep_s` is the step; 50 µs or finer, and coarsestStep_s() or finer where there is a coupling. The shaft starts
  /// at rest at Rig::startAngle_rad().
  Plant(const Rig& rig, double substep_s, uint64_t seed);

  void applyVoltage(double voltage_V) {
    voltage_V_ = voltage_V;
    open_ = false;
  }
  void openWindings() { open_ = true; }
  /// Holds the shaft fast, or lets it go.
  void block(bool held) { blocked_ = held; }
  /// Sets the winding's resistance to `part` of what the rig file gives.
  void scaleResistance(double part);
  void advance(int substeps);

  double time_s() const { return time_s_; }
  double angle_rad() const {
    return angle_rad_;
  }  ///< of the motor, from the index; on a linear axis from the lower stop
  /// Likewise where the encoder sits: behind the coupling, or on the motor's shaft.
  double encoderAngle_rad() const { return coupling_.present() ? load_rad_ : angle_rad_; }
  double loadVelocity_rad_per_s() const { return coupling_.present() ? loadVelocity_ : velocity_; }
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
  double windingVoltage() const;
  double warmth() const;
  double outerTorque() const;
  double stopTorque(double angle_rad, double velocity) const;
  double outsideTorque(double duration_s);
  void moveLoad(double duration_s);
  double threshold(int way) const;
  double stand(double duration_s);
  double slide(double duration_s);
  void comeToRest();
  void heat();
  void prepare();
  Propagator propagatorFor(int way, double duration_s) const;

  double substep_s_;
  LinearMotor motor_[2];  ///< per way, with the way's mean viscous friction
  Propagator closed_[2], opened_[2];
  std::vector<Cell> cells_;
  double cellsPerTurn_ = 0.0;
  double stribeckVelocity_, scatterRms_, supply_V_;
  double dragCoefficient_ = 0.0, warmShare_ = 0.0, warmTime_s_ = 1.0, restShare_ = 0.0, restTime_s_ = 1.0;
  double deadTime_V_ = 0.0, sagResistance_ohm_ = 0.0;
  double heatShare_ = 0.0, heatCurrent_A_ = 1.0, heatTime_s_ = 1.0, heat_ = 0.0, coldResistance_ohm_ = 0.0;
  RigCoupling coupling_;
  double load_rad_ = 0.0, loadVelocity_ = 0.0;   ///< behind the coupling
  double coupled_Nm_ = 0.0, loadStop_Nm_ = 0.0;  ///< of the step that runs: through the coupling, on the load
  double travel_rad_ = 0.0, stopStiffness_ = 0.0, stopDamping_ = 0.0;  ///< between the stops of a linear axis
  double pulse_Nm_ = 0.0, pulseStart_s_ = 0.0, pulseEnd_s_ = 0.0;

  Noise noise_;
  double time_s_ = 0.0, angle_rad_ = 0.0, velocity_ = 0.0, current_ = 0.0, voltage_V_ = 0.0, acceleration_ = 0.0;
  bool open_ = true, moving_ = false, blocked_ = false;
  double resistancePart_ = 1.0;
  int way_ = 1;                     ///< of the motion: 0 cw, 1 ccw
  double scatter_[2] = {1.0, 1.0};  ///< of this standstill, or of the breakaway that began this motion
  double restAngle_rad_ = 1e300;    ///< where the scatter of this standstill was drawn
  double restStart_s_ = -1e9, heatDone_s_ = 0.0;
};

/// The coarsest step with which a plant follows the coupling's swing to 1e-4 of its frequency; 50 µs without one.
double coarsestStep_s(const Rig& rig);

}  // namespace breakaway
