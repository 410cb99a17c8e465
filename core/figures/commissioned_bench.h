// A bench on which figures are measured: a drive that has been commissioned.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "base/result.h"
#include "commission/commission.h"
#include "experiment/compensation.h"
#include "experiment/course.h"
#include "experiment/drive.h"

namespace breakaway {

/// What was measured by commissioning, and the drive as commissioning left it: homed and tuned.
struct CommissionedBench {
  std::unique_ptr<Drive> drive;
  Commission measured;

  double inertia_kg_m2() const { return measured.motor.inertia_kg_m2.value; }
  double torqueConstant_Nm_per_A() const { return measured.motor.torqueConstant_Nm_per_A.value; }
  /// Of the velocity sweep.
  double highestSpeed_rad_per_s() const;
};

/// Commissions the drive. Errors: those of commission().
Result<CommissionedBench> commissionBench(std::unique_ptr<Drive> drive, const CommissionOptions& options);

/// A course as it ran, and the mean speed just before it.
struct RanCourse {
  std::vector<Sample> samples;
  double velocityBefore_rad_per_s = 0.0;
};

/// A part of the friction that a figure compares, with its column's and its curve's name.
struct Compensated {
  CompensatedFriction part;
  const char* column;
  const char* label;
};

constexpr std::array<Compensated, 4> fromNoneToMap{{{CompensatedFriction::none, "none", "none"},
                                                    {CompensatedFriction::coulomb, "f", "F"},
                                                    {CompensatedFriction::coulombAndViscous, "f_and_b", "F + Bω"},
                                                    {CompensatedFriction::map, "map", "map"}}};

/// Runs a course with this part of the measured friction compensated; afterwards nothing is. Errors: the drive's, the
/// course's.
Result<RanCourse> runCourse(CommissionedBench& bench, const CourseOptions& course, CompensatedFriction part);

/// The angle at which the rotor, brought to a stand, is now, as the encoder counts it. Errors: the drive's.
Result<double> angleNow(CommissionedBench& bench);

}  // namespace breakaway
