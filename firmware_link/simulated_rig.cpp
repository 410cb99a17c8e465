#include "firmware_link/simulated_rig.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "control/tuning.h"

namespace breakaway {

namespace {

constexpr double fastestPart = 0.95;    // of the speed without load: where nothing is left to brake with
constexpr double continuousPart = 0.5;  // of the most current, for ever
constexpr double least_m = 2e-4;        // travel of a linear axis that is motion

double oneDigit(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  return std::round(value / decade) * decade;
}

double sensorRange_A(const Rig& rig) {
  return CurrentSensorModel(rig, 0).range_A();
}

template <typename Scalar>
ServoSettings<Scalar> namePlateSettings(const Rig& rig, double limit_A) {
  const double unit = rig.unitPerRad();
  const double Kt = oneDigit(rig.torqueConstant_Nm_per_A / unit);
  const double J = oneDigit((rig.inertia_kg_m2 + rig.coupling.loadInertia_kg_m2) / (unit * unit));
  const double tick_s = 1.0 / rig.loopRate_Hz;
  const MotionGains<double> gains = tuneMotion(J, Kt, 60.0, 40.0);
  ServoSettings<Scalar> settings;
  settings.gains.velocity_kp_A_s_per_rad = static_cast<Scalar>(gains.velocity_kp_A_s_per_rad);
  settings.gains.velocity_ki_A_per_rad = static_cast<Scalar>(gains.velocity_ki_A_per_rad);
  settings.gains.position_kp_A_per_rad = static_cast<Scalar>(gains.position_kp_A_per_rad);
  settings.gains.position_kd_A_s_per_rad = static_cast<Scalar>(gains.position_kd_A_s_per_rad);
  settings.gains.velocity_limit_rad_per_s =
      static_cast<Scalar>(0.6 * rig.bridge.supply_V / rig.backEmfConstant_V_s_per_rad * unit);
  settings.observer_cutoff_rad_per_s =
      static_cast<Scalar>(tuneObserver(tick_s, boardVelocityBandwidth_rad_per_s(tick_s)));
  settings.inertia_kg_m2 = static_cast<Scalar>(J);
  settings.torqueConstant_Nm_per_A = static_cast<Scalar>(Kt);
  settings.current_limit_A = static_cast<Scalar>(limit_A);
  return settings;
}

}  // namespace

SimulatedRig::SimulatedRig(const Rig& rig, unsigned seed)
    : ticks_s_(1.0 / rig.loopRate_Hz),
      rate_Hz_(rig.loopRate_Hz),
      substeps_(static_cast<int>(std::ceil(ticks_s_ / coarsestStep_s(rig) - 1e-9))),
      plant_(rig, ticks_s_ / substeps_, 2u * seed + 1u),
      encoder_(rig),
      sensor_(rig, 2u * seed + 2u),
      bridge_(rig),
      faults_(rig.faults),
      terminals_(rig.wiring),
      supply_V_(rig.bridge.supply_V) {
}

SimulatedRig::Reading SimulatedRig::read() {
  const double exact_s = static_cast<double>(tickCount_) * ticks_s_;
  const BoardTrouble trouble = faults_.none() ? BoardTrouble{} : faults_.step(exact_s, plant_.encoderAngle_rad());
  plant_.block(trouble.blocked);
  plant_.scaleResistance(trouble.resistancePart);
  supplyPart_ = trouble.supplyPart;
  terminals_.at(exact_s);
  const EncoderModel::Reading encoder = encoder_.read(plant_.encoderAngle_rad());
  Reading reading;
  reading.count = terminals_.count(encoder.count) + trouble.slippedCounts;
  reading.index = terminals_.index((encoder.index && !trouble.hidesIndex) || trouble.showsIndex);
  reading.supply_V = terminals_.supplyReading(supply_V_ * trouble.supplyPart);
  const double flows_A = terminals_.sensorWay() * (plant_.current_A() + trouble.past_A);
  reading.current_A = sensor_.read(flows_A, static_cast<double>(tickCount_) / rate_Hz_);
  if (terminals_.sensorDead()) reading.current_A = 0.0;
  reading.linkLost = trouble.linkLost;
  ++tickCount_;
  return reading;
}

void SimulatedRig::drive(bool enabled, double duty) {
  if (enabled && !terminals_.leadOff()) {
    plant_.applyVoltage(terminals_.voltage(bridge_.voltage(duty) * supplyPart_));
  } else {
    plant_.openWindings();
  }
  plant_.advance(substeps_);
}

template <typename Scalar>
board::BoardHardware<Scalar> hardwareOf(const Rig& rig) {
  const double tick_s = 1.0 / rig.loopRate_Hz, range_A = sensorRange_A(rig);
  const double unit = rig.unitPerRad(), count = unit * turn_rad / rig.encoder.countsPerRev;
  const double most_A = std::min(0.9 * range_A, rig.bridge.supply_V / rig.resistance_ohm);
  board::BoardHardware<Scalar> hardware;
  hardware.simulated = true;
  hardware.loopRate_Hz = static_cast<Scalar>(rig.loopRate_Hz);
  hardware.countsPerRev =
      static_cast<std::uint32_t>(std::lround(rig.axis == Axis::rotary ? rig.encoder.countsPerRev : 1.0 / count));
  hardware.supply_V = static_cast<Scalar>(rig.bridge.supply_V);
  hardware.sensorRange_A = static_cast<Scalar>(range_A);
  hardware.sensorStep_A = static_cast<Scalar>(2.0 * range_A / std::exp2(rig.currentSensor.adcBits));
  hardware.pwmSteps = static_cast<std::uint32_t>(std::lround(std::max(0.0, rig.bridge.pwmSteps)));
  hardware.servo = {static_cast<Scalar>(tick_s),
                    static_cast<Scalar>(count),
                    {static_cast<Scalar>(rig.resistance_ohm), static_cast<Scalar>(rig.inductance_H),
                     static_cast<Scalar>(rig.backEmfConstant_V_s_per_rad / unit),
                     static_cast<Scalar>(boardCurrentBandwidth_rad_per_s(tick_s))},
                    static_cast<Scalar>(boardVelocityBandwidth_rad_per_s(tick_s))};
  hardware.watch.tick_s = static_cast<Scalar>(tick_s);
  hardware.watch.count_rad = static_cast<Scalar>(count);
  if (rig.axis == Axis::linear) hardware.watch.blockedTravel_rad = static_cast<Scalar>(least_m);
  hardware.watch.trip_A = static_cast<Scalar>(std::min(1.25 * most_A, 0.95 * range_A));
  hardware.watch.supply_V = static_cast<Scalar>(rig.bridge.supply_V);
  hardware.watch.mostAcceleration_rad_per_s2 =
      static_cast<Scalar>(3.0 * most_A * rig.torqueConstant_Nm_per_A / rig.inertia_kg_m2 * unit);
  hardware.watch.resistance_ohm = hardware.servo.current.resistance_ohm;
  hardware.watch.inductance_H = hardware.servo.current.inductance_H;
  hardware.watch.backEmf_V_s_per_rad = hardware.servo.current.backEmfConstant_V_s_per_rad;
  hardware.start = namePlateSettings<Scalar>(rig, 0.6 * most_A);
  hardware.mostCurrent_A = static_cast<Scalar>(most_A);
  const double unloaded = rig.bridge.supply_V / rig.backEmfConstant_V_s_per_rad * unit;
  hardware.mostVelocity_rad_per_s = static_cast<Scalar>(unloaded);
  hardware.watch.mostVelocity_rad_per_s = static_cast<Scalar>(fastestPart * unloaded);
  hardware.watch.continuous_A = static_cast<Scalar>(continuousPart * most_A);
  return hardware;
}

template board::BoardHardware<float> hardwareOf<float>(const Rig& rig);
template board::BoardHardware<double> hardwareOf<double>(const Rig& rig);

}  // namespace breakaway
