// Which of several angles and speeds go together, by their values.
#pragma once

#include <vector>

#include "recording/import/choose_columns.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// Where the angle that would be taken moves otherwise than the speed that would be, and another angle or speed beside
/// them agrees, sets aside what is no motor's: a robot's tilt and its rate beside its wheel's speed; so is an angle of
/// something with a name of its own ("pedal_pos") beside a motor's speed whose unit is told. `angle` and `speed` are
/// the columns that would be taken. Whether anything was set aside.
bool setStrangersAside(const RawTable& table, size_t angle, size_t speed, std::vector<Choice>& choices);

}  // namespace breakaway
