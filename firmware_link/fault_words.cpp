#include "firmware_link/fault_words.h"

#include <cmath>

namespace breakaway {

Trip tripOf(wire::FaultCode code) {
  using wire::FaultCode;
  switch (code) {
    case FaultCode::none:
    case FaultCode::travel:
    case FaultCode::overTemperature:
    case FaultCode::leaseExpired:
      return Trip::none;
    default:
      return static_cast<Trip>(code);
  }
}

Message faultWords(const wire::Fault& fault, const FaultLimits& limits) {
  using wire::FaultCode;
  switch (fault.code) {
    case FaultCode::none:
      return message("the board stopped the motor and does not say why");
    case FaultCode::overCurrent:
    case FaultCode::openSensor:
    case FaultCode::supplyLow:
    case FaultCode::encoderJump:
    case FaultCode::blocked:
    case FaultCode::supplyHigh:
    case FaultCode::contradiction:
    case FaultCode::overSpeed:
    case FaultCode::windingHeat:
      return tripWords(static_cast<Trip>(fault.code),
                       {static_cast<double>(fault.current_A),
                        limits.trip_A,
                        static_cast<double>(fault.limit_A),
                        static_cast<double>(fault.supply_V),
                        limits.supply_V,
                        static_cast<double>(fault.jump_rad) / limits.count_rad,
                        limits.blockedFor_s,
                        {static_cast<double>(fault.voltage_V), static_cast<double>(fault.current_A),
                         static_cast<double>(fault.velocity_rad_per_s),
                         static_cast<double>(fault.meanVelocity_rad_per_s), static_cast<double>(fault.resistance_ohm),
                         static_cast<double>(fault.backEmf_V_s_per_rad), limits.trip_A, limits.axis}});
    case FaultCode::travel:
      return message("the rotor went beyond the travel that the board allows; widen travel_limit_rad, or ask for less");
    case FaultCode::overTemperature:
      return message("over-temperature: {:.0f} degrees Celsius; let the motor cool, then go on",
                     static_cast<double>(fault.temperature_degC));
    case FaultCode::leaseExpired:
      return linkLossWords(limits.lease_s);
  }
  return message("the board stopped the motor for a reason that this program does not know (code {})",
                 static_cast<int>(fault.code));
}

}  // namespace breakaway
