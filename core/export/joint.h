// What a joint of a robot simulator can be told of a model, and what it can't.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "diagnose/model/load_part.h"
#include "diagnose/model/model.h"
#include "export/model_program.h"

namespace breakaway {

/// Which parts a form of joint holds beside inertia, viscous and Coulomb friction.
struct JointAbility {
  bool constantLoad = false;
  bool breakaway = false;  ///< static friction apart from sliding friction
  bool stop = false;
  bool inputLimit = false;
  bool springLoad = false;  ///< a second joint with a spring
  bool weight = false;      ///< a pendulum, as the link's mass
};

/// On a linear axis read kg for kg m², N for Nm, m for rad.
struct Joint {
  Axis axis = Axis::rotary;
  DriveInput input = DriveInput::torque;
  double inertia = 0.0;  ///< of the motor with what is fixed to it, without pendulum and without a load on a spring
  double viscous = 0.0, coulomb = 0.0;
  double breakaway = 0.0;                        ///< beyond Coulomb friction at standstill, Nm
  double constantLoad = 0.0;                     ///< as Term::load_Nm
  std::optional<double> lower = {}, upper = {};  ///< stops, rad
  std::optional<TwoMass> springLoad = {};
  std::optional<Pendulum> pendulum = {};  ///< with its down angle
  double torquePerInput = 1.0;            ///< Nm per V, A or Nm
  double backEmfDamping = 0.0;            ///< Kt Ke/R where a voltage drives, Nm s/rad
  std::optional<double> supply_V = {};    ///< of the bridge
  std::optional<double> inputLimit = {};  ///< V, A or Nm
  struct Law {
    double kp = 0.0, kd = 0.0;         ///< Nm/rad, Nm s/rad
    std::optional<double> limit = {};  ///< Nm
  };
  std::optional<Law> law = {};  ///< of a servo that a reference drives
  std::vector<LeftOut> leftOut = {};
  Model held = {};  ///< the model with what the joint holds alone
};

/// Errors: a law in duty without supply_V.
Result<Joint> jointOf(const Model& model, const JointAbility& ability);

}  // namespace breakaway
