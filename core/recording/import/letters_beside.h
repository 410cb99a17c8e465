// What single letters and short words of a name mean by the names beside it.
#pragma once

#include <vector>

#include "recording/import/choose_columns.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// "joint_eff" beside "joint_pos", "hip_q" beside "hip_dq", "u_a" without a "u_b", "p" beside "p_des", "x" beside
/// "x_dot" and "theta".
void takeLettersBeside(const RawTable& table, std::vector<Choice>& choices);

}  // namespace breakaway
