// Which of several angles and speeds go together, by their values.
#pragma once

#include <vector>

#include "recording/import/choose_columns.h"
#include "recording/import/name_parts.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// The name's words without those that surely name a quantity: what "omega_enc" and "theta_enc" share.
Words wordsBesideQuantity(const RawTable& table, size_t c);

/// A position in metres beside a speed of rotation whose unit is told, with which it has little in common, is no
/// motor's: how far a rotor is off its centre. Whether it was set aside.
bool setStrangePlaceAside(const RawTable& table, size_t position, size_t speed, std::vector<Choice>& choices);

/// Where no angle is known: a column that is called as the speed is but for one word ("loc_state" beside "speed_state")
/// and moves as it says; what has that word, too, goes with it.
void takeAnglesByValues(const RawTable& table, std::vector<Choice>& choices);

/// Where no name tells any motion: of columns that nothing is known of, one that changes as another says is the angle,
/// and that other one its speed; of a chain (place, speed, acceleration) the first two. Both are guesses.
void takeMotionByValues(const RawTable& table, std::vector<Choice>& choices);

/// Where no name tells a motion, what is called by a joint alone is its angle, as a guess: "joint_1", "elbow_act".
void takeJointsAlone(const RawTable& table, std::vector<Choice>& choices);

/// Where nothing else moves, the only column in degrees or radians whose words aren't known is how far it turns, a
/// guess ("R_KFE_deg"), unless it is called a direction or a place on earth.
void takeOnlyAngle(const RawTable& table, std::vector<Choice>& choices);

}  // namespace breakaway
