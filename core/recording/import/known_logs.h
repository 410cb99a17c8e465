// Logs whose columns mean something that their names alone don't tell.
#pragma once

#include <string>

#include "base/result.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// Rewrites the columns of a log that is recognised into recordings' names and units and says so in a remark; leaves
/// every other table as it is.
/// - EMPS benchmark (A. Janot, M. Gautier, M. Brunot, "Data set and reference models of EMPS", 2019): t, qm, qg, vir
/// and the
///   drive gain gtau; the force is gtau · vir.
/// - BAM (M. Duclusaud et al., "Extended friction models for the physics simulation of servo actuators", arXiv
/// 2410.08650):
///   `load` of an XL330 is the PWM register, 16 bit, of which ±885 is full duty. It is read as signed. Values that no
///   such register can hold mean that the log was interpolated across the wrap; then the drive input is lost, and the
///   error says so.
Result<void> translateKnownLog(RawTable& table, const std::string& name);

}  // namespace breakaway
