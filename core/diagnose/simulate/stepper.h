// Exact stick-slip steps of a model with one degree of freedom.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "diagnose/model/effect.h"

namespace breakaway {

/// The base physics with numbers, on a linear axis in kg, N and m.
///   J a = drive − B ω − F s − G sin(θ − θ_down) − terms;   drive = Kt i;   L di/dt = u − R i − Ke ω
/// Without an electrical side the drive is Kt u, with Kt = 1 where u is already a torque.
struct Physics {
  Axis axis = Axis::rotary;
  double inertia = 1.0;               ///< J with the pendulum's share, kg m²
  double viscous = 0.0;               ///< B, Nm s/rad
  double coulomb = 0.0;               ///< F, Nm
  double gravity = 0.0;               ///< G, Nm
  double downAngle = 0.0;             ///< θ_down, rad
  bool electrical = false;            ///< u is a voltage; otherwise u is a current or a torque
  double torqueConstant = 1.0;        ///< Kt, Nm/A
  double backEmf = 0.0;               ///< Ke, V s/rad
  double resistance = 1.0;            ///< R, Ω
  double inductance = 0.0;            ///< L, H; 0: the current follows at once
  std::optional<double> driveLate_s;  ///< what is recorded of a measured drive acted earlier by this
  double load = 0.0;  ///< a further constant load, Nm: the bias; the restart's observer adds what the model lacks

  /// Of a standing axis, once the current has followed: Nm per unit of u.
  double torquePerInput() const { return electrical ? torqueConstant / resistance : torqueConstant; }
  /// What the declared load asks for at a position, Nm.
  double knownLoad(double position) const { return gravity != 0.0 ? gravity * std::sin(position - downAngle) : 0.0; }
};

struct CompiledTerm {
  const Effect* effect = nullptr;
  std::vector<double> parameters;
};

struct PastMotion {
  double time_s = 0.0, position = 0.0, velocity = 0.0;
};

struct MotionState {
  double position = 0.0;
  double velocity = 0.0;
  double current = 0.0;       ///< A; meaningful with an electrical side only
  double acceleration = 0.0;  ///< of the step before: predicts the middle of the next
  // History that some effects depend on; kept up only where the model has effects.
  double rest_s = 0.0;                ///< how long the last standstill lasted, or lasts by now
  double turned = 0.0;                ///< position of the last reversal
  double way = 0.0;                   ///< ±1: direction of the last motion
  double slip = 0.0;                  ///< elastic friction as a part of the full one, −1 … 1
  std::vector<PastMotion> past = {};  ///< the newest last; only where a servo's law answers late
  std::array<double, 8> memory{};     ///< the effects' hidden states, one after the other
};

/// Advances a state under a constant drive input. Between events the motion is the exact solution of the linear
/// equations, with position- and velocity-dependent terms taken at the middle of the step (second order); reversals and
/// the end of standstill are located within the step, and friction at standstill is an inequality: what does not move
/// stays exactly still.
class Stepper {
 public:
  Stepper(const Physics& physics, std::vector<CompiledTerm> terms);

  /// One row: `dt` s under input `u`, from `time_s` on; `connected` false means open windings. Divided into steps of at
  /// most 2 ms where terms depend on the state.
  void advance(MotionState& state, double u, double dt, double time_s, bool connected = true);

  const Physics& physics() const { return physics_; }
  const std::vector<CompiledTerm>& terms() const { return terms_; }
  void setLoad(double load_Nm) { physics_.load = load_Nm; }
  void setSupply(double supply_V) { supply_ = supply_V; }

  struct Forces {
    double load = 0.0;
    double friction = 0.0;
  };
  /// Load and friction at an instant, elastic friction counted as friction; `drive` in Nm. With a span their means over
  /// so much motion around the position.
  Forces forcesAt(const MotionState& state, double position, double velocity, double direction, double drive,
                  double time_s, double span = 0.0) const;
  /// What each of terms() gives at an instant, into `parts`; those that `wanted` doesn't mark stay as they are.
  void partsAt(const MotionState& state, double position, double velocity, double direction, double drive,
               double time_s, double span, std::span<const char> wanted, std::span<Term> parts) const;
  /// forcesAt() of known parts.
  Forces forcesOf(double position, std::span<const Term> parts) const;
  /// Advances hidden states and history over a step that went from `before` to `state` under `u` and ended at `time_s`.
  void keepHistory(MotionState& state, const MotionState& before, double u, double dt, double time_s) const;
  /// Voltage lost at a place and speed once the current has settled, V.
  double lostVoltage(const MotionState& state, double u, double position, double velocity, double time_s) const;
  bool losesVoltage() const { return losesVoltage_; }
  bool elastic() const { return stiffness_ > 0.0; }
  double slipStiffness() const { return stiffness_; }  ///< of elastic friction, Nm/rad
  /// Of elastic friction while it deflects, Nm s/rad.
  double slipDamping() const { return 2.0 * dampingRatio_ * std::sqrt(stiffness_ * physics_.inertia); }
  /// Into which a row is divided at least, s.
  double longestStep_s() const { return longestStep_; }
  /// Whether forces depend on more than the direction of motion.
  bool stateDependent() const { return stateDependent_; }
  /// Whether effects carry hidden state, so that forcesAt() doesn't tell all of a parameter's influence.
  bool remembers() const { return memorySize_ > 0 || stiffness_ > 0.0; }
  /// Whether any of that outlives a restart: a load that swings is found anew at each.
  bool remembersLong() const { return remembersLong_ || stiffness_ > 0.0; }
  /// Whether a load swings against the motor.
  bool swings() const { return swings_; }

 private:
  /// Exact transition of v' = −d v/J + a over dt.
  struct Decay {
    double dt = -1.0;
    double damping = 0.0;
    double velocity = 1.0;      ///< v after per v before
    double gainVelocity = 0.0;  ///< v after per a, s
    double gainPosition = 0.0;  ///< x after per a, s²
  };
  /// Exact transition of (i, v) with inductance over dt, and of the position on top.
  struct Coupled {
    double dt = -1.0;
    double ii = 1, iv = 0, vi = 0, vv = 1;
    double xi = 0, xv = 0;  ///< ∫ of the second row
  };

  /// What a step asks of a term again and again.
  struct Own {
    size_t memory = 0, size = 0;  ///< where its hidden state lies
    const HiddenState* hidden = nullptr;
    bool losesVoltage = false;
  };

  template <typename Act>
  void eachTerm(const MotionState& state, Situation& at, Act act) const;
  Situation situationAt(const MotionState& state, double position, double velocity, double direction, double drive,
                        double time_s) const;
  Forces forcesDuring(const MotionState& state, double direction, double drive, double damping, double dt,
                      double time_s) const;
  Decay decayOver(double dt, double damping) const;
  Coupled coupledOver(double dt) const;
  void mechanical(MotionState& state, double drive, double damping, double dt, double time_s);
  void inductive(MotionState& state, double u, double dt, double time_s);
  double breakawayTime(const MotionState& state, double u, double dt, double time_s, double& direction) const;
  double reversalTime(const MotionState& state, double iEnd, double vEnd, double dt, double vAfter) const;

  Physics physics_;
  std::vector<CompiledTerm> terms_;
  std::vector<Own> own_;  ///< one per term
  bool stateDependent_;
  bool losesVoltage_ = false;
  bool remembersLong_ = false;
  bool swings_ = false;
  size_t memorySize_ = 0;
  double stiffness_ = 0.0;     ///< of elastic friction, Nm/rad; 0: rigid
  double dampingRatio_ = 0.0;  ///< of it while it deflects
  double longestStep_ = 2e-3;
  double supply_ = 0.0;
  Decay decay_;
  Coupled coupled_;
};

}  // namespace breakaway
