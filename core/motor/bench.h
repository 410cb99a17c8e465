// The bench file: what the technician believes about the rig (resources/help/files.md).
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/axis.h"
#include "base/result.h"
#include "motor/duty_curve.h"
#include "motor/servo_law.h"

namespace breakaway {

enum class ControlMode { openLoop, velocity, position };

/// The bench file's names of the motor's quantities on one axis.
struct MotorNames {
  const char *torqueConstant, *backEmfConstant, *resistance, *inductance, *inertia, *viscous, *coulomb, *counts;
};
const MotorNames& motorNames(Axis axis);

/// Start values in SI; on a linear axis read kg for kg m², N for Nm, m for rad. Missing: unknown, to be fitted.
struct MotorBelief {
  std::optional<double> torqueConstant;   ///< Nm/A or N/A
  std::optional<double> backEmfConstant;  ///< V s/rad or V s/m
  std::optional<double> resistance_ohm;
  std::optional<double> inductance_H;
  std::optional<double> inertia;  ///< kg m² or kg
  std::optional<double> viscous;  ///< Nm s/rad or N s/m
  std::optional<double> coulomb;  ///< Nm or N
};

struct Pendulum {
  double mass_kg = 0.0;
  double length_m = 0.0;
  double armMass_kg = 0.0;
  double downAngle_rad = 0.0;
};

struct BenchController {
  ControlMode mode = ControlMode::openLoop;
  double kp = 0.0, ki = 0.0, kd = 0.0;  ///< A per rad/s … or A per rad …, by mode
  double observerCutoff_rad_per_s = 0.0;
  double nominalInertia = 0.0;
  double nominalTorqueConstant = 0.0;
  double currentLimit_A = 0.0;
};

struct Bench {
  std::string name;
  std::string motorSerial;  ///< which motor this is; empty: unknown
  Axis axis = Axis::rotary;
  DriveInput input = DriveInput::torque;  ///< what acts; with `servo`, what its law gives out
  std::optional<ServoLaw> servo;          ///< where the recording holds the reference of the servo's own loop
  std::optional<double> supply_V;
  std::optional<double> currentGainInterval;  ///< relative half width of the current sensor's 95 % interval
  DutyCurve dutyCurve;                        ///< of the bridge, as commissioning found it; unknown: straight
  std::optional<double> countsPerUnit;        ///< per rev or per m, as in the file
  std::optional<double> polePairs;            ///< of a rotary motor; for boards that speak of electrical turns
  MotorBelief motor;
  std::set<std::string> trusted;  ///< contract names, e.g. "torque_constant_Nm_per_A", "controller.kp_Nm_per_rad"
  std::optional<Pendulum> pendulum;
  BenchController controller;
  std::vector<std::string> remarks;  ///< contradictions that whoever wrote it went on in spite of

  /// One encoder count in rad or m; 0 when the encoder is not declared.
  double count() const;
  bool electrical() const { return input == DriveInput::voltage || input == DriveInput::duty; }
  std::string positionChannel() const;  ///< angle_rad or position_m
  std::string velocityChannel() const;
  std::string torqueChannel() const;  ///< torque_Nm or force_N
  std::string inputChannel() const;   ///< voltage_V, duty, current_A, torque_Nm or force_N, or the reference
};

/// The drive input called `name` in the contract, or nothing when there is none of that name on this axis.
std::optional<DriveInput> driveInputNamed(const std::string& name, Axis axis);

Result<Bench> readBench(const std::string& path);
Result<Bench> readBenchText(const std::string& text, const std::string& place);
Result<void> writeBench(const Bench& bench, const std::string& path);

}  // namespace breakaway
