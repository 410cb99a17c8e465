// The identified motor as a file: every value with its standard error.
#pragma once

#include <string>

#include "base/axis.h"
#include "base/result.h"
#include "identify/motor_identification.h"

namespace breakaway {

class JsonObject;

/// One identification of a motor on its bench, with what was mounted for it.
struct MotorRecord {
  std::string device;  ///< the board's
  IdentifiedMotor motor;
  Estimate addedInertia_kg_m2;  ///< a disc of known inertia on the shaft, or a mass on the slide; 0: none
  Axis axis = Axis::rotary;     ///< the file names its fields for it
};

/// motor.json, breakaway.motor/1.
Result<void> writeMotor(const MotorRecord& record, const std::string& path);
/// Errors: a field is missing or wrong, by file and name.
Result<MotorRecord> readMotor(const std::string& path);

/// The motor as a JSON object with a rotor's names, for other files that hold one.
std::string motorText(const IdentifiedMotor& motor);
/// Takes every field of motorText() from `object`; others are the caller's.
IdentifiedMotor motorIn(JsonObject& object, Axis axis = Axis::rotary);

}  // namespace breakaway
